#include <solver/joints/geometric_stiffness.h>
#include <solver/joints/joint_passes.h>

namespace fettle::physics::detail {
void raise_inertia(const JointSource& source, const JointStep& step, JointScratch& joints,
                   BodyScratch& bodies) {
    std::vector<SolverBody>& all = bodies.solver_bodies;
    GeometricStiffness stiffness;
    stiffness.reset(all.size());
    for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
        stiffness.add(kind.ends(array, k), source.objects.joints[array.joints[k]].force);
    });
    std::vector<bool> raised(all.size());
    for (uint32_t i = 1; i < all.size(); ++i) {
        const float before = all[i].inverse_inertia;
        const float inverse = stiffness.inverse_inertia(i, before, step.h);
        if (inverse == before) continue;
        raised[i] = true;
        all[i].inverse_inertia = inverse;
        bodies.solver_forces[i].turn_change *= inverse / before;
    }
    for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
        const JointEnds& ends = kind.ends(array, k);
        if (raised[ends.a] || raised[ends.b]) kind.prepare(source, array, step, {k, k + 1});
    });
}

}  // namespace fettle::physics::detail
