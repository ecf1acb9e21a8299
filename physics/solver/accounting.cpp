#include <solver/accounting.h>
#include <state/joint_kind.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics::detail {
namespace {

Vec2 along(const ContactConstraint& c, float normal, float tangent) {
    return normal * c.normal + tangent * right_perp(c.normal);
}

VelocitySums::OfContact& sum_of(VelocitySums& sums, uint32_t contact) {
    for (VelocitySums::OfContact& sum : sums.contacts)
        if (sum.contact == contact) return sum;
    return sums.contacts.emplace_back(VelocitySums::OfContact{.contact = contact});
}

VelocitySums::OfJoint& sum_of_joint(VelocitySums& sums, uint32_t slot) {
    for (VelocitySums::OfJoint& sum : sums.joints)
        if (sum.slot == slot) return sum;
    return sums.joints.emplace_back(VelocitySums::OfJoint{.slot = slot});
}

/// Calls `add(lane)` for the lanes of a group that contain the body.
void for_lanes(const WideContact& wide, uint32_t body, auto&& add) {
    for (int lane = 0; lane < group_size; ++lane) {
        if (wide.a[lane] == wide.b[lane]) return;  // the rest is unused
        if (wide.a[lane] == body || wide.b[lane] == body) add(lane);
    }
}

/// The angular impulse at one point on the body of a side, -1: a, 1: b; with its size.
struct Twist {
    float sum = 0.0f, size = 0.0f;

