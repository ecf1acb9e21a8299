#pragma once

#include <mover/obstacles.h>
#include <mover/planes.h>

#include <vector>

namespace fettle::physics::detail {

/// The settings of one move.
struct MoveSettings {
    float skin = 0.0f;
    float least_cosine = 0.0f;  ///< of the slope of ground
    float step_height = 0.0f;   ///< 0: no steps
    bool walks = false;         ///< on ground: slopes that are too steep are walls
};

/// A dynamic body that a mover runs into, or stands on.
struct Push {
    uint32_t body = none;
    Position point;
    Vec2 normal;
    float separation = 0.0f;  ///< m; negative: it overlaps the mover
};

/// A mover during one step: it moves in short parts of its motion, and after each of them it
/// overlaps no obstacle.
class Moving {
  public:
    Moving(Obstacles& obstacles, const Capsule& capsule, const MoveSettings& settings,
           const Position& start)
        : position(start), obstacles_(obstacles), capsule_(capsule), settings_(settings) {}

    /// A part of the motion, which should be short compared with the radius. `ridden`: what of it
    /// is the motion of the ground, which is already where it will be.
    void advance(Vec2 motion, Vec2 ridden);
    /// Finds the dynamic bodies within the skin towards which `motion` leads. The mover pushes them
    /// also in a step in which they were as fast as the mover, so no gap opens between them.
    void find_pushed(Vec2 motion);
    /// Moves it back onto its ground, a body that has moved away from it by at most `reach`. It
    /// goes the shortest way, so on a slope it goes neither up nor down. False and not moved if
    /// there is no ground of this body.
    bool follow(uint32_t carrier, float reach);
    /// Moves it down by at most `reach` onto ground; false and not moved if there is none.
    bool snap_to_ground(float reach);
    /// The plane of the ground below its feet; none in the air.
    std::optional<Plane> ground();
    /// True if nothing overlaps it by more than a tenth of its radius.
    bool has_room();
    /// The velocity that walls and other bodies that are not dynamic leave it, or give it, and with
    /// which it leaves those that it overlaps. `dt`: the length of the step, s.
    Vec2 driven(Vec2 velocity, float dt);
    /// The velocity without the parts that obstacles at its position stop.
    Vec2 clipped(Vec2 velocity);

    Position position;
    std::vector<Push> pushes;
    std::optional<Plane> wall, ceiling;
    std::optional<Plane> step;  ///< the last step that it climbed

  private:
    void slide(Vec2 motion);
    void put_back(const Position& to) {
        obstacles_.reduce_clearance(length(position - to));
        position = to;
    }
    bool step_up(const Position& start, Vec2 motion);
    bool will_step_up(Vec2 motion);
    void record_hits(Vec2 motion);
    std::vector<Bound> bounds(Vec2 motion, bool with_distance) const;
    float evasion() const;
    bool walkable(const Plane& plane, const Position& floor, Vec2 motion);
    float cosine(const Plane& plane) const { return dot(plane.normal, capsule_.up); }
    bool is_steep(const Plane& plane) const {
        return cosine(plane) > 0.01f && cosine(plane) < settings_.least_cosine;
    }
    Vec2 lateral(Vec2 v) const { return v - dot(v, capsule_.up) * capsule_.up; }

    Obstacles& obstacles_;
    const Capsule& capsule_;
    MoveSettings settings_;
    std::vector<Plane> planes_;
    Vec2 blocked_;  ///< normal of the last obstacle that is no ground and stopped it; zero: none
};

}  // namespace fettle::physics::detail
