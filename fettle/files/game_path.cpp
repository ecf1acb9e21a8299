#include <files/game_path.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

#include <fettle/property/storage/game_files.h>

#include <files/archive.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

// Finds a file of Fettle itself: installed beside the program, in a folder of `share`, or in the
// source folder of the build.
fs::path find_own_file(const fs::path& file, const char* share, const char* in_sources) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& folder :
         {program / "../share" / share, fs::path(FETTLE_SOURCE_DIR) / in_sources})
        if (fs::exists(folder / file, error)) return fs::weakly_canonical(folder / file);
    return {};
}
fs::path find_own_file(const fs::path& file) {
    return find_own_file(file, "fettle", "");
}

}  // namespace

fs::path gallery() {
    const fs::path main = find_own_file("scripts/gallery/main.lua");
    if (main.empty())
        throw FileError("the gallery is missing from the installation; name a game to run");
    return main.parent_path();
}

fs::path assets() {
    return find_own_file("assets");
}

fs::path guide() {
    return find_own_file("guide/README.md", "doc/fettle", "docs");
}

fs::path installed_modules() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path beside = program / "../lib/fettle/modules";  // in the build folder
    const fs::path installed = program / FETTLE_LIBRARIES / "fettle/modules";
    return fs::weakly_canonical(fs::exists(installed, error) ? installed : beside, error);
}

namespace {

/// Returns for example "a pipe" if `path` exists and is not a regular file; null otherwise.
const char* kind_unless_regular(const fs::path& path) {
    std::error_code error;
    switch (fs::status(path, error).type()) {
        case fs::file_type::directory:
            return "a folder";
        case fs::file_type::fifo:
            return "a pipe";
        case fs::file_type::socket:
            return "a socket";
        case fs::file_type::block:
        case fs::file_type::character:
            return "a device";
        default:
            return nullptr;
    }
}

}  // namespace

void require_file(const fs::path& file, const char* expected) {
    if (const char* const kind = kind_unless_regular(file))
        throw FileError(file.string() + ": expected " + expected + ", found " + kind);
}

void write_file(const fs::path& file, const std::string& content) {
    std::ofstream out(file, std::ios::binary);
    out << content;
    out.close();
    if (!out) throw FileError(file.string() + ": cannot be written: " + std::strerror(errno));
}

fs::path found_game(const fs::path& named) {
    constexpr const char* script = "a file with a script";
    std::error_code error;
    if (!fs::exists(named, error)) {
        const bool link = fs::is_symlink(named, error);
        throw FileError(named.string() +
                        (link ? ": this link leads nowhere" : ": there is no such file or folder"));
    }
    if (!fs::is_directory(named, error)) {
        require_file(named, script);
        if (is_archive(named)) {
            if (read_archive(named, "main.lua").empty())
                throw FileError(named.string() +
                                ": this archive is not a game, it has no main.lua");
            return fs::canonical(named) / "main.lua";
        }
        return fs::is_symlink(named, error) ? fs::canonical(named) : named;
    }
    const fs::path main = named / "main.lua";
    if (!fs::exists(main, error)) {
        const bool link = fs::is_symlink(main, error);
        throw FileError(link ? main.string() + ": this link leads nowhere"
                             : named.string() + ": this folder is not a game, it has no main.lua");
    }
    require_file(main, script);
    return named;
}

fs::path folder_of(const fs::path& game) {
    std::error_code error;
    const fs::path folder = fs::is_directory(game, error) ? game : game.parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

namespace {

bool has_word(std::string_view text, std::string_view word) {
    const auto in_word = [&](std::size_t at) {
        return at < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
    };
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + 1))
        if ((at == 0 || !in_word(at - 1)) && !in_word(at + word.size())) return true;
    return false;
}

bool file_has_word(property::GameFiles& files, const fs::path& file, std::string_view word) {
    try {
        return has_word(files.read(file), word);
    } catch (const property::FileError&) {
        return false;  // a pipe, or larger than a script may be: loading it reports the error
    }
}

}  // namespace

bool mentions_quit(const fs::path& game, std::span<const std::string> chunks) {
    constexpr std::string_view word = "quit";
    for (const std::string& chunk : chunks)
        if (has_word(chunk, word)) return true;
    if (const fs::path archive = archive_of(game); !archive.empty()) {
        for (const auto& [name, content] : read_archive(archive))
            if (name.ends_with(".lua") && has_word(content, word)) return true;
        return false;
    }
    std::error_code error;
    property::GameFiles files;
    files.stay_below(folder_of(game));
    if (!fs::is_directory(game, error)) return file_has_word(files, game, word);
    for (fs::recursive_directory_iterator it(game, error), end; it != end; it.increment(error)) {
        if (error) break;
        if (it->path().extension() == ".lua" && file_has_word(files, it->path(), word)) return true;
    }
    return false;
}

}  // namespace fettle::program
