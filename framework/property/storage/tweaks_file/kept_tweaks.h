#pragma once
// Kept tweaks of instances that scripts make, and of single instances of scene files that are
// loaded several times: `main.tweaks.json` beside the game, by path.
//
//   {
//     "fettle_tweaks": 1,
//     "values": {"world.ball.mass": 5},
//     "given": {"world.ball.mass": 2},
//     "created": {"world.lamp": {a scene}},
//     "moved": {"world.car.wheel": "world.car.spare"},
//     "deleted": ["world.wall"]
//   }
//
// "given" has the values that scripts gave when others were kept in their places. "moved" has the
// new paths of parts of scenes, by the paths that the scene files give them. All other paths are
// those after these moves.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <fettle/property/located_writes.h>
#include <fettle/property/path.h>
#include <fettle/property/storage/game_files.h>
#include <fettle/property/storage/scene.h>
#include <fettle/property/tree.h>

#include <json/json_edit.h>
#include <scenes/image.h>
#include <scenes/scene_origins.h>
#include <tweaks_file/instance_moves.h>

namespace fettle::property {

class KeptTweaks {
  public:
    using Warn = std::function<void(const std::string&)>;

    /// Reads the file if it exists. If it is invalid, that is reported, and the file has no effect
    /// and is never written.
    KeptTweaks(Tree& tree, GameFiles& files, std::filesystem::path file, Warn warn);

    ~KeptTweaks();
    KeptTweaks(const KeptTweaks&) = delete;
    KeptTweaks& operator=(const KeptTweaks&) = delete;

    const std::filesystem::path& file() const { return file_; }
    /// Finds the instance with a home path. Without this function, the path is used as it is.
    using Find = std::function<Handle(const std::string& home)>;
    void find_by(Find find) { find_ = std::move(find); }
    /// Reads the file again, because another run of the game may have changed it.
    void reload();

    /// Applies the values of the instance and of everything below it.
    void apply_values(Handle top);
    /// Applies everything: values, creations, moves and deletions. Returns what was moved.
    std::vector<Handle> apply_all();
    /// Sets the values whose references were missing, and reports those that are still missing.
    void retry_waiting();

    // Changes for the next run. Throw Error; `write` throws FileError.
    /// `declared`: the property of the class; null for an ad-hoc property, or if the instance does
    /// not exist. `written`: as for `image_in_file`.
    void set(const std::string& instance, const std::string& property, const Property* declared,
             const Image& image, const NewPath& written);
    /// Notes the value that a script gives, in whose place another one is kept. Later notes about
    /// the same property change nothing.
    void note_given(const std::string& instance, const std::string& property,
                    const Property* declared, const Image& image, const NewPath& written);
    void add(const std::string& path, const std::string& scene);
    /// Returns, for each path, the removed entries for `put_back`.
    std::vector<std::string> remove(const std::vector<std::string>& paths);
    /// `taken_out`: the result of `remove`; "" if unknown. `scene`: the current scene of the
    /// instance, because its references may have changed meanwhile.
    void put_back(const std::string& path, const std::string& taken_out, const std::string& scene);
    /// "main.tweaks.json:4" if the file has a value for the property; otherwise "".
    std::string place_of(const std::string& instance, const std::string& property) const;
    bool makes(const std::string& path) const;
    bool deletes(const std::string& path) const;
    /// Whether the file moves any instance, whether it moves one to `path`, and whether it moves
    /// one away from there.
    bool moves_any() const { return !contents_.moved.empty(); }
    bool moves_to(const std::string& path) const;
    bool moves_away(const std::string& path) const;
    /// The path of an instance that the file moves out of what is at `path`; "" if there is none.
    std::string moved_out_of(const std::string& path) const;
    /// Whether and how instances get other paths: those that the file makes, and others, which the
    /// file moves. `require_movable` throws Error if the instance is a part of another one that the
    /// file makes, and would leave it. `move` makes all moves at once.
    void require_movable(const std::string& from, const std::string& to) const;
    void move(const std::vector<MoveStep>& moves);
    /// Replaces the paths of instances in tweaks and in their references.
    void rename(const NewPath& now_at);
    /// Removes a tweak, because another file contains the value now.
    void forget_value(const std::string& instance, const std::string& property);
    /// The same for the instances and everything below them; references to them become null.
    /// Returns the same as `remove`.
    std::vector<std::string> forget_below(const std::vector<std::string>& paths);
    void write();

