#include <files/recorded_files.h>

#include <fstream>
#include <set>
#include <string_view>

#include <files/game_path.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view own_file_prefix =
    "fettle:";  // prefix of the names of Fettle's own files

/// Name of the file in a recording. These files are not in the game's folder, nor are they Fettle's
/// own.
std::string recorded_name(KeptFile which) {
    return which == KeptFile::store ? "fettle:store" : "fettle:preferences";
}

fs::path whole_folder_of(const fs::path& game) {
    std::error_code error;
    return fs::weakly_canonical(folder_of(game), error);
}

/// Returns the path of `file` relative to `folder`; "" if it is not below the folder.
std::string name_below(const fs::path& file, const fs::path& folder) {
    if (folder.empty()) return {};
    const fs::path relative = file.lexically_relative(folder);
    if (relative.empty() || *relative.begin() == "..") return {};
    return relative.generic_string();
}

fs::path path_of(const std::string& name, const fs::path& game) {
    if (name.starts_with(own_file_prefix)) return assets() / name.substr(own_file_prefix.size());
    const fs::path path(name);
    return path.is_absolute() ? path : whole_folder_of(game) / path;
}

}  // namespace

app::RunFile recorded(const property::GameFiles::FileState& state, const fs::path& game) {
    std::string name = name_below(state.file, whole_folder_of(game));
    if (name.empty()) {
        name = name_below(state.file, assets());
        name = name.empty() ? state.file.generic_string() : std::string(own_file_prefix) + name;
    }
    return {.name = std::move(name),
            .checksum = state.checksum,
            .overwritten = state.overwritten,
            .content = state.content};
}

std::string name_of(KeptFile which) {
    return which == KeptFile::store ? "store.json" : "preferences.json";
}

app::RunFile recorded_text(KeptFile which, const std::string& text) {
    return {.name = recorded_name(which), .overwritten = true, .content = text};
}

std::string recorded_text(KeptFile which, const app::Recording& recording) {
    for (const app::RunFile& file : recording.files())
        if (file.name == recorded_name(which)) return file.content.value_or("");
    return {};
}

std::vector<std::string> changed_since(const app::Recording& recording, const fs::path& game) {
    std::set<std::string> overwritten;
    for (const app::RunFile& file : recording.files())
        if (file.overwritten) overwritten.insert(file.name);
    std::vector<std::string> changed;
    for (const app::RunFile& file : recording.files()) {
        if (overwritten.contains(file.name)) continue;
        const auto now = property::file_checksum(path_of(file.name, game));
        if (now == file.checksum) continue;
        const char* const how = !now ? " is missing" : !file.checksum ? " is new" : " differs";
        changed.push_back(file.name + how);
    }
    return changed;
}

void require_recording_or_nothing(const fs::path& file) {
    constexpr std::string_view beginning = "fettle-recording ";
    std::ifstream in(file, std::ios::binary);
    std::string found(beginning.size(), '\0');
    in.read(found.data(), static_cast<std::streamsize>(found.size()));
    if (in.gcount() > 0 && found != beginning)
        throw FileError(file.string() +
                        ": this file is not a recording, and is not overwritten by one");
}

fs::path next_recording(const fs::path& file) {
    for (int number = 2;; ++number) {
        fs::path next = file;
        next.replace_filename(file.stem().string() + "-" + std::to_string(number) +
                              file.extension().string());
        std::error_code error;
        if (!fs::exists(fs::symlink_status(next, error))) return next;
    }
}

void use_recorded_content(const app::Recording& recording, const fs::path& game,
                          property::GameFiles& files) {
    files.stay_in_memory();
    for (const app::RunFile& file : recording.files())
        if (file.overwritten) files.put(path_of(file.name, game), file.content);
}

}  // namespace fettle::program
