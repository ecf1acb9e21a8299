#include <files/game_folders.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include <fettle/property/storage/tweaks.h>
#include <fettle/property/text_hash.h>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

fs::path user_data() {
    const char* data = std::getenv("XDG_DATA_HOME");
    if (data != nullptr && data[0] == '/') return data;  // XDG: ignore relative paths
    const char* home = std::getenv("HOME");
    if (home != nullptr && home[0] == '/') return fs::path(home) / ".local" / "share";
    return {};
}

}  // namespace

fs::path game_folder(const fs::path& game) {
    std::error_code error;
    const fs::path folder = fs::is_directory(game, error) ? game : game.parent_path();
    const fs::path whole = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
    return error ? folder : whole;
}

std::string game_name(const fs::path& game) {
    std::error_code error;
    return fs::is_directory(game, error) ? "main" : game.stem().string();
}

std::string game_title(const fs::path& game) {
    const std::string name = game_name(game);
    return name == "main" ? game_folder(game).filename().string() : name;
}

fs::path fettle_data() {
    const fs::path data = user_data();
    return data.empty() ? data : data / "fettle";
}

fs::path user_folder(const fs::path& game) {
    const fs::path data = fettle_data();
    if (data.empty()) return {};
    std::string readable;
    for (const char c : game_title(game))
        readable += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' ? c : '_';
    // File systems allow names of 255 bytes.
    readable.resize(std::min<std::size_t>(readable.size(), 200));
    // The hash separates the folders of games with the same name.
    const fs::path whole = game_folder(game) / game_name(game);
    return data / (readable + "-" + text_hash_digits(whole.string()));
}

std::vector<fs::path> journal_folders(const fs::path& game) {
    std::vector<fs::path> folders{game_folder(game) / ".fettle"};
    if (const fs::path own = user_folder(game); !own.empty()) folders.push_back(own);
    return folders;
}

fs::path journal_of(const fs::path& game) {
    const std::string name = game_name(game) + ".tweaks.sqlite";
    const std::vector<fs::path> folders = journal_folders(game);
    std::error_code error;
    for (const fs::path& folder : folders)
        if (fs::exists(folder / name, error)) return folder / name;
    const bool beside = ::faccessat(AT_FDCWD, game_folder(game).c_str(), W_OK, AT_EACCESS) == 0;
    return (beside ? folders.front() : folders.back()) / name;
}

}  // namespace fettle::property
