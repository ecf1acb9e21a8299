#pragma once
// State of the tweaks while a game runs; shared by the files that implement it.

#include <deque>
#include <map>
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

#include <scenes/image.h>
#include <scenes/scene_origins.h>
#include <scenes/scene_text.h>
#include <tweaks/fresh_instances.h>
#include <tweaks/journal.h>
#include <tweaks_file/instance_moves.h>
#include <tweaks_file/kept_tweaks.h>

namespace fettle::property {

struct Tweaks::State : EditObserver {
    using Kind = JournalRow::Kind;
    using RowState = JournalRow::State;

    struct Entry;
    /// What a tweak is at a moment of the game. Going back in time restores it.
    struct EntryState {
        JournalRow row;
        std::int64_t version = 0;  // number of its last change, counted over all tweaks
        Image was, now;            // for a value
        // For a value: the one that a script gave when the game was loaded, if nothing has written
        // another one before the edit.
        std::optional<Image> given;
        std::string scene;  // for a new or restored instance
        // For a new instance: the values of its scene when it was made, with later edits by people.
        // A scene written now would also contain changes by the simulation.
        SceneValues values;
        Handle handle;
        Symbol property;
        bool gone = false;          // its object was deleted, or the edit was undone
        Entry* with = nullptr;      // for a deletion: the other deletion that it is part of
        Entry* deletion = nullptr;  // the deletion that made it void
        std::vector<std::pair<Handle, Symbol>> inside;  // of a creation: edited cells
        std::vector<Entry*> voided;  // entries whose `deletion` or `with` is or was this one
    };
    struct SavedEntry {
        EntryState state;
        std::size_t renames;  // number of `renames` that it contains
    };
    /// A tweak of this run. It is identified by its object, so editing a property twice is one
    /// tweak, and undoing the edit removes it. Its own members are true at all moments.
    struct Entry : EntryState {
        bool away = false;  // its edit was made in another branch or later, so it does not hold
        bool committed = false;  // the journal contains it
        bool dirty = false;
        // The versions that were kept and dropped last; 0: none.
        std::int64_t kept_version = 0, dropped_version = 0;
        std::optional<Image> in_file;  // for a value: what this run has written into its file
        std::string taken_out;         // for a kept deletion: the text removed from the file
        std::string found_at;          // the path in `by_path`; "" if it is not in it
        JournalRow* left = nullptr;    // in `earlier`: its row while it is left behind, if it was
        std::shared_ptr<const SavedEntry> saved;  // null: it has changed since it was saved
    };
    /// All tweaks of this run that are known at a moment.
    struct Moment {
        std::shared_ptr<const char> of;  // the mark of its `State`
        std::vector<std::shared_ptr<const SavedEntry>> entries;
    };

    struct Moments {
        const std::shared_ptr<const char> mark = std::make_shared<const char>();
        std::shared_ptr<const Moment> last;     // null: entries have changed since
        std::shared_ptr<const Moment> pending;  // the game has gone there
        std::vector<std::function<void(Entry&)>> renames;
    };
    /// The tweaks that are about an instance as a whole, by the `key` of the instance.
    struct ByInstance {
        std::unordered_map<std::uint64_t, Entry*> created, deleted, restored, moved;
    };

    /// Rows that earlier runs left in the journal, and those that are left behind.
    struct EarlierRows {
        std::deque<JournalRow> rows;       // others point to them
        std::vector<JournalRow*> changed;  // of `rows`: to be written again
        std::vector<JournalRow*> renamed;  // of `rows`: with other names or places in files
        /// Rows that were applied again, and the tweaks of this run that they became.
        std::vector<std::pair<JournalRow*, Entry*>> reapplied;
        std::vector<JournalRow> invalid;  // rows that could not be read
        std::vector<JournalRow> removed;  // dropped rows of `invalid`
    };

    static std::string key_of(Kind kind, const std::string& instance, const std::string& property) {
        return std::to_string(static_cast<int>(kind)) + instance + '\n' + property;
    }

    State(Tree& tree, const std::filesystem::path& game, Journal::Warn sink, TweakOptions options);
    ~State() override;
    /// The host gets the text when the present operation has ended: its function may use the
    /// tweaks, for example keep some, which changes what the operation reads.
    void warn(std::string text) { untold.push_back(std::move(text)); }
    void give_warnings();
    /// Gives them, and returns the report of the operation that has ended.
    TweakReport with_warnings(TweakReport report) {
        give_warnings();
        return report;
    }
    std::size_t drop_invalid(std::string_view pattern);
    void take_earlier(std::vector<JournalRow> rows);
    void refresh_earlier();

