#pragma once
// Tweaks: the edits of people while a game runs. Each is written to the journal when it is made and
// survives a crash of the process. It can be kept (written into the scene file of its value),
// applied again in a later run, or dropped. docs/design/storage.md has the details.

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

/// Folder for files about a game that are not part of the game: a folder of the user for each game
/// ($XDG_DATA_HOME/fettle/..., else ~/.local/share/fettle/...). It is not created. Empty if the
/// user has no such folder. `game`: a folder, or a .lua file.
std::filesystem::path user_folder(const std::filesystem::path& game);

/// The journal of a game's tweaks: the one that exists, else the file that the first tweak would
/// make. Beside the game in `.fettle`, or in `user_folder(game)` if nothing can be written there.
std::filesystem::path journal_of(const std::filesystem::path& game);

/// Title of a game: the name of its folder, or of its file if that is not main.lua.
std::string game_title(const std::filesystem::path& game);

struct Tweak {
    std::string path;      // "world.ball.mass", or path of an instance; before a move
    std::string there;     // the same after a move
    std::string was, now;  // as printed, with units; "is ..." for a formula
    std::uint64_t step = 0;
    std::int64_t time = 0;   // s since 1970
    bool value = true;       // true: of a property; false: of an instance
    bool earlier = false;    // made and not kept by an earlier run
    bool committed = false;  // in the journal
    bool kept = false;
    std::string kept_in;  // name of the file
};

/// Result of keeping, applying again or dropping tweaks.
struct TweakReport {
    std::size_t count = 0;                // number of tweaks without a problem
    std::vector<std::string> files{};     // written
    std::vector<std::string> problems{};  // one line for each tweak with a problem
    std::vector<std::string> notes{};     // which instances the files change, where it is not clear
};

/// A tweak of an earlier run as words, which identify it in every run.
using TweakWords = std::vector<std::string>;

struct TweakOptions {
    GameFiles* files = nullptr;  // not owned; null: the files on the disk
    /// In place of a journal, for a replay: the open tweaks at the start of the recorded run.
    /// Nothing is written to a journal then.
    std::optional<std::vector<TweakWords>> earlier{};
    /// Why tweaks cannot be kept: `keep` throws Error(rejected) with this text. "": they can.
    std::string not_kept_because{};
};

class Tweaks {
  public:
    /// `game`: a folder with main.lua, or a .lua file. The journal is .fettle/NAME.tweaks.sqlite
    /// beside it, or in `user_folder` if that cannot be written; nothing is created before the
    /// first tweak. `warn` receives errors of files that cannot be used; no member throws because
    /// of one.
    Tweaks(Tree& tree, const std::filesystem::path& game,
           std::function<void(const std::string&)> warn, TweakOptions options = {});
    /// May be called after the tree's destructor; edits that are not in the journal by then are
    /// lost.
    ~Tweaks();
    Tweaks(const Tweaks&) = delete;
    Tweaks& operator=(const Tweaks&) = delete;

    /// Call after each barrier of the tree: writes the edits since the last one to the journal.
    void barrier();

    /// Tweaks of earlier runs first, then the others in the order of the edits.
    std::vector<Tweak> list() const;
    /// Number of open tweaks of earlier runs.
    std::size_t open_earlier() const;
    /// These tweaks, for a recording.
    std::vector<TweakWords> earlier_in_words() const;

    // After the end of the tree the functions below throw Error(deleted).
    // `pattern` as for watching; a pattern without stars that names an instance means all tweaks of
    // it. Throw Error for a text that is not a pattern.

    /// Writes tweaks where their values came from: into the scene file, or, for instances made by a
    /// script, into NAME.tweaks.json beside the game.
    /// If several instances come from the scene file, into the same file as those of a script, for
    /// one instance only.
    TweakReport keep(std::string_view pattern);
    /// Writes them into scene files in any case: every instance that comes from such a file has
    /// the change when the file is loaded again. Includes values that were kept for one instance
    /// in this run.
    TweakReport keep_for_all(std::string_view pattern);
    /// The number of other instances in the tree that come from the scene file of the instance; 0
    /// if it comes from none.
    std::size_t others_of_scene(Handle instance) const;
    /// Applies tweaks of earlier runs again, as edits of the current writer.
    TweakReport reapply(std::string_view pattern);
    /// Drops tweaks; values do not change.
    TweakReport drop(std::string_view pattern);

    /// Must be called after a scene was loaded from that file. `instances`: the list from
    /// `load_scene`. `named_by_script`: a script, not the file, gave the name of the topmost
    /// instance.
    void scene_loaded(const std::filesystem::path& file,
                      const std::vector<SceneInstance>& instances, bool named_by_script = false);
    /// Must be called when an instance got its place in the tree: sets the kept values of it and of
    /// the instances below it.
    void placed(Handle instance);
    /// Must be called when the game is loaded: kept values replace the values that its script has
    /// set.
    void game_loaded();

    // While the script of the game is loaded again. The instances are part of the game.

    /// The place in the file of kept tweaks that sets the property, whatever the script gives:
    /// "main.tweaks.json:4"; "" if it does not.
    std::string set_by_file(Handle instance, const Property& property) const;
    /// Whether this run has kept that value in the scene file of the instance, or has written the
    /// instance into it: the file gives what is there already.
    bool has_kept(Handle instance, const Property& property, const Value& value) const;
    bool has_kept(Handle instance) const;
    /// Whether an edit of the property is listed and holds now.
    bool has_edit(Handle instance, const Property& property) const;
    /// Must be called when the script has given the property another value than before: it takes
    /// the place of an edit, and later edits start from it. Returns the edit that it replaces,
    /// "2 → 7 kg"; "" if there was none.
    std::string given_again(Handle instance, const Property& property);
    /// Must be called when the default of a property with an edit has changed.
    void default_changed(Handle instance, const Property& property);
    /// Must be called before an instance is deleted that the script does not make any more, or if
    /// it was deleted before: drops its edits, and those of all below it. Returns their number.
    std::size_t made_no_more(const std::string& path);
    /// Must be called when the script has replaced an instance by one of another class. Makes the
    /// edits of the former one and of those below it again for which `same` is true: the script
    /// gives the property what it gave before. Drops the others, and returns their number.
    std::size_t replaced(Handle instance, const std::function<bool(Handle, const Property&)>& same);

    /// Whether they are the tweaks of that tree, and it lives.
    bool are_of(const Tree& tree) const;
    /// Path of the journal; empty before the first commit.
    std::filesystem::path journal() const;

    struct FETTLE_STORAGE_PRIVATE State;

  private:
    FETTLE_STORAGE_PRIVATE State& usable() const;
    std::unique_ptr<State> state_;
};

}  // namespace fettle::property

FETTLE_STORAGE_END
