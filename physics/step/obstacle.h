#pragma once

#include <contacts/border.h>
#include <distance/distance.h>
#include <step/time_of_impact.h>

namespace fettle::physics::detail {

/// The least depth of a core, m. Resting contacts overlap by less.
inline constexpr float least_depth = 0.25f * speculative_margin;

/// Distance of a shape from what it hits at arrival, m: the normal must be that of the impact.
inline constexpr float hit_gap = 0.0005f;

/// A shape that is nearer to an obstacle than this at the start of a step had a contact in it, m.
inline constexpr float contact_gap = 0.5f * speculative_margin;

/// What a shape may meet on its way; computes when the shape or its core reaches it.
class Obstacle {
  public:
    /// `now`: the beginning of the motions.
    Obstacle(const FinishInput& in, uint32_t obstacle, const Motion& motion, float now);

    float time_of(const Sweep& shape, float gap) const {
        return is_border_ ? time_of_impact(shape, plane_.normal, plane_.depth, gap, now_)
                          : time_of_impact(shape, obstacle_, gap, now_);
    }
    bool is_beside(const Sweep& shape) const { return is_within(shape, contact_gap); }
    bool is_within(const Sweep& shape, float gap) const { return !(time_of(shape, gap) > now_); }
    /// The direction from the obstacle to the shape at time `t`; zero if they overlap.
    Vec2 direction_to(const Sweep& shape, float t) const {
        if (is_border_) return plane_.normal;
        return -direction_between(shape, obstacle_, t);
    }
    /// When a point that moves from `start` to `end` reaches the obstacle. A point that is in the
    /// obstacle already, but not deeper than `slip`, goes no deeper.
    Impact of_point(const Position& start, const Position& end, float slip) const;
    /// A segment of a chain stops nothing that comes from behind it.
    bool is_from_behind(const Position& start) const;

  private:
    /// `way`: of a point in the rest of the step, seen from the obstacle.
    Impact arrival(const Probe& hit, Vec2 way) const;
    /// A point stops before the obstacle on chord `i` of its way, which has this number of chords
    /// of equal duration.
    Impact stop_before(const Probe& hit, Vec2 chord, int i, int chords) const;

    /// Seen from an obstacle that turns, the way of a point is an arc. As one chord it would miss
    /// the obstacle, or meet it too late, when the point is already in it.
    Impact on_arc(const Position& start, const Position& end, int chords) const;

    /// The normal of the nearest side of the obstacle for a point in it, not deeper than `slip`;
    /// else zero.
    Vec2 way_out(Vec2 point, float slip) const;

    /// A direction in the frame of the obstacle, in world axes.
    Vec2 from_frame(Vec2 direction, float t) const {
        if (is_border_) return direction;
        return rotate(rotation_of(obstacle_.motion.rotation(t)), direction);
    }

    /// A place at a time, in the frame of the obstacle.
    Vec2 from_obstacle(const Position& place, float t) const {
        const Vec2 d = place - obstacle_.motion.center(t);
        return unrotate(rotation_of(obstacle_.motion.rotation(t)), d);
    }

    float now_;
    bool is_border_;
    BorderPlane plane_;
    Sweep obstacle_;
};

/// Between a shape and a point; both relative to the center of mass of the shape's body.
struct PointGap {
    Vec2 out;            ///< from the shape to the point; zero if they are far apart
    float width = 0.0f;  ///< m, negative in the shape
};
/// `most`: a point that is farther away is far apart, m.
PointGap gap_to_point(const Solid& shape, Vec2 point, float most);

/// From the center of mass of its body to the centroid of a shape, m, in world axes.
Vec2 centroid_of(const ObjectState& objects, const Columns& columns, uint32_t shape);
inline Vec2 centroid_of(const FinishInput& in, uint32_t shape) {
    return centroid_of(in.objects, in.columns, shape);
}
/// The centroid of a shape whose body moves, at a time.
Position centroid_at(const FinishInput& in, uint32_t shape, const Motion& motion, float t);

}  // namespace fettle::physics::detail
