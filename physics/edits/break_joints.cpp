#include <edits/edits.h>

#include <cmath>

// Joints whose load in a step exceeds their limits for breaking or for reporting.

namespace fettle::physics::detail {

void break_joints(const Editing& e, const JointScratch& scratch, float rate) {
    for (const Strain& strain : scratch.strains) {
        const JointRecord& joint = e.objects.joints[strain.joint];
        const Vec2 force = rate * strain.force;
        const float torque = rate * strain.torque;
        const auto exceeds = [&](float most_force, float most_torque) {
            return length(force) > most_force || std::fabs(torque) > most_torque;
        };
        const auto add_event = [&](auto& list) {
            const auto [a, b] = joint.bodies;
            const auto named = [&](uint32_t body) {
                return body == 0 ? BodyId() : body_id(e.columns, body);  // the world has no id
            };
            list.push_back({{strain.joint, e.columns.joint_generations[strain.joint]},
                            named(a),
                            named(b),
                            force,
                            torque});
        };
        if (exceeds(joint.report_force, joint.report_torque))
            add_event(e.activity.events.joint_loaded);
        if (!exceeds(joint.break_force, joint.break_torque)) continue;
        add_event(e.activity.events.joint_broke);
        set_joint_broken(e, strain.joint, true);
    }
}

}  // namespace fettle::physics::detail
