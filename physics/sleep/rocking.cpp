#include <sleep/rest.h>
#include <sleep/rocking.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics::detail {
namespace {

/// A body is followed for this time, s; then it begins again from where it is.
constexpr float watch = 4.0f;
/// A body that gets farther than this has left: m for each m/s of its speed of rest. A body that
/// goes no farther than a quarter of it may fall asleep while it still moves.
constexpr float farthest = 12.8f, narrow = 0.25f * farthest;

/// Less than this is no way: m for each m/s.
constexpr float unnoticed = 0.3f;

/// A body that is this many times as fast as ever before in its stay was hit or pushed.
constexpr float sudden = 1.5f;

/// A body must have come back from this part of its greatest distance.
constexpr float most_of_way = 0.8f;

/// Damping of the velocity, 1/s.
constexpr float calming = 2.0f;

}  // namespace

bool is_fast(const BodyRecord& body, const BodyState& state, float slow) {
    return fastest_speed(body, state) >= slow;
}

Stay begun_stay(uint32_t slot, const BodyRecord& body, const BodyState& state) {
    return {slot, 0, state.angle, body.center, 0.0f, 0.0f, 0.0f, fastest_speed(body, state)};
}

bool continue_stay(Stay& stay, const BodyRecord& body, const BodyState& state, float slow,
                   float passed) {
    const float speed = fastest_speed(body, state);
    const float moved = way_since(stay, body, state.angle);
    if (moved > farthest * slow || speed > sudden * max(stay.fastest, slow)) return false;
    stay.time += passed;
    stay.fastest = max(stay.fastest, speed);
    stay.far = max(stay.far, moved);
    if (moved < 0.5f * stay.far) stay.back = stay.far;
    if (stay.time < watch) return true;
    // What swings as often as it is looked at is always found at the same place.
    if (stay.back < most_of_way * stay.far && stay.far > unnoticed * slow) return false;
    const uint32_t returns = stay.far <= narrow * slow ? stay.returns + 1 : 1;
    stay = {stay.body, returns, state.angle, body.center, 0.0f, 0.0f, 0.0f, stay.fastest};
    return true;
}

bool rocks(const Stay& stay) {
    return stay.returns > 0;
}

bool rocks_for_long(const Stay& stay) {
    return stay.returns > 1;
}

void calm(BodyState& state, float passed) {
    const float keep = 1.0f / (1.0f + calming * passed);
    state.velocity = keep * state.velocity;
    state.angular_velocity *= keep;
}

Stay* stay_of(std::vector<Stay>& stays, uint32_t body) {
    const auto place =
        std::lower_bound(stays.begin(), stays.end(), body,
                         [](const Stay& stay, uint32_t slot) { return stay.body < slot; });
    return place != stays.end() && place->body == body ? &*place : nullptr;
}

void end_stay(std::vector<Stay>& stays, uint32_t body) {
    if (const Stay* const stay = stay_of(stays, body))
        stays.erase(stays.begin() + (stay - stays.data()));
}

}  // namespace fettle::physics::detail
