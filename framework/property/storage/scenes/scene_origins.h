#pragma once
// Which instance was described where in which scene file, so that what is changed of it can be kept
// there.

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

/// Of a child that its name alone finds.
inline constexpr std::size_t no_place = std::numeric_limits<std::int64_t>::max();

/// From the topmost instance of a scene file to one below: at each step the name of a child, and
/// its place among the children of the file, for one that the file does not name.
struct SceneStep {
    std::string name;
    std::size_t place = 0;
};
using SceneSteps = std::vector<SceneStep>;

/// As a text, and back; the text is empty for the topmost instance's own.
std::string steps_text(const SceneSteps& steps);
/// The same steps with new names, told by the steps before.
SceneSteps renamed_steps(const SceneSteps& steps,
                         const std::vector<std::pair<SceneSteps, std::string>>& names);
SceneSteps read_steps(const std::string& text);

class SceneOrigins {
  public:
    struct Origin {
        std::filesystem::path file;
        SceneSteps steps;
        Handle top;
    };
    void loaded(const Tree& tree, const std::filesystem::path& file,
                const std::vector<SceneInstance>& instances, bool named_by_script);
    /// Files say more, or other names, since they were loaded: that an instance at those steps is
    /// called otherwise; that an instance of the tree is described below another one.
    using Names = std::vector<std::pair<SceneSteps, std::string>>;
    void renamed(const std::filesystem::path& file, const Names& names);
    void added(const Tree& tree, Handle parent, Handle child);
    /// No file describes the instance and what is below it any more.
    void forget(const Tree& tree, Handle top);
    std::set<std::filesystem::path> files() const;
    /// Whether a scene's topmost instance has its name from a script.
    bool named_by_script(Handle top) const;
    /// Nothing for an instance that no file describes.
    std::optional<Origin> find(Handle instance) const;

  private:
    struct Scene {
        std::filesystem::path file;
        std::vector<SceneInstance> instances;
        std::vector<std::string> names;  // when they were loaded
        bool named_by_script = false;
    };
    struct Place {
        std::size_t scene;
        std::size_t instance;
    };
    static std::uint64_t key(Handle handle) {
        return std::uint64_t{handle.generation} << 32 | handle.index;
    }
    void prune(const Tree& tree);
    static SceneSteps steps_of(const Scene& scene, std::size_t instance);

    std::unordered_map<std::size_t, Scene> scenes_;
    std::unordered_map<std::uint64_t, Place> places_;
    std::size_t next_ = 0;
    std::size_t prune_at_ = 64;
};

}  // namespace fettle::property
