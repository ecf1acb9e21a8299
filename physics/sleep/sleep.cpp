#include <geometry/make_room.h>
#include <partition/union_find.h>
#include <sleep/rest.h>
#include <sleep/rocking.h>
#include <sleep/sleep.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fettle::physics::detail {
namespace {

/// Steps between two searches for resting islands, while there is a reason to search.
constexpr uint64_t search_interval = 8;

}  // namespace

bool in_motion(const ObjectState& objects, const Columns& columns, uint32_t body) {
    const BodyRecord& record = objects.bodies[body];
    if (record.solver_index == 0) return false;
    if (record.mobility == Mobility::dynamic) return true;
    const BodyState& state = columns.states[body];
    return state.velocity.x != 0.0f || state.velocity.y != 0.0f || state.angular_velocity != 0.0f;
}

void leave_island(ObjectState& objects, uint32_t body) {
    const uint32_t island = objects.bodies[body].lists.island;
    if (island == none) return;
    objects.bodies[body].lists.island = none;
    uint32_t* link = &objects.islands[island].first;
    while (*link != body) link = &objects.bodies[*link].lists.next;
    *link = std::exchange(objects.bodies[body].lists.next, none);
    if (objects.islands[island].first == none)
        objects.island_slots.release(objects.islands, island);
}

void wake_sleeping(const Activity& activity, uint32_t body) {
    ObjectState& objects = activity.objects;
    Columns& columns = activity.columns;
    ActiveLists& active = activity.active;
    const uint32_t island = objects.bodies[body].lists.island;
    std::vector<uint32_t> members;
    objects.for_each_asleep(island, [&](uint32_t member) { members.push_back(member); });
    objects.island_slots.release(objects.islands, island);
    for (uint32_t member : members) {
        objects.bodies[member].lists.island = objects.bodies[member].lists.next = none;
        objects.bodies[member].sleep_time = 0.0f;
        objects.bodies[member].flags.never_awake = false;
        add_awake(objects, active, member);
        activity.events.woke.push_back(body_id(columns, member));
    }
    // Near crowded shapes that sleep, pairs may be missing: the woken shapes look for them.
    for (uint32_t member : members) {
        uint32_t shape =
            objects.crowded_shapes > 0 ? objects.bodies[member].lists.first_shape : none;
        for (; shape != none; shape = objects.shapes[shape].next)
            if (objects.is_solid(shape)) objects.set_crowded(shape, true);
    }
    std::vector<uint32_t> woken;
    for (uint32_t member : members) {
        objects.for_each_contact(member, [&](uint32_t contact) {
            if (objects.contacts[contact].awake_index != none) return;
            objects.contacts[contact].awake_index = 0;  // the other body must not add it
            woken.push_back(contact);
        });
    }
    // The solver converges best in the order of creation.
    std::sort(woken.begin(), woken.end());
    for (uint32_t contact : woken) add_awake_contact(objects, active, contact);
    woken.clear();
    for (uint32_t member : members) {
        objects.for_each_joint(member, [&](uint32_t joint, uint32_t) {
            if (objects.joints[joint].awake_index == none) woken.push_back(joint);
        });
    }
    std::sort(woken.begin(), woken.end());
    for (uint32_t joint : woken) list_joint(objects, active, joint);
}

void wake_touching(const Activity& activity, uint32_t body) {
    ObjectState& objects = activity.objects;
    // Waking does not change the lists of contacts, so the loop stays valid.
    objects.for_each_contact(body, [&](uint32_t contact) {
        if (objects.contacts[contact].manifold.count > 0)
            wake_body(activity, objects.other_body(contact, body));
    });
    objects.for_each_joint(body, [&](uint32_t joint, uint32_t side) {
        wake_body(activity, objects.joints[joint].bodies[side ^ 1]);
    });
}

void wake_joint(const Activity& activity, uint32_t joint) {
    ObjectState& objects = activity.objects;
    for (uint32_t body : objects.joints[joint].bodies) wake_body(activity, body);
}

void wake_jointed(const Activity& activity) {
    ObjectState& objects = activity.objects;
    Columns& columns = activity.columns;
    ActiveLists& active = activity.active;
    if (objects.island_slots.count == 0) return;
    for (const auto& list : active.awake_joints) {
        // Waking appends to the list during the loop.
        for (size_t i = 0; i < list.size(); ++i) {
            const auto [a, b] = objects.joints[list[i]].bodies;
            if (objects.bodies[a].asleep() && in_motion(objects, columns, b))
                wake_body(activity, a);
            if (objects.bodies[b].asleep() && in_motion(objects, columns, a))
                wake_body(activity, b);
        }
    }
}

