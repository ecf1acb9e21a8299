#include <state/crowding.h>
#include <state/joint_kind.h>

#include <cmath>

namespace fettle::physics::detail {
namespace {

/// An upper bound of the strength of the joints of a body: of the parts of the body in their
/// directions and in their angles, if the other bodies did not turn.
struct StrengthBound {
    float along = 0.0f, turn = 0.0f;
    Vec2 arms;  ///< sum, in the coordinates of the body: 0 if the joints are all around
    float lengths = 0.0f;
    bool welded = false;

    void add(const BodyRecord& body, const BodyRecord& other, const JointRecord& joint,
             uint32_t side) {
        const float inverse = body.inverse_mass + other.inverse_mass;
        const Vec2 arm = Vec2(joint.anchors[side]) - body.local_center;
        const float by_turn = body.inverse_inertia * dot(arm, arm);
        along += body.inverse_mass / inverse;
        turn += by_turn / (inverse + by_turn);
        arms = arms + arm;
        lengths += std::abs(arm.x) + std::abs(arm.y);
        welded |= joint.type == JointType::weld;
    }
    bool may_exceed(float strength) const {
        if (welded) return true;
        const float aside = lengths > 0.0f ? (std::abs(arms.x) + std::abs(arms.y)) / lengths : 0.0f;
        const float half = 0.5f * (along - turn);
        return 0.5f * (along + turn) + std::sqrt(half * half + aside * aside * along * turn) >
               strength;
    }
};

}  // namespace

bool may_be_crowded(const ObjectState& objects, uint32_t body) {
    const BodyRecord& record = objects.bodies[body];
    if (record.lists.joint_count < least_crowding || record.inverse_mass == 0.0f) return false;
    StrengthBound bound;
    uint32_t count = 0;
    objects.for_each_joint(body, [&](uint32_t slot, uint32_t side) {
        const JointRecord& joint = objects.joints[slot];
        const auto holds = joint_kind(joint.type).holds;
        if (holds == nullptr || !holds(joint) || !objects.may_act(joint)) return;
        bound.add(record, objects.bodies[joint.bodies[side ^ 1]], joint, side);
        ++count;
    });
    constexpr float of_fixed_grid = 2.6f;  // the node of a grid beside one that does not move
    static_assert(1.05f * least_strength > of_fixed_grid);
    return count >= least_crowding && bound.may_exceed(1.05f * least_strength);
}

}  // namespace fettle::physics::detail
