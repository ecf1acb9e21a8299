#include <world/world_data.h>

#include <algorithm>
#include <atomic>
#include <cmath>

// A step writes the joints that act into constraints, by type and in the order of the nodes they
// belong to, solves those of some nodes at a time, and reads their impulses back.

namespace fettle::physics::detail {
namespace {

/// Joints that a thread takes at a time.
constexpr size_t joints_at_a_time = 128;

/// What is known of an awake joint before it is prepared: the node it belongs to, whether it can
/// break; nothing where it does not act.
constexpr uint8_t can_break = 0x80;
static_assert(2 * most_strips <= can_break);

/// A joint gives by load / (m·ω²), and m is that of its light body: hung from light links, a heavy
/// body would stretch them at the usual stiffness. Twice the stiffness is stable only if the sweeps
/// over the joints come nearer to agreeing: four instead of one.
bool bears_heavy_load(const SolverBody& a, const SolverBody& b) {
    constexpr float most = 10.0f;  // as heavy as the other
    if (a.inverse_mass == 0.0f || b.inverse_mass == 0.0f) return false;
    return a.inverse_mass > most * b.inverse_mass || b.inverse_mass > most * a.inverse_mass;
}

/// Other threads may read what does not move: a joint to it gets a copy, which it leaves as it is.
template <typename Constraint, typename Act>
void on_ends(std::vector<SolverBody>& bodies, Constraint& c, Act&& act) {
    const auto still = [](const SolverBody& body) {
        return body.inverse_mass == 0.0f && body.inverse_inertia == 0.0f;
    };
    SolverBody &a = bodies[c.ends.a], &b = bodies[c.ends.b];
    SolverBody copy;
    if (still(a)) {
        copy = a;
        act(copy, b);
    } else if (still(b)) {
        copy = b;
        act(a, copy);
    } else {
        act(a, b);
    }
}

}  // namespace

JointEnds WorldData::joint_ends(const JointRecord& joint) const {
    const auto [a, b] = joint.bodies;
    const BodyRecord &body_a = bodies[a], &body_b = bodies[b];
    JointEnds ends;
    ends.a = body_a.solver_index;
    ends.b = body_b.solver_index;
    ends.place = joint.place;
    ends.start_a =
        rotate({states[a].cosine, states[a].sine}, joint.anchors[0] - body_a.local_center);
    ends.start_b =
        rotate({states[b].cosine, states[b].sine}, joint.anchors[1] - body_b.local_center);
    ends.lever_a = ends.start_a;
    ends.lever_b = ends.start_b;
    ends.apart = body_b.center - body_a.center;
    ends.angle = (states[b].angle - states[a].angle) + (body_b.angle_rest - body_a.angle_rest);
    const float mass_a = solver_bodies[ends.a].inverse_mass;
    const float mass_b = solver_bodies[ends.b].inverse_mass;
    ends.inverse_a = {body_a.locked_x ? 0.0f : mass_a, body_a.locked_y ? 0.0f : mass_a};
    ends.inverse_b = {body_b.locked_x ? 0.0f : mass_b, body_b.locked_y ? 0.0f : mass_b};
    return ends;
}

JointFrame WorldData::joint_frame(const JointRecord& joint) const {
    const auto [a, b] = joint.bodies;
    return {.a = {states[a].cosine, states[a].sine},
            .center_a = bodies[a].center,
            .center_b = bodies[b].center,
            .anchor_a = joint.anchors[0],
            .angle_a = double(states[a].angle) + double(bodies[a].angle_rest),
            .angle_b = double(states[b].angle) + double(bodies[b].angle_rest)};
}

/// Which of the awake ones of a type act, in the order of their nodes.
template <class Constraint>
void WorldData::list_acting_joints(JointPlan& plan) {
    constexpr auto type = size_t(joint_type<typename Constraint::Data>);
    const auto& awake = awake_joints[type];
    joint_notes.resize(awake.size());
    share_out_range(threads, awake.size(), joints_at_a_time, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const JointRecord& joint = joints[awake[i]];
            const Role role = role_of(joint);
            if (role == Role::idle) forget_impulses(awake[i]);
            joint_notes[i] = 0;
            if (role != Role::acting) continue;  // asleep, it goes on as it was when it wakes
            // Unlike a contact, a joint writes on what it is moved by: all of them are of one line
            // of nodes, each solved after the other.
            const SolverEnd a = solver_ends[joint.bodies[0]], b = solver_ends[joint.bodies[1]];
            const StripNode node =
                above_both((a.index() != 0 ? a : b).strip(), (b.index() != 0 ? b : a).strip());
            joint_notes[i] =
                uint8_t(std::max<StripNode>(node, 1) | (joint.breakable() ? can_break : 0));
        }
    });
    plan.nodes.clear();
    for (const uint8_t note : joint_notes)
        if (note != 0) plan.nodes.count(note & ~can_break);
    plan.nodes.sum_up();
    auto next = plan.nodes.places();
    plan.joints.resize(plan.nodes.size());
    for (size_t i = 0; i < awake.size(); ++i) {
        if (joint_notes[i] == 0) continue;
        const uint32_t place = next[joint_notes[i] & ~can_break]++;
        plan.joints[place] = awake[i];
        if ((joint_notes[i] & can_break) != 0) strains.push_back({awake[i], place, {}, 0.0f});
    }
}