    // tweaks.cpp: edits
    void edited(Handle instance, const Property& property, const CellState& before) override;
    void instance_created(Handle instance) override;
    void instance_deleting(Handle instance) override;
    void moved(Handle instance, Handle old_parent, const std::string& old_name) override;
    bool attached(Handle instance) const;
    bool is_fresh(Handle instance) const;
    Entry* created_above(Handle instance) const;
    /// `begins`: set to true if it has no edit at this moment yet.
    Entry& entry(Kind kind, const std::string& instance, const std::string& property, Handle handle,
                 bool* begins = nullptr);
    Entry& add_entry(Kind kind, const std::string& instance, Handle handle);
    void touch(Entry& entry);
    void name_deleted(Image& image, const Value& value) const;
    void note_deletion(Handle instance, Handle parent, const std::string& path);
    bool taken_out_of_creation(Handle instance, Handle parent);
    void update_restored_values(Handle instance, const Property& property);
    void undelete_above(Handle instance);
    Entry& add_deletion(Handle instance, const std::string& path, const std::string& home);
    void make_void(const std::string& path, const std::string& home, Entry& deletion);
    void revive(Entry& deletion);

    // moments.cpp: the tweaks that hold at the moment to which the game has gone
    EditMoment moment() override;
    void went_to(const std::shared_ptr<const void>& state) override;
    /// Must be called before entries are used.
    void settle();
    void put(Entry& its, const std::shared_ptr<const SavedEntry>& saved);
    void leave(Entry& its);
    void leave_behind(Entry& its);
    void refresh_paths_of_later_values();
    void withdraw_replaced_creations();
    void withdraw_left_deletions(Handle instance);
    static bool is_left_behind(const Entry& its) {
        return its.left != nullptr && its.left->state == RowState::open;
    }
    static RowState state_now(const Entry& its);
    void add_to_dirty(Entry& its);
    /// Files got other names of instances: changes all entries, also those that are restored later.
    void rename_in_entries(std::function<void(Entry&)> rename);

    // entry_index.cpp: adds tweaks, and finds those of an instance without a search through all
    /// Must be called after the path of an entry or the texts that may name instances have changed.
    void index(Entry& entry);
    /// The entries at that path and below it, but for restorations, in order.
    std::vector<Entry*> at_or_below(const std::string& path) const;
    std::vector<Entry*> in_order(std::vector<Entry*> entries) const;
    static bool may_name(const Entry& entry);

    // tweaks_moved.cpp
    bool moved_with_creation(Handle instance, Handle old_parent, const std::string& old_path);
    void rekey(Entry& its, const std::string& path);
    void repath(Handle instance, const std::string& old_path);
    /// Moves of this run that are in no file.
    InstanceMoves moves() const;
    std::string home_of(Handle instance) const;
    bool is_home_of_another(const std::string& home, Handle instance) const;
    bool is_home(const Entry& move) const;
    /// Whether the kept-tweaks file, and no scene, deletes the instance with that home path.
    bool deleted_by_path(const std::string& home) const;
    void refresh_path(Entry& its);
    static bool is_removed(const JournalRow& row);
    /// The journal gets the row of an earlier run with its new names.
    void renamed_earlier(JournalRow& row);
    /// Called after files got other names of instances.
    void homes_changed(const NewPath& now_at);
    void steps_renamed(const std::filesystem::path& file, const SceneOrigins::Names& names);
    /// The file of kept tweaks moves that part of a scene: what is edited of it and below it is
    /// kept there, too.
    void part_moved(const JournalRow& move, Handle part);
    /// A row of an earlier run was kept: the tweak of this run about the same value starts from it.
    void set_former_value(const JournalRow& row);
    void note_origin(Entry& entry, Handle instance) const;
    bool is_given_by_script(Handle instance, const Property& property) const;

    // reloaded.cpp: the script of the game is loaded again
    Entry* value_of(Handle instance, const Property& property) const;
    std::string given_again(Handle instance, const Property& property);
    void start_from(Entry& its, const Image& given);
    std::size_t made_no_more(const std::string& path);
    std::size_t replaced(Handle instance, const std::function<bool(Handle, const Property&)>& same);