void wake_all(const Activity& activity) {
    ObjectState& objects = activity.objects;
    Columns& columns = activity.columns;
    for (uint32_t body = 0; body < objects.bodies.size(); ++body) {
        if (columns.body_generations[body] != 0) wake_body(activity, body);
    }
}

void put_to_sleep(const Activity& activity, std::span<const uint32_t> group, uint32_t island) {
    ObjectState& objects = activity.objects;
    Columns& columns = activity.columns;
    uint32_t* link = &objects.islands[island].first;
    for (uint32_t body : group) {
        BodyRecord& record = objects.bodies[body];
        *link = body;
        link = &record.lists.next;
        record.lists.island = island;
        record.solver_index = 0;
        record.sleep_time = 0.0f;
        record.step_load.force = {};
        record.step_load.torque = 0.0f;
        columns.states[body].velocity = {};
        columns.states[body].angular_velocity = 0.0f;
        columns.previous[body] = {columns.states[body].position, columns.states[body].angle};
        activity.events.slept.push_back(body_id(columns, body));
    }
}

namespace {

/// Removes sleeping objects from the lists. One pass over each list keeps the order.
void compact_awake(ObjectState& objects, ActiveLists& active) {
    size_t kept = 0;
    for (uint32_t body : active.awake_bodies) {
        if (objects.bodies[body].solver_index == 0) continue;
        active.awake_bodies[kept++] = body;
        objects.bodies[body].solver_index = uint32_t(kept);
    }
    active.awake_bodies.resize(kept);
    kept = 0;
    for (uint32_t contact : active.awake_contacts) {
        ContactRecord& c = objects.contacts[contact];
        if (objects.bodies[c.body_a].solver_index == 0 &&
            objects.bodies[c.body_b].solver_index == 0) {
            c.awake_index = none;
            continue;
        }
        c.awake_index = uint32_t(kept);
        active.awake_contacts[kept++] = contact;
    }
    active.awake_contacts.resize(kept);
    for (auto& list : active.awake_joints) {
        kept = 0;
        for (uint32_t joint : list) {
            JointRecord& record = objects.joints[joint];
            const auto [a, b] = record.bodies;
            const bool awake =
                objects.bodies[a].solver_index != 0 || objects.bodies[b].solver_index != 0;
            record.awake_index = awake ? uint32_t(kept) : none;
            if (awake) list[kept++] = joint;
        }
        list.resize(kept);
    }
}

/// Removes the contacts and joints of a small sleeping group from the lists, in a time that does
/// not depend on the length of the lists. The last entry of a list takes the place of a removed
/// one.
void remove_links(ObjectState& objects, ActiveLists& active, std::span<const uint32_t> group) {
    for (const uint32_t body : group) {
        objects.for_each_contact(body, [&](uint32_t contact) {
            const ContactRecord& c = objects.contacts[contact];
            if (c.awake_index != none &&
                objects.bodies[objects.other_body(contact, body)].solver_index == 0)
                remove_awake_contact(objects, active, contact);
        });
        objects.for_each_joint(
            body, [&](uint32_t joint, uint32_t) { list_joint(objects, active, joint); });
    }
}

}  // namespace

void put_group_to_sleep(const Activity& activity, uint32_t body) {
    ObjectState& objects = activity.objects;
    ActiveLists& active = activity.active;
    if (objects.bodies[body].solver_index == 0) return;
    const uint32_t island = objects.island_slots.allocate(objects.islands);
    std::vector<uint32_t> group;
    // The island also marks the members of the group.
    const auto add = [&](uint32_t member) {
        objects.bodies[member].lists.island = island;
        group.push_back(member);
    };
    add(body);
    for (size_t i = 0; i < group.size(); ++i) {
        if (objects.bodies[group[i]].mobility != Mobility::dynamic) continue;
        auto follow = [&](uint32_t other) {
            const BodyRecord& record = objects.bodies[other];
            if (record.solver_index == 0 || record.lists.island == island) return;
            if (record.mobility == Mobility::dynamic) add(other);
        };
        objects.for_each_joint(group[i], [&](uint32_t joint, uint32_t side) {
            if (objects.joints[joint].moves()) follow(objects.joints[joint].bodies[side ^ 1]);
        });
        objects.for_each_contact(group[i], [&](uint32_t contact) {
            if (objects.contacts[contact].acts()) follow(objects.other_body(contact, group[i]));
        });
    }
    // Many bodies may be put to sleep one by one: a pass over all lists for each would be
    // quadratic. The solver converges best in the order of creation, so large groups keep it.
    constexpr size_t share = 16;
    const bool small = group.size() * share < active.awake_bodies.size();
    if (small)
        for (const uint32_t member : group) remove_awake(objects, active, member);
    put_to_sleep(activity, group, island);
    if (small)
        remove_links(objects, active, group);
    else
        compact_awake(objects, active);
}

