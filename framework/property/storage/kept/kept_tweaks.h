#pragma once
// Tweaks that were kept of what a script makes: `main.tweaks.json`, beside the game, by path.
//
//   {
//     "fettle_tweaks": 1,
//     "values": {"world.ball.mass": 5},
//     "created": {"world.lamp": {a scene}},
//     "deleted": ["world.wall"]
//   }

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

#include <fettle/property/path.h>
#include <fettle/property/storage/game_files.h>
#include <fettle/property/storage/scene.h>
#include <fettle/property/tree.h>

#include <json/json_edit.h>
#include <kept/instance_moves.h>
#include <scenes/image.h>
#include <scenes/scene_origins.h>

namespace fettle::property {

class KeptTweaks {
  public:
    using Warn = std::function<void(const std::string&)>;

    /// Reads the file, if there is one. One that cannot be used is told, has no effect and is never
    /// written.
    KeptTweaks(Tree& tree, GameFiles& files, std::filesystem::path file, Warn warn);

    const std::filesystem::path& file() const { return file_; }
    /// Finds the instance of a home path; without it that is the one at the path now.
    using Find = std::function<Handle(const std::string& home)>;
    void find_by(Find find) { find_ = std::move(find); }
    /// What the file says now: another run of the game may have kept something since.
    void read_again();

    /// Values of the instance and of everything below it.
    void apply_values(Handle top);
    /// To everything there is: values, and what was created and deleted.
    void apply_all();
    /// Sets the values that wait for an instance, and tells of those whose instance is not there
    /// by now.
    void settle();

    // For the next run. Throw Error; `write` throws FileError.
    /// `declared`: by the class of the instance, null for an ad-hoc property, or where there is no
    /// such instance now. `written`: as for `image_in_file`.
    void set(const std::string& instance, const std::string& property, const Property* declared,
             const Image& image, const NewPath& written);
    void add(const std::string& path, const std::string& scene);
    /// For each of the paths, what the file told of it, for `put_back`.
    std::vector<std::string> remove(const std::vector<std::string>& paths);
    /// `taken_out`: what `remove` has given; "" where it is not known. `scene`: of the
    /// instance as it is now, since what it named may have gone or have got another name meanwhile.
    void put_back(const std::string& path, const std::string& taken_out, const std::string& scene);
    bool makes(const std::string& path) const;
    bool deletes(const std::string& path) const;
    /// Instances that the file makes get other paths: all of them at once. Throws Error for one
    /// that it makes as a part of another one and that is to leave it.
    void require_movable(const std::string& from, const std::string& to) const;
    void move(const std::vector<MoveStep>& moves);
    /// Instances have other paths now: those that tweaks are about, and those that they name.
    void rename(const NewPath& now_at);
    /// A value, or an instance with all its values, is told elsewhere from now on.
    void forget_value(const std::string& instance, const std::string& property);
    /// And what is below them; what named them names nothing. Gives what `remove` gives.
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
    /// A value that a property is to get.
    struct Assignment {
        Handle instance;
        std::string property, path;
        Handle top;  // of the scene that says it; null for one of "values"
        std::shared_ptr<const Document> document;
        const Node* node;
    };
    /// Null where there is none now.
    Handle instance(const std::string& home) const {
        return find_ ? find_(home) : instance_or_none(tree_, home);
    }
    bool assign(const Assignment& to, bool last);
    void assign_or_wait(Assignment to);
    void try_waiting(bool last);
    void create_all();
    void settle_formulas();
    void fold();
    std::string made_above(const std::string& path) const;
    void rename_values(const NewPath& now_at);
    std::vector<std::string> about(const PathSet& set, const std::vector<std::string>& paths) const;
    using Remove = std::function<std::vector<std::string>(const std::vector<std::string>&)>;
    static std::vector<std::string> deepest_first(const std::vector<std::string>& paths,
                                                  const Remove& remove);
    std::vector<std::string> forget_beside(const std::vector<std::string>& paths);
    void name_as_in(const std::string& path, const std::string& scene);
    bool part_removed(const std::string& path);
    static SceneSteps steps_between(const std::string& top, const std::string& path);
    void rename_in_references(const NewPath& now_at);
    /// The text of a value or of a new instance with other paths; nothing where it names none.
    std::optional<std::string> with_paths(const std::string& section, const std::string& key,
                                          const NewPath& now_at) const;
    std::vector<std::pair<std::string, std::string>> all_keys() const;
    void create(const std::string& path);
    Handle find(const Node& node, const std::string& path, std::size_t count,
                const std::string& then);
    void tell_values_of_nobody();
    void warn(std::size_t offset, const std::string& reason);
    void warn(const Document& document, std::size_t offset, const std::string& reason);
    void tell(const SceneError& error);
    const Node* member(std::string_view section, const std::string& key) const;
    /// What the file has for a key, as if it began in column 1.
    std::string text_of(const std::string& section, const std::string& key) const;
    /// What is to be in the file; it is written with all others.
    void put(const std::string& section, const std::string& key, const std::string& value);
    void drop(const std::string& section, const std::string& key);
    void put_deleted(const std::string& path);
    struct Change {
        std::string key;
        std::optional<std::string> value;  // none: it goes
    };
    struct Changes {
        std::string section;
        std::vector<Change> list{};
        std::unordered_map<std::string, std::size_t> places{};  // in the list, by key
    };
    void change(const std::string& section, const std::string& key,
                std::optional<std::string> value);
    static void make(JsonEdit& edit, const Changes& changes);

    Tree& tree_;
    GameFiles& files_;
    std::filesystem::path file_;
    Warn warn_;
    Find find_;
    std::unordered_set<std::string> created_;   // of the contents
    std::string problem_;                       // why the file is not used
    std::shared_ptr<const Document> document_;  // as it was read
    std::vector<Changes> changes_;              // since, of each section
    Contents contents_;
    std::unordered_set<std::string> told_;  // warnings
    std::vector<Assignment> waiting_;       // for an instance that they name
    bool unwritten_ = false;                // the document is newer than the file
    bool applied_ = false;                  // all of it, once
};

}  // namespace fettle::property
