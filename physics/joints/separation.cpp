#include <joints/coordinate.h>
#include <joints/joint_handle.h>

#include <algorithm>
#include <cmath>

// How far a joint is from where it should hold its bodies. Only rigid parts and limits hold.

namespace fettle::physics {

using namespace detail;

namespace {

float angular_separation_of(const RatchetJoint& joint) {
    const float past = joint.caught_angle() - joint.angle();
    return std::max(0.0f, joint.backwards() ? -past : past);
}

}  // namespace

float Joint::separation() const {
    if (dormant()) return 0.0f;
    const JointRecord& record = live().joints[id_.index];
    const JointKind& kind = joint_kind(record.type);
    if (kind.separation == nullptr) return 0.0f;
    const Body a = body_a();
    const Vec2 axis = a ? a.world_vector({1.0f, 0.0f}) : Vec2(1.0f, 0.0f);
    return kind.separation(
        record, {world_anchor_a(), world_anchor_b(), {axis.x, axis.y}, record.anchors[0]});
}

float Joint::angular_separation() const {
    if (dormant()) return 0.0f;
    const auto as = [this]<class Type>(Type) { return world().joint<Type>(id_); };
    const auto beyond_limits = [](const auto& joint) {
        return Limits{joint.lower_angle(), joint.upper_angle()}.beyond(joint.angle());
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
