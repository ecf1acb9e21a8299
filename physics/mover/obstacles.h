#pragma once

#include <collision/solid.h>
#include <fettle/physics/mover.h>
#include <queries/query_lock.h>

#include <optional>
#include <span>
#include <vector>

namespace fettle::physics::detail {

/// Access of a mover to the data of a world.
struct MoverWorld {
    static WorldData& of(const World& world) { return *world.data_; }
};

/// The capsule of a mover: a line from its lower to its upper center, relative to its feet, and a
/// radius.
class Capsule {
  public:
    Capsule(const MoverDef& def, float height);
    Capsule(const Capsule&) = delete;
    Capsule& operator=(const Capsule&) = delete;

    /// The line, with a radius.
    Solid solid(float radius) const;
    /// The least coordinate of the capsule along a unit vector, from the feet, m.
    float lowest(Vec2 direction) const;
    Vec2 lower() const { return ends_[0]; }
    Vec2 middle() const { return 0.5f * (ends_[0] + ends_[1]); }
    const Vec2 up;
    const float radius, height;

  private:
    Vec2 ends_[2];
    Vec2 normals_[2];
    float offsets_[2] = {0.0f, 0.0f};
    int count_ = 2;
};

/// A solid shape near a mover.
struct Obstacle {
    Solid solid;
    Position center;  ///< center of mass of its body
    Vec2 shift;       ///< its motion in the step
    Vec2 motion;      ///< the same, also of a dynamic body that comes towards the mover
    uint32_t shape = none, body = none;
    bool border = false;  ///< a side of the bounds: `front` is its normal, `depth` its place
    bool one_sided = false;
    bool dynamic = false;
    bool of_mover = false;     ///< a part of the body of another mover
    bool taken_along = false;  ///< it moves as the feet on it do
    bool leads = false;        ///< dynamic, and not the ground: it moves only away from the mover
    Vec2 front;                ///< unit vector out of the solid side of a one-sided obstacle
    WorldCoordinate depth = 0;
    float clearance = 0.0f;  ///< m: the mover is at least this far away
};

/// A plane of an obstacle, relative to a position of the mover.
struct Plane {
    Vec2 normal;
    Position point;
    float separation = 0.0f;
    uint32_t obstacle = 0;
    bool deep = false;  ///< the line of the capsule is inside the obstacle
};

/// The obstacles in a part of a world, in their positions at the share `time` (0 … 1) of the step.
class Obstacles {
  public:
    Obstacles(const World& world, const MoverDef& def, const Capsule& capsule);

    /// Finds the obstacles that overlap a box now, or kinematic bodies that may come into it in
    /// `dt` seconds.
    void find(Box4 box, const Position& position, uint32_t carrier, float dt,
              std::optional<ShapeId> left_out);
    /// For a mover in the air, to be called before `find`: the least cosine of the slope of ground
    /// on which it may land.
    void set_landing(float least_cosine) { landing_cosine_ = least_cosine; }
    /// Gives all shapes of `body` that are below the feet the motion of the feet. So they keep
    /// their distance from the feet, although the shapes of a body that turns are only shifted
    /// here.
    void take_along(uint32_t body, Vec2 motion, const Position& position);
    void set_time(float time);
    /// Must be called when the mover was moved by this distance (m), but not by a `cast`.
    void reduce_clearance(float distance);
    float farthest_shift() const;  ///< m: of the obstacle that may reach the mover and moves most
    /// The planes within `reach` at this position, nearest first, at most 16. A corner that is
    /// flush with a nearer plane is left out, unless its obstacle is `kept`.
    void planes_at(const Position& position, float reach, uint32_t kept,
                   std::vector<Plane>& planes);
    /// The share of a motion after which an obstacle is nearer than `gap`; `hit`: this obstacle.
    /// `with_ground`: false leaves out what moves as the feet do.
    float cast(const Position& position, Vec2 motion, float gap, uint32_t& hit,
               bool with_ground = true);
    /// The normal of the first surface that a ray meets.
    std::optional<Vec2> ray(const Position& from, Vec2 motion) const;
    /// The plane of one obstacle. None if it does not act on a mover at this position.
    std::optional<Plane> plane(uint32_t obstacle, const Position& position) const;
    /// The nearest plane of a body within `reach` whose slope has at least this cosine.
    std::optional<Plane> floor_of(uint32_t body, const Position& position, float reach,
                                  float least_cosine) const;
    /// How far an obstacle that overlaps the mover pushes it out in this part of the step, m.
    float most_push_out(const Plane& plane) const;
    /// True if the own body of the mover stops an obstacle: a dynamic body.
    bool stops(const Plane& plane) const { return has_body_ && all_[plane.obstacle].dynamic; }
    /// The velocity of an obstacle at a plane, m/s.
    Vec2 velocity_at(const Plane& plane) const;
    /// Calls `visit(body)` for dynamic ledges.
    void for_each_dynamic_ledge(auto&& visit) const {
        for (const Obstacle& each : all_)
            if (each.dynamic && each.one_sided) visit(each.body);
    }
    const Obstacle& operator[](uint32_t index) const { return all_[index]; }
    WorldData& data() const { return data_; }

  private:
    bool stands_on_it(uint32_t body) const;
    void add(uint32_t shape, const Position& position, uint32_t carrier, float dt);
    Position center(const Obstacle& obstacle) const {
        return obstacle.center + time_ * obstacle.shift;
    }
    Plane deepest(const Obstacle& obstacle, Vec2 offset) const;

    WorldData& data_;
    const MoverDef& def_;
    const Capsule& capsule_;
    QueryFilter filter_;
    std::vector<Obstacle> all_;
    float time_ = 0.0f;
    float part_ = 0.0f;  ///< the share of the step between the last two times
    float landing_cosine_ = infinity;
    bool has_body_ = false;  ///< the mover has a body of its own
    float dt_ = 0.0f;        ///< s: the length of the step; 0: nothing moves
};

/// What is known of the mover whose body this is; null if it is none of a mover.
const MoverBody* mover_of(const WorldData& data, uint32_t body);
/// The order of the bodies of movers in a world.
inline bool is_before(const MoverBody& mover, uint32_t body) {
    return mover.body.index < body;
}
/// The angle by which a body turns in the step, rad.
float turn_of(const BodyState& state, float dt);
/// The velocity of a point of a body, m/s.
Vec2 velocity_of(const WorldData& data, uint32_t body, const Position& point);
/// The motion of a point of a body in the step.
Vec2 motion_of(const WorldData& data, uint32_t body, const Position& point, float dt);

}  // namespace fettle::physics::detail
