// Bodies that overlap are pushed apart, each with at most the push speed from its neighbors. In a
// crowd, where a body overlaps many others deeply, these speeds add up from one body to the next,
// and the relax pass cannot take all of them away: 500 discs in one spot flew apart with 25 m/s. So
// a push in a crowd makes no body faster than the push speed and than the bodies that it meets.
// Momentum is not kept there. Only worlds with crowded shapes need this
// (contacts/crowded_shapes.h).
//
// The same bound shows which contacts joints cannot resolve. Two bodies that hang on joints and are
// made to overlap may be unable to part in the direction of the push. Then the contact and the
// joints press against each other with hundreds of weights, and the bodies slip aside faster and
// faster. A push explains no more than the push speed, so such a contact does not act until the
// shapes have parted: the joints have priority (contacts/overlaps/held_open.h).

#include <contacts/overlaps/wedged_bodies.h>
#include <solver/free_motion.h>

#include <algorithm>
#include <vector>

namespace fettle::physics::detail {
namespace {

/// Number of others that a body overlaps deeply, in the middle of a crowd and at its edge.
constexpr uint32_t least_overlaps = 3, least_at_edge = 1;

struct OverlapLimits {
    const SolverInput& input;
    const Columns& columns;

    static float speed_of(Vec2 velocity, float angular_velocity, const BodyRecord& record) {
        return length(velocity) + std::fabs(angular_velocity) * record.extent;
    }
    /// True if the body overlaps `least` other bodies by more than a quarter of its thickness.
    bool overlaps_others(uint32_t body, uint32_t least) const {
        const BodyRecord& record = input.objects.bodies[body];
        if (record.lists.contact_count < least || record.mobility != Mobility::dynamic)
            return false;
        uint32_t overlaps = 0;
        input.objects.for_each_contact(body, [&](uint32_t contact) {
            const ContactRecord& c = input.objects.contacts[contact];
            const BodyRecord& other = input.objects.bodies[input.objects.other_body(contact, body)];
            const float deep = -0.25f * min(record.thickness, other.thickness);
            for (int i = 0; i < c.manifold.count; ++i)
                if (!c.sensor && c.manifold.points[i].separation < deep) {
                    ++overlaps;
                    break;
                }
        });
        return overlaps >= least;
    }
    /// Speed that the fastest point of a body would have after the step without contacts.
    float free_speed_of(uint32_t body) const {
        const FreeMotion motion = FreeMotion::of(input, columns, body);
        return speed_of(motion.velocity, motion.turn, input.objects.bodies[body]);
    }

    /// The greatest speed that the body can get from forces, from its contacts, and from joints; or
    /// less, but then at least `enough`.
    float greatest_speed_of(uint32_t body, float enough) const {
        const ObjectState& objects = input.objects;
        float most = max(free_speed_of(body), input.settings.push_speed);
        if (most >= enough) return most;
        const bool found = objects.any_contact(
            objects.bodies[body].lists.first_contact, none, [&](uint32_t contact) {
                const ContactRecord& c = objects.contacts[contact];
                if (c.manifold.count == 0 || c.sensor) return false;
                const float speed = free_speed_of(objects.other_body(contact, body));
                most = max(most, (1.0f + c.restitution) * speed + std::fabs(c.surface_speed));
                return most >= enough;
            });
        if (found) return most;
        objects.for_each_joint(body, [&](uint32_t joint, uint32_t side) {
            most = max(most, free_speed_of(objects.joints[joint].bodies[side ^ 1]));
        });
        return most;
    }

    /// Returns whether the body was too fast.
    bool limit(uint32_t body) const {
        const uint32_t index = input.objects.bodies[body].solver_index;
        SolverBody& b = input.bodies.solver_bodies[index];
        const float speed = speed_of(b.velocity, b.angular_velocity, input.objects.bodies[body]);
        const float most = greatest_speed_of(body, speed);
        if (speed <= most) return false;
        b.velocity = (most / speed) * b.velocity;
        b.angular_velocity *= most / speed;
        return true;
    }
};

}  // namespace

void limit_pushes(const SolverInput& input, const Columns& columns) {
    const OverlapLimits limits = {input, columns};
    ObjectState& objects = input.objects;
    const std::vector<uint32_t>& awake = input.active.awake_bodies;
    if (std::none_of(awake.begin(), awake.end(),
                     [&](uint32_t body) { return limits.overlaps_others(body, least_overlaps); }))
        return;
    std::vector<uint32_t> open;
    std::vector<bool> seen;  // by index in the solver
    const auto add = [&](uint32_t body) {
        const BodyRecord& record = objects.bodies[body];
        if (record.mobility != Mobility::dynamic || seen[record.solver_index]) return;
        seen[record.solver_index] = true;
        open.push_back(body);
    };
    seen.resize(awake.size() + 1);
    seen[0] = true;  // bodies that sleep
    for (const uint32_t body : awake)
        if (limits.overlaps_others(body, least_at_edge)) add(body);
    // A body that was too fast may have made the bodies that it pushed too fast as well.
    for (size_t i = 0; i < open.size(); ++i) {
        const uint32_t body = open[i];
        if (!limits.limit(body)) continue;
        input.bodies.limited.push_back(body);
        objects.for_each_contact(body, [&](uint32_t contact) {
            const ContactRecord& c = objects.contacts[contact];
            if (c.manifold.count > 0 && !c.sensor) add(objects.other_body(contact, body));
        });
    }
}

size_t find_jammed(const SolverInput& input, const Columns& columns, std::span<uint32_t> pressed) {
    const OverlapLimits limits = {input, columns};
    const auto end = std::stable_partition(pressed.begin(), pressed.end(), [&](uint32_t contact) {
        const ContactRecord& c = input.objects.contacts[contact];
        if (!is_pinned(input.objects, c)) return false;
        const bool a_was_fast = limits.limit(c.body_a), b_was_fast = limits.limit(c.body_b);
        return a_was_fast || b_was_fast;
    });
    return size_t(end - pressed.begin());
}

}  // namespace fettle::physics::detail
