#include <files/packed_game.h>

#include <fettle/property/storage/game_files.h>

#include <files/game_path.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

bool is_left_out(const fs::path& name) {
    if (*name.begin() == "tests") return true;
    for (const fs::path& part : name)
        if (part.string().starts_with('.')) return true;
    const std::string last = name.filename().string();
    for (const std::string_view ending : {".tweaks.json", ".sqlite", ".sqlite-wal", ".sqlite-shm",
                                          archive_ending.data(), ".deb", ".tar.gz", ".recording"})
        if (last.ends_with(ending)) return true;
    return false;
}

}  // namespace

ArchiveFiles packed_game(const fs::path& game) {
    const fs::path folder = folder_of(game);
    property::GameFiles reader;
    reader.stay_below(folder);
    ArchiveFiles files;
    for (fs::recursive_directory_iterator it(folder), end; it != end; ++it) {
        const fs::path name = it->path().lexically_relative(folder);
        if (is_left_out(name)) {
            if (it->is_directory() && !it->is_symlink()) it.disable_recursion_pending();
            continue;
        }
        if (it->is_directory()) continue;
        require_file(it->path(), "a file of the game");
        files[name.generic_string()] = reader.read(it->path());
    }
    if (!fs::is_directory(game)) {  // one .lua file: a package begins with main.lua
        const std::string name = game.filename().string();
        files = {{"main.lua", reader.read(game)}};
    }
    return files;
}

}  // namespace fettle::program
