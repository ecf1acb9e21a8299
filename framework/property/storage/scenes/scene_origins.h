#pragma once
// For each instance, the scene file that describes it and its place there. Changes of the instance
// are kept at this place.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fettle/property/storage/scene.h>
#include <fettle/property/tree.h>

namespace fettle::property {

/// Place of a child that can be found by its name.
inline constexpr std::size_t no_place = std::numeric_limits<std::int64_t>::max();

/// Steps from the topmost instance of a scene file to one below it. A step is the name of a child.
/// For a child without a name in the file it also has the place among the children in the file.
struct SceneStep {
    std::string name;
    std::size_t place = 0;
};
using SceneSteps = std::vector<SceneStep>;

/// The steps as a text, and the inverse function. The text is empty for the topmost instance.
std::string steps_text(const SceneSteps& steps);
SceneSteps read_steps(const std::string& text);
/// Replaces the names in the steps. `names`: old steps and new names.
SceneSteps renamed_steps(const SceneSteps& steps,
                         const std::vector<std::pair<SceneSteps, std::string>>& names);

class SceneOrigins {
  public:
    struct Origin {
        std::filesystem::path file;
        SceneSteps steps;
        Handle top;
    };
    void loaded(const Tree& tree, const std::filesystem::path& file,
                const std::vector<SceneInstance>& instances, bool named_by_script);
    /// Files have changed since they were loaded. `renamed`: the instances at those steps have
    /// other names. `added`: a file describes `child` below `parent` now.
    using Names = std::vector<std::pair<SceneSteps, std::string>>;
    void renamed(const std::filesystem::path& file, const Names& names);
    void added(const Tree& tree, Handle parent, Handle child);
    /// Forgets the instance and everything below it, because no file describes them any more.
    void forget(const Tree& tree, Handle top);
    /// The same for a part of a scene, and for the parts of that scene below it. Nothing for the
    /// topmost instance.
    void forget_part(const Tree& tree, Handle part);
    std::set<std::filesystem::path> files() const;
    /// The topmost instances that exist and come from that file.
    std::vector<Handle> tops(const Tree& tree, const std::filesystem::path& file) const;
    /// Whether a script named the topmost instance of the scene.
    bool named_by_script(Handle top) const;
    /// nullopt for an instance that no file describes.
    std::optional<Origin> find(Handle instance) const;

  private:
    struct Scene {
        std::filesystem::path file;
        std::vector<SceneInstance> instances;
        std::vector<std::string> names;  // names when the file was loaded
        bool named_by_script = false;
    };
    struct Place {
        std::size_t scene;
        std::size_t instance;
    };
    void prune(const Tree& tree);
    static SceneSteps steps_of(const Scene& scene, std::size_t instance);

    std::unordered_map<std::size_t, Scene> scenes_;
    std::unordered_map<std::uint64_t, Place> places_;
    std::size_t next_ = 0;
    std::size_t prune_at_ = 64;
};

}  // namespace fettle::property
