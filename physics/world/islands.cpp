#include <geometry/growth.h>
#include <partition/union_find.h>
#include <world/world_data.h>

#include <algorithm>
#include <utility>

// Sleeping. What is awake is listed; what sleeps is in an island with all that fell asleep with it,
// costs nothing in a step, and wakes as a whole. Islands are found by union-find over the active
// contacts and joints, and only in steps in which some body has rested long enough: keeping them up
// to date all the time would cost more than that.

namespace fettle::physics::detail {
namespace {

/// Steps between two looks for resting islands, while there is a reason to look.
constexpr uint64_t look_interval = 8;

}  // namespace

void WorldData::add_awake(uint32_t body) {
    awake_bodies.push_back(body);
    bodies[body].solver_index = uint32_t(awake_bodies.size());
}

void WorldData::remove_awake(uint32_t body) {
    const uint32_t place = bodies[body].solver_index - 1;
    awake_bodies[place] = awake_bodies.back();
    bodies[awake_bodies[place]].solver_index = place + 1;
    awake_bodies.pop_back();
    bodies[body].solver_index = 0;
}

void WorldData::add_awake_contact(uint32_t contact) {
    contacts[contact].awake_index = uint32_t(awake_contacts.size());
    awake_contacts.push_back(contact);
}

void WorldData::remove_awake_contact(uint32_t contact) {
    const uint32_t place = contacts[contact].awake_index;
    awake_contacts[place] = awake_contacts.back();
    contacts[awake_contacts[place]].awake_index = place;
    awake_contacts.pop_back();
    contacts[contact].awake_index = none;
}

bool WorldData::in_motion(uint32_t body) const {
    const BodyRecord& record = bodies[body];
    if (record.solver_index == 0) return false;
    if (record.mobility == Mobility::dynamic) return true;
    const BodyState& state = states[body];
    return state.velocity.x() != 0.0f || state.velocity.y() != 0.0f ||
           state.angular_velocity != 0.0f;
}

void WorldData::leave_island(uint32_t body) {
    const uint32_t island = bodies[body].island;
    if (island == none) return;
    bodies[body].island = none;
    uint32_t* link = &islands[island].first;
    while (*link != body) link = &bodies[*link].next;
    *link = std::exchange(bodies[body].next, none);
    if (islands[island].first == none) free_island_slot(island);
}

void WorldData::free_island_slot(uint32_t island) {
    islands[island] = {none, island_slots.free};
    island_slots.free = island;
    --island_slots.count;
}

void WorldData::wake_sleeping(uint32_t body) {
    const uint32_t island = bodies[body].island;
    std::vector<uint32_t> members;
    for_each_asleep(island, [&](uint32_t member) { members.push_back(member); });
    free_island_slot(island);
    for (uint32_t member : members) {
        bodies[member].island = bodies[member].next = none;
        bodies[member].sleep_time = 0.0f;
        bodies[member].never_awake = false;
        add_awake(member);
        event_sink().woke.push_back(body_id(member));
    }
    std::vector<uint32_t> woken;
    for (uint32_t member : members) {
        for_each_contact(member, [&](uint32_t contact) {
            if (contacts[contact].awake_index != none) return;
            contacts[contact].awake_index = 0;  // listed below; seen from the other body no more
            woken.push_back(contact);
        });
    }
    // The order in which they were made, not that of the lists: it is what the solver converges
    // best in.
    std::sort(woken.begin(), woken.end());
    for (uint32_t contact : woken) add_awake_contact(contact);
    woken.clear();
    for (uint32_t member : members) {
        for_each_joint(member, [&](uint32_t joint, uint32_t) {
            if (joints[joint].awake_index == none) woken.push_back(joint);
        });
    }
    std::sort(woken.begin(), woken.end());
    for (uint32_t joint : woken) list_joint(joint);
}

void WorldData::wake_touching(uint32_t body) {
    // Waking changes no contact list, so it may be walked meanwhile.
    for_each_contact(body, [&](uint32_t contact) {
        if (contacts[contact].manifold.count > 0) wake_body(other_body(contact, body));
    });
    for_each_joint(
        body, [&](uint32_t joint, uint32_t side) { wake_body(joints[joint].bodies[side ^ 1]); });
}

void WorldData::wake_all() {
    for (uint32_t body = 0; body < bodies.size(); ++body) {
        if (body_generations[body] != 0) wake_body(body);
    }
}

/// Afterwards the lists of what is awake still hold the group: see `compact_awake`.
void WorldData::put_to_sleep(std::span<const uint32_t> group) {
    uint32_t island = island_slots.free;
    if (island != none) {
        island_slots.free = islands[island].next_free;
    } else {
        island = uint32_t(islands.size());
        make_room(islands);
        islands.emplace_back();
    }
    ++island_slots.count;
    uint32_t* link = &islands[island].first;
    for (uint32_t body : group) {
        BodyRecord& record = bodies[body];
        *link = body;
        link = &record.next;
        record.island = island;
        record.solver_index = 0;
        record.sleep_time = 0.0f;
        record.step_force = {};
        record.step_torque = 0.0f;
        states[body].velocity.setZero();
        states[body].angular_velocity = 0.0f;
        previous[body] = {states[body].position, states[body].angle};
        event_sink().slept.push_back(body_id(body));
    }
}

/// Drops from the lists who fell asleep. One pass over each keeps its order, which a removal one by
/// one would not.
void WorldData::compact_awake() {
    size_t kept = 0;
    for (uint32_t body : awake_bodies) {
        if (bodies[body].solver_index == 0) continue;
        awake_bodies[kept++] = body;
        bodies[body].solver_index = uint32_t(kept);
    }
    awake_bodies.resize(kept);
    kept = 0;
    for (uint32_t contact : awake_contacts) {
        ContactRecord& c = contacts[contact];
        if (bodies[c.body_a].solver_index == 0 && bodies[c.body_b].solver_index == 0) {
            c.awake_index = none;
            continue;
        }
        c.awake_index = uint32_t(kept);
        awake_contacts[kept++] = contact;
    }
    awake_contacts.resize(kept);
    for (auto& list : awake_joints) {
        kept = 0;
        for (uint32_t joint : list) {
            JointRecord& record = joints[joint];
            const auto [a, b] = record.bodies;
            const bool awake = bodies[a].solver_index != 0 || bodies[b].solver_index != 0;
            record.awake_index = awake ? uint32_t(kept) : none;
            if (awake) list[kept++] = joint;
        }
        list.resize(kept);
    }
}

void WorldData::put_group_to_sleep(uint32_t body) {
    if (bodies[body].solver_index == 0) return;
    std::vector<uint32_t> group = {body};
    std::vector<bool> seen(bodies.size());
    seen[body] = true;
    for (size_t i = 0; i < group.size(); ++i) {
        if (bodies[group[i]].mobility != Mobility::dynamic) continue;
        auto follow = [&](uint32_t other) {
            if (seen[other] || bodies[other].solver_index == 0) return;
            if (bodies[other].mobility != Mobility::dynamic) return;
            seen[other] = true;
            group.push_back(other);
        };
        for_each_joint(group[i], [&](uint32_t joint, uint32_t side) {
            if (joints[joint].acts()) follow(joints[joint].bodies[side ^ 1]);
        });
        for_each_contact(group[i], [&](uint32_t contact) {
            const ContactRecord& c = contacts[contact];
            if (c.manifold.count > 0 && !c.sensor && !c.disabled)
                follow(other_body(contact, group[i]));
        });
    }
    put_to_sleep(group);
    compact_awake();
}

/// Solvers that correct positions without velocities: what is being pushed out does not rest.
void WorldData::keep_pushed_awake(float dt) {
    const float way = settings.sleep_speed * dt;
    for (size_t i = 1; i < solver_bodies.size(); ++i) {
        if (length_squared(solver_bodies[i].shift) > way * way)
            bodies[awake_bodies[i - 1]].sleep_time = 0.0f;
    }
}

void WorldData::sleep_resting_islands() {
    if (!settings.sleeping || sleep_candidates == 0 || steps % look_interval != 0) return;
    const size_t count = awake_bodies.size();
    UnionFind sets;
    sets.reset(count);
    std::vector<uint8_t> restless(count, 0);
    for (size_t i = 0; i < count; ++i) {
        const BodyRecord& record = bodies[awake_bodies[i]];
        restless[i] = !record.can_sleep || record.sleep_time < settings.sleep_delay;
    }
    auto link = [&](uint32_t body_a, uint32_t body_b) {
        const uint32_t a = bodies[body_a].solver_index, b = bodies[body_b].solver_index;
        if (a == 0 || b == 0) return;
        const bool moves_a = bodies[body_a].mobility == Mobility::dynamic;
        const bool moves_b = bodies[body_b].mobility == Mobility::dynamic;
        if (moves_a && moves_b)
            sets.unite(a - 1, b - 1);
        else if (moves_a && in_motion(body_b))
            restless[a - 1] = 1;  // carried by something that moves
        else if (moves_b && in_motion(body_a))
            restless[b - 1] = 1;
    };
    for (uint32_t slot : awake_contacts) {
        const ContactRecord& c = contacts[slot];
        if (c.manifold.count > 0 && !c.sensor && !c.disabled) link(c.body_a, c.body_b);
    }
    for (const auto& list : awake_joints) {
        for (uint32_t joint : list) link(joints[joint].bodies[0], joints[joint].bodies[1]);
    }
    std::vector<uint8_t> island_restless(count, 0);
    for (uint32_t i = 0; i < count; ++i) island_restless[sets.find(i)] |= restless[i];
    std::vector<std::vector<uint32_t>> groups;
    std::vector<uint32_t> group_of(count, none);
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t root = sets.find(i);
        if (island_restless[root]) continue;
        if (group_of[root] == none) {
            group_of[root] = uint32_t(groups.size());
            groups.emplace_back();
        }
        groups[group_of[root]].push_back(awake_bodies[i]);
    }
    for (const auto& group : groups) put_to_sleep(group);
    if (!groups.empty()) compact_awake();
}

}  // namespace fettle::physics::detail
