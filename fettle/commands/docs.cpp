#include <filesystem>
#include <string>
#include <vector>

#include <fettle/script/reference.h>

#include <command_line/subcommand.h>
#include <commands/commands.h>
#include <ending/exit_status.h>
#include <files/game_path.h>
#include <session/session.h>
#include <terminal/terminal.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

struct DocsOptions {
    fs::path folder{};
    fs::path game{};                     // its classes are described too; empty: only Fettle's own
    std::vector<std::string> modules{};  // modules to plug in: files, or names of installed modules
};

void write(const fs::path& file, const std::string& text) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    require_file(file, "a file to write");
    if (error) throw FileError(file.string() + ": cannot be written: " + error.message());
    write_file(file, text);
}

int docs(const DocsOptions& options) {
    RunOptions run;
    if (!options.game.empty()) run.game = found_game(options.game);
    run.modules = options.modules;
    run.headless = true;
    Session session(run, nullptr, {});
    if (!options.game.empty()) {
        session.start();
        if (session.failed()) return script_error;
    }
    const property::Tree& tree = session.tree();
    write(options.folder / "fettle.lua", script::annotations(tree));
    const auto pages = script::reference_pages(tree);
    for (const script::ReferencePage& page : pages) write(options.folder / page.file, page.text);
    print_line(options.folder.string() + ": fettle.lua and " + std::to_string(pages.size()) +
               " pages");
    return success;
}

}  // namespace

Command add_docs(CLI::App& app) {
    Subcommand<DocsOptions> command(
        app, "docs", "Write annotations for editors (LuaCATS) and reference pages (Markdown).");
    command.text("folder", &DocsOptions::folder, "a folder", "Where to; made when it is missing")
        ->required();
    command.text("game", &DocsOptions::game, path_of_game,
                 "A game whose own classes are to be described as well");
    command.text("--module", &DocsOptions::modules, "a file or a name",
                 "A module whose classes are, too: a shared object, or the name of an installed "
                 "one (repeatable)");
    return command.runs(docs);
}

}  // namespace fettle::program
