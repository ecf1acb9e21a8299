#pragma once
// A common interface to all engines: build a scene, step it, read its bodies.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "scenes/scene.h"

namespace fettle::bench {

/// Motion of a body: position of its origin, velocity of its center of mass.
struct BodyMotion {
    Point position{};
    float angle = 0;
    Point velocity{};
    float angular_velocity = 0;
};

/// A scene in an engine. Bodies are identified by their index in the scene.
class Engine {
  public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    /// Makes one step of `time_step`.
    virtual void step() = 0;
    virtual BodyMotion motion(std::size_t body) const = 0;
    virtual void set_velocity(std::size_t body, Point velocity) = 0;
    /// Adds the bodies of a group; existing bodies of the group are removed first. Throws if the
    /// engine has no groups.
    virtual void replace_group(std::size_t group, const SceneGroup& description);
    virtual void mix_groups(std::uint64_t&) const {}
    /// An edit from outside the simulation: `set_velocity` through the highest-level interface of
    /// the engine.
    virtual void edit_velocity(std::size_t body, Point velocity) { set_velocity(body, velocity); }
    /// Has an effect only if the engine supports several threads.
    virtual void set_threads(int) {}
    /// Pairs of touching shapes, sleeping ones included.
    virtual std::size_t contacts() const = 0;
    /// Existing bodies, static ones included.
    virtual std::size_t bodies() const = 0;
};

/// Adds one body to an FNV-1a hash.
void mix(std::uint64_t& hash, const BodyMotion& body);

/// FNV-1a hash of the motion of `count` bodies, in the order of the scene, and of the bodies of its
/// groups. Equal states have equal hashes in all engines.
std::uint64_t hash_of(const Engine& engine, std::size_t count);

struct EngineKind {
    std::string_view name;
    /// Null if the engine is not installed.
    std::function<std::unique_ptr<Engine>(const Scene& scene)> make;
    std::string_view package;  // Debian package of an engine that is not installed
    int max_threads = 1;
};

/// fettle, hosted, box2d, chipmunk, in this order.
std::span<const EngineKind> engine_kinds();
/// Throws std::invalid_argument with a list of the names if no engine has this name.
const EngineKind& engine_named(std::string_view name);

std::unique_ptr<Engine> make_fettle(const Scene& scene);
std::unique_ptr<Engine> make_hosted(const Scene& scene);
std::unique_ptr<Engine> make_box2d(const Scene& scene);
std::unique_ptr<Engine> make_chipmunk(const Scene& scene);

}  // namespace fettle::bench
