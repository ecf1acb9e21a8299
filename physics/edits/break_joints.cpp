#include <edits/edits.h>

#include <cmath>

// Joints whose load in a step exceeds what they can bear.

namespace fettle::physics::detail {

void break_joints(const Editing& e, const JointScratch& scratch, float rate) {
    for (const Strain& strain : scratch.strains) {
        const JointRecord& joint = e.objects.joints[strain.joint];
        const Vec2 force = rate * strain.force;
        const float torque = rate * strain.torque;
        if (length(force) <= joint.break_force && std::fabs(torque) <= joint.break_torque) continue;
        const auto [a, b] = joint.bodies;
        e.activity.events.joint_broke.push_back(
            {{strain.joint, e.columns.joint_generations[strain.joint]},
             body_id(e.columns, a),
             body_id(e.columns, b),
             force,
             torque});
        set_joint_broken(e, strain.joint, true);
    }
}

}  // namespace fettle::physics::detail
