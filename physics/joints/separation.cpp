#include <joints/joint_handle.h>

#include <algorithm>
#include <cmath>

// How far a joint is from where it should hold its bodies. Only rigid parts and limits hold.

namespace fettle::physics {

using namespace detail;

namespace {

/// How far a value is outside of limits; if they cross, the upper one is used.
float beyond(float value, float lower, float upper) {
    return std::max({0.0f, std::min(lower, upper) - value, value - upper});
}

float gap_of(const Joint& joint) {
    return gap_between(joint).length();
}

float separation_of(const DistanceJoint& joint) {
    const float low = joint.min_length(), high = joint.max_length(), now = joint.distance();
    if (joint.hertz() < infinity) return beyond(now, low, high);
    const float length = std::min(std::max(joint.length(), std::min(low, high)), high);
    return std::abs(now - length);
}

/// Of a joint that slides along an axis between two limits.
float on_rail(const Joint& joint, const Vec2& axis, float lower, float upper) {
    const Vec2 normal(-axis.y, axis.x);
    return std::hypot(translation_along(joint, normal),
                      beyond(translation_along(joint, axis), lower, upper));
}
template <class Sliding>
float on_rail(const Sliding& joint) {
    return on_rail(joint, joint.axis(), joint.lower_translation(), joint.upper_translation());
}

float separation_of(const GrooveJoint& joint) {
    const Vec2 run = joint.end() - joint.anchor_a();
    return run.length() > 1e-6f ? on_rail(joint, run, 0.0f, run.length()) : gap_of(joint);
}

float angular_separation_of(const RatchetJoint& joint) {
    const float past = joint.caught_angle() - joint.angle();
    return std::max(0.0f, joint.backwards() ? -past : past);
}

}  // namespace

float Joint::separation() const {
    if (dormant()) return 0.0f;
    const auto as = [this]<class Type>(Type) { return world().joint<Type>(id_); };
    switch (type()) {
        case JointType::distance:
            return separation_of(as(DistanceJoint()));
        case JointType::revolute:
            return gap_of(*this);
        case JointType::prismatic:
            return on_rail(as(PrismaticJoint()));
        case JointType::wheel:
            return on_rail(as(WheelJoint()));
        case JointType::weld:
            return as(WeldJoint()).hertz() < infinity ? 0.0f : gap_of(*this);
        case JointType::pulley:
            return std::max(0.0f, as(PulleyJoint()).length_now() - as(PulleyJoint()).length());
        case JointType::groove:
            return separation_of(as(GrooveJoint()));
        case JointType::pin_slot:
            return on_rail(as(PinSlotJoint()));
        case JointType::mouse:
        case JointType::motor:
        case JointType::gear:
        case JointType::ratchet:
        case JointType::filter:
        case JointType::rotary_limit:
            break;
    }
    return 0.0f;
}

float Joint::angular_separation() const {
    if (dormant()) return 0.0f;
    const auto as = [this]<class Type>(Type) { return world().joint<Type>(id_); };
    const auto beyond_limits = [](const auto& joint) {
        return beyond(joint.angle(), joint.lower_angle(), joint.upper_angle());
    };
    switch (type()) {
        case JointType::revolute:
            return beyond_limits(as(RevoluteJoint()));
        case JointType::rotary_limit:
            return beyond_limits(as(RotaryLimitJoint()));
        case JointType::prismatic:
            return std::abs(as(PrismaticJoint()).angle());
        case JointType::weld: {
            const WeldJoint weld = as(WeldJoint());
            return weld.angular_hertz() < infinity ? 0.0f : std::abs(weld.angle());
        }
        case JointType::gear:
            return std::abs(as(GearJoint()).phase_now() - as(GearJoint()).phase());
        case JointType::ratchet:
            return angular_separation_of(as(RatchetJoint()));
        case JointType::mouse:
        case JointType::distance:
        case JointType::wheel:
        case JointType::motor:
        case JointType::pulley:
        case JointType::groove:
        case JointType::pin_slot:
        case JointType::filter:
            break;
    }
    return 0.0f;
}

}  // namespace fettle::physics