    void add(float side, float normal_lever, float tangent_lever, float normal, float tangent) {
        const float n = normal_lever * normal, t = tangent_lever * tangent;
        sum += side * (n + t);
        size += std::fabs(n) + std::fabs(t);
    }
    void add(float side, const ConstraintPoint& p, float normal, float tangent) {
        add(side, side < 0.0f ? p.normal_lever_a : p.normal_lever_b,
            side < 0.0f ? p.tangent_lever_a : p.tangent_lever_b, normal, tangent);
    }
};

void add_twist(VelocitySums& sums, VelocitySums::OfContact& sum, const Twist& twist) {
    sum.twist += twist.sum;
    sums.turn.size += twist.size;
}

void add_wide(VelocitySums& sums, const SolverInput& input, const SolverBlock& block,
              WideBlock& from) {
    for (size_t group = block.first_group; group < block.group_end; ++group) {
        const WideContact& wide = *from.contacts_of(group);
        for_lanes(wide, sums.solver_body, [&](int lane) {
            const Vec2 n = {wide.normal_x[lane], wide.normal_y[lane]};
            const bool second = wide.b[lane] == sums.solver_body;
            const float side = second ? 1.0f : -1.0f;
            const uint32_t acting = input.contacts.lane_contacts[group * group_size + size_t(lane)];
            VelocitySums::OfContact& sum = sum_of(sums, input.contacts.acting[acting].slot);
            Twist twist;
            for (const WidePoint& p : wide.points) {
                const float normal = p.normal_impulse[lane], tangent = p.tangent_impulse[lane];
                sum.impulse = sum.impulse + side * (normal * n + tangent * right_perp(n));
                twist.add(side, (second ? p.normal_lever_b : p.normal_lever_a)[lane],
                          (second ? p.tangent_lever_b : p.tangent_lever_a)[lane], normal, tangent);
            }
            add_twist(sums, sum, twist);
        });
    }
}

/// Calls `add(constraint, sum, side)` for those of the contacts that are on the body.
void for_single(VelocitySums& sums, const SingleContacts& contacts, auto&& add) {
    for (const ContactConstraint& c : contacts.constraints)
        if (c.a == sums.solver_body || c.b == sums.solver_body)
            add(c, sum_of(sums, c.contact), c.b == sums.solver_body ? 1.0f : -1.0f);
}

/// True if the normal and the levers of a contact follow its bodies. Such a contact has one point.
bool is_curved(const SolverInput& input, const ContactConstraint& c) {
    return c.extra != 0 && input.contacts.serial.extras[c.extra - 1].rolling != 0;
}

void add_serial(VelocitySums& sums, const SolverInput& input) {
    for_single(sums, input.contacts.serial,
               [&](const ContactConstraint& c, VelocitySums::OfContact& sum, float side) {
                   Twist twist;
                   const bool curved = is_curved(input, c);
                   if (curved) {
                       sum.impulse = sum.impulse + sum.biased_impulse;
                       twist.sum = sum.biased_twist;
                   }
                   for (int k = 0; k < c.count; ++k) {
                       const ConstraintPoint& p = c.points[k];
                       const Vec2 done = curved ? sum.biased : Vec2{};
                       const float normal = p.normal_impulse - done.x,
                                   tangent = p.tangent_impulse - done.y;
                       sum.impulse = sum.impulse + side * along(c, normal, tangent);
                       twist.add(side, p, normal, tangent);
                       sum.counted[k] += p.normal_impulse;
                   }
                   if (c.extra != 0)
                       twist.add(side, 1.0f, 0.0f,
                                 input.contacts.serial.extras[c.extra - 1].rolling_impulse, 0.0f);
                   add_twist(sums, sum, twist);
               });
}

/// Calls `add(kind, array, index, sum, side)` for the joints of a body.
void for_joints(VelocitySums& sums, const SolverInput& input, auto&& add) {
    if (input.objects.bodies[sums.body.index].lists.joint_count == 0) return;
    for (size_t i = 0; i < input.joints.joint_arrays.size(); ++i) {
        const JointArray& array = input.joints.joint_arrays[i];
        const JointKind& kind = joint_kind(JointScratch::type_of(i));
        for (size_t k = 0; k < array.joints.size(); ++k) {
            const uint32_t slot = array.joints[k];
            const auto& bodies = input.objects.joints[slot].bodies;
            if (bodies[0] == sums.body.index || bodies[1] == sums.body.index)
                add(kind, array, k, sum_of_joint(sums, slot),
                    bodies[1] == sums.body.index ? size_t{1} : size_t{0});
        }
    }
}

/// A sub-step begins with the impulses of the last one, at the levers that they had.
void begin_joint(const JointKind& kind, const JointArray& array, size_t k,
                 VelocitySums::OfJoint& sum, size_t side) {
    sum.known = kind.impulses(array, k);
    const JointLoad load = kind.load_on(array, k, sum.known, side);
    sum.now_impulse = load.push;
    sum.now_twist = load.twist;
    sum.now_moment = load.moment;
}

/// Adds what a pass has changed, at the present levers.
void follow_joint(const JointKind& kind, const JointArray& array, size_t k,
                  VelocitySums::OfJoint& sum, size_t side) {
    const JointImpulses now = kind.impulses(array, k);
    const JointLoad all = kind.load_on(array, k, now, side),
                    old = kind.load_on(array, k, sum.known, side);
    sum.known = now;
    sum.now_impulse = sum.now_impulse + (all.push - old.push);
    sum.now_twist += all.twist - old.twist;
    sum.now_moment = std::max(sum.now_moment, all.moment);
}

void add_joints(VelocitySums& sums, const SolverInput& input) {
    for_joints(sums, input,
               [&](const JointKind& kind, const JointArray& array, size_t k,
                   VelocitySums::OfJoint& sum, size_t side) {
                   follow_joint(kind, array, k, sum, side);
                   sum.impulse = sum.impulse + sum.now_impulse;
                   sum.twist += sum.now_twist;
                   sums.turn.size += std::fabs(sum.now_twist) + sum.now_moment;
                   begin_joint(kind, array, k, sum, side);
               });
}

/// The impulses of bounces are not in those of any sub-step.
void add_bounces(VelocitySums& sums, const SingleContacts& contacts) {
    for_single(sums, contacts,
               [&](const ContactConstraint& c, VelocitySums::OfContact& sum, float side) {
                   if (c.extra == 0) return;
                   const ContactExtra& extra = contacts.extras[c.extra - 1];
                   const BounceSum& first = extra.bounced;
                   sum.impulse = sum.impulse + side * first.impulse;
                   Twist twist;
                   twist.add(side, 1.0f, 0.0f, side < 0.0f ? first.twist_a : first.twist_b, 0.0f);
                   // At the end of the step, or by another solver.
                   for (int k = 0; k < c.count; ++k) {
                       const float bounced = extra.total[k] - sum.counted[k] - first.normal[k];
                       sum.impulse = sum.impulse + side * along(c, bounced, 0.0f);
                       twist.add(side, c.points[k], bounced, 0.0f);
                   }
                   add_twist(sums, sum, twist);
               });
}

}  // namespace