    // tweaks_commit.cpp: rows
    void barrier();
    void make_fresh_entries(Handle moving = {});
    void make_fresh_entry(Handle instance);
    bool undelete_if_deleted(Handle instance);
    bool undelete(Entry& deletion);
    void note_values(Entry& made, std::vector<std::string>* warnings);
    void restored(Handle instance, Entry& deletion);
    void refresh(Entry& entry);
    void refresh_created(Entry& entry);
    void refresh_values(Entry& entry);
    bool visible(const Entry& entry) const;
    template <class WithPaths>
    std::string without_deleted(const std::string& text, WithPaths with_paths) const;
    /// The path of a deleted instance in the texts of tweaks. It is unique, because another
    /// instance may get the old path.
    static std::string path_of_deleted(Handle instance) {
        return path_below("game", impossible_name(std::to_string(instance.key())));
    }
    static bool is_of_deleted(const std::string& path) { return path.starts_with(R"(game["\000)"); }
    /// Replaces a path in all references of tweaks.
    void rename_mentions(const std::string& from, const std::string& to);
    void add_reference_tweaks(Entry& made, const std::string& path);
    void commit();
    void report_lost();

    /// The path without links if it is one of the game's own files. Files loaded from elsewhere are
    /// not changed.
    std::optional<std::filesystem::path> own_file(const std::filesystem::path& named) const;

    // open_rows.cpp, keeping/: operations on tweaks
    std::vector<JournalRow*> matching(std::string_view pattern, bool earlier_only);
    /// Adds values that were kept for one of several instances of a scene file.
    void add_kept_for_one(std::vector<JournalRow*>& rows, std::string_view pattern);
    TweakReport keep(std::string_view pattern, bool for_all);
    /// The number of instances in the tree that come from that scene file, but for the one with
    /// that home path.
    std::size_t others_of_scene(const std::filesystem::path& file,
                                const std::string& home_of_top) const;
    TweakReport reapply(std::string_view pattern);
    TweakReport drop(std::string_view pattern);
    void set_state(JournalRow& row, RowState state);
    Entry& entry_of(const JournalRow& row) {
        return *entries[static_cast<std::size_t>(row.number) - 1];
    }
    Entry* entry_about(const JournalRow& row, Handle instance) const;
    void reopen_undone_rows();

    Tree& tree;
    std::weak_ptr<const Tree*> tree_life;
    std::filesystem::path folder;        // folder of the game
    const Journal::Warn sink;            // the function of the host for warnings
    std::vector<std::string> untold;     // warnings that it has not got yet
    const std::string not_kept_because;  // see TweakOptions
    GameFiles own_files;
    GameFiles& files;
    std::unique_ptr<Journal> journal;  // null in a replay
    KeptTweaks kept;
    SceneOrigins origins;

    std::vector<std::unique_ptr<Entry>> entries;  // entry number n is at index n - 1
    std::unordered_map<std::string, Entry*> by_key;
    std::multimap<std::string, Entry*> by_path;  // the present paths of what they are about
    std::unordered_set<Entry*> naming;           // those whose texts may name instances
    std::vector<Entry*> dirty;
    FreshInstances fresh;
    ByInstance by_instance;
    EarlierRows earlier;
    std::int64_t last_number = 0, last_version = 0;
    Moments moments;
    /// Steps at which a script that was loaded again gave a value, by path.
    std::unordered_map<std::string, std::uint64_t> given_later;
    std::string last_failure;   // reported once
    int barriers_to_retry = 0;  // barriers before a failed commit is tried again
};

/// Selects tweaks by a pattern.
class TweakPattern {
  public:
    explicit TweakPattern(std::string_view text);
    bool matches(const JournalRow& row) const;

  private:
    Pattern pattern_;
    bool whole_instances_;
};

/// The words of a row for a recording, and a row made of words, which belongs to another run and
/// cannot be written.
TweakWords words_of(const JournalRow& row);
/// Throws Error for words that are not a row.
JournalRow row_of(const TweakWords& words);

/// Why a row is not a valid tweak, for example an invalid path or value; "" if it is valid.
std::string problem_of(const JournalRow& row);

/// The text, or its first bytes followed by "..."; characters are not split.
std::string shortened(const std::string& text, std::size_t longest);

/// "world.ball.mass", or the path of the instance.
std::string path_of(const JournalRow& row);

}  // namespace fettle::property
