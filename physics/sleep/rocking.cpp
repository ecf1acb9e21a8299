#include <sleep/rest.h>
#include <sleep/rocking.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics::detail {
namespace {

/// A body rocks in place from this time on, s. After the longest time, it must rest.
constexpr float least_time = 4.0f, longest_time = 16.0f;

/// A body that is this many times as fast as ever before in its stay was hit or pushed.
constexpr float sudden = 1.5f;

/// A body must have come back from this part of its greatest distance.
constexpr float most_of_way = 0.8f;

/// The part of the velocity that a second takes away is 1 - 1 / (1 + calming).
constexpr float calming = 2.0f;

float speed_of(const BodyRecord& body, const BodyState& state) {
    return max(length(state.velocity), std::fabs(state.angular_velocity) * body.extent);
}

bool comes_back(const Stay& stay) {
    return stay.back >= most_of_way * stay.far;
}

}  // namespace

bool is_fast(const BodyRecord& body, const BodyState& state, float slow) {
    return speed_of(body, state) >= slow;
}

Stay begun_stay(uint32_t slot, const BodyRecord& body, const BodyState& state) {
    return {slot, state.angle, body.center, 0.0f, 0.0f, 0.0f, speed_of(body, state)};
}

bool continue_stay(Stay& stay, const BodyRecord& body, const BodyState& state, float slow,
                   float passed) {
    const float speed = speed_of(body, state);
    const float moved =
        length(body.center - stay.center) + std::fabs(state.angle - stay.angle) * body.extent;
    const bool bounces = body.lists.touching == 0;
    if (bounces || moved > mean * slow * longest_time || speed > sudden * max(stay.fastest, slow))
        return false;
    stay.time += passed;
    stay.fastest = max(stay.fastest, speed);
    stay.far = max(stay.far, moved);
    if (moved < 0.5f * stay.far) stay.back = stay.far;
    return stay.time < least_time || comes_back(stay);
}

/// How long a body must stay until it rocks, s.
float time_to_rock(const Stay& stay, float slow) {
    return max(least_time, stay.far / (mean * slow));
}

bool rocks(const Stay& stay, float slow) {
    return stay.time >= time_to_rock(stay, slow) && comes_back(stay);
}

bool rocks_for_long(const Stay& stay, float slow) {
    return stay.time >= 2.0f * time_to_rock(stay, slow) && comes_back(stay);
}

void calm(BodyState& state, float passed) {
    const float keep = 1.0f / (1.0f + calming * passed);
    state.velocity = keep * state.velocity;
    state.angular_velocity *= keep;
}

Stay* stay_of(std::vector<Stay>& stays, uint32_t body) {
    const auto place = std::ranges::lower_bound(stays, body, {}, &Stay::body);
    return place != stays.end() && place->body == body ? &*place : nullptr;
}

void end_stay(std::vector<Stay>& stays, uint32_t body) {
    if (const Stay* const stay = stay_of(stays, body))
        stays.erase(stays.begin() + (stay - stays.data()));
}

}  // namespace fettle::physics::detail
