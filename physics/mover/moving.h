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
};

/// A mover on its way through one step: it moves in short ways, and after each of them it stands
/// clear of all obstacles.
class Moving {
  public:
    Moving(Obstacles& obstacles, const Capsule& capsule, const MoveSettings& settings,
           const Position& start)
        : position(start), obstacles_(obstacles), capsule_(capsule), settings_(settings) {}

    /// A short way, at most half of the radius long.
    void advance(Vec2 way);
    /// Lists the dynamic bodies within the skin towards which `way` leads. The mover pushes them
    /// also in a step in which they were as fast as the mover, so no gap opens between them.
    void touch(Vec2 way);
    /// Moves it down by at most `reach` onto ground; false and not moved if there is none.
    bool settle(float reach);
    /// The plane of the ground below its feet; none in the air.
    std::optional<Plane> ground();
    /// True if nothing overlaps it by more than a tenth of its radius.
    bool has_room();
    /// The velocity without the parts that obstacles at its place stop.
    Vec2 clipped(Vec2 velocity);

    Position position;
    std::vector<Push> pushes;
    std::optional<Plane> wall, ceiling;
    std::optional<Plane> step;  ///< the last step that it climbed

  private:
    void slide(Vec2 way);
    void put_back(const Position& to) {
        obstacles_.put_aside(length(position - to));
        position = to;
    }
    bool step_up(const Position& start, Vec2 way);
    bool will_step_up(Vec2 way);
    void note_hits(Vec2 way, float overlap_allowed);
    std::vector<Bound> bounds(Vec2 way, bool with_distance) const;
    bool walkable(const Plane& plane, const Position& feet, Vec2 way);
    float cosine(const Plane& plane) const { return dot(plane.normal, capsule_.up); }
    bool is_steep(const Plane& plane) const {
        return cosine(plane) > 0.01f && cosine(plane) < settings_.least_cosine;
    }
    Vec2 lateral(Vec2 v) const { return v - dot(v, capsule_.up) * capsule_.up; }

    Obstacles& obstacles_;
    const Capsule& capsule_;
    MoveSettings settings_;
    std::vector<Plane> planes_;
};

}  // namespace fettle::physics::detail
