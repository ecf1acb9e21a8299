// The biased pass moves bodies that overlap apart and closes the gaps of joints, and the relax pass
// takes the velocities of these corrections away. Where contacts and joints work against each
// other, it takes only a part of them: then the corrections shake the bodies for ever, and the
// impulses with which the next sub-step begins throw them. And impacts that the direct solver
// solves together, each with the speed of its approach, may give back more than they took, as in a
// row of balls. But contacts, and joints without motors and springs, give no energy to the bodies
// that they connect. So the kinetic energy of such a group after the step is at most that before
// the step plus the work of the forces. What is more is taken from its velocities. A correction
// that lifts a body is paid for, too, since the way of the body counts for the work of its weight.

#include <geometry/motion.h>
#include <solver/solvers.h>
#include <state/joint_kind.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace fettle::physics::detail {
namespace {

class StrainedGroups {
  public:
    StrainedGroups(const SolverInput& input, const Columns& columns, float h)
        : input_(input),
          objects_(input.objects),
          columns_(columns),
          inverse_h_(1.0f / h),
          seen_(input.bodies.solver_bodies.size(), 0) {
        seen_[0] = in_group;  // bodies that sleep
    }

    /// Limits the energy of the group of bodies to which a body belongs.
    void limit(uint32_t body) {
        if (finds_new(body)) limit_found(1.0f, 0.0f);
    }
    /// The same for a body that has become much faster, if contacts act in its group. A host that
    /// moves an anchor or winds up a rope gives energy, so the group may gain some in a step.
    void limit_gain(uint32_t body) {
        constexpr float most_gain = 1.1f, least = 0.5f;  // a factor of the energy; m/s
        if (finds_new(body) && touches_) limit_found(most_gain, 0.5f * least * least);
    }

  private:
    static constexpr uint8_t in_group = 1, in_driven_group = 2;

    struct Energy {
        double before = 0.0, work = 0.0, after = 0.0;  ///< J
        double mass = 0.0;
        double momentum_x = 0.0, momentum_y = 0.0;
    };

    /// Finds the group of a body. False if it is known already, or something gives energy to it.
    bool finds_new(uint32_t body) {
        if (seen_[objects_.bodies[body].solver_index] != 0) return false;
        find(body);
        return !driven_;
    }
    void find(uint32_t body) {
        group_.clear();
        driven_ = held_ = touches_ = false;
        add(body);
        for (size_t i = 0; i < group_.size() && !driven_; ++i) {
            const uint32_t from = group_[i];
            objects_.for_each_joint(from, [&](uint32_t slot, uint32_t side) {
                const JointRecord& joint = objects_.joints[slot];
                if (joint.awake_index == none || !joint.moves()) return;
                const auto gives_energy = joint_kind(joint.type).gives_energy;
                driven_ = driven_ || (gives_energy != nullptr && gives_energy(joint));
                add(joint.bodies[1 - side]);
            });
            objects_.for_each_contact(from, [&](uint32_t contact) {
                const ContactRecord& c = objects_.contacts[contact];
                if (!c.acts()) return;
                touches_ = true;
                driven_ = driven_ || c.surface_speed != 0.0f;
                add(objects_.other_body(contact, from));
            });
        }
        if (driven_)
            for (const uint32_t member : group_)
                seen_[objects_.bodies[member].solver_index] = in_driven_group;
    }
    void add(uint32_t body) {
        const BodyRecord& record = objects_.bodies[body];
        if (record.mobility != Mobility::dynamic || record.solver_index == 0) {
            held_ = true;
            driven_ = driven_ || (record.solver_index != 0 && !stands_still(columns_.states[body]));
            return;
        }
        uint8_t& seen = seen_[record.solver_index];
        driven_ = driven_ || seen == in_driven_group;
        if (seen != 0) return;
        seen = in_group;
        group_.push_back(body);
    }

    Energy energy() const {
        Energy sum;
        for (const uint32_t body : group_) {
            const uint32_t index = objects_.bodies[body].solver_index;
            const SolverBody& b = input_.bodies.solver_bodies[index];
            const SolverForce& f = input_.bodies.solver_forces[index];
            const BodyState& state = columns_.states[body];
            const float mass = inverse_or_zero(b.inverse_mass);
            const float inertia = inverse_or_zero(b.inverse_inertia);
            const auto motion = [&](Vec2 velocity, float turn) {
                return 0.5 * double(mass * length_squared(velocity) + inertia * turn * turn);
            };
            sum.before += motion(state.velocity, state.angular_velocity);
            sum.after += motion(b.velocity, b.angular_velocity);
            sum.work += double(inverse_h_ *
                               (mass * dot(f.change, b.shift) + inertia * f.turn_change * b.turn));
            sum.mass += double(mass);
            sum.momentum_x += double(mass * b.velocity.x);
            sum.momentum_y += double(mass * b.velocity.y);
        }
        return sum;
    }

