#include "wild/checks/gaps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fettle::bench::wild {
namespace {

const BodyNow& end_of(int index, const std::vector<BodyNow>& bodies) {
    static const BodyNow world{.exists = true};
    return index == the_world ? world : bodies[std::size_t(index)];
}

float beyond(float value, float lower, float upper) {
    return std::max({lower - value, value - upper, 0.0f});
}

/// The vector between two anchors: across a line, and along it, m.
struct Line {
    float aside, travel;
};
Line on_line(const Anchors& at, const Vec2& along) {
    const Vec2 unit = along.normalized(), way = at.b - at.a;
    return {std::abs(unit.x * way.y - unit.y * way.x), unit.dot(way)};
}

Gap rail(const JointPlan& joint, const Anchors& at, float angle_of_a, const Vec2& usual_axis) {
    const Vec2 axis = placed(joint.vector("set_axis", usual_axis), Vec2{}, angle_of_a);
    const Line line = on_line(at, axis);
    return {line.aside + beyond(line.travel, joint.number("set_lower_translation", -infinity),
                                joint.number("set_upper_translation", infinity)),
            0};
}

}  // namespace

Anchors anchors_of(const JointPlan& joint, const std::vector<BodyNow>& bodies) {
    const BodyNow &a = end_of(joint.a, bodies), &b = end_of(joint.b, bodies);
    return {placed(joint.anchor_a, a.position, a.angle),
            placed(joint.anchor_b, b.position, b.angle)};
}

std::optional<Gap> gap_of(const JointPlan& joint, const std::vector<BodyNow>& bodies) {
    const BodyNow &a = end_of(joint.a, bodies), &b = end_of(joint.b, bodies);
    if (!a.exists || !b.exists) return {};
    const Anchors at = anchors_of(joint, bodies);
    const float apart = (at.b - at.a).length();
    const float angle = b.angle - a.angle - joint.number("set_reference_angle", 0);
    // A joint that holds the angle does not count whole turns.
    const float held = std::abs(std::remainder(angle, 2 * std::numbers::pi_v<float>));
    switch (joint.type) {
        case JointType::distance: {
            const bool rod = std::isinf(joint.number("set_hertz", infinity));
            const float length = joint.number("set_length", 1);
            const float most = joint.number("set_max_length", infinity);
            return Gap{rod ? std::abs(apart - std::min(length, most)) : beyond(apart, 0, most), 0};
        }
        case JointType::revolute:
            return Gap{apart, beyond(angle, joint.number("set_lower_angle", -infinity),
                                     joint.number("set_upper_angle", infinity))};
        case JointType::weld:
            return Gap{std::isinf(joint.number("set_hertz", infinity)) ? apart : 0,
                       std::isinf(joint.number("set_angular_hertz", infinity)) ? held : 0};
        case JointType::prismatic: {
            Gap gap = rail(joint, at, a.angle, {1, 0});
            gap.angle = held;
            return gap;
        }
        case JointType::pin_slot:
            return rail(joint, at, a.angle, {1, 0});
        case JointType::wheel:
            return rail(joint, at, a.angle, {0, 1});
        case JointType::groove: {
            const Vec2 way = joint.vector("set_end", {1, 0}) - joint.anchor_a;
            const Line line = on_line(at, placed(way, Vec2{}, a.angle));
            return Gap{line.aside + beyond(line.travel, 0, way.length()), 0};
        }
        case JointType::pulley: {
            const float rope =
                (at.a - joint.vector("set_ground_a", at.a)).length() +
                joint.number("set_ratio", 1) * (at.b - joint.vector("set_ground_b", at.b)).length();
            return Gap{std::max(rope - joint.number("set_length", infinity), 0.0f), 0};
        }
        default:
            return Gap{};
    }
}

}  // namespace fettle::bench::wild
