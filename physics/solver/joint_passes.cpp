#include <solver/joint_passes.h>
#include <state/active_lists.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace fettle::physics::detail {
namespace {

/// Joints that a thread takes at a time.
constexpr size_t joints_at_a_time = 128;

/// The note of an awake joint before it is prepared: the node it belongs to, and this bit if it can
/// break; 0 if it does not act.
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

/// Other threads may read a body that does not move: a joint to it gets a copy, and the body is not
/// written.
template <typename Constraint, typename Act>
void on_ends(std::span<SolverBody> bodies, Constraint& c, Act&& act) {
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

/// Writes the joints of a step into constraints.
struct JointPreparation {
    ObjectState& objects;
    const Columns& columns;
    const ActiveLists& active;
    const BodyScratch& bodies;
    JointScratch& scratch;
    ThreadPool* threads;

    JointEnds ends_of(const JointRecord& joint) const {
        const auto [a, b] = joint.bodies;
        const BodyRecord &body_a = objects.bodies[a], &body_b = objects.bodies[b];
        JointEnds ends;
        ends.a = body_a.solver_index;
        ends.b = body_b.solver_index;
        ends.place = joint.place;
        ends.start_a = rotate({columns.states[a].cosine, columns.states[a].sine},
                              joint.anchors[0] - body_a.local_center);
        ends.start_b = rotate({columns.states[b].cosine, columns.states[b].sine},
                              joint.anchors[1] - body_b.local_center);
        ends.lever_a = ends.start_a;
        ends.lever_b = ends.start_b;
        ends.apart = body_b.center - body_a.center;
        ends.angle = (columns.states[b].angle - columns.states[a].angle) +
                     (body_b.angle_rest - body_a.angle_rest);
        const float mass_a = bodies.solver_bodies[ends.a].inverse_mass;
        const float mass_b = bodies.solver_bodies[ends.b].inverse_mass;
        ends.inverse_a = {body_a.locked_x ? 0.0f : mass_a, body_a.locked_y ? 0.0f : mass_a};
        ends.inverse_b = {body_b.locked_x ? 0.0f : mass_b, body_b.locked_y ? 0.0f : mass_b};
        return ends;
    }

    JointFrame frame_of(const JointRecord& joint) const {
        const auto [a, b] = joint.bodies;
        return {.a = {columns.states[a].cosine, columns.states[a].sine},
                .center_a = objects.bodies[a].center,
                .center_b = objects.bodies[b].center,
                .anchor_a = joint.anchors[0],
                .angle_a = double(columns.states[a].angle) + double(objects.bodies[a].angle_rest),
                .angle_b = double(columns.states[b].angle) + double(objects.bodies[b].angle_rest)};
    }

    /// Which of the awake ones of a type act, in the order of their nodes.
    template <class Constraint>
    void list_acting(JointPlan& plan) {
        constexpr auto type = size_t(joint_type<typename Constraint::Data>);
        const auto& awake = active.awake_joints[type];
        scratch.joint_notes.resize(awake.size());
        share_out_range(threads, awake.size(), joints_at_a_time, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const JointRecord& joint = objects.joints[awake[i]];
                const JointRole role = role_of(objects, joint);
                if (role == JointRole::idle) forget_impulses(objects, awake[i]);
                scratch.joint_notes[i] = 0;
                if (role != JointRole::acting)
                    continue;  // asleep, it goes on as it was when it wakes
                // Unlike a contact, a joint also writes to a body that moves on its own: the nodes
                // of all joints of such a body are on one path from the root, so none is solved
                // beside another.
                const SolverEnd a = bodies.solver_ends[joint.bodies[0]],
                                b = bodies.solver_ends[joint.bodies[1]];
                const StripNode node =
                    above_both((a.index() != 0 ? a : b).strip(), (b.index() != 0 ? b : a).strip());
                scratch.joint_notes[i] =
                    uint8_t(std::max<StripNode>(node, 1) | (joint.breakable() ? can_break : 0));
            }
        });
        plan.nodes.clear();
        for (const uint8_t note : scratch.joint_notes)
            if (note != 0) plan.nodes.count(note & ~can_break);
        plan.nodes.sum_up();
        auto next = plan.nodes.places();
        plan.joints.resize(plan.nodes.size());
        for (size_t i = 0; i < awake.size(); ++i) {
            if (scratch.joint_notes[i] == 0) continue;
            const uint32_t place = next[scratch.joint_notes[i] & ~can_break]++;
            plan.joints[place] = awake[i];
            if ((scratch.joint_notes[i] & can_break) != 0)
                scratch.strains.push_back({awake[i], place, {}, 0.0f});
        }
    }

