#include <world/world_data.h>

#include <cmath>
#include <utility>

// Joints: what all of them have in slots, linked into lists of both bodies, and what a type adds in
// a list of that type without gaps. Those that act on something awake are listed by type; a step
// writes them into constraints, in the order of the lists, and reads their impulses back.

namespace fettle::physics::detail {
namespace {

/// A joint gives by load / (m·ω²), and m is that of its light body: hung from light links, a heavy
/// body would stretch them at the usual stiffness. Twice the stiffness is stable only if the sweeps
/// over the joints come nearer to agreeing: four instead of one.
bool bears_heavy_load(const SolverBody& a, const SolverBody& b) {
    constexpr float most = 10.0f;  // as heavy as the other
    if (a.inverse_mass == 0.0f || b.inverse_mass == 0.0f) return false;
    return a.inverse_mass > most * b.inverse_mass || b.inverse_mass > most * a.inverse_mass;
}

}  // namespace

uint32_t WorldData::add_joint(const JointRecord& record, JointType type, uint32_t place) {
    uint32_t slot = free_joint;
    if (slot != none) {
        free_joint = joints[slot].next_free;
    } else {
        slot = uint32_t(joints.size());
        joints.emplace_back();
        joint_generations.push_back(0);
    }
    joints[slot] = record;
    joints[slot].type = type;
    joints[slot].place = place;
    joint_generations[slot] = next_generation++;
    ++joint_count;
    link_joint(slot, 0);
    link_joint(slot, 1);
    wake_joint(slot);
    list_joint(slot);
    refilter_joint(slot);
    return slot;
}

void WorldData::destroy_joint(uint32_t joint) {
    wake_joint(joint);
    joints[joint].enabled = false;
    list_joint(joint);
    refilter_joint(joint);
    unlink_joint(joint, 0);
    unlink_joint(joint, 1);
    const uint32_t place = joints[joint].place;
    auto erase = [&](auto& list) {
        list[place] = list.back();
        joints[list[place].joint].place = place;
        list.pop_back();
    };
    with_list(joint_lists, joints[joint].type, erase);
    joints[joint] = {};
    joints[joint].next_free = free_joint;
    free_joint = joint;
    joint_generations[joint] = 0;
    --joint_count;
}

void WorldData::link_joint(uint32_t joint, uint32_t side) {
    JointRecord& record = joints[joint];
    BodyRecord& body = bodies[record.bodies[side]];
    record.edges[side] = {none, body.first_joint};
    if (body.first_joint != none)
        joints[body.first_joint >> 1].edges[body.first_joint & 1].previous = joint << 1 | side;
    body.first_joint = joint << 1 | side;
    ++body.joint_count;
}

void WorldData::unlink_joint(uint32_t joint, uint32_t side) {
    BodyRecord& body = bodies[joints[joint].bodies[side]];
    const ListEdge edge = joints[joint].edges[side];
    if (edge.previous != none)
        joints[edge.previous >> 1].edges[edge.previous & 1].next = edge.next;
    else
        body.first_joint = edge.next;
    if (edge.next != none) joints[edge.next >> 1].edges[edge.next & 1].previous = edge.previous;
    --body.joint_count;
}

void WorldData::set_joint_body(uint32_t joint, uint32_t side, uint32_t body) {
    wake_joint(joint);
    const bool enabled = std::exchange(joints[joint].enabled, false);
    refilter_joint(joint);  // those who part may collide
    unlink_joint(joint, side);
    joints[joint].bodies[side] = body;
    link_joint(joint, side);
    joints[joint].enabled = enabled;
    forget_impulses(joint);
    wake_joint(joint);
    list_joint(joint);
    refilter_joint(joint);
}

void WorldData::set_joint_enabled(uint32_t joint, bool enabled) {
    joints[joint].enabled = enabled;
    wake_joint(joint);
    list_joint(joint);
    refilter_joint(joint);
}

void WorldData::set_joint_broken(uint32_t joint, bool broken) {
    joints[joint].broken = broken;
    wake_joint(joint);
    list_joint(joint);
    refilter_joint(joint);
}

void WorldData::forget_impulses(uint32_t joint) {
    auto forget = [&](auto& list) { list[joints[joint].place].impulses = {}; };
    with_list(joint_lists, joints[joint].type, forget);
    joints[joint].force = {};
    joints[joint].torque = 0.0f;
}

/// A joint is listed while it acts and one of its bodies is awake. Asleep, it keeps its impulses;
/// doing nothing, it has none.
void WorldData::list_joint(uint32_t joint) {
    JointRecord& record = joints[joint];
    auto& list = awake_joints[size_t(record.type)];
    const auto [a, b] = record.bodies;
    const bool wanted =
        record.acts() && (bodies[a].solver_index != 0 || bodies[b].solver_index != 0);
    if (!wanted && role_of(record) == Role::idle) forget_impulses(joint);
    if (wanted == (record.awake_index != none)) return;
    if (wanted) {
        record.awake_index = uint32_t(list.size());
        list.push_back(joint);
        return;
    }
    list[record.awake_index] = list.back();
    joints[list.back()].awake_index = record.awake_index;
    list.pop_back();
    record.awake_index = none;
}

void WorldData::set_joint_collide(uint32_t joint, bool collide) {
    joints[joint].collide = collide;
    wake_joint(joint);
    refilter_joint(joint);
}

void WorldData::wake_joint(uint32_t joint) {
    for (uint32_t body : joints[joint].bodies) wake_body(body);
}

/// Who sleeps at a joint to something that has begun to move.
void WorldData::wake_jointed() {
    if (island_count == 0) return;
    for (const auto& list : awake_joints) {
        // Waking appends to the list while it is walked.
        for (size_t i = 0; i < list.size(); ++i) {
            const auto [a, b] = joints[list[i]].bodies;
            if (bodies[a].asleep() && in_motion(b)) wake_body(a);
            if (bodies[b].asleep() && in_motion(a)) wake_body(b);
        }
    }
}

/// The border belongs to the world, and what hangs in the world still collides with it.
bool WorldData::keeps_apart(uint32_t joint) const {
    const JointRecord& j = joints[joint];
    return j.acts() && !j.collide && j.bodies[0] != 0 && j.bodies[1] != 0;
}

bool WorldData::joint_forbids_contact(uint32_t body_a, uint32_t body_b) const {
    if (bodies[body_a].joint_count > bodies[body_b].joint_count) std::swap(body_a, body_b);
    for (uint32_t edge = bodies[body_a].first_joint; edge != none;) {
        const JointRecord& joint = joints[edge >> 1];
        if (joint.bodies[~edge & 1] == body_b && keeps_apart(edge >> 1)) return true;
        edge = joint.edges[edge & 1].next;
    }
    return false;
}

/// After an edit: contacts between the two bodies end, or are looked for.
void WorldData::refilter_joint(uint32_t joint) {
    uint32_t a = joints[joint].bodies[0], b = joints[joint].bodies[1];
    if (bodies[a].contact_count > bodies[b].contact_count) std::swap(a, b);
    if (joint_forbids_contact(a, b)) {
        for_each_contact(a, [&](uint32_t contact) {
            if (other_body(contact, a) == b) destroy_contact(contact);
        });
        return;
    }
    if (a == 0 || b == 0) return;
    for (uint32_t body : {a, b}) {
        for (uint32_t s = bodies[body].first_shape; s != none; s = shapes[s].next) mark_moved(s);
    }
}

WorldData::Role WorldData::role_of(const JointRecord& joint) const {
    Role role = Role::idle;
    for (uint32_t body : joint.bodies) {
        if (!joint.acts() || bodies[body].mobility != Mobility::dynamic) continue;
        if (bodies[body].solver_index != 0) return Role::acting;
        role = Role::asleep;
    }
    return role;
}

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

template <class Constraint>
void WorldData::prepare_list(const JointStep& step, std::vector<Constraint>& made) {
    using Data = typename Constraint::Data;
    constexpr JointType type = joint_type<Data>;
    made.clear();
    for (uint32_t slot : awake_joints[size_t(type)]) {
        const JointRecord& joint = joints[slot];
        const Role role = role_of(joint);
        if (role == Role::idle) forget_impulses(slot);
        if (role != Role::acting) continue;  // asleep, it goes on as it was when it wakes
        if (joint.breakable()) strains.push_back({slot, uint32_t(made.size()), {}, 0.0f});
        const Data& data = std::get<std::vector<Data>>(joint_lists)[joint.place];
        Constraint& c = made.emplace_back();
        c.ends = joint_ends(joint);
        c.impulses = data.impulses;
        c.impulses.scale(step.impulse_ratio);
        c.prepare(data, joint_frame(joint), step, solver_bodies[c.ends.a], solver_bodies[c.ends.b]);
    }
}

JointStep WorldData::prepare_joints(float h) {
    JointStep step;
    step.h = h;
    step.inverse_h = 1.0f / h;
    step.impulse_ratio = last_substep > 0.0f ? h / last_substep : 1.0f;
    strains.clear();
    std::apply([&](auto&... list) { (prepare_list(step, list), ...); }, joint_constraints);
    bool heavy = false;
    auto look = [&](const auto& list) {
        for (const auto& c : list)
            heavy |= bears_heavy_load(solver_bodies[c.ends.a], solver_bodies[c.ends.b]);
    };
    std::apply([&](const auto&... list) { (look(list), ...); }, joint_constraints);
    step.sweeps = heavy ? 4 : 1;
    step.rigid = make_softness(heavy ? min(120.0f, 0.5f / h) : min(60.0f, 0.25f / h), 2.0f, h);
    return step;
}

void WorldData::warm_start_joints() {
    auto pass = [&](auto& list) {
        for (auto& c : list) c.warm_start(solver_bodies[c.ends.a], solver_bodies[c.ends.b]);
    };
    std::apply([&](auto&... list) { (pass(list), ...); }, joint_constraints);
}

void WorldData::solve_joints(const JointStep& step) {
    auto pass = [&](auto& list) {
        for (auto& c : list) c.solve(solver_bodies[c.ends.a], solver_bodies[c.ends.b], step);
    };
    for (int sweep = 0; sweep < step.sweeps; ++sweep)
        std::apply([&](auto&... list) { (pass(list), ...); }, joint_constraints);
}

/// Backwards: what the first pass carried down a chain, this one carries up.
void WorldData::relax_joints(const JointStep& step) {
    auto pass = [&](auto& list) {
        for (size_t i = list.size(); i-- > 0;) {
            auto& c = list[i];
            c.relax(solver_bodies[c.ends.a], solver_bodies[c.ends.b], step);
        }
    };
    for (int sweep = 0; sweep < step.sweeps; ++sweep)
        std::apply([&](auto&... list) { (pass(list), ...); }, joint_constraints);
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
        for (auto& c : list) {
            Data& data = std::get<std::vector<Data>>(joint_lists)[c.ends.place];
            data.impulses = c.impulses;
            // What overflowed would begin the next step, and so last for ever.
            const V2 push = c.push();
            if (!std::isfinite(push.x + push.y + c.twist())) data.impulses = {};
            joints[data.joint].force = bounded(step.inverse_h * push, 1e30f);
            joints[data.joint].torque = bounded(step.inverse_h * c.twist(), 1e30f);
        }
    };
    std::apply([&](auto&... list) { (pass(list), ...); }, joint_constraints);
    break_joints(step);
}

}  // namespace fettle::physics::detail
