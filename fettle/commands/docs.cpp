#include <commands/docs.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>

#include <fettle/script/reference.h>

#include <command_line/arguments.h>
#include <command_line/exit_status.h>
#include <command_line/terminal.h>
#include <files/file_errors.h>
#include <files/game_path.h>
#include <session/session.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& text) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    require_file(file, "a file to write");
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (error || !out)
        throw FileError(file.string() +
                        ": cannot be written: " + (error ? error.message() : std::strerror(errno)));
}

}  // namespace

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

Command add_docs(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "docs", "Write annotations for editors (LuaCATS) and reference pages (Markdown).");
    const auto options = std::make_shared<DocsOptions>();
    command.allow_extras();
    command
        .add_option_function<std::string>(
            "folder",
            [options](const std::string& folder) {
                options->folder = checked_text("folder", folder, "a folder");
            },
            "Where to; made when it is missing")
        ->required();
    command.add_option_function<std::string>(
        "game",
        [options](const std::string& game) {
            options->game = checked_text("game", game, "a folder with main.lua, or a .lua file");
        },
        "A game whose own classes are to be described as well");
    command
        .add_option_function<std::string>(
            "--module",
            [options](const std::string& name) {
                options->modules.push_back(checked_text("--module", name, "a file or a name"));
            },
            "A module whose classes are, too: a shared object, or the name of an installed one "
            "(repeatable)")
        ->trigger_on_parse();
    return {&command, [options] { return with_file_errors([&] { return docs(*options); }); }};
}

}  // namespace fettle::program
