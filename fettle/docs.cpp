#include "docs.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <memory>

#include <fettle/script/reference.h>

#include "exit_status.h"
#include "game_path.h"
#include "session.h"

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

void write(const fs::path& file, const std::string& text) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (error || !out) throw FileError(file.string() + ": cannot be written");
}

}  // namespace

int docs(const DocsOptions& options) {
    RunOptions run;
    run.game = options.game;
    run.modules = options.modules;
    run.headless = true;
    Session session(run, nullptr, {});
    if (!options.game.empty()) {
        require_game(options.game);
        session.start();
        if (session.failed()) return script_error;
    }
    const property::Tree& tree = session.tree();
    write(options.folder / "fettle.lua", script::annotations(tree));
    const auto pages = script::reference_pages(tree);
    for (const script::ReferencePage& page : pages) write(options.folder / page.file, page.text);
    std::printf("%s: fettle.lua and %zu pages\n", options.folder.string().c_str(), pages.size());
    return success;
}

void add_docs(CLI::App& app, int& status) {
    CLI::App& command = *app.add_subcommand(
        "docs", "Write annotations for editors (LuaCATS) and reference pages (Markdown).");
    const auto options = std::make_shared<DocsOptions>();
    command.add_option("folder", options->folder, "Where to; made when it is missing")->required();
    command.add_option("game", options->game,
                       "A game whose own classes are to be described as well");
    command
        .add_option_function<std::string>(
            "--module", [options](const std::string& name) { options->modules.push_back(name); },
            "A module whose classes are, too: a shared object, or the name of an installed one "
            "(repeatable)")
        ->trigger_on_parse();
    command.callback([options, &status] {
        try {
            status = docs(*options);
        } catch (const FileError& error) {
            std::fprintf(stderr, "fettle: %s\n", error.what());
            status = file_error;
        } catch (const fs::filesystem_error& error) {
            std::fprintf(stderr, "fettle: %s: %s\n", error.path1().string().c_str(),
                         error.code().message().c_str());
            status = file_error;
        }
    });
}

}  // namespace fettle::program