  private:
    using Node = Document::Node;
    struct Kept {
        std::string property;
        std::string key;
    };
    struct Moved {
        std::string key, home, now;  // `home`: the path that a scene file gives
    };
    struct Contents {
        std::map<std::string, std::vector<Kept>> values{};  // by path of the instance
        std::vector<std::string> created{}, deleted{};      // paths
        std::vector<Moved> moved{};
        InstanceMoves moves{};  // the same as `moved`
    };
    void read();
    void set_contents(Contents contents);
    static Contents contents_of(const Document& document);
    void check_value(const std::string& path, const Property* declared, const Image& image) const;
    /// A value to be assigned to a property.
    struct Assignment {
        Handle instance;
        std::string property, path;
        Handle top;  // topmost instance of the scene with the value; null for "values"
        std::shared_ptr<const Document> document;
        const Node* node;
    };
    /// Null if it does not exist now.
    Handle instance(const std::string& home) const {
        return find_ ? find_(home) : instance_or_none(tree_, home);
    }
    /// A value that a script has given before a kept one took its place, as it is in a file, and
    /// for people.
    struct Given {
        std::string value{}, text{}, unit{}, place{};
        Handle instance{};
        Symbol property{};
    };
    std::string text_for_people(const Node& node, const Given& of) const;
    void note_given_now(const Assignment& to);
    void compare_with_given();
    bool assign(const Assignment& to, bool last);
    void assign_or_wait(Assignment to);
    void try_waiting(bool last);
    /// What is still to be done of the moves, deletions and creations.
    struct Mover {
        const Moved* move;
        Handle instance;
    };
    struct Open {
        std::vector<Mover> movers{};                                      // parents first
        std::vector<std::pair<const Node*, std::string>> deletions{};     // with their paths
        std::unordered_set<std::string> to_delete{};                      // these paths
        std::unordered_map<std::string, const std::string*> creations{};  // keys by path
    };
    std::vector<Handle> apply_structure();
    std::string path_of_values(Handle instance) const;
    Open all_open();
    void make_room(const Open& open);
    bool move_some(Open& open, bool last);
    bool move_now(const Mover& mover, const Open& open,
                  const std::unordered_set<const Moved*>& done, bool last);
    bool delete_some(Open& open, bool last);
    bool create_some(Open& open, bool last);
    void run_formulas();
    void fold();
    std::string made_above(const std::string& path) const;
    void rename_values(const NewPath& now_at);
    std::vector<std::string> about(const PathSet& set, const std::vector<std::string>& paths) const;
    using Remove = std::function<std::vector<std::string>(const std::vector<std::string>&)>;
    static std::vector<std::string> deepest_first(const std::vector<std::string>& paths,
                                                  const Remove& remove);
    std::vector<std::string> forget_beside(const std::vector<std::string>& paths);
    void delete_moved_into(const PathSet& set, const std::vector<std::string>& paths);
    void rename_deleted(const NewPath& now_at);
    void put_moved(const std::string& home, const std::string& now);
    void name_as_in(const std::string& path, const std::string& scene);
    bool remove_part(const std::string& path);
    static SceneSteps steps_between(const std::string& top, const std::string& path);
    void rename_in_references(const NewPath& now_at);
    /// The text of a value or of a new instance with replaced paths; nullopt if it contains no
    /// reference.
    std::optional<std::string> with_paths(const std::string& section, const std::string& key,
                                          const NewPath& now_at) const;
    std::vector<std::pair<std::string, std::string>> all_keys() const;
    void create(const std::string& path);
    Handle find(const Node& node, const std::string& path, std::size_t count,
                const std::string& then);
    void report_unused_values();
    void warn(std::size_t offset, const std::string& reason);
    void warn(const Document& document, std::size_t offset, const std::string& reason);
    void report(const SceneError& error);
    const Node* member(std::string_view section, const std::string& key) const;
    /// The text of an entry, with its first column as column 1.
    std::string text_of(const std::string& section, const std::string& key) const;
    /// Sets an entry. The file is written later with all changes.
    void put(const std::string& section, const std::string& key, const std::string& value);
    void drop(const std::string& section, const std::string& key);
    void put_deleted(const std::string& path);
    struct Change {
        std::string key;
        std::optional<std::string> value;  // nullopt: the entry is removed
    };
    struct Changes {
        std::string section;
        std::vector<Change> list{};
        std::unordered_map<std::string, std::size_t> places{};  // index in the list, by key
    };
    void change(const std::string& section, const std::string& key,
                std::optional<std::string> value);
    static void apply(JsonEdit& edit, const Changes& changes);

    Tree& tree_;
    GameFiles& files_;
    std::filesystem::path file_;
    Warn warn_;
    Find find_;
    std::unordered_set<std::string> created_;   // same as in `contents_`
    std::string problem_;                       // why the file is not used
    std::shared_ptr<const Document> document_;  // the file as it was read
    std::vector<Changes> changes_;              // changes since then, one item per section
    Contents contents_;
    std::unordered_set<std::string> reported_;  // warnings
    std::vector<Assignment> waiting_;           // until the instance that they refer to exists
    bool unwritten_ = false;                    // the document is newer than the file
    bool applied_ = false;                      // set by `apply_all`
    bool moved_ = false;                        // the same, when everything has its place
    std::map<std::string, Given> given_now_;    // in this run, by key
    std::unique_ptr<LocatedWrites> located_;    // while the game is being loaded
    std::weak_ptr<const Tree*> tree_life_;
};

}  // namespace fettle::property
