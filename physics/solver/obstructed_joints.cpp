#include <solver/obstructed_joints.h>
#include <state/joint_kind.h>

namespace fettle::physics::detail {
namespace {

/// The gap for which an obstructed joint pulls, m: some 140 times the weight of its body, which
/// sinks into the obstacle by about as much.
constexpr float obstructed_gap = 0.01f;
/// Contacts bear at least this part of the pull.
constexpr float least_borne = 0.5f;
/// A contact bears the pull if it is against it, with this cosine at least, and overlaps by more
/// than `obstructed_gap`: its impulse may be missing, since a body that was thrown keeps none.
constexpr float against = 0.7f;

/// True if contacts with bodies that are not dynamic push a body along `direction`, with half of
/// `impulse` at least.
bool is_held_back(const ObjectState& objects, uint32_t body, Vec2 direction, float impulse) {
    float borne = 0.0f;
    objects.for_each_contact(body, [&](uint32_t contact) {
        const ContactRecord& c = objects.contacts[contact];
        const Mobility other = objects.bodies[objects.other_body(contact, body)].mobility;
        if (!c.acts() || other == Mobility::dynamic) return;
        const float along = dot(c.manifold.normal, direction) * (c.body_b == body ? 1.0f : -1.0f);
        for (int k = 0; k < c.manifold.count; ++k) {
            const ManifoldPoint& point = c.manifold.points[k];
            borne += max(along, 0.0f) * point.normal_impulse;
            if (along > against && point.separation < -obstructed_gap) borne = infinity;
        }
    });
    return borne > least_borne * impulse;
}

bool is_obstructed(const ObjectState& objects, const JointRecord& joint, float h) {
    const float pull = length(joint.force);
    if (!(pull > 0.0f)) return false;
    for (const size_t side : {0u, 1u}) {
        const uint32_t body = joint.bodies[side];
        const BodyRecord& record = objects.bodies[body];
        if (record.mobility != Mobility::dynamic || record.lists.first_contact == none) continue;
        // The joint pulls body b along its force, and body a against it.
        const Vec2 back = ((side == 0 ? 1.0f : -1.0f) / pull) * joint.force;
        if (is_held_back(objects, body, back, h * pull)) return true;
    }
    return false;
}

}  // namespace

void yield_to_obstacles(const JointSource& source, const JointStep& step, JointScratch& joints) {
    const ObjectState& objects = source.objects;
    if (objects.contact_slots.count == 0) return;
    const std::vector<SolverBody>& bodies = source.bodies.solver_bodies;
    for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
        const JointRecord& joint = objects.joints[array.joints[k]];
        JointEnds& ends = kind.ends(array, k);
        if (may_be_obstructed(joint.force, bodies[ends.a], bodies[ends.b], step.h) &&
            is_obstructed(objects, joint, step.h))
            ends.greatest_error = obstructed_gap;
    });
}

}  // namespace fettle::physics::detail
