#pragma once
// Tweaks: what people edit while a game runs. Every one is journaled as it is made and survives the
// death of the process; it can be kept (written into the scene file it came from), made again in
// a later run, or dropped. docs/design/storage.md tells how.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/storage/export.h>
#include <fettle/property/storage/scene.h>
#include <fettle/property/tree.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

class GameFiles;

/// Where files about a game go when they are not the game's own: a folder of the user's for each
/// game ($XDG_DATA_HOME/fettle/..., else ~/.local/share/fettle/...). It is not created. Empty when
/// the user has no such place. `game`: a folder, or a .lua file.
std::filesystem::path user_folder(const std::filesystem::path& game);

/// What it is called: its folder, or its file where that is not main.lua.
std::string game_title(const std::filesystem::path& game);

struct Tweak {
    std::string path;      // "world.ball.mass"; of an instance that was created, deleted or moved
    std::string was, now;  // as printed, with units; "is ..." for a formula
    std::uint64_t step = 0;
    std::int64_t time = 0;   // s since 1970
    bool value = true;       // of a property; else of an instance
    bool earlier = false;    // made by an earlier run, and not kept then
    bool committed = false;  // in the journal
    bool kept = false;
    std::string kept_in;  // name of the file
};

/// What came of keeping, making again or dropping.
struct TweakReport {
    std::size_t count = 0;                // of the tweaks it was done to
    std::vector<std::string> files{};     // written
    std::vector<std::string> problems{};  // a line for each tweak it could not be done to
};

/// A tweak of an earlier run, in the words it is known by from one run to the next.
using TweakWords = std::vector<std::string>;

struct TweakOptions {
    GameFiles* files = nullptr;  // not owned; none: what is on the disk
    /// In place of a journal, for a run that is made again: what was open when it began. Nothing is
    /// journaled then.
    std::optional<std::vector<TweakWords>> earlier{};
};

class Tweaks {
  public:
    /// `game`: a folder with main.lua, or a .lua file. The journal is .fettle/NAME.tweaks.sqlite
    /// beside it, or in `user_folder` where that cannot be written; nothing is created before the
    /// first tweak. `warn` is told of files that cannot be used; nothing here throws because of
    /// one.
    Tweaks(Tree& tree, const std::filesystem::path& game,
           std::function<void(const std::string&)> warn, TweakOptions options = {});
    /// May come after the tree's; what was not journaled by then is lost.
    ~Tweaks();
    Tweaks(const Tweaks&) = delete;
    Tweaks& operator=(const Tweaks&) = delete;

    /// After each barrier of the tree: commits what was edited since the last one.
    void barrier();

    /// Of earlier runs first, then in the order they were made.
    std::vector<Tweak> list() const;
    /// How many tweaks of earlier runs are still open.
    std::size_t open_earlier() const;
    /// Those, for a run that is to be made again.
    std::vector<TweakWords> earlier_in_words() const;

    // `pattern` as for watching; one without stars that names an instance means everything of it.
    // Throw Error for a text that is no pattern.

    /// Writes them where their values came from: into the scene file, or for what a script made
    /// into NAME.tweaks.json beside the game.
    TweakReport keep(std::string_view pattern);
    /// Makes tweaks of earlier runs again, as edits of whoever writes now.
    TweakReport reapply(std::string_view pattern);
    /// Forgets them; values stay as they are.
    TweakReport drop(std::string_view pattern);

    /// A scene was loaded from that file: `instances` as `load_scene` told them; whether a script,
    /// and not the file, has given the topmost one its name.
    void scene_loaded(const std::filesystem::path& file,
                      const std::vector<SceneInstance>& instances, bool named_by_script = false);
    /// An instance found its place in the tree: what was kept of it, and of what is below it, is
    /// set.
    void placed(Handle instance);
    /// The game is set up: what was kept counts more than what its script has set meanwhile.
    void game_loaded();

    /// Of the journal; empty before the first commit.
    std::filesystem::path journal() const;

    struct FETTLE_STORAGE_PRIVATE State;

  private:
    std::unique_ptr<State> state_;
};

}  // namespace fettle::property

FETTLE_STORAGE_END
