#include <commands/where.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include <fettle/property/storage/tweaks.h>

#include <command_line/arguments.h>
#include <command_line/exit_status.h>
#include <command_line/terminal.h>
#include <files/file_errors.h>
#include <files/game_path.h>
#include <files/settings.h>

namespace fettle::program {

namespace fs = std::filesystem;

int where(const fs::path& named) {
    const fs::path game = found_game(named);
    const fs::path player = property::player_folder(game, read_settings(game).id);
    const auto tell_place = [](const std::string& what, const fs::path& place) {
        std::error_code error;
        const bool there = fs::exists(place, error);
        print_line(what + std::string(13 - what.size(), ' ') + place.string() +
                   (there ? "" : "  (not made yet)"));
    };
    if (player.empty()) {
        print_line("This user has neither XDG_DATA_HOME nor HOME: nothing of a game is kept.");
    } else {
        tell_place("store", player / "store.json");
        tell_place("saves", player / "saves");
        tell_place("settings", player / "settings.json");
        tell_place("preferences", player / "preferences.json");
    }
    tell_place("tweaks", property::journal_of(game));
    return success;
}

Command add_where(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "where", "Print where the store, the saves, the settings and the tweaks of a game are.");
    command.allow_extras();
    const auto game = std::make_shared<fs::path>();
    command
        .add_option_function<std::string>(
            "path",
            [game](const std::string& text) {
                *game = checked_text("path", text, "a folder with main.lua, or a .lua file");
            },
            "A folder with main.lua, or one .lua file")
        ->required();
    return {&command, [game] { return with_file_errors([&] { return where(*game); }); }};
}

}  // namespace fettle::program
