#include <filesystem>
#include <string>

#include <fettle/property/storage/tweaks.h>

#include <command_line/subcommand.h>
#include <commands/commands.h>
#include <ending/exit_status.h>
#include <files/archive.h>
#include <files/game_path.h>
#include <files/settings.h>
#include <terminal/terminal.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

struct WhereOptions {
    fs::path game{};
};

int where(const WhereOptions& options) {
    const fs::path game = found_game(options.game);
    const fs::path player = property::player_folder(game, read_settings(game).id);
    const auto print_place = [](const std::string& what, const fs::path& place) {
        std::error_code error;
        const bool there = fs::exists(place, error);
        print_line(what + std::string(13 - what.size(), ' ') + place.string() +
                   (there ? "" : "  (not made yet)"));
    };
    if (player.empty()) {
        print_line("This user has neither XDG_DATA_HOME nor HOME: nothing of a game is kept.");
    } else {
        print_place("store", player / "store.json");
        print_place("saves", player / "saves");
        print_place("settings", player / "settings.json");
        print_place("preferences", player / "preferences.json");
    }
    if (!archive_of(game).empty())
        print_line("tweaks       none: a game in an archive (.fettle) keeps no tweaks");
    else
        print_place("tweaks", property::journal_of(game));
    return success;
}

}  // namespace

Command add_where(CLI::App& app) {
    Subcommand<WhereOptions> command(
        app, "where",
        "Print where the store, the saves, the settings and the tweaks of a game are.");
    command
        .text("path", &WhereOptions::game, path_of_game, "A folder with main.lua, or one .lua file")
        ->required();
    return command.runs(where);
}

}  // namespace fettle::program
