#include <solver/joints/geometric_stiffness.h>
#include <solver/joints/joint_passes.h>
#include <solver/joints/long_levers.h>

namespace fettle::physics::detail {
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
