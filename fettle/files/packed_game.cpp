#include <files/packed_game.h>

#include <algorithm>
#include <array>

#include <fettle/property/storage/game_files.h>

#include <files/game_path.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

/// Files that no game reads: those that Fettle and other programs make beside it, the sources of
/// pictures and maps, and copies of editors.
constexpr std::array never_packed{std::string_view("*.sqlite"),
                                  std::string_view("*.sqlite-wal"),
                                  std::string_view("*.sqlite-shm"),
                                  std::string_view("*.deb"),
                                  std::string_view("*.tar.gz"),
                                  std::string_view("*.recording"),
                                  std::string_view("*.psd"),
                                  std::string_view("*.xcf"),
                                  std::string_view("*.kra"),
                                  std::string_view("*.ase"),
                                  std::string_view("*.aseprite"),
                                  std::string_view("*.blend"),
                                  std::string_view("*.tiled-project"),
                                  std::string_view("*.tiled-session"),
                                  std::string_view("*~"),
                                  std::string_view("*.bak"),
                                  std::string_view("*.orig"),
                                  std::string_view("Thumbs.db"),
                                  std::string_view("desktop.ini"),
                                  std::string_view("__MACOSX")};

/// `*` stands for any characters but a slash, `?` for one.
bool matches(std::string_view pattern, std::string_view name) {
    std::size_t star = std::string_view::npos, after = 0, p = 0, n = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            after = n;
        } else if (p < pattern.size() &&
                   (pattern[p] == name[n] || (pattern[p] == '?' && name[n] != '/'))) {
            ++p, ++n;
        } else if (star != std::string_view::npos && name[after] != '/') {
            p = star + 1;
            n = ++after;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

/// Whether a file or a folder of that name is left out: by its name alone, or by its whole path if
/// the pattern has a slash.
bool is_named_by(std::string_view pattern, const fs::path& name) {
    while (pattern.ends_with('/')) pattern.remove_suffix(1);
    if (pattern.starts_with("./")) pattern.remove_prefix(2);
    const std::string whole = name.generic_string(), last = name.filename().string();
    return matches(pattern, pattern.find('/') == std::string_view::npos ? last : whole);
}

bool is_left_out(const fs::path& name, const std::vector<std::string>& exclude) {
    const std::string last = name.filename().string();
    const auto named = [&](std::string_view pattern) { return is_named_by(pattern, name); };
    return name == "tests" || last.starts_with('.') || last.ends_with(archive_ending) ||
           std::ranges::any_of(never_packed, named) || std::ranges::any_of(exclude, named);
}

/// Whether `fettle package --linux` has made the folder.
bool is_package(const fs::path& folder) {
    return fs::is_regular_file(folder / "bin/fettle") && fs::is_directory(folder / "share/fettle");
}

}  // namespace

PackedGame packed_game(const fs::path& game, const std::vector<std::string>& exclude) {
    const fs::path folder = folder_of(game);
    property::GameFiles reader;
    reader.stay_below(folder);
    PackedGame packed;
    if (!fs::is_directory(game)) {
        // A package begins with main.lua, and the edits that were kept lie beside it.
        packed.one_file = true;
        packed.files["main.lua"] = reader.read(game);
        const fs::path kept = fs::path(game).replace_extension(".tweaks.json");
        if (fs::exists(kept)) packed.files["main.tweaks.json"] = reader.read(kept);
        return packed;
    }
    for (fs::recursive_directory_iterator it(folder), end; it != end; ++it) {
        const fs::path name = it->path().lexically_relative(folder);
        const bool is_folder = it->is_directory() && !it->is_symlink();
        if (is_left_out(name, exclude) || (is_folder && is_package(it->path()))) {
            if (is_folder) it.disable_recursion_pending();
            if (!name.filename().string().starts_with('.'))
                packed.left_out.push_back(name.generic_string() + (is_folder ? "/" : ""));
            continue;
        }
        if (it->is_directory()) continue;
        require_file(it->path(), "a file of the game");
        packed.files[name.generic_string()] = reader.read(it->path());
    }
    std::ranges::sort(packed.left_out);
    return packed;
}

}  // namespace fettle::program