void begin_sums(const SolverInput& input, const Columns& columns, uint64_t steps, float h) {
    for (VelocitySums& sums : input.sums) {
        const bool follows = sums.step != 0 && sums.step == steps && sums.solver_body != 0;
        const Vec2 earlier = sums.after;
        const float earlier_turn = sums.turn.after;
        sums = {.body = sums.body, .step = steps + 1};
        if (!columns.is_valid(sums.body)) continue;
        const BodyRecord& record = input.objects.bodies[sums.body.index];
        if (record.mobility != Mobility::dynamic || record.solver_index == 0) continue;
        sums.solver_body = record.solver_index;
        const SolverBody& body = input.bodies.solver_bodies[sums.solver_body];
        const SolverForce& force = input.bodies.solver_forces[sums.solver_body];
        const Vec2 moves = {record.flags.locked_x ? 0.0f : 1.0f,
                            record.flags.locked_y ? 0.0f : 1.0f};
        const float substeps = float(input.settings.substeps);
        sums.inverse_mass = body.inverse_mass * moves;
        sums.before = body.velocity;
        sums.earlier = follows ? earlier : sums.before;
        sums.gravity = substeps * h * record.gravity_scale * scaled(moves, input.settings.gravity);
        sums.force = substeps * h * scaled(sums.inverse_mass, record.load.force);
        sums.applied = substeps * h * scaled(sums.inverse_mass, record.step_load.force);
        sums.fields =
            substeps * scaled(moves, force.change) - (sums.gravity + sums.force + sums.applied);
        VelocitySums::OfTurn& turn = sums.turn;
        turn.inverse_inertia = record.flags.locked_rotation ? 0.0f : body.inverse_inertia;
        turn.before = body.angular_velocity;
        turn.earlier = follows ? earlier_turn : turn.before;
        const float by_torque = substeps * h * turn.inverse_inertia;
        turn.torque = by_torque * record.load.torque;
        turn.applied = by_torque * record.step_load.torque;
        if (turn.inverse_inertia > 0.0f)
            turn.fields = substeps * force.turn_change - (turn.torque + turn.applied);
    }
}

void add_to_joint(std::span<VelocitySums> all, uint32_t joint, uint32_t solver_body,
                  const double (&on)[3], double impulse) {
    if (solver_body == 0) return;
    for (VelocitySums& sums : all) {
        if (sums.solver_body != solver_body) continue;
        VelocitySums::OfJoint& sum = sum_of_joint(sums, joint);
        const auto twist = float(impulse * on[2]);
        sum.impulse = sum.impulse + Vec2{float(impulse * on[0]), float(impulse * on[1])};
        sum.twist += twist;
        sums.turn.size += std::fabs(twist);
    }
}

void add_biased(const SolverInput& input) {
    for (VelocitySums& sums : input.sums) {
        if (sums.solver_body == 0 || sums.block != 0) continue;
        for_single(sums, input.contacts.serial,
                   [&](const ContactConstraint& c, VelocitySums::OfContact& sum, float side) {
                       if (!is_curved(input, c)) return;
                       const ConstraintPoint& p = c.points[0];
                       Twist twist;
                       twist.add(side, p, p.normal_impulse, p.tangent_impulse);
                       sum.biased = {p.normal_impulse, p.tangent_impulse};
                       sum.biased_impulse = side * along(c, p.normal_impulse, p.tangent_impulse);
                       sum.biased_twist = twist.sum;
                   });
        for_joints(sums, input, follow_joint);
    }
}

