#include <world/world_data.h>

#include <algorithm>

// Looks for disagreement between the parts of a world that say the same thing in different ways.

namespace fettle::physics {

using namespace detail;

namespace {

using Fault = std::optional<std::string>;

std::string number(uint64_t value) {
    return std::to_string(value);
}

Fault check_contacts(const WorldData& data) {
    uint32_t live = 0, awake = 0;
    std::vector<uint32_t> touching(data.bodies.size(), 0), degree(data.bodies.size(), 0);
    for (uint32_t slot = 0; slot < data.contacts.size(); ++slot) {
        const ContactRecord& c = data.contacts[slot];
        if (c.shape_a == none) continue;
        ++live;
        if (c.shape_a >= c.shape_b)
            return "contact " + number(slot) + " has its shapes in the wrong order";
        if (data.pairs.find(c.shape_a, c.shape_b) != slot)
            return "contact " + number(slot) + " is not in the pair set";
        if (data.forms[c.shape_a].body != c.body_a || data.forms[c.shape_b].body != c.body_b) {
            return "contact " + number(slot) + " names a body that its shape left";
        }
        const bool active =
            data.bodies[c.body_a].solver_index != 0 || data.bodies[c.body_b].solver_index != 0;
        if (active != (c.awake_index != none))
            return "contact " + number(slot) + " sleeps otherwise than its bodies";
        if (active) {
            ++awake;
            if (c.awake_index >= data.awake_contacts.size() ||
                data.awake_contacts[c.awake_index] != slot) {
                return "contact " + number(slot) + " is not where it is listed";
            }
        }
        for (uint32_t body : {c.body_a, c.body_b}) {
            ++degree[body];
            touching[body] += c.touching && !c.sensor;
        }
    }
    if (live != data.contact_count) return std::string("the number of contacts is wrong");
    if (live != data.pairs.size()) return std::string("the pair set holds pairs without a contact");
    if (awake != data.awake_contacts.size())
        return std::string("the list of awake contacts is too long");
    for (uint32_t body = 0; body < data.bodies.size(); ++body) {
        uint32_t walked = 0;
        data.for_each_contact(body, [&](uint32_t) { ++walked; });
        if (walked != degree[body] || walked != data.bodies[body].contact_count) {
            return "body " + number(body) + " has a broken list of contacts";
        }
        if (touching[body] != data.bodies[body].touching)
            return "body " + number(body) + " miscounts what it touches";
    }
    return {};
}

Fault check_bodies(const WorldData& data) {
    uint32_t awake = 0, asleep = 0, in_islands = 0;
    for (uint32_t body = 1; body < data.bodies.size(); ++body) {
        if (data.body_generations[body] == 0) continue;
        const BodyRecord& record = data.bodies[body];
        const BodyState& s = data.states[body];
        for (float v : {s.position.x(), s.position.y(), s.angle, s.velocity.x(), s.velocity.y(),
                        s.angular_velocity}) {
            if (!std::isfinite(v))
                return "body " + number(body) + " has a state that is not finite";
        }
        if (record.solver_index != 0) {
            ++awake;
            if (record.island != none)
                return "body " + number(body) + " is awake and in a sleeping island";
            if (data.awake_bodies[record.solver_index - 1] != body) {
                return "body " + number(body) + " is not where it is listed";
            }
        } else if (record.asleep()) {
            ++asleep;
            if (record.island == none) return "body " + number(body) + " sleeps in no island";
        }
        for (uint32_t shape = record.first_shape; shape != none; shape = data.shapes[shape].next) {
            if (data.forms[shape].body != body)
                return "shape " + number(shape) + " is listed in another body";
        }
    }
    if (awake != data.awake_bodies.size())
        return std::string("the list of awake bodies is too long");
    for (uint32_t i = 0; i < data.islands.size(); ++i)
        data.for_each_asleep(i, [&](uint32_t) { ++in_islands; });
    if (asleep != in_islands) return std::string("the islands hold bodies that do not sleep");
    return {};
}

Fault check_trees(const WorldData& data) {
    if (!data.fixed_tree.is_consistent()) return std::string("the tree of fixed shapes is broken");
    if (!data.moving_tree.is_consistent())
        return std::string("the tree of moving shapes is broken");
    uint32_t proxies = 0;
    for (uint32_t shape = 4; shape < data.shapes.size(); ++shape) {
        if (data.shape_generations[shape] == 0 || data.forms[shape].body == none) continue;
        const ShapeRecord& record = data.shapes[shape];
        if (record.listed || data.bodies[data.forms[shape].body].listed)
            continue;  // not yet refreshed
        if (!data.is_solid(shape)) {
            if (record.proxy != Tree::none) return "outline " + number(shape) + " is in a tree";
            continue;
        }
        if (record.proxy == Tree::none) return "shape " + number(shape) + " is in no tree";
        const Tree& tree = record.tree == Mobility::fixed ? data.fixed_tree : data.moving_tree;
        if (!contains(tree.box(record.proxy), data.boxes[shape]))
            return "shape " + number(shape) + " left its fat box";
        ++proxies;
    }
    if (data.edited_bodies.empty() && proxies != data.fixed_tree.size() + data.moving_tree.size()) {
        return std::string("a tree holds shapes that do not exist");
    }
    return {};
}

/// All pairs whose fat boxes overlap must have a contact: by brute force.
Fault check_pairs(const WorldData& data) {
    if (!data.edited_bodies.empty() || !data.moved_shapes.empty()) return {};
    for (uint32_t a = 4; a < data.shapes.size(); ++a) {
        if (data.shape_generations[a] == 0 || data.forms[a].body == none || !data.is_solid(a))
            continue;
        for (uint32_t b = a + 1; b < data.shapes.size(); ++b) {
            if (data.shape_generations[b] == 0 || data.forms[b].body == none || !data.is_solid(b))
                continue;
            if (!overlap(data.fat_boxes[a], data.fat_boxes[b]) || !data.may_collide(a, b)) continue;
            if (data.pairs.find(a, b) == PairSet::absent) {
                return "shapes " + number(a) + " and " + number(b) + " overlap without a contact";
            }
        }
    }
    return {};
}

/// Every joint is in the lists of both its bodies and at its place in the list of its type.
Fault check_joints(const WorldData& data) {
    std::vector<uint32_t> degree(data.bodies.size());
    size_t live = 0, listed = 0;
    for (uint32_t joint = 0; joint < data.joints.size(); ++joint) {
        if (data.joint_generations[joint] == 0) continue;
        ++live;
        for (uint32_t body : data.joints[joint].bodies) ++degree[body];
    }
    if (live != data.joint_count) return std::string("the number of joints is wrong");
    for (uint32_t body = 0; body < data.bodies.size(); ++body) {
        uint32_t walked = 0;
        data.for_each_joint(body, [&](uint32_t joint, uint32_t side) {
            walked += data.joints[joint].bodies[side] == body;
        });
        if (walked != degree[body] || walked != data.bodies[body].joint_count)
            return "body " + number(body) + " has a broken list of joints";
    }
    bool placed = true;
    auto check_list = [&](const auto& list) {
        for (size_t place = 0; place < list.size(); ++place)
            placed &= data.joints[list[place].joint].place == place;
        listed += list.size();
    };
    std::apply([&](const auto&... list) { (check_list(list), ...); }, data.joint_lists);
    for (uint32_t joint = 0; joint < data.joints.size(); ++joint) {
        const JointRecord& record = data.joints[joint];
        const auto [a, b] = record.bodies;
        const bool awake = data.joint_generations[joint] != 0 && record.acts() &&
                           (data.bodies[a].solver_index != 0 || data.bodies[b].solver_index != 0);
        const auto& list = data.awake_joints[size_t(record.type)];
        const uint32_t index = record.awake_index;
        if (awake != (index != none) || (awake && (index >= list.size() || list[index] != joint)))
            return "joint " + number(joint) + " is not listed as it should be";
    }
    if (!placed || listed != live) return std::string("a list of joints does not hold its joints");
    return {};
}

}  // namespace

std::optional<std::string> detail::WorldData::validate() const {
    for (auto check : {check_bodies, check_contacts, check_trees, check_pairs, check_joints}) {
        if (Fault fault = check(*this)) return fault;
    }
    return {};
}

std::optional<std::string> World::validate() const {
    return data_->validate();
}

}  // namespace fettle::physics