void keep_pushed_awake(ObjectState& objects, const ActiveLists& active, const BodyScratch& bodies,
                       const WorldDef& settings, float dt) {
    for (size_t i = 1; i < bodies.solver_bodies.size(); ++i) {
        BodyRecord& body = objects.bodies[active.awake_bodies[i - 1]];
        const float way = objects.sleep_speed_of(settings, body) * dt;
        if (length_squared(bodies.solver_bodies[i].shift) > way * way) body.sleep_time = 0.0f;
    }
}

namespace {

/// True if the two surfaces of a contact move past each other no faster than half of their given
/// speed. A body that an obstacle holds back slides on the belt and may rest.
bool carried_by_belt(const ObjectState& objects, const Columns& columns,
                     const ContactRecord& contact) {
    if (contact.surface_speed == 0.0f) return false;
    const Vec2 t = right_perp(contact.manifold.normal);
    const ManifoldPoint& point = contact.manifold.points[0];
    const auto along = [&](uint32_t body, Vec2 anchor) {
        if (objects.bodies[body].solver_index == 0) return 0.0f;
        const BodyState& state = columns.states[body];
        return dot(t, state.velocity + cross(state.angular_velocity, anchor));
    };
    const float slip = along(contact.body_b, point.anchor_b) -
                       along(contact.body_a, point.anchor_a) + contact.surface_speed;
    return std::fabs(slip) < 0.5f * std::fabs(contact.surface_speed);
}

/// Why a body does not rest, as bits: it moves by itself, or something drives it, however slow it
/// is. 0: it rests.
constexpr uint8_t by_itself = 1, driven = 2;

/// A body that rocks alone, or among few others, costs little and may go on.
constexpr uint32_t kept_awake = 8;

/// An island of the awake bodies.
struct AwakeIsland {
    uint8_t unrest = 0;                         ///< of all its bodies
    uint32_t slow_bodies = 0, fast_bodies = 0;  ///< now
    bool rocks = true;                          ///< what is fast rocks in place
    bool rocks_for_long = true;                 ///< what does not rest rocks so
    bool touches = false;                       ///< a body touches something
    bool held = false;                          ///< by a contact or joint with what is not dynamic
    bool turns = false;                         ///< it flies or hangs, and is not still
};

float rest_speed_of(const ObjectState& objects, const WorldDef& settings, uint32_t body) {
    const BodyRecord& record = objects.bodies[body];
    return rest_speed(objects.sleep_speed_of(settings, record), record);
}

void continue_stays(const ObjectState& objects, const Columns& columns, ActiveLists& active,
                    const WorldDef& settings, float passed) {
    std::erase_if(active.stays, [&](Stay& stay) {
        const BodyRecord& body = objects.bodies[stay.body];
        return body.solver_index == 0 || body.mobility != Mobility::dynamic ||
               !continue_stay(stay, body, columns.states[stay.body],
                              rest_speed_of(objects, settings, stay.body), passed);
    });
}

/// Slows down what rocks in place among bodies that are slow, and may soon rest.
void calm_rocking(const ObjectState& objects, Columns& columns, ActiveLists& active,
                  const WorldDef& settings, float passed, UnionFind& sets,
                  std::span<const uint8_t> unrest, std::vector<AwakeIsland>& islands) {
    std::vector<uint32_t> rocking;
    std::vector<Stay> begun;
    for (uint32_t i = 0; i < unrest.size(); ++i) {
        if (unrest[i] != by_itself) continue;
        AwakeIsland& island = islands[sets.find(i)];
        if (island.unrest != by_itself) continue;
        const uint32_t slot = active.awake_bodies[i];
        const BodyRecord& body = objects.bodies[slot];
        const Stay* const stay = stay_of(active.stays, slot);
        if (stay != nullptr) {
            island.rocks &= rocks(*stay);
            island.rocks_for_long &= rocks_for_long(*stay);
            rocking.push_back(i);
            continue;
        }
        island.rocks_for_long = false;
        if (!is_fast(body, columns.states[slot], rest_speed_of(objects, settings, slot))) continue;
        island.rocks = false;
        if (kept_awake * island.fast_bodies <= island.slow_bodies)
            begun.push_back(begun_stay(slot, body, columns.states[slot]));
    }
    for (const uint32_t i : rocking) {
        AwakeIsland& island = islands[sets.find(i)];
        if (!island.rocks) continue;
        calm(columns.states[active.awake_bodies[i]], passed);
        if (island.rocks_for_long) island.unrest = 0;
    }
    active.stays.insert(active.stays.end(), begun.begin(), begun.end());
    std::sort(active.stays.begin(), active.stays.end(),
              [](const Stay& a, const Stay& b) { return a.body < b.body; });
}

/// Something drives the body, if it is awake and dynamic.
void disturb(const ObjectState& objects, uint32_t body, std::span<uint8_t> unrest) {
    const BodyRecord& record = objects.bodies[body];
    if (record.solver_index != 0 && record.mobility == Mobility::dynamic)
        unrest[record.solver_index - 1] = driven;
}

/// For each awake body why it does not rest, as far as its own motion and its joints tell.
std::vector<uint8_t> unrest_of_bodies(const ObjectState& objects, const Columns& columns,
                                      const ActiveLists& active, const JointScratch& joints,
                                      const WorldDef& settings) {
    std::vector<uint8_t> unrest(active.awake_bodies.size(), 0);
    for (size_t i = 0; i < unrest.size(); ++i) {
        const BodyRecord& record = objects.bodies[active.awake_bodies[i]];
        const bool alone = record.mobility == Mobility::dynamic && record.lists.first_joint == none;
        if (record.sleep_time < settings.sleep_delay) unrest[i] = alone ? by_itself : driven;
        if (!record.flags.can_sleep || (record.mobility != Mobility::dynamic &&
                                        in_motion(objects, columns, active.awake_bodies[i])))
            unrest[i] = driven;
    }
    for (const JointArray& array : joints.joint_arrays) {
        for (size_t i = 0; i < array.joints.size(); ++i) {
            if (array.drives[i] != 0)
                for (const uint32_t body : objects.joints[array.joints[i]].bodies)
                    disturb(objects, body, unrest);
        }
    }
    return unrest;
}

/// Unites the awake bodies that touch or are joined. What moves without being dynamic, and what a
/// belt carries, does not rest. Returns which bodies touch one that is not dynamic, or are
/// joined to it.
std::vector<bool> unite_islands(const ObjectState& objects, const Columns& columns,
                                const ActiveLists& active, UnionFind& sets,
                                std::vector<uint8_t>& unrest) {
    std::vector<bool> held(unrest.size(), false);
    const auto link = [&](uint32_t body_a, uint32_t body_b) {
        const uint32_t a = objects.bodies[body_a].solver_index,
                       b = objects.bodies[body_b].solver_index;
        const bool moves_a = objects.bodies[body_a].mobility == Mobility::dynamic;
        const bool moves_b = objects.bodies[body_b].mobility == Mobility::dynamic;
        if (a != 0 && !moves_b) held[a - 1] = true;
        if (b != 0 && !moves_a) held[b - 1] = true;
        if (a == 0 || b == 0) return;
        if (moves_a && moves_b)
            sets.unite(a - 1, b - 1);
        else if (moves_a && in_motion(objects, columns, body_b))
            unrest[a - 1] = driven;  // a moving body carries it
        else if (moves_b && in_motion(objects, columns, body_a))
            unrest[b - 1] = driven;
    };
    for (const uint32_t slot : active.awake_contacts) {
        const ContactRecord& c = objects.contacts[slot];
        if (!c.acts()) continue;
        link(c.body_a, c.body_b);
        if (!carried_by_belt(objects, columns, c)) continue;
        disturb(objects, c.body_a, unrest);
        disturb(objects, c.body_b, unrest);
    }
    for (const auto& list : active.awake_joints) {
        for (const uint32_t joint : list)
            link(objects.joints[joint].bodies[0], objects.joints[joint].bodies[1]);
    }
    return held;
}

/// The islands, each at the index of the root of its set.
std::vector<AwakeIsland> islands_of(const ObjectState& objects, const Columns& columns,
                                    const ActiveLists& active, const WorldDef& settings,
                                    UnionFind& sets, std::span<const uint8_t> unrest,
                                    const std::vector<bool>& held) {
    std::vector<AwakeIsland> islands(unrest.size());
    for (uint32_t i = 0; i < unrest.size(); ++i) {
        AwakeIsland& island = islands[sets.find(i)];
        island.unrest |= unrest[i];
        const uint32_t slot = active.awake_bodies[i];
        const bool fast = unrest[i] != 0 && is_fast(objects.bodies[slot], columns.states[slot],
                                                    rest_speed_of(objects, settings, slot));
        ++(fast ? island.fast_bodies : island.slow_bodies);
        island.touches |= objects.bodies[slot].lists.touching > 0;
        island.held |= held[i];
    }
    return islands;
}

/// What flies or hangs rests only if all of it is still; otherwise its time of rest begins again.
void keep_turning_awake(ObjectState& objects, const Columns& columns, const ActiveLists& active,
                        const WorldDef& settings, UnionFind& sets,
                        std::vector<AwakeIsland>& islands) {
    bool any = false;
    for (uint32_t i = 0; i < islands.size(); ++i) {
        AwakeIsland& island = islands[sets.find(i)];
        const uint32_t slot = active.awake_bodies[i];
        const BodyRecord& body = objects.bodies[slot];
        if ((island.touches && island.held) || island.unrest != 0 ||
            body.mobility != Mobility::dynamic)
            continue;
        if (hangs_still(rest_speed_of(objects, settings, slot), body, objects.rest_poses[slot],
                        columns.states[slot]))
            continue;
        any = island.turns = true;
    }
    for (uint32_t i = 0; any && i < islands.size(); ++i) {
        AwakeIsland& island = islands[sets.find(i)];
        if (!island.turns) continue;
        island.unrest = by_itself;
        objects.bodies[active.awake_bodies[i]].sleep_time = 0.0f;
    }
}

/// The bodies of each island that rests.
std::vector<std::vector<uint32_t>> resting_bodies(const ActiveLists& active, UnionFind& sets,
                                                  std::span<const AwakeIsland> islands) {
    std::vector<std::vector<uint32_t>> resting;
    std::vector<uint32_t> place_of(islands.size(), none);
    for (uint32_t i = 0; i < islands.size(); ++i) {
        const uint32_t root = sets.find(i);
        if (islands[root].unrest != 0) continue;
        if (place_of[root] == none) {
            place_of[root] = uint32_t(resting.size());
            resting.emplace_back();
        }
        resting[place_of[root]].push_back(active.awake_bodies[i]);
    }
    return resting;
}

}  // namespace

