#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include <fettle/property/storage/game_settings.h>

#include <command_line/for_shell.h>
#include <command_line/joined.h>
#include <command_line/subcommand.h>
#include <commands/commands.h>
#include <ending/exit_status.h>
#include <files/dashed_name.h>
#include <files/game_path.h>
#include <files/packed_game.h>
#include <files/settings.h>
#include <game/packed_modules.h>
#include <packing/folder_and_deb.h>
#include <packing/package_problems.h>
#include <packing/scene_problems.h>
#include <terminal/terminal.h>

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

/// A Debian package needs a name of at least two characters. A name without letters and digits of
/// ASCII has none, and "fettle" is the package of Fettle itself: then the name is made of the id.
std::string file_name_of(const std::string& name, const std::string& id) {
    std::string of_name = dashed_name(name), of_id = dashed_name(id);
    if (of_name.size() >= 2 && of_name != "fettle") return of_name;
    if (of_id.size() >= 2 && of_id != "fettle") return of_id;
    return of_name == "fettle" ? "fettle-game" : "game";
}

/// Digits, letters and dots, beginning with a digit. What follows a dash comes before the version
/// without it, as 1.0-beta before 1.0; Debian writes ~ for that.
std::string version_of(const std::string& version) {
    std::string plain;
    for (const char c : version) {
        const bool digit = c >= '0' && c <= '9';
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.';
        if (digit || (!plain.empty() && letter))
            plain += c;
        else if (!plain.empty() && plain.back() != '~' && (c == '-' || c == '_' || c == '+'))
            plain += c == '-' ? '~' : '.';
    }
    return plain.empty() ? "0.1" : plain;
}

/// "NAME <EMAIL>", which Debian requires.
std::string maintainer_of(const std::string& author) {
    constexpr std::string_view nobody = " <unknown@localhost>";
    const std::size_t open = author.find('<'), close = author.find('>');
    const bool has_address = open != std::string::npos && open > 0 && close == author.size() - 1 &&
                             author.find('@', open) < close &&
                             author.find('<', open + 1) == author.npos;
    std::string plain;
    for (const char c : author)
        if (c >= ' ' || static_cast<unsigned char>(c) >= 0x80)
            if (has_address || (c != '<' && c != '>')) plain += c;
    if (plain.empty()) plain = "unknown";
    return has_address ? plain : plain + std::string(nobody);
}

/// Says which facts of the game are others in the package.
void print_changes(const property::GameSettings& settings, const PackageFacts& facts) {
    if (!settings.version.empty() && settings.version != facts.version)
        print_line(
            "note: the version \"" + on_one_line(settings.version) + "\" is " + facts.version +
            " there: such a version has letters, digits, dots and ~, and begins with a digit");
    if (dashed_name(facts.name) != facts.id)
        print_line("note: the files of \"" + facts.name + "\" are called " + facts.id +
                   " there: such a name has at least two letters or digits, and is not \"fettle\"");
}

PackageFacts facts_of(const fs::path& game) {
    const property::GameSettings settings = read_settings(game);
    const fs::path folder = fs::absolute(game).lexically_normal();
    std::string name = settings.name;
    if (name.empty())
        name = (folder.has_filename() ? folder : folder.parent_path()).stem().string();
    return {.name = on_one_line(name),
            .id = file_name_of(name, settings.id),
            .version = version_of(settings.version),
            .maintainer = maintainer_of(settings.author),
            .icon = settings.icon};
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
    std::vector<std::string> problems = problems_of(packed, options.made);
    // A game with a missing file often cannot be loaded.
    if (problems.empty()) problems = scene_problems(game, packed);
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
    if (!options.linux_run.empty() || !options.deb.empty()) {
        libraries = bring_modules(game, files);
        print_changes(read_settings(game), facts);
    }
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
