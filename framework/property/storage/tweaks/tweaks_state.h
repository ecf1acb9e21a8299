#pragma once
// What the journal of tweaks knows while a game runs, for the files that implement it.

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fettle/property/edits.h>
#include <fettle/property/path.h>
#include <fettle/property/storage/game_files.h>
#include <fettle/property/storage/tweaks.h>

#include <kept/instance_moves.h>
#include <kept/kept_tweaks.h>
#include <scenes/image.h>
#include <scenes/scene_origins.h>
#include <tweaks/journal.h>

namespace fettle::property {

struct Tweaks::State : EditObserver {
    using Kind = JournalRow::Kind;
    using RowState = JournalRow::State;

    /// A tweak of this run. Known by what it is about, so that editing a property twice is one
    /// tweak, and undoing it is none.
    struct Entry {
        JournalRow row;
        Image was, now;     // of a value
        std::string scene;  // of a new instance, or of one that is back
        Handle handle;
        Symbol property;
        bool gone = false;          // a person deleted what it is about, or took it back
        Entry* with = nullptr;      // a deletion: of which other one it is a part
        Entry* deletion = nullptr;  // which deletion made it void
        bool committed = false;     // the journal has it
        bool dirty = false;
        std::vector<std::pair<Handle, Symbol>> inside;  // of a creation: edited below it since
        std::string taken_out;  // of a deletion that was kept: what it took out of the file
    };

    static std::uint64_t key(Handle handle) {
        return std::uint64_t{handle.generation} << 32 | handle.index;
    }

    static std::string key_of(Kind kind, const std::string& instance, const std::string& property) {
        return std::to_string(static_cast<int>(kind)) + instance + '\n' + property;
    }

    State(Tree& tree, const std::filesystem::path& game, Journal::Warn warn, TweakOptions options);
    ~State() override;
    std::size_t drop_left_aside(std::string_view pattern);
    void take_earlier(std::vector<JournalRow> rows);
    void refresh_earlier();

    // tweaks.cpp: what is edited
    void edited(Handle instance, const Property& property, const CellState& before) override;
    void born(Handle instance) override;
    void dying(Handle instance) override;
    void moved(Handle instance, Handle old_parent, const std::string& old_name) override;
    bool attached(Handle instance) const;
    bool is_fresh(Handle instance) const;
    Entry* created_above(Handle instance) const;
    Entry& entry(Kind kind, const std::string& instance, const std::string& property,
                 Handle handle);
    Entry& add_entry(Kind kind, const std::string& instance, Handle handle);
    void touch(Entry& entry);
    void name_deleted(Image& image, const Value& value) const;
    void bury(Handle instance, Handle parent, const std::string& path);
    bool taken_out_of_creation(const std::string& name, Handle parent);
    void edited_again(Handle instance, const Property& property);
    void back_in_time(Handle instance);
    Entry& add_deletion(Handle instance, const std::string& path, const std::string& home);
    void make_void(const std::string& path, const std::string& home, Entry& deletion);
    void revive(const Entry& deletion);

    // tweaks_moved.cpp
    bool moved_with_creation(Handle instance, Handle old_parent, const std::string& old_name,
                             const std::string& old_path);
    void rekey(Entry& its, const std::string& path);
    void repath(Handle instance, const std::string& old_path);
    /// Moves of this run that are in no file.
    InstanceMoves moves() const;
    std::string home_of(Handle instance) const;
    bool is_home_of_another(const std::string& home, Handle instance) const;
    bool is_home(const Entry& move) const;
    /// Whether what has that home path is deleted in no scene, but by the file of kept tweaks.
    bool deleted_by_path(const std::string& home) const;
    void find_again(Entry& its);
    bool rename_scene(Entry& made) const;
    /// Files call instances otherwise now.
    void homes_changed(const NewPath& now_at);
    void steps_renamed(const std::filesystem::path& file, const SceneOrigins::Names& names);
    /// A row of an earlier run was kept: this run's tweak of the same value begins there.
    void file_says(const JournalRow& row);
    void tell_origin(Entry& entry, Handle instance) const;