void begin_substeps(const SolverInput& input, const SolverBlock& block) {
    for (VelocitySums& sums : input.sums) {
        const std::span bodies = input.schedule.blocks.bodies_of(block);
        if (sums.solver_body == 0 ||
            std::find(bodies.begin(), bodies.end(), sums.solver_body) == bodies.end())
            continue;
        sums.block = uint32_t(&block - &input.schedule.blocks[0]);
        sums.last = input.bodies.solver_bodies[sums.solver_body].velocity;
        sums.turn.last = input.bodies.solver_bodies[sums.solver_body].angular_velocity;
        if (sums.block == 0) for_joints(sums, input, begin_joint);
    }
}

void add_substep(const SolverInput& input, const SolverBlock& block, WideBlock& wide) {
    const auto index = uint32_t(&block - &input.schedule.blocks[0]);
    for (VelocitySums& sums : input.sums) {
        if (sums.solver_body == 0 || sums.block != index) continue;
        add_wide(sums, input, block, wide);
        if (index == 0) {
            add_serial(sums, input);
            add_joints(sums, input);
        }
        const SolverForce& force = input.bodies.solver_forces[sums.solver_body];
        const auto lost_by = [](float keep, float inverse_mass) {
            return inverse_mass > 0.0f ? keep - 1.0f : 0.0f;  // not along a locked axis
        };
        const Vec2 lost = {lost_by(force.keep.x, sums.inverse_mass.x),
                           lost_by(force.keep.y, sums.inverse_mass.y)};
        sums.damping = sums.damping + scaled(lost, sums.last + force.change);
        sums.last = input.bodies.solver_bodies[sums.solver_body].velocity;
        VelocitySums::OfTurn& turn = sums.turn;
        turn.damping +=
            lost_by(force.turn_keep, turn.inverse_inertia) * (turn.last + force.turn_change);
        turn.last = input.bodies.solver_bodies[sums.solver_body].angular_velocity;
    }
}

void end_sums(const SolverInput& input, const Columns& columns) {
    const ObjectState& objects = input.objects;
    for (VelocitySums& sums : input.sums) {
        if (sums.solver_body == 0) continue;
        if (const AttractedBody* const pulled = input.bodies.attractions.find(sums.solver_body))
            sums.fields = sums.fields + pulled->difference;
        add_bounces(sums, input.contacts.serial);
        add_bounces(sums, input.contacts.passing);
        std::erase_if(sums.contacts, [](const VelocitySums::OfContact& sum) {
            return sum.impulse.x == 0.0f && sum.impulse.y == 0.0f && sum.twist == 0.0f;
        });
        for (VelocitySums::OfContact& sum : sums.contacts) {
            const ContactRecord& c = objects.contacts[sum.contact];
            const bool first = c.body_a == sums.body.index;
            sum.own = shape_id(objects, columns, first ? c.shape_a : c.shape_b);
            sum.other = shape_id(objects, columns, first ? c.shape_b : c.shape_a);
            sum.body = body_id(columns, first ? c.body_b : c.body_a);
        }
        for (VelocitySums::OfJoint& sum : sums.joints)
            sum.joint = {sum.slot, columns.joint_generations[sum.slot]};
    }
}

void store_velocities_after(std::span<VelocitySums> all, const Columns& columns) {
    for (VelocitySums& sums : all) {
        if (sums.solver_body == 0) continue;
        const BodyState& state = columns.states[sums.body.index];
        sums.after = state.velocity;
        sums.turn.after = state.angular_velocity;
    }
}

}  // namespace fettle::physics::detail
