#pragma once

#include <fettle/physics/world.h>
#include <state/world_state.h>

#include <cmath>
#include <utility>

// When a body is at rest. After `sleep_delay` at rest, it may fall asleep.

namespace fettle::physics::detail {

/// A body of this extent or more is at rest below the sleep speed of the world, m.
inline constexpr float usual_extent = 0.07f;

/// A contact of a corner with the very end of an edge may end and begin again forever. The body
/// then slips back and forth in place: for moments it is up to `most_over_sleep_speed` times as
/// fast as the sleep speed, and on average it is slower than `mean_over_sleep_speed` times that
/// speed.
inline constexpr float most_over_sleep_speed = 6.0f, mean_over_sleep_speed = 0.4f;

/// A body that is slower is at rest, m/s. A small body that moves through its own size in the delay
/// is not. `sleep_speed`: that of the body or the world, m/s.
inline float rest_speed(float sleep_speed, const BodyRecord& body) {
    const float size = min(body.extent / usual_extent, 1.0f);
    return sleep_speed * size * size;
}

/// The speed of the fastest point of a body, m/s.
inline float fastest_speed(const BodyRecord& body, const BodyState& state) {
    return max(length(state.velocity), std::fabs(state.angular_velocity) * body.extent);
}

/// How far the center of a body and its farthest point around it have gone since `start`, which has
/// a center and an angle, m.
inline float way_since(const auto& start, const BodyRecord& body, float angle) {
    return length(body.center - start.center) + std::fabs(angle - start.angle) * body.extent;
}

/// True if a body at rest tips over: it turns faster and faster, so it has turned less than it
/// would have at its present speed. `turned`: the distance that its fastest point has moved around
/// the center of mass since it came to rest, m; `turning`: the present speed of this point, m/s;
/// both with the sign of the rotation, because a body that rocks turns back. A body that has hardly
/// turned, or that would have turned many times as far at its present speed, trembles in place.
inline bool tips_over(float sleep_speed, float sleep_delay, float turned, float turning) {
    constexpr float noticeable = 0.05f, least = 1.1f, most = 4.0f;
    const float moved = std::fabs(turned);
    const float steady = (turned < 0.0f ? -turning : turning) * sleep_delay;
    return moved > noticeable * sleep_speed * sleep_delay && steady > least * moved &&
           steady < most * moved;
}

/// A body that no contact supports is slow for a moment wherever it turns back: a ball at the top
/// of its flight, a pendulum at its greatest angle. It is at rest if, since it became slow, it went
/// no farther than at this part of the sleep speed, and is no faster now.
inline constexpr float hanging_over_sleep_speed = 0.05f;

/// True if a body that no contact supports is at rest. `slow`: its speed of rest, m/s.
inline bool hangs_still(float slow, const BodyRecord& body, const RestPose& rest,
                        const BodyState& state) {
    const float still = hanging_over_sleep_speed * slow;
    return fastest_speed(body, state) <= still &&
           way_since(rest, body, state.angle) <= still * body.sleep_time;
}

/// Counts the time that the body is at rest: slower than `sleep_speed` (m/s). `angle`: of the body,
/// rad. `speed`: of its fastest point, m/s; `turning`: of this point around the center of mass,
/// m/s.
inline void count_rest(float sleep_speed, float sleep_delay, BodyRecord& body, RestPose& rest,
                       float angle, float speed, float turning, float dt) {
    const float size = min(body.extent / usual_extent, 1.0f);
    const float slow = rest_speed(sleep_speed, body);
    const bool jerks =
        speed >= slow && speed < most_over_sleep_speed * slow && body.lists.touching > 0;
    if (speed >= slow && !jerks) {
        body.sleep_time = 0.0f;
        return;
    }
    const bool begins = body.sleep_time == 0.0f;
    // Corrections of overlaps move a body without velocity. At the speed of rest, its center and
    // its farthest point go no farther than this.
    const float way = begins ? 0.0f : way_since(rest, body, angle);
    const bool is_corrected = way > 2.0f * slow * body.sleep_time;
    const auto turned = [&] { return (angle - rest.angle) * body.extent; };
    if (begins || is_corrected ||
        (jerks && way > mean_over_sleep_speed * slow * size * sleep_delay)) {
        rest = {body.center, angle};
        body.sleep_time = 0.0f;
    }
    const float before = std::exchange(body.sleep_time, body.sleep_time + dt);
    if (before < sleep_delay && body.sleep_time >= sleep_delay &&
        tips_over(slow, sleep_delay, turned(), turning))
        body.sleep_time = 0.0f;
}

}  // namespace fettle::physics::detail