void sleep_resting_islands(const Activity& activity, const JointScratch& joints,
                           const WorldDef& settings, uint32_t candidates, uint64_t step,
                           float& since_search) {
    ObjectState& objects = activity.objects;
    Columns& columns = activity.columns;
    ActiveLists& active = activity.active;
    if (step % search_interval != 0) return;
    const float passed = std::exchange(since_search, 0.0f);
    if (!settings.sleeping) return active.stays.clear();
    continue_stays(objects, columns, active, settings, passed);
    if (candidates == 0 && active.stays.empty()) return;
    std::vector<uint8_t> unrest = unrest_of_bodies(objects, columns, active, joints, settings);
    UnionFind sets;
    sets.reset(unrest.size());
    const std::vector<bool> held = unite_islands(objects, columns, active, sets, unrest);
    std::vector<AwakeIsland> islands =
        islands_of(objects, columns, active, settings, sets, unrest, held);
    keep_turning_awake(objects, columns, active, settings, sets, islands);
    calm_rocking(objects, columns, active, settings, passed, sets, unrest, islands);
    const std::vector<std::vector<uint32_t>> resting = resting_bodies(active, sets, islands);
    for (const std::vector<uint32_t>& bodies : resting)
        put_to_sleep(activity, bodies, objects.island_slots.allocate(objects.islands));
    if (!resting.empty()) compact_awake(objects, active);
}

}  // namespace fettle::physics::detail
