#pragma once
// A plan in an engine, with the data that checks read after each step.

#include <cstdint>
#include <memory>
#include <vector>

#include "wild/plans/plan.h"

namespace fettle::bench::wild {

/// A body as it is now.
struct BodyNow {
    bool exists = false;
    bool awake = false;
    std::uint32_t slot = 0;  // in a world of the library
    BodyType type = BodyType::static_body;
    Vec2 position = {};  // of its origin
    float angle = 0;
    Vec2 velocity = {};  // of its center of mass
    float angular_velocity = 0;
    Vec2 center = {};  // of mass, in the world
    float mass = 0;
    float inertia = 0;
    float gravity_scale = 1;
    float deepest = 0;            // overlap with what it touches, m
    float load = 0;               // forces of all contacts together, N; 0 in another engine
    std::vector<int> touched{};   // bodies, or `the_world`; sensors do not count
    std::vector<Vec2> held_by{};  // normals, towards it, of its contacts with what is not dynamic

    bool touching() const { return !touched.empty(); }

    Vec2 velocity_at(const Vec2& point) const {
        const Vec2 lever = point - center;
        return velocity + angular_velocity * Vec2(-lever.y, lever.x);
    }
};

class RunningWorld {
  public:
    RunningWorld() = default;
    RunningWorld(const RunningWorld&) = delete;
    RunningWorld& operator=(const RunningWorld&) = delete;
    virtual ~RunningWorld() = default;

    /// Makes the objects and edits that the plan has before this step.
    virtual void prepare(int step) = 0;
    virtual void advance(float dt) = 0;
    /// Reads all bodies, in the order of the plan.
    virtual void read(std::vector<BodyNow>& bodies) const = 0;
    /// The world of the library; null for another engine.
    virtual World* fettle() { return nullptr; }
};

/// Both refer to the plan, which must outlive them.
std::unique_ptr<RunningWorld> run_in_fettle(const WorldPlan& plan);
/// Null if Box2D is not installed or cannot represent the plan.
std::unique_ptr<RunningWorld> run_in_box2d(const WorldPlan& plan);

}  // namespace fettle::bench::wild
