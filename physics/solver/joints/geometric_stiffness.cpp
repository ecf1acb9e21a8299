#include <solver/joints/geometric_stiffness.h>
#include <solver/joints/joint_passes.h>
#include <solver/joints/long_levers.h>

namespace fettle::physics::detail {
namespace {

/// What the long levers of its joints ask of a body.
struct LeverNeeds {
    float inertia = 0.0f;  ///< at least, kg m²
    float reach = 0.0f;    ///< the longest lever, m
};

std::vector<LeverNeeds> needs_of_levers(const JointSource& source, JointScratch& joints,
                                        const std::vector<SolverBody>& all) {
    std::vector<LeverNeeds> needs(all.size());
    for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
        if (kind.separation == nullptr) return;
        const JointEnds& ends = kind.ends(array, k);
        const SolverBody &a = all[ends.a], &b = all[ends.b];
        if (!has_long_lever(ends, kind.pushes_at_b, a, b)) return;
        const JointRecord& joint = source.objects.joints[array.joints[k]];
        // A pass is exact for a body that only one joint holds, and nothing touches. Nothing that
        // only one joint holds at something fixed is thrown by its angle.
        const uint32_t alone = alone_at_fixed(source.objects, joint, a, b);
        const bool touches =
            alone == none || source.objects.bodies[alone].lists.first_contact != none;
        const auto add = [&](uint32_t body, Vec2 arm) {
            if (!moves(all[body])) return;
            LeverNeeds& need = needs[body];
            if (alone == none) need.reach = max(need.reach, length(arm));
            if (touches) need.inertia = max(need.inertia, least_inertia(arm, a, b));
        };
        add(ends.a, start_arm(ends, kind.pushes_at_b));
        add(ends.b, ends.start_b);
    });
    return needs;
}

}  // namespace

void raise_inertia(const JointSource& source, const JointStep& step, JointScratch& joints,
                   BodyScratch& bodies, bool far) {
    std::vector<SolverBody>& all = bodies.solver_bodies;
    GeometricStiffness stiffness;
    stiffness.reset(all.size());
    for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
        stiffness.add(kind.ends(array, k), source.objects.joints[array.joints[k]].force);
    });
    std::vector<LeverNeeds> needs;
    if (far) needs = needs_of_levers(source, joints, all);
    std::vector<bool> raised(all.size());
    for (uint32_t i = 1; i < all.size(); ++i) {
        const float before = all[i].inverse_inertia;
        float inverse = stiffness.inverse_inertia(i, before, step.h);
        if (far && needs[i].inertia * inverse > 1.0f) inverse = 1.0f / needs[i].inertia;
        if (inverse == before) continue;
        raised[i] = true;
        all[i].inverse_inertia = inverse;
        bodies.solver_forces[i].turn_change *= inverse / before;
    }
    for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
        const JointEnds& ends = kind.ends(array, k);
        if (raised[ends.a] || raised[ends.b]) kind.prepare(source, array, step, {k, k + 1});
        if (!far) return;
        const float reach = max(needs[ends.a].reach, needs[ends.b].reach);
        if (reach > near_reach) kind.ends(array, k).angle_share = near_reach / reach;
    });
}

}  // namespace fettle::physics::detail
