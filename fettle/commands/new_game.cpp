#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <nlohmann/json.hpp>

#include <fettle/property/spelling.h>
#include <fettle/property/text_hash.h>
#include <fettle/script/reference.h>

#include <command_line/for_shell.h>
#include <command_line/joined.h>
#include <command_line/subcommand.h>
#include <commands/commands.h>
#include <ending/exit_status.h>
#include <files/dashed_name.h>
#include <files/draft.h>
#include <files/game_path.h>
#include <session/session.h>
#include <terminal/terminal.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

struct NewGameOptions {
    fs::path folder{};
    std::string pattern = "empty";  // the name of a folder in assets/templates
};

constexpr const char* common_files = "common";  // the folder with files that every new game gets

fs::path templates() {
    const fs::path own = assets();
    std::error_code error;
    if (own.empty() || !fs::is_directory(own / "templates" / common_files, error))
        throw FileError("the templates of games are missing from the installation");
    return own / "templates";
}

std::vector<std::string> template_names() {
    std::vector<std::string> names;
    for (const auto& each : fs::directory_iterator(templates()))
        if (each.is_directory() && each.path().filename() != common_files)
            names.push_back(each.path().filename().string());
    std::ranges::sort(names);
    return names;
}

/// Why there is no such template; empty if there is one.
std::string template_problem(const std::string& name) {
    const std::vector<std::string> names = template_names();
    if (std::ranges::find(names, name) != names.end()) return {};
    return "--template: there is no template \"" + on_one_line(name) + "\"; there are " +
           joined(names) + property::suggestion(name, names);
}

/// A part of an id: letters and digits of the name in lower case, the rest as dashes. A name of
/// which more than that changes also gets a hash, so that two such names have different ids: the
/// saves of a game lie under its id.
std::string id_of(const std::string& name) {
    constexpr std::size_t longest = 60;
    std::string id = dashed_name(name).substr(0, longest);
    const bool unique = std::ranges::equal(
        name, id, [](unsigned char a, unsigned char b) { return std::tolower(a) == b; });
    if (id.empty()) id = "game";
    return unique ? id : id + "-" + property::text_hash_digits(name);
}

void replace_all(std::string& text, std::string_view what, const std::string& with) {
    for (std::size_t at = text.find(what); at != std::string::npos;
         at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
}

void fill_in_settings(const fs::path& folder, const std::string& name) {
    const fs::path file = folder / "game.json";
    std::ifstream in(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    std::string quoted =
        nlohmann::json(name).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    replace_all(text, "\"GAME_NAME\"", quoted);
    replace_all(text, "GAME_ID", id_of(name));
    replace_all(text, "FETTLE_VERSION", FETTLE_VERSION);
    write_file(file, text);
}

/// Writes the classes and functions of this version for editors, which complete and check them.
void write_annotations(const fs::path& folder) {
    fs::create_directories(folder / ".editor");
    RunOptions run;
    run.headless = true;
    Session session(run, nullptr, {});
    write_file(folder / ".editor" / "fettle.lua", script::annotations(session.tree()));
}

void make(const fs::path& folder, const std::string& pattern, const std::string& name) {
    for (const std::string& from : {std::string(common_files), pattern})
        fs::copy(templates() / from, folder,
                 fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    // Files of an installation may be write-protected.
    for (const auto& each : fs::recursive_directory_iterator(folder))
        fs::permissions(each.path(), fs::perms::owner_write, fs::perm_options::add);
    fill_in_settings(folder, name);
    write_annotations(folder);
}

/// Moves all files of the draft into the folder, or none.
void fill(const fs::path& folder, const fs::path& draft) {
    std::vector<fs::path> moved;
    try {
        for (const auto& each : fs::directory_iterator(draft)) {
            moved.push_back(folder / each.path().filename());
            fs::rename(each.path(), moved.back());
        }
    } catch (...) {
        std::error_code ignored;
        for (const fs::path& each : moved) fs::remove_all(each, ignored);
        throw;
    }
}

/// Makes the folder with the files of the template and annotations for editors. Throws FileError
/// for a folder that is not empty, and FileError or fs::filesystem_error if a file cannot be
/// written; then no game is made.
int new_game(const NewGameOptions& options) {
    if (const std::string problem = template_problem(options.pattern); !problem.empty()) {
        print_error(problem);
        return bad_usage;
    }
    fs::path folder = fs::absolute(options.folder).lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();
    std::error_code error;
    // A link that leads nowhere counts as existing.
    const bool there = fs::exists(fs::symlink_status(folder, error));
    if (there && (!fs::is_directory(folder, error) || !fs::is_empty(folder)))
        throw FileError(options.folder.string() +
                        ": there is something already, so nothing was made");
    const std::string name = folder.filename().string();
    if (std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x20; })) {
        print_error(
            "name: expected a folder without line breaks and other control characters in "
            "its name, got \"" +
            on_one_line(name) + '"');
        return bad_usage;
    }
    fs::create_directories(folder.parent_path());
    // Made under another name, so that an error leaves no incomplete game. An existing folder is
    // filled and not replaced, because the user's shell may be in it.
    const Draft draft(there ? folder / name : folder);
    const fs::path made = draft.path / name;
    fs::create_directory(made);
    make(made, options.pattern, name);
    if (there)
        fill(folder, made);
    else
        fs::rename(made, folder);
    const std::string typed = for_shell(options.folder.string());
    print_line(typed + ": a game to begin with. Play it with fettle run " + typed +
               ", test it with fettle test " + typed);
    return success;
}

}  // namespace

Command add_new_game(CLI::App& app) {
    Subcommand<NewGameOptions> command(
        app, "new", "Make a small game to begin with, with a test and settings for editors.");
    command
        .text("name", &NewGameOptions::folder, "a folder that is not there yet",
              "The folder of the game, which is made")
        ->required();
    command.text("--template", &NewGameOptions::pattern, "the name of a template",
                 "empty, physics, platformer or topdown; empty unless given");
    return command.runs(new_game);
}

}  // namespace fettle::program
