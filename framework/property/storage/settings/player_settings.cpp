#include <nlohmann/json.hpp>

#include <fettle/property/storage/game_settings.h>
#include <fettle/property/storage/scene.h>
#include <fettle/property/storage/tweaks.h>

#include <files/durable_file.h>
#include <files/game_folders.h>

namespace fettle::property {

namespace fs = std::filesystem;
using SettingsJson = nlohmann::ordered_json;

namespace {

constexpr std::size_t largest_settings = std::size_t{1} << 20;  // bytes

fs::path settings_file(const fs::path& folder) {
    return folder / "settings.json";
}

/// The object in the file; an empty one if it is missing or damaged.
SettingsJson settings_in(const fs::path& folder) {
    std::error_code error;
    if (folder.empty() || !fs::exists(settings_file(folder), error)) return SettingsJson::object();
    try {
        SettingsJson whole =
            SettingsJson::parse(read_file(settings_file(folder), largest_settings), nullptr, false);
        return whole.is_object() ? whole : SettingsJson::object();
    } catch (const FileError&) {
        return SettingsJson::object();
    }
}

}  // namespace

fs::path player_folder(const fs::path& game, const std::string& id) {
    if (id.empty()) return user_folder(game);
    const fs::path data = fettle_data();
    return data.empty() ? data : data / "games" / id;
}

PlayerSettings read_player_settings(const fs::path& folder) {
    const SettingsJson whole = settings_in(folder);
    PlayerSettings settings;
    if (const auto found = whole.find("fullscreen"); found != whole.end() && found->is_boolean())
        settings.fullscreen = found->get<bool>();
    return settings;
}

void write_player_settings(const fs::path& folder, const PlayerSettings& settings) {
    if (folder.empty()) return;
    SettingsJson whole = settings_in(folder);
    if (settings.fullscreen) whole["fullscreen"] = *settings.fullscreen;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw FileError(folder, "cannot be made: " + error.message());
    replace_file(settings_file(folder), whole.dump(2) + "\n");
}

}  // namespace fettle::property
