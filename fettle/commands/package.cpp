#include <CLI/CLI.hpp>
#include <cctype>
#include <filesystem>
#include <string>
#include <vector>

#include <fettle/property/storage/game_settings.h>

#include <command_line/exit_status.h>
#include <command_line/for_shell.h>
#include <command_line/joined.h>
#include <command_line/subcommand.h>
#include <command_line/terminal.h>
#include <commands/commands.h>
#include <files/dashed_name.h>
#include <files/game_path.h>
#include <files/packed_game.h>
#include <files/settings.h>
#include <game/packed_modules.h>
#include <packing/folder_and_deb.h>
#include <packing/package_problems.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

struct PackageOptions {
    fs::path game{};
    // The files to make; empty: this one is not made.
    fs::path file{};                  // NAME.fettle
    fs::path linux_run{};             // a folder, or NAME.tar.gz
    fs::path deb{};                   // NAME.deb
    std::vector<std::string> made{};  // names of files that the game itself makes
};

/// A Debian package needs a name of at least two characters.
std::string file_name_of(const std::string& name) {
    const std::string dashed = dashed_name(name);
    return dashed.size() < 2 ? "game" : dashed;
}

/// Digits, letters and dots, beginning with a digit.
std::string version_of(const std::string& version) {
    std::string plain;
    for (const char c : version)
        if ((c >= '0' && c <= '9') || (!plain.empty() && (std::isalpha(c) != 0 || c == '.')))
            plain += c;
    return plain.empty() ? "0.1" : plain;
}

PackageFacts facts_of(const fs::path& game) {
    const property::GameSettings settings = read_settings(game);
    const fs::path folder = fs::absolute(game).lexically_normal();
    std::string name = settings.name;
    if (name.empty())
        name = (folder.has_filename() ? folder : folder.parent_path()).stem().string();
    std::string author;
    for (const char c : settings.author)
        if (c >= ' ' && c != '<' && c != '>') author += c;
    return {.name = on_one_line(name),
            .id = file_name_of(name),
            .version = version_of(settings.version),
            .author = author};
}

void print_left_out(const PackedGame& packed) {
    if (!packed.left_out.empty()) print_line("left out: " + joined(packed.left_out));
}

int package(const PackageOptions& options) {
    if (options.file.empty() && options.linux_run.empty() && options.deb.empty()) {
        print_error(
            "package: name what to make: --file NAME.fettle, --linux FOLDER or --deb NAME.deb");
        return bad_usage;
    }
    const fs::path game = found_game(options.game);
    if (!archive_of(game).empty())
        throw FileError(options.game.string() + ": is an archive already; name the game's folder");
    const PackageFacts facts = facts_of(game);
    const PackedGame packed = packed_game(game, read_settings(game).package_exclude);
    ArchiveFiles files = packed.files;
    const std::vector<std::string> problems = problems_of(packed, options.made);
    for (const std::string& problem : problems) print_error(problem);
    if (!problems.empty()) {
        print_error(
            "nothing was made: the game would not run elsewhere. --made NAME names a file that "
            "the game makes itself");
        return file_error;
    }
    print_left_out(packed);
    if (!options.file.empty()) {
        require_installed_modules(game);
        write_archive(options.file, files);
        print_line(options.file.string() + ": " + std::to_string(files.size()) +
                   (files.size() == 1 ? " file" : " files") + ". Play it with fettle run " +
                   for_shell(options.file.string()));
    }
    std::vector<fs::path> libraries;
    if (!options.linux_run.empty() || !options.deb.empty()) libraries = bring_modules(game, files);
    if (!options.linux_run.empty()) {
        make_folder(options.linux_run, facts, files, libraries);
        print_line(options.linux_run.string() + ": " + start_of_folder(facts) +
                   " in it starts the game");
    }
    if (!options.deb.empty()) {
        make_debian_package(options.deb, facts, files, libraries);
        print_line(options.deb.string() + ": installs /usr/games/" + facts.id);
    }
    return success;
}

}  // namespace

Command add_package(CLI::App& app) {
    Subcommand<PackageOptions> command(
        app, "package",
        "Make a package of a game for players: one file, a folder, a Debian package.");
    command
        .text("path", &PackageOptions::game, path_of_game,
              "A folder with main.lua, or one .lua file")
        ->required();
    command.option("--file", "One file, which fettle run plays: NAME.fettle",
                   [](PackageOptions& to, const std::string& text) {
                       to.file = checked_text("--file", text, "a file");
                       if (to.file.extension() != archive_ending)
                           throw CLI::ValidationError("--file",
                                                      "expected a name that ends in .fettle");
                   });
    command.text("--linux", &PackageOptions::linux_run, "a folder that is not there yet",
                 "A folder that runs without Fettle, or a file NAME.tar.gz with it: it needs a "
                 "Linux as new as this one, X11 and OpenGL");
    command.option("--deb", "A Debian package of that folder: NAME.deb",
                   [](PackageOptions& to, const std::string& text) {
                       to.deb = checked_text("--deb", text, "a file");
                       if (to.deb.extension() != ".deb")
                           throw CLI::ValidationError("--deb", "expected a name that ends in .deb");
                   });
    command.text("--made", &PackageOptions::made, "a name",
                 "The name of a file that the game makes itself, so that it may be missing "
                 "(repeatable)");
    return command.runs(package);
}

}  // namespace fettle::program
