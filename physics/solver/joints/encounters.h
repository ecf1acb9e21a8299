#pragma once

#include <state/limits.h>
#include <state/world_state.h>

#include <algorithm>

namespace fettle::physics::detail {

/// A push goes into an obstacle if the cosine to its normal is greater than this.
inline constexpr float steep = 0.7f;

inline bool is_dynamic(const ObjectState& objects, uint32_t body) {
    return objects.bodies[body].mobility == Mobility::dynamic;
}

/// How directly a body is pushed into an obstacle.
struct Encounter {
    float into = 0.0f;  ///< the cosine, 0 if there is no obstacle
    Vec2 out;           ///< the normal of the obstacle
};

/// The obstacle that a body is pushed into most directly, of those that it overlaps by more than
/// `overlap`, or is nearer to than minus that. The impulse of that contact may be missing, since a
/// body that was thrown keeps none. `velocity`: of the push. `is_meant(obstacle)` says which
/// obstacles count.
template <typename IsMeant>
Encounter encounter_of(const ObjectState& objects, uint32_t body, Vec2 velocity, float overlap,
                       IsMeant&& is_meant) {
    Encounter most;
    objects.for_each_contact(body, [&](uint32_t slot) {
        const ContactRecord& c = objects.contacts[slot];
        const uint32_t other = objects.other_body(slot, body);
        if (!c.acts() || !is_meant(other)) return;
        const Vec2 out = c.body_b == body ? c.manifold.normal : -c.manifold.normal;
        if (std::any_of(c.manifold.points, c.manifold.points + c.manifold.count,
                        [=](const ManifoldPoint& p) { return p.separation < -overlap; }))
            if (-dot(out, velocity) > most.into) most = {-dot(out, velocity), out};
    });
    return most;
}
inline bool is_in_obstacle(const ObjectState& objects, uint32_t body, Vec2 velocity,
                           float overlap) {
    const auto is_fixed = [&](uint32_t other) { return !is_dynamic(objects, other); };
    return encounter_of(objects, body, velocity, overlap, is_fixed).into > steep;
}

/// True if a push goes into an obstacle, and along it into another one: the two hold the body in a
/// narrow gap.
template <typename IsMeant>
bool is_wedged(const ObjectState& objects, uint32_t body, Vec2 velocity, const Encounter& first,
               IsMeant&& is_meant) {
    constexpr float least = 0.05f;  // a cosine
    if (!(first.into > least)) return false;
    const Vec2 along = velocity + first.into * first.out;
    return encounter_of(objects, body, along, -speculative_margin, is_meant).into >
           least * length(along);
}

}  // namespace fettle::physics::detail
