#pragma once
// Kept tweaks of instances that scripts make: `main.tweaks.json` beside the game, by path.
//
//   {
//     "fettle_tweaks": 1,
//     "values": {"world.ball.mass": 5},
//     "given": {"world.ball.mass": 2},
//     "created": {"world.lamp": {a scene}},
//     "deleted": ["world.wall"]
//   }
//
// "given" has the values that scripts gave when others were kept in their places.

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
    /// Applies everything: values, creations and deletions.
    void apply_all();
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
    /// Whether and how instances that the file makes get other paths. `require_movable` throws
    /// Error if the instance is a part of another one and would leave it. `move` makes all moves at
    /// once.
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
    struct Contents {
        std::map<std::string, std::vector<Kept>> values{};  // by path of the instance
        std::vector<std::string> created{}, deleted{};      // paths
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
    void create_all();
    void run_formulas();
    void fold();
    std::string made_above(const std::string& path) const;
    void rename_values(const NewPath& now_at);
    std::vector<std::string> about(const PathSet& set, const std::vector<std::string>& paths) const;
    using Remove = std::function<std::vector<std::string>(const std::vector<std::string>&)>;
    static std::vector<std::string> deepest_first(const std::vector<std::string>& paths,
                                                  const Remove& remove);
    std::vector<std::string> forget_beside(const std::vector<std::string>& paths);
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
    std::map<std::string, Given> given_now_;    // in this run, by key
    std::unique_ptr<LocatedWrites> located_;    // while the game is being loaded
    std::weak_ptr<const Tree*> tree_life_;
};

}  // namespace fettle::property
