#pragma once
// The file `game.json` of a game: name, version, window and other settings that are needed before
// its scripts run. Also the settings that a player has made, in a file that the next run reads.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/storage/export.h>
#include <fettle/property/value.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

class GameFiles;

/// Whether a game has the console: always, in developer runs only, or never.
enum class ConsoleUse : std::uint8_t { on, developer, off };

/// Settings of the window in `game.json`; empty: the file does not have it.
struct WindowSettings {
    static constexpr double largest = 16384;  // px, of each side
    std::optional<std::string> title{};
    std::optional<Vec2> size{};  // px
    std::optional<bool> fullscreen{};
    std::optional<bool> resizable{};
    std::optional<bool> vsync{};
};

/// How the names of images end that an icon may be.
inline constexpr std::array<std::string_view, 5> icon_endings = {".png", ".jpg", ".jpeg", ".bmp",
                                                                 ".tga"};

struct GameSettings {
    static constexpr std::int64_t most_memory = 1'000'000;  // MB

    std::string name{};     // shown to players
    std::string id{};       // names the player's folder for the game; "" if it has none
    std::string version{};  // of the game
    std::string author{};
    std::string icon{};                // an image below the game's folder
    std::string icon_at{"game.json"};  // the place of its name, for messages: "game.json:2:11"
    std::string fettle{};              // the version of Fettle that the game was written for
    ConsoleUse console = ConsoleUse::on;
    /// Whether enlarged images are smooth, for instances whose `smooth` was not set; empty: the
    /// default of their class.
    std::optional<bool> smooth{};
    std::optional<std::uint64_t> seed{};  // of random()
    bool random_seed = false;             // each run in a window has a seed of its own
    /// MB that the scripts may use, and MB of what they add to the tree; empty: the default.
    std::optional<std::uint64_t> memory{};
    WindowSettings window{};
    /// Names of files that packages leave out; `*` and `?` stand for other characters.
    std::vector<std::string> package_exclude{};

    /// Title of the window: that of the window, else the name; "" if there is neither.
    std::string title() const { return window.title.value_or(name); }
};

/// Reads `game.json` in the folder of `game`; without the file all settings have their defaults.
/// `program`: the version of this program. Throws SceneError for a text that is not JSON, unknown
/// keys (with the nearest one), values of another type or out of range, and for a game that needs a
/// newer version. Throws FileError.
GameSettings read_game_settings(GameFiles& files, const std::filesystem::path& game,
                                std::string_view program);

/// The same from a text; `file_name` appears in messages.
GameSettings game_settings(std::string text, const std::string& file_name,
                           std::string_view program);

/// Reads `modules.json` in the folder of a game, and calls `take` for each module that it names;
/// without the file there is none. Throws SceneError for a text that is not JSON, for other
/// content, and in the place of an exception of `take`; and FileError.
void read_module_list(GameFiles& files, const std::filesystem::path& folder,
                      const std::function<void(const std::string& module)>& take);

/// The folder for a player's data of a game: saves, store, settings. It depends on the `id` and not
/// on the folder of the game; without an id it is `user_folder(game)`. It is not created. Empty if
/// the user has no folder for data.
std::filesystem::path player_folder(const std::filesystem::path& game, const std::string& id);

/// Settings that the player has made in earlier runs; empty: never made.
struct PlayerSettings {
    std::optional<bool> fullscreen{};
};

/// Reads `settings.json` in that folder; a file that is missing or damaged has no settings.
PlayerSettings read_player_settings(const std::filesystem::path& folder);

/// Writes it, and creates the folder. Other keys of the file stay. Throws FileError.
void write_player_settings(const std::filesystem::path& folder, const PlayerSettings& settings);

}  // namespace fettle::property

FETTLE_STORAGE_END