/// True if some of them bear a heavy load.
template <class Constraint>
bool WorldData::prepare_list(const JointStep& step, std::vector<Constraint>& made) {
    using Data = typename Constraint::Data;
    JointPlan& plan = joint_plans.of_type[size_t(joint_type<Data>)];
    list_acting_joints<Constraint>(plan);
    made.resize(plan.joints.size());
    std::atomic<bool> heavy = false;
    share_out_range(threads, made.size(), joints_at_a_time, [&](size_t begin, size_t end) {
        bool any = false;
        for (size_t i = begin; i < end; ++i) {
            const JointRecord& joint = joints[plan.joints[i]];
            const Data& data = std::get<std::vector<Data>>(joint_lists)[joint.place];
            Constraint& c = made[i];
            c = {};
            c.ends = joint_ends(joint);
            c.impulses = data.impulses;
            c.impulses.scale(step.impulse_ratio);
            const SolverBody &a = solver_bodies[c.ends.a], &b = solver_bodies[c.ends.b];
            c.prepare(data, joint_frame(joint), step, a, b);
            any |= bears_heavy_load(a, b);
        }
        if (any) heavy.store(true, std::memory_order_relaxed);
    });
    return heavy.load(std::memory_order_relaxed);
}

JointStep WorldData::prepare_joints(float h) {
    JointStep step;
    step.h = h;
    step.inverse_h = 1.0f / h;
    step.impulse_ratio = last_substep > 0.0f ? h / last_substep : 1.0f;
    strains.clear();
    bool heavy = false;
    std::apply([&](auto&... list) { ((heavy |= prepare_list(step, list)), ...); },
               joint_constraints);
    step.sweeps = heavy ? 4 : 1;
    step.rigid = make_softness(heavy ? min(120.0f, 0.5f / h) : min(60.0f, 0.25f / h), 2.0f, h);
    return step;
}

size_t WorldData::acting_joints() const {
    size_t count = 0;
    for (const JointPlan& plan : joint_plans.of_type) count += plan.joints.size();
    return count;
}

/// `visit(constraint)` for those of some nodes, type by type.
template <bool backwards, typename Visit>
void WorldData::for_each_joint_of(const StripNodes& nodes, Visit&& visit) {
    const auto pass = [&](auto& list) {
        using Data = typename std::remove_cvref_t<decltype(list)>::value_type::Data;
        const NodeRanges& ranges = joint_plans.of_type[size_t(joint_type<Data>)].nodes;
        const size_t begin = ranges.begin(nodes), end = ranges.end(nodes);
        for (size_t i = 0; i < end - begin; ++i) visit(list[backwards ? end - 1 - i : begin + i]);
    };
    std::apply([&](auto&... list) { (pass(list), ...); }, joint_constraints);
}

void WorldData::warm_start_joints(const StripNodes& nodes) {
    for_each_joint_of(nodes, [&](auto& c) {
        on_ends(solver_bodies, c, [&](SolverBody& a, SolverBody& b) { c.warm_start(a, b); });
    });
}

void WorldData::solve_joints(const JointStep& step, const StripNodes& nodes) {
    for (int sweep = 0; sweep < step.sweeps; ++sweep) {
        for_each_joint_of(nodes, [&](auto& c) {
            on_ends(solver_bodies, c, [&](SolverBody& a, SolverBody& b) { c.solve(a, b, step); });
        });
    }
}

/// Backwards: what the first pass carried down a chain, this one carries up.
void WorldData::relax_joints(const JointStep& step, const StripNodes& nodes) {
    for (int sweep = 0; sweep < step.sweeps; ++sweep) {
        for_each_joint_of<true>(nodes, [&](auto& c) {
            on_ends(solver_bodies, c, [&](SolverBody& a, SolverBody& b) { c.relax(a, b, step); });
        });
    }
}

/// Which bodies have joints, for `JointShare`.
void WorldData::find_jointed() {
    joint_share.clear();
    for (uint32_t node = 1; node < strips.all_nodes().end; ++node) {
        for_each_joint_of({node, node + 1}, [&](const auto& c) {
            for (const uint32_t body : {c.ends.a, c.ends.b})
                if (body != 0) joint_share.add(node, body);
        });
    }
    joint_share.unite();
}

void WorldData::strain_joints() {
    for (Strain& strain : strains) {
        auto add = [&](const auto& list) {
            strain.force = strain.force + list[strain.index].push();
            strain.torque += list[strain.index].twist();
        };
        with_list(joint_constraints, joints[strain.joint].type, add);
    }
}

/// Those that bore more than they can, in the mean over the step. They act no more.
void WorldData::break_joints(const JointStep& step) {
    const float rate = step.inverse_h / float(settings.substeps);
    for (const Strain& strain : strains) {
        const JointRecord& joint = joints[strain.joint];
        const V2 force = rate * strain.force;
        const float torque = rate * strain.torque;
        if (length(force) <= joint.break_force && std::fabs(torque) <= joint.break_torque) continue;
        const auto [a, b] = joint.bodies;
        event_sink().joint_broke.push_back({{strain.joint, joint_generations[strain.joint]},
                                            body_id(a),
                                            body_id(b),
                                            to_vec2(force),
                                            torque});
        set_joint_broken(strain.joint, true);
    }
}

void WorldData::store_joints(const JointStep& step) {
    auto pass = [&](auto& list) {
        using Data = typename std::remove_cvref_t<decltype(list)>::value_type::Data;
        share_out_range(threads, list.size(), joints_at_a_time, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const auto& c = list[i];
                Data& data = std::get<std::vector<Data>>(joint_lists)[c.ends.place];
                data.impulses = c.impulses;
                // What overflowed would begin the next step, and so last for ever.
                const V2 push = c.push();
                if (!std::isfinite(push.x + push.y + c.twist())) data.impulses = {};
                joints[data.joint].force = bounded(step.inverse_h * push, greatest_impulse);
                joints[data.joint].torque = bounded(step.inverse_h * c.twist(), greatest_impulse);
            }
        });
    };
    std::apply([&](auto&... list) { (pass(list), ...); }, joint_constraints);
    break_joints(step);
}

}  // namespace fettle::physics::detail
