// Checks that redundant lists of a deserialized world agree.

#include <saving/saved_world.h>
#include <state/crowding.h>

namespace fettle::physics::detail {
namespace {

using Fault = std::optional<std::string>;
using std::to_string;

/// True if the list contains all marked slots. It may contain others: slots that were freed and
/// used again.
bool lists_the_marked(const std::vector<uint32_t>& list, size_t size, auto is_marked) {
    std::vector<bool> listed(size);
    for (const uint32_t i : list) listed[i] = true;
    for (uint32_t i = 0; i < size; ++i)
        if (is_marked(i) && !listed[i]) return false;
    return true;
}

/// True if the list contains the marked slots and nothing else, each once.
bool lists_only_the_marked(const std::vector<uint32_t>& list, size_t size, auto is_marked) {
    size_t marked = 0;
    for (uint32_t i = 0; i < size; ++i) marked += is_marked(i);
    return list.size() == marked && lists_the_marked(list, size, is_marked);
}

/// True if the list of free slots contains every free slot and no other.
template <class Record>
bool lists_the_free(const Slots& slots, const std::vector<Record>& records, auto is_free) {
    size_t free = 0;
    for (uint32_t i = 0; i < records.size(); ++i) free += is_free(i);
    for (uint32_t i = slots.free; i != none; i = Record(records[i]).next_free()) {
        if (!is_free(i) || free == 0) return false;
        --free;
    }
    return free == 0;
}

/// Checks the lists of bodies, or of shapes: the edited ones, and the free slots.
template <class Record>
Fault check_slot_lists(const std::string& kind, const std::vector<Record>& records,
                       const std::vector<uint32_t>& generations,
                       const std::vector<uint32_t>& edited, const Slots& slots) {
    if (!lists_the_marked(edited, records.size(), [&](uint32_t i) { return records[i].listed; }))
        return "the list of edited " + kind + " is wrong";
    if (!lists_the_free(slots, records, [&](uint32_t i) { return generations[i] == 0; }))
        return "the list of free " + kind + " is wrong";
    return {};
}

/// Number of edges in the list of a body; `none` if an edge belongs to another body.
template <class Edge, class Body>
uint32_t degree(uint32_t first, uint32_t body, Edge edge_of, Body body_of) {
    uint32_t count = 0, previous = none;
    for (uint32_t e = first; e != none; ++count) {
        const ListEdge& edge = edge_of(e >> 1).edges[e & 1];
        if (edge.previous != previous || body_of(e >> 1, e & 1) != body) return none;
        previous = e;
        e = edge.next;
    }
    return count;
}

/// False if its mobility does not follow from its type. An edit that changes one of them lists it.
bool mobility_fits_type(const BodyRecord& body) {
    if (body.listed || body.mobility == Mobility::fixed) return true;
    return body.mobility == Mobility::kinematic ? body.type == BodyType::kinematic_body
                                                : body.type == BodyType::dynamic_body;
}

/// Checks that each record of unusual traits belongs to one body or is free.
Fault check_traits(const WorldState& data) {
    std::vector<bool> owned(data.traits.size());
    uint32_t owners = 0;
    for (uint32_t body = 0; body < data.bodies.size(); ++body) {
        const uint32_t traits = data.bodies[body].traits;
        if (data.body_generations[body] == 0 || traits == none) continue;
        if (owned[traits]) return "body " + to_string(body) + " shares its traits with another one";
        owned[traits] = true;
        ++owners;
    }
    if (owners != data.trait_slots.count)
        return std::string("the number of unusual traits of bodies is wrong");
    if (!lists_the_free(data.trait_slots, data.traits, [&](uint32_t i) { return !owned[i]; }))
        return std::string("the list of free traits is wrong");
    return {};
}

Fault check_islands(const WorldState& data) {
    uint32_t used = 0;
    for (const Island& island : data.islands) used += island.first != none;
    if (used != data.island_slots.count) return std::string("the number of islands is wrong");
    if (!lists_the_free(data.island_slots, data.islands,
                        [&](uint32_t i) { return data.islands[i].first == none; }))
        return std::string("the list of free islands is wrong");
    return {};
}

Fault check_fields(const WorldState& data) {
    uint32_t live = 0;
    for (const FieldRecord& field : data.fields) live += field.generation != 0;
    if (live != data.field_slots.count) return std::string("the number of fields is wrong");
    if (!lists_the_free(data.field_slots, data.fields,
                        [&](uint32_t i) { return data.fields[i].generation == 0; }))
        return std::string("the list of free fields is wrong");
    return {};
}

Fault check_bodies(const WorldState& data) {
    uint32_t live = 0, awake = 0, asleep = 0, in_islands = 0, kinematic = 0, bullets = 0;
    for (uint32_t body = 0; body < data.bodies.size(); ++body) {
        const BodyRecord& record = data.bodies[body];
        if (data.body_generations[body] == 0) {
            if (record.solver_index != 0 || record.lists.first_shape != none ||
                record.lists.first_contact != none || record.lists.first_joint != none)
                return "body " + to_string(body) + " is destroyed but still linked";
            continue;
        }
        live += body != 0;
        if (record.flags.disabled &&
            (record.mobility != Mobility::fixed || record.lists.first_contact != none))
            return "body " + to_string(body) + " is disabled but takes part";
        bullets += record.flags.bullet;
        kinematic += record.mobility == Mobility::kinematic;
        if ((record.flags.mass_dirty || record.flags.placement_dirty) && !record.listed)
            return "body " + to_string(body) + " is out of date but not listed";
        if (record.lists.island == none && record.lists.next != none)
            return "body " + to_string(body) + " is in no island but linked to another body";
        if (!mobility_fits_type(record))
            return "body " + to_string(body) + " has a mobility that does not fit its type";
        if (record.solver_index != 0) {
            ++awake;
            if (record.mobility == Mobility::fixed)
                return "body " + to_string(body) + " is awake and cannot move";
            if (record.lists.island != none)
                return "body " + to_string(body) + " is awake and in a sleeping island";
            if (record.solver_index > data.awake_bodies.size() ||
                data.awake_bodies[record.solver_index - 1] != body)
                return "body " + to_string(body) + " is not where it is listed";
        } else if (record.asleep()) {
            ++asleep;
            if (record.lists.island == none)
                return "body " + to_string(body) + " sleeps in no island";
        }
    }
    if (live != data.body_slots.count || kinematic != data.kinematic_bodies ||
        bullets != data.bullets)
        return std::string("the number of bodies is wrong");
    if (awake != data.awake_bodies.size())
        return std::string("the list of awake bodies is too long");
    for (uint32_t i = 0; i < data.islands.size(); ++i)
        data.for_each_asleep(i, [&](uint32_t) { ++in_islands; });
    if (asleep != in_islands) return std::string("the islands hold bodies that do not sleep");
    return check_slot_lists("bodies", data.bodies, data.body_generations, data.edited_bodies,
                            data.body_slots);
}

/// True for a shape that collides, unless an edit has listed it, which gives it a proxy.
bool needs_proxy(const WorldState& data, uint32_t shape) {
    const uint32_t body = data.forms[shape].body;
    return body != none && data.is_solid(shape) && !data.bodies[body].flags.disabled &&
           !data.bodies[body].listed && !data.shapes[shape].listed;
}

/// Checks that no two shapes have the same vertices, and that no vertices in use are free.
Fault check_vertices(const WorldState& data) {
    std::vector<bool> taken(data.pool.local.size());
    const auto claim = [&](size_t begin, size_t size) {
        if (size > taken.size() || begin > taken.size() - size) return false;
        bool free = true;
        for (size_t i = begin; i < begin + size; ++i) {
            free &= !taken[i];
            taken[i] = true;
        }
        return free;
    };
    for (uint32_t shape = border_sides; shape < data.shapes.size(); ++shape) {
        const uint32_t size = data.shapes[shape].capacity;
        if (size > 0 && !claim(data.forms[shape].begin, size))
            return "shape " + to_string(shape) + " has the vertices of another one";
    }
    bool free = true;
    data.pool.for_each_free([&](size_t begin, size_t size) { free &= claim(begin, size); });
    if (!free) return std::string("the list of free vertices is wrong");
    return {};
}

Fault check_shapes(const WorldState& data) {
    uint32_t live = 0, on_bodies = 0, listed = 0, proxies = 0, sensors = 0, crowded = 0;
    for (uint32_t shape = border_sides; shape < data.shapes.size(); ++shape) {
        const ShapeRecord& record = data.shapes[shape];
        if (data.shape_generations[shape] == 0) {
            if (data.forms[shape].body != none || record.proxy != Tree::none ||
                record.owner != none || record.capacity != 0)
                return "shape " + to_string(shape) + " is destroyed but still linked";
            continue;
        }
        live += record.owner == none;
        sensors += record.owner == none && record.surface.sensor;
        crowded += record.crowded;
        on_bodies += data.forms[shape].body != none;
        if (record.geometry_dirty && !record.listed)
            return "shape " + to_string(shape) + " is out of date but not listed";
        if (record.proxy == Tree::none) {
            if (needs_proxy(data, shape)) return "shape " + to_string(shape) + " is in no tree";
            continue;
        }
        ++proxies;
        if (data.forms[shape].body != none && data.bodies[data.forms[shape].body].flags.disabled)
            return "shape " + to_string(shape) + " is in a tree, and its body is disabled";
        const Tree& tree = record.tree == Mobility::fixed ? data.fixed_tree : data.moving_tree;
        if (tree.item(record.proxy) != shape || data.forms[shape].body == none)
            return "shape " + to_string(shape) + " is in a tree as another one";
    }
    if (live != data.shape_slots.count || sensors != data.sensors)
        return std::string("the number of shapes is wrong");
    if (proxies != data.fixed_tree.size() + data.moving_tree.size())
        return std::string("a tree holds shapes that do not exist");
    for (uint32_t body = 0; body < data.bodies.size(); ++body) {
        uint32_t previous = none;
        for (uint32_t s = data.bodies[body].lists.first_shape; s != none; s = data.shapes[s].next) {
            if (data.forms[s].body != body || data.shapes[s].previous != previous)
                return "shape " + to_string(s) + " is listed in another body";
            previous = s;
            ++listed;
        }
        if (data.bodies[body].lists.last_shape != previous)
            return "body " + to_string(body) + " has a broken list of shapes";
    }
    if (crowded != data.crowded_shapes) return std::string("the number of crowded shapes is wrong");
    if (listed != on_bodies) return std::string("a shape is not listed in its body");
    // The next step searches for the pairs of each listed shape. If one shape were listed very
    // often, this would hardly end.
    if (!lists_only_the_marked(data.moved_shapes, data.shapes.size(),
                               [&](uint32_t shape) { return data.shapes[shape].moved; }))
        return std::string("the list of moved shapes is wrong");
    return check_slot_lists("shapes", data.shapes, data.shape_generations, data.edited_shapes,
                            data.shape_slots);
}

Fault check_contacts(const WorldState& data) {
    uint32_t live = 0, awake = 0, edges = 0;
    std::vector<uint32_t> touching(data.bodies.size(), 0);
    for (uint32_t slot = 0; slot < data.contacts.size(); ++slot) {
        const ContactRecord& c = data.contacts[slot];
        if (c.shape_a == none) {
            if (c.awake_index != none)
                return "contact " + to_string(slot) + " is destroyed but still listed";
            continue;
        }
        ++live;
        if (c.shape_a >= c.shape_b)
            return "contact " + to_string(slot) + " has its shapes in the wrong order";
        if (data.pairs.find(c.shape_a, c.shape_b) != slot)
            return "contact " + to_string(slot) + " is not in the pair set";
        if (data.forms[c.shape_a].body != c.body_a || data.forms[c.shape_b].body != c.body_b)
            return "contact " + to_string(slot) + " names a body that its shape left";
        const bool active =
            data.bodies[c.body_a].solver_index != 0 || data.bodies[c.body_b].solver_index != 0;
        if (active != (c.awake_index != none))
            return "contact " + to_string(slot) +
                   " is not listed as asleep or awake like its bodies";
        if (active) {
            ++awake;
            if (c.awake_index >= data.awake_contacts.size() ||
                data.awake_contacts[c.awake_index] != slot)
                return "contact " + to_string(slot) + " is not where it is listed";
        }
        for (uint32_t body : {c.body_a, c.body_b}) touching[body] += c.touching && !c.sensor;
    }
    if (live != data.contact_slots.count) return std::string("the number of contacts is wrong");
    if (live != data.pairs.size()) return std::string("the pair set holds pairs without a contact");
    if (awake != data.awake_contacts.size())
        return std::string("the list of awake contacts is too long");
    for (uint32_t body = 0; body < data.bodies.size(); ++body) {
        const BodyRecord& record = data.bodies[body];
        const uint32_t count = degree(
            record.lists.first_contact,
            body, [&](uint32_t slot) -> auto& { return data.contact_links[slot]; },
            [&](uint32_t slot, uint32_t side) {
                const ContactRecord& c = data.contacts[slot];
                return c.shape_a == none ? none : side == 0 ? c.body_a : c.body_b;
            });
        if (count != record.lists.contact_count)
            return "body " + to_string(body) + " has a broken list of contacts";
        if (touching[body] != record.lists.touching)
            return "body " + to_string(body) + " has a wrong number of touching contacts";
        edges += count;
    }
    if (edges != 2 * live) return std::string("a contact is not listed in its bodies");
    if (!lists_the_free(data.contact_slots, data.contact_links,
                        [&](uint32_t slot) { return data.contacts[slot].shape_a == none; }))
        return std::string("the list of free contacts is wrong");
    return {};
}

/// Checks that every joint is in the lists of both its bodies.
Fault check_joints(const WorldState& data) {
    uint32_t live = 0, edges = 0, awake = 0, dormant = 0;
    for (uint32_t joint = 0; joint < data.joints.size(); ++joint) {
        const JointRecord& record = data.joints[joint];
        const auto [a, b] = record.bodies;
        const bool lives = data.joint_generations[joint] != 0;
        live += lives;
        dormant += lives && record.dormant();
        const bool active = lives && data.may_act(record) &&
                            (data.bodies[a].solver_index != 0 || data.bodies[b].solver_index != 0);
        const auto& list = data.awake_joints[size_t(record.type)];
        const uint32_t index = record.awake_index;
        if (active != (index != none) || (active && (index >= list.size() || list[index] != joint)))
            return "joint " + to_string(joint) + " is not listed as it should be";
        awake += active;
    }
    if (live != data.joint_slots.count || dormant != data.dormant_joints)
        return std::string("the number of joints is wrong");
    for (const auto& list : data.awake_joints) awake -= uint32_t(list.size());
    if (awake != 0) return std::string("the lists of awake joints are too long");
    for (uint32_t body = 0; body < data.bodies.size(); ++body) {
        const uint32_t count = degree(
            data.bodies[body].lists.first_joint,
            body, [&](uint32_t joint) -> auto& { return data.joints[joint]; },
            [&](uint32_t joint, uint32_t side) {
                return data.joint_generations[joint] == 0 ? none : data.joints[joint].bodies[side];
            });
        if (count != data.bodies[body].lists.joint_count)
            return "body " + to_string(body) + " has a broken list of joints";
        if (data.edited_bodies.empty() && data.edited_shapes.empty() &&
            data.bodies[body].may_be_crowded != may_be_crowded(data, body))
            return "it is not known whether joints crowd body " + to_string(body);
        edges += count;
    }
    if (edges != 2 * live) return std::string("a joint is not listed in its bodies");
    if (!lists_the_free(data.joint_slots, data.joints,
                        [&](uint32_t joint) { return data.joint_generations[joint] == 0; }))
        return std::string("the list of free joints is wrong");
    return {};
}

}  // namespace

std::optional<std::string> memberships_problem(const WorldState& world) {
    for (auto check : {check_bodies, check_traits, check_islands, check_shapes, check_vertices,
                       check_contacts, check_joints, check_fields}) {
        if (Fault fault = check(world)) return fault;
    }
    return {};
}

}  // namespace fettle::physics::detail
