#pragma once
// One way to talk to every engine: build a scene, step it, look at its bodies.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "scenes/scene.h"

namespace fettle::bench {

/// How a body moves: position of its origin, velocity of its center of mass.
struct BodyMotion {
    Point position{};
    float angle = 0;
    Point velocity{};
    float angular_velocity = 0;
};

/// A scene in an engine. Bodies are named by their index in the scene.
class Engine {
  public:
    Engine() = default;
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    virtual ~Engine() = default;

    /// One step of `time_step`.
    virtual void step() = 0;
    virtual BodyMotion motion(std::size_t body) const = 0;
    virtual void set_velocity(std::size_t body, Point velocity) = 0;
    /// The bodies of a group come; those of it that are there go before. Throws where the engine
    /// has no groups.
    virtual void arrive(std::size_t group, const SceneGroup& description);
    virtual void mix_groups(std::uint64_t&) const {}
    /// An edit from outside, as a tinkerer makes it: `set_velocity` by the engine's most public
    /// way.
    virtual void edit_velocity(std::size_t body, Point velocity) { set_velocity(body, velocity); }
    /// Only where the engine can have more than one.
    virtual void set_threads(int) {}
    /// Pairs of shapes that touch, sleeping ones too.
    virtual std::size_t contacts() const = 0;
    /// Bodies that exist, static ones too.
    virtual std::size_t bodies() const = 0;
};

/// One body more in a hash, FNV-1a.
void mix(std::uint64_t& hash, const BodyMotion& body);

/// FNV-1a over the motion of `count` bodies, in the order of the scene, and of those of its groups:
/// equal for equal states, whatever the engine.
std::uint64_t hash_of(const Engine& engine, std::size_t count);

struct EngineKind {
    std::string_view name;
    /// Null where the engine is not installed.
    std::function<std::unique_ptr<Engine>(const Scene& scene)> make;
    std::string_view package;  // Debian's, of a peer that is not installed
    int max_threads = 1;
};

/// fettle, hosted, box2d, chipmunk; in this order.
std::span<const EngineKind> engine_kinds();
/// Throws std::invalid_argument that lists the names.
const EngineKind& engine_named(std::string_view name);

std::unique_ptr<Engine> make_fettle(const Scene& scene);
std::unique_ptr<Engine> make_hosted(const Scene& scene);
std::unique_ptr<Engine> make_box2d(const Scene& scene);
std::unique_ptr<Engine> make_chipmunk(const Scene& scene);

}  // namespace fettle::bench
