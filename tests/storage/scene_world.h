#pragma once
// A tree with classes of every kind of binding, as a source of scenes.

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <fettle/property/storage/scene.h>
#include <fettle/property/tree.h>

namespace scene_test {

using namespace fettle::property;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Thing: a native property of every type, in an array of structs that moves as it grows; `mass` is
/// computed from `density` until it is set.
struct Thing {
    double number = 0;
    float small = 0.6f;
    std::int64_t integer = 0;
    std::int32_t narrow = 7;
    bool flag = false;
    double position[2] = {0, 0};
    float offset[2] = {0, 0};
    Color tint{};
    std::uint8_t kind = 2;
    double density = 1;
    double mass = 0;
    bool mass_given = false;
    float gain = 0.1f;
};

class SceneWorld {
  public:
    SceneWorld();
    Handle add(std::string_view of, Handle parent, std::string_view name = {}) {
        return tree.create(tree.class_named(of), parent, name);
    }
    Handle add(std::string_view of, std::string_view name = {}) { return add(of, world, name); }
    std::string text(Handle node) const { return scene_text(tree, node); }
    /// Loads `text`. Throws std::logic_error if it is loaded although `check_scene` refuses it.
    Handle load(std::string_view text, std::string_view name = {});
    /// Loads `text` and returns the message of the error; "" if it is loaded.
    std::string refusal(std::string_view text);
    /// Saves, loads under another name, and returns the copy.
    Handle copy(Handle node, std::string_view name = "copy") { return load(text(node), name); }
    /// Every property of everything below the world as text, to compare two states.
    std::string everything() const;

    std::vector<Thing> things;  // outlives the tree
    Tree tree;
    Handle world;
    std::vector<std::string> warnings;

  private:
    void define_thing();
    void define_stored();
};

}  // namespace scene_test
