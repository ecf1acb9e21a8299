#include <saving/saved_world.h>
#include <world/world_data.h>

// Checks all invariants of a world. Compares every shape with every other one.

namespace fettle::physics {

using namespace detail;

namespace {

using Fault = std::optional<std::string>;
using std::to_string;

Fault check_trees(const WorldData& data) {
    if (!data.fixed_tree.is_consistent()) return std::string("the tree of fixed shapes is broken");
    if (!data.moving_tree.is_consistent())
        return std::string("the tree of moving shapes is broken");
    uint32_t proxies = 0;
    for (uint32_t shape = border_sides; shape < data.shapes.size(); ++shape) {
        if (data.shape_generations[shape] == 0 || data.forms[shape].body == none) continue;
        const ShapeRecord& record = data.shapes[shape];
        if (record.listed || data.bodies[data.forms[shape].body].listed)
            continue;  // not yet refreshed
        if (data.bodies[data.forms[shape].body].flags.disabled) continue;
        if (!data.is_solid(shape)) {
            if (record.proxy != Tree::none) return "outline " + to_string(shape) + " is in a tree";
            continue;
        }
        if (record.proxy == Tree::none) return "shape " + to_string(shape) + " is in no tree";
        const Tree& tree = record.tree == Mobility::fixed ? data.fixed_tree : data.moving_tree;
        if (!contains(tree.box(record.proxy), data.boxes[shape]))
            return "shape " + to_string(shape) + " left its fat box";
        ++proxies;
    }
    if (data.edited_bodies.empty() && proxies != data.fixed_tree.size() + data.moving_tree.size()) {
        return std::string("a tree holds shapes that do not exist");
    }
    return {};
}

bool collides(const WorldData& data, uint32_t shape) {
    return data.shape_generations[shape] != 0 && data.forms[shape].body != none &&
           !data.bodies[data.forms[shape].body].flags.disabled && data.is_solid(shape);
}

/// Checks that all pairs with overlapping fat boxes have a contact, unless they are in a crowd.
/// Compares all pairs.
Fault check_pairs(const WorldData& data) {
    if (!data.edited_bodies.empty() || !data.moved_shapes.empty()) return {};
    if (data.lacks_refused_pairs()) return {};  // until the next step
    for (uint32_t a = 4; a < data.shapes.size(); ++a) {
        if (!collides(data, a)) continue;
        for (uint32_t b = a + 1; b < data.shapes.size(); ++b) {
            if (!collides(data, b)) continue;
            if (!overlap(data.fat_boxes[a], data.fat_boxes[b]) || !data.may_collide(a, b)) continue;
            if (data.shapes[a].crowded || data.shapes[b].crowded) continue;
            if (data.pairs.find(a, b) == PairSet::absent) {
                return "shapes " + to_string(a) + " and " + to_string(b) +
                       " overlap without a contact";
            }
        }
    }
    return {};
}

}  // namespace

std::optional<std::string> World::validate() const {
    const WorldData& data = *data_;
    data.self.may_copy("World::validate");
    WorldLock lock(data.self, WorldLock::During::change, in_edit);  // calls the filter
    Fault fault = memberships_problem(data);
    if (!fault) fault = numbers_problem(data);
    if (!fault) fault = check_trees(data);
    if (!fault) fault = check_pairs(data);
    lock.finish();
    return fault;
}

}  // namespace fettle::physics