    /// `gain` and `per_mass` (J/kg): what the group may gain.
    void limit_found(float gain, float per_mass) {
        const Energy e = energy();
        const double most = gain * max(float(e.before + e.work), 0.0f) + per_mass * float(e.mass);
        if (!(e.after > most)) return;
        // What nothing fixed holds keeps its momentum.
        Vec2 mean;
        double common = 0.0;
        if (!held_ && e.mass > 0.0) {
            mean = {float(e.momentum_x / e.mass), float(e.momentum_y / e.mass)};
            common = 0.5 * e.mass * double(length_squared(mean));
        }
        const double own = e.after - common;
        const float scale = own > 0.0 ? std::sqrt(max(float((most - common) / own), 0.0f)) : 0.0f;
        for (const uint32_t body : group_) {
            SolverBody& b = input_.bodies.solver_bodies[objects_.bodies[body].solver_index];
            b.velocity = mean + scale * (b.velocity - mean);
            b.angular_velocity *= scale;
        }
    }

    const SolverInput& input_;
    const ObjectState& objects_;
    const Columns& columns_;
    float inverse_h_;
    std::vector<uint8_t> seen_;    ///< by solver body
    std::vector<uint32_t> group_;  ///< slots
    bool driven_ = false;          ///< something may give energy to the group
    bool touches_ = false;         ///< a contact acts on one of its bodies
    bool held_ = false;            ///< something that it cannot move touches it or is joined to it
};

/// Whether a body has become faster in the step by so much more than its forces explain that its
/// group may have gained energy. Where contacts press bodies together that joints connect, as the
/// thighs of a doll that lands, each sub-step begins with the impulses of the one before, which do
/// not fit bodies that turn fast.
bool is_much_faster(const SolverBody& now, const SolverForce& force, const BodyState& before,
                    float inverse_h) {
    constexpr float most = 4.0f, least = 4.0f;  // times the energy; of its double per mass, (m/s)²
    // The square of the radius at which the mass would have the inertia of the body.
    const float arm = now.inverse_inertia > 0.0f ? now.inverse_mass / now.inverse_inertia : 0.0f;
    const auto energy = [arm](Vec2 velocity, float turn) {
        return length_squared(velocity) + arm * turn * turn;
    };
    const float work =
        2.0f * inverse_h * (dot(force.change, now.shift) + arm * force.turn_change * now.turn);
    const float at_first = energy(before.velocity, before.angular_velocity);
    return energy(now.velocity, now.angular_velocity) - work > most * at_first + least;
}

}  // namespace

void limit_strained(const SolverInput& input, const Columns& columns,
                    std::span<const uint32_t> pressed, float h) {
    const auto jointed = [&](uint32_t body) {
        return input.objects.bodies[body].lists.first_joint != none;
    };
    std::optional<StrainedGroups> groups;
    for (const uint32_t body : input.bodies.strained) {
        if (!groups) groups.emplace(input, columns, h);
        groups->limit(body);
    }
    for (const uint32_t contact : pressed) {
        const ContactRecord& c = input.objects.contacts[contact];
        if (!jointed(c.body_a) && !jointed(c.body_b)) continue;
        if (!groups) groups.emplace(input, columns, h);
        groups->limit(c.body_a);
        groups->limit(c.body_b);
    }
    const auto& joints = input.active.awake_joints;
    if (std::all_of(joints.begin(), joints.end(), [](const auto& of) { return of.empty(); }))
        return;
    const std::vector<uint32_t>& bodies = input.active.awake_bodies;
    for (size_t i = 0; i < bodies.size(); ++i) {
        const SolverBody& body = input.bodies.solver_bodies[i + 1];
        const SolverForce& force = input.bodies.solver_forces[i + 1];
        if (!is_much_faster(body, force, columns.states[bodies[i]], 1.0f / h) ||
            !jointed(bodies[i]))
            continue;
        if (!groups) groups.emplace(input, columns, h);
        groups->limit_gain(bodies[i]);
    }
}

}  // namespace fettle::physics::detail