    /// True if some of them bear a heavy load.
    template <class Constraint>
    bool prepare_list(const JointStep& step, std::vector<Constraint>& made) {
        using Data = typename Constraint::Data;
        JointPlan& plan = scratch.joint_plans.of_type[size_t(joint_type<Data>)];
        list_acting<Constraint>(plan);
        made.resize(plan.joints.size());
        std::atomic<bool> heavy = false;
        share_out_range(threads, made.size(), joints_at_a_time, [&](size_t begin, size_t end) {
            bool any = false;
            for (size_t i = begin; i < end; ++i) {
                const JointRecord& joint = objects.joints[plan.joints[i]];
                const Data& data = std::get<std::vector<Data>>(objects.joint_lists)[joint.place];
                Constraint& c = made[i];
                c = {};
                c.ends = ends_of(joint);
                c.impulses = data.impulses;
                c.impulses.scale(step.impulse_ratio);
                const SolverBody &a = bodies.solver_bodies[c.ends.a],
                                 &b = bodies.solver_bodies[c.ends.b];
                c.prepare(data, frame_of(joint), step, a, b);
                any |= bears_heavy_load(a, b);
            }
            if (any) heavy.store(true, std::memory_order_relaxed);
        });
        return heavy.load(std::memory_order_relaxed);
    }
};

/// `visit(constraint)` for those of some nodes, type by type.
template <bool backwards = false, typename Visit>
void for_each_joint_of(JointScratch& joints, const StripNodes& nodes, Visit&& visit) {
    const auto pass = [&](auto& list) {
        using Data = typename std::remove_cvref_t<decltype(list)>::value_type::Data;
        const NodeRanges& ranges = joints.joint_plans.of_type[size_t(joint_type<Data>)].nodes;
        const size_t begin = ranges.begin(nodes), end = ranges.end(nodes);
        for (size_t i = 0; i < end - begin; ++i) visit(list[backwards ? end - 1 - i : begin + i]);
    };
    std::apply([&](auto&... list) { (pass(list), ...); }, joints.joint_constraints);
}

}  // namespace

JointStep prepare_joints(ObjectState& objects, const Columns& columns, const ActiveLists& active,
                         const BodyScratch& bodies, JointScratch& joints, float h,
                         float impulse_ratio, ThreadPool* threads) {
    JointPreparation preparation = {objects, columns, active, bodies, joints, threads};
    JointStep step;
    step.h = h;
    step.inverse_h = 1.0f / h;
    step.impulse_ratio = impulse_ratio;
    joints.strains.clear();
    bool heavy = false;
    std::apply([&](auto&... list) { ((heavy |= preparation.prepare_list(step, list)), ...); },
               joints.joint_constraints);
    step.sweeps = heavy ? 4 : 1;
    step.rigid = make_softness(heavy ? min(120.0f, 0.5f / h) : min(60.0f, 0.25f / h), 2.0f, h);
    return step;
}

void warm_start_joints(JointScratch& joints, std::span<SolverBody> bodies,
                       const StripNodes& nodes) {
    for_each_joint_of(joints, nodes, [&](auto& c) {
        on_ends(bodies, c, [&](SolverBody& a, SolverBody& b) { c.warm_start(a, b); });
    });
}

void solve_joints(JointScratch& joints, std::span<SolverBody> bodies, const JointStep& step,
                  const StripNodes& nodes) {
    for (int sweep = 0; sweep < step.sweeps; ++sweep) {
        for_each_joint_of(joints, nodes, [&](auto& c) {
            on_ends(bodies, c, [&](SolverBody& a, SolverBody& b) { c.solve(a, b, step); });
        });
    }
}

/// Backwards: the biased pass carries an impulse down a chain, this pass carries it up.
void relax_joints(JointScratch& joints, std::span<SolverBody> bodies, const JointStep& step,
                  const StripNodes& nodes) {
    for (int sweep = 0; sweep < step.sweeps; ++sweep) {
        for_each_joint_of<true>(joints, nodes, [&](auto& c) {
            on_ends(bodies, c, [&](SolverBody& a, SolverBody& b) { c.relax(a, b, step); });
        });
    }
}

void find_jointed(JointScratch& joints, const Strips& strips) {
    joints.joint_share.clear();
    for (uint32_t node = 1; node < strips.all_nodes().end; ++node) {
        for_each_joint_of(joints, {node, node + 1}, [&](const auto& c) {
            for (const uint32_t body : {c.ends.a, c.ends.b})
                if (body != 0) joints.joint_share.add(node, body);
        });
    }
    joints.joint_share.unite();
}

void strain_joints(const ObjectState& objects, JointScratch& joints) {
    for (Strain& strain : joints.strains) {
        auto add = [&](const auto& list) {
            strain.force = strain.force + list[strain.index].push();
            strain.torque += list[strain.index].twist();
        };
        with_list(joints.joint_constraints, objects.joints[strain.joint].type, add);
    }
}

void store_joints(ObjectState& objects, const JointScratch& joints, const JointStep& step,
                  ThreadPool* threads) {
    auto pass = [&](auto& list) {
        using Data = typename std::remove_cvref_t<decltype(list)>::value_type::Data;
        share_out_range(threads, list.size(), joints_at_a_time, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const auto& c = list[i];
                Data& data = std::get<std::vector<Data>>(objects.joint_lists)[c.ends.place];
                data.impulses = c.impulses;
                // What overflowed would begin the next step, and so last for ever.
                const V2 push = c.push();
                if (!std::isfinite(push.x + push.y + c.twist())) data.impulses = {};
                objects.joints[data.joint].force = bounded(step.inverse_h * push, greatest_impulse);
                objects.joints[data.joint].torque =
                    bounded(step.inverse_h * c.twist(), greatest_impulse);
            }
        });
    };
    std::apply([&](auto&... list) { (pass(list), ...); }, joints.joint_constraints);
}

}  // namespace fettle::physics::detail
