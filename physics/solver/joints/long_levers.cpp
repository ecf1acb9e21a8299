#include <solver/joints/joint_passes.h>
#include <solver/joints/long_levers.h>

namespace fettle::physics::detail {
namespace {

/// The moment of inertia, kg m², that a body needs whose joint pushes it at `arm` from its center.
float least_inertia(Vec2 arm, const SolverBody& a, const SolverBody& b) {
    return length_squared(arm) *
           inverse_or_zero(greatest_lever_ratio * (a.inverse_mass + b.inverse_mass));
}

/// The body of a joint that holds it at something that does not move, if it has no other joint;
/// else `none`.
uint32_t alone_at_fixed(const ObjectState& objects, const JointRecord& joint, const SolverBody& a,
                        const SolverBody& b) {
    if (moves(a) && moves(b)) return none;
    const uint32_t body = joint.bodies[moves(a) ? 0 : 1];
    const uint32_t edge = objects.bodies[body].lists.first_joint;
    return edge != none && objects.joints[edge >> 1].edges[edge & 1].next == none ? body : none;
}

}  // namespace

std::vector<LeverNeeds> needs_of_levers(const JointSource& source, JointScratch& joints,
                                        std::span<const SolverBody> bodies) {
    std::vector<LeverNeeds> needs(bodies.size());
    for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
        if (kind.separation == nullptr) return;
        const JointEnds& ends = kind.ends(array, k);
        const SolverBody &a = bodies[ends.a], &b = bodies[ends.b];
        if (!has_long_lever(ends, kind.pushes_at_b, a, b)) return;
        const JointRecord& joint = source.objects.joints[array.joints[k]];
        // A pass is exact for a body that only one joint holds, and nothing touches. Nothing that
        // only one joint holds at something fixed is thrown by its angle.
        const uint32_t alone = alone_at_fixed(source.objects, joint, a, b);
        const bool touches =
            alone == none || source.objects.bodies[alone].lists.first_contact != none;
        const auto add = [&](uint32_t body, Vec2 arm) {
            if (!moves(bodies[body])) return;
            LeverNeeds& need = needs[body];
            if (alone == none) need.reach = max(need.reach, length(arm));
            if (touches) need.inertia = max(need.inertia, least_inertia(arm, a, b));
        };
        add(ends.a, start_arm(ends, kind.pushes_at_b));
        add(ends.b, ends.start_b);
    });
    return needs;
}

}  // namespace fettle::physics::detail
