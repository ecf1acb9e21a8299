#pragma once

#include <fettle/physics/world.h>
#include <sleep/drawn.h>
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

/// Looks at a body that has been slow for the whole delay, twice `half` seconds. If a force draws
/// it, the second half becomes the first one. A body came to rest at the end of a step, so its
/// first half is shorter by a step of `dt`.
inline void check_drawn(float slow, float half, BodyRecord& body, RestPose& rest,
                        const BodyState& state, float dt) {
    const float over = body.sleep_time - 2.0f * half;
    const Vec2 way = body.center - rest.center - over * state.velocity - rest.first_way;
    const Vec2 first = (1.0f / (half - dt)) * rest.first_way, second = (1.0f / half) * way;
    if (!is_drawn(slow, half, first, second, state.velocity, rest.drawn_time)) return;
    const Vec2 step = 0.5f * dt * (first + second);
    rest = {rest.center + rest.first_way + step, state.angle, way - step, rest.drawn_time + half};
    body.sleep_time -= half;
}

/// Counts the time that the body is at rest: slower than `sleep_speed` (m/s). `speed`: of its
/// fastest point, m/s.
inline void count_rest(float sleep_speed, float sleep_delay, BodyRecord& body, RestPose& rest,
                       const BodyState& state, float speed, float dt) {
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
    const float way = begins ? 0.0f : way_since(rest, body, state.angle);
    const bool is_corrected = way > 2.0f * slow * body.sleep_time;
    if (begins || is_corrected ||
        (jerks && way > mean_over_sleep_speed * slow * size * sleep_delay)) {
        rest = {body.center, state.angle, {}};
        body.sleep_time = 0.0f;
    }
    const float before = std::exchange(body.sleep_time, body.sleep_time + dt);
    const float half = 0.5f * sleep_delay;
    if (body.sleep_time < half || before >= sleep_delay) return;
    if (before < half)
        rest.first_way = body.center - rest.center - (body.sleep_time - half) * state.velocity;
    else if (body.sleep_time >= sleep_delay)
        check_drawn(slow, half, body, rest, state, dt);
}

}  // namespace fettle::physics::detail
