#pragma once

#include <fettle/physics/world.h>
#include <state/world_state.h>

// When a body is at rest. After `sleep_delay` at rest, it may fall asleep.

namespace fettle::physics::detail {

/// A body of this extent or more is at rest below the sleep speed of the world, m.
inline constexpr float usual_extent = 0.07f;

/// A contact that holds a corner on the last bit of an edge may let go and hold again forever. The
/// body then slips back and forth in place, for moments up to this many times as fast as the sleep
/// speed, and on average slower than this part of it.
inline constexpr float jerk = 6.0f, mean = 0.4f;

/// Counts the time that the body is at rest: slower than `sleep_speed` (m/s). `angle`: of the body,
/// rad. `speed`: of its fastest point, m/s.
inline void count_rest(float sleep_speed, float sleep_delay, BodyRecord& body, RestPose& rest,
                       float angle, float speed, float dt) {
    // A small body that moves through its own size in the delay is not at rest.
    const float size = min(body.extent / usual_extent, 1.0f);
    const float slow = sleep_speed * size * size;
    const bool jerks = speed >= slow && speed < jerk * slow && body.lists.touching > 0;
    if (speed >= slow && !jerks) {
        body.sleep_time = 0.0f;
        return;
    }
    const bool begins = body.sleep_time == 0.0f;
    const auto way = [&] {
        return length(body.center - rest.center) + std::fabs(angle - rest.angle) * body.extent;
    };
    if (begins || (jerks && way() > mean * slow * size * sleep_delay)) {
        rest = {body.center, angle};
        body.sleep_time = 0.0f;
    }
    body.sleep_time += dt;
}

}  // namespace fettle::physics::detail