    // tweaks_commit.cpp: what becomes rows
    void barrier();
    void settle_fresh(Handle moving = {});
    void settle_one(Handle instance);
    bool settle_undeleted(Handle instance);
    bool undelete(Entry& deletion);
    std::string scene_of_new(Handle top, std::vector<std::string>* warnings) const;
    SceneSteps steps_below(Handle instance, Handle top) const;
    void restored(Handle instance, Entry& deletion);
    void refresh(Entry& entry);
    void refresh_created(Entry& entry);
    bool visible(const Entry& entry) const;
    template <class WithPaths>
    std::string without_deleted(const std::string& text, WithPaths with_paths) const;
    /// In the texts of tweaks, of an instance that was deleted: another one may get its path.
    static std::string path_of_deleted(Handle instance) {
        return path_below("game", impossible_name(std::to_string(key(instance))));
    }
    static bool is_of_deleted(const std::string& path) { return path.starts_with(R"(game["\000)"); }
    /// In what tweaks name, one path in the place of another.
    void rename_mentions(const std::string& from, const std::string& to);
    void name_again(const Entry& made, const std::string& path);
    void commit();
    void tell_lost() const;

    /// Without links, where the file is one of the game's own: what was loaded from elsewhere is
    /// not changed.
    std::optional<std::filesystem::path> own_file(const std::filesystem::path& named) const;

    // tweaks.cpp, keep.cpp: what is done to them
    std::vector<JournalRow*> matching(std::string_view pattern, bool earlier_only);
    TweakReport keep(std::string_view pattern);
    TweakReport reapply(std::string_view pattern);
    TweakReport drop(std::string_view pattern);
    void set_state(JournalRow& row, RowState state);
    Entry& entry_of(const JournalRow& row) {
        return *entries[static_cast<std::size_t>(row.number) - 1];
    }
    Entry* entry_about(const JournalRow& row, Handle instance) const;
    void settle_reapplied();

    Tree& tree;
    std::weak_ptr<const Tree*> tree_life;
    std::filesystem::path folder;  // of the game
    Journal::Warn warn;
    GameFiles own_files;
    GameFiles& files;
    std::unique_ptr<Journal> journal;  // none: what is done is done again
    KeptTweaks kept;
    SceneOrigins origins;

    std::vector<std::unique_ptr<Entry>> entries;  // number 1 first
    std::unordered_map<std::string, Entry*> by_key;
    std::vector<Entry*> dirty;
    std::vector<Handle> fresh;  // created since the last barrier, in order; some have gone again
    std::unordered_set<std::uint64_t> is_in_fresh;
    // By instance.
    std::unordered_map<std::uint64_t, Entry*> created, deleted, restorations, moved_entries;
    std::vector<JournalRow> earlier;   // of earlier runs
    std::vector<JournalRow*> changed;  // of those, to be put again
    /// Rows of earlier runs that were made again, with the tweaks of this run that they became.
    std::vector<std::pair<JournalRow*, Entry*>> reapplied;
    std::vector<JournalRow> left_aside;  // of earlier runs: they say no tweak
    std::vector<JournalRow> removed;     // of those, dropped
    std::int64_t last_number = 0;
    std::string last_failure;  // told once
    int rest = 0;              // barriers until a failed commit is tried again
};

/// Whether a tweak is meant by a pattern.
class TweakPattern {
  public:
    explicit TweakPattern(std::string_view text);
    bool matches(const JournalRow& row) const;

  private:
    Pattern pattern_;
    bool whole_instances_;
};

/// A row, for a recording of the run; and as that of another run, which cannot be written.
TweakWords words_of(const JournalRow& row);
/// Throws Error for words that no row has.
JournalRow row_of(const TweakWords& words);

/// Why a row, of whoever's making, is not what a tweak is: a path that is none, a value that is
/// none
/// ...; "" when it is one.
std::string problem_of(const JournalRow& row);

/// The text, or its first bytes, whole characters of them, and "...".
std::string shortened(const std::string& text, std::size_t longest);

/// "world.ball.mass", or the path of the instance.
std::string path_of(const JournalRow& row);

}  // namespace fettle::property
