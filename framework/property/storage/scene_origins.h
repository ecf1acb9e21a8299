#pragma once
// Which instance was described where in which scene file, so that what is changed of it can be kept
// there.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <fettle/property/storage/scene.h>
#include <fettle/property/tree.h>

namespace fettle::property {

/// From the topmost instance of a scene file to one below: at each step the name of a child, and
/// its place among the children of the file, for one that the file does not name.
struct SceneStep {
    std::string name;
    std::size_t place = 0;
};
using SceneSteps = std::vector<SceneStep>;

/// As a text, and back; the text is empty for the topmost instance's own.
std::string steps_text(const SceneSteps& steps);
SceneSteps read_steps(const std::string& text);

class SceneOrigins {
  public:
    struct Origin {
        std::filesystem::path file;
        SceneSteps steps;
        Handle top;
    };
    void loaded(const Tree& tree, const std::filesystem::path& file,
                const std::vector<SceneInstance>& instances);
    /// Nothing for an instance that no file describes.
    std::optional<Origin> find(Handle instance) const;

  private:
    struct Scene {
        std::filesystem::path file;
        std::vector<SceneInstance> instances;
        std::vector<std::string> names;  // when they were loaded
    };
    struct Place {
        std::size_t scene;
        std::size_t instance;
    };
    static std::uint64_t key(Handle handle) {
        return std::uint64_t{handle.generation} << 32 | handle.index;
    }
    void prune(const Tree& tree);

    std::unordered_map<std::size_t, Scene> scenes_;
    std::unordered_map<std::uint64_t, Place> places_;
    std::size_t next_ = 0;
    std::size_t prune_at_ = 64;
};

}  // namespace fettle::property
