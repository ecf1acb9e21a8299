#include <collision/extreme_points.h>
#include <saving/saved_world.h>

#include <algorithm>
#include <bit>
#include <optional>

// Checks of indices and lists. Damaged data that pass these checks may still describe a strange
// world, as edits may. They cannot cause access to foreign memory.

namespace fettle::physics::detail {
namespace {

/// Stores the description of the first error.
class Findings {
  public:
    void require(bool holds, const char* what) {
        if (!holds && !problem_) problem_ = what;
    }
    std::optional<std::string> result() const { return problem_; }

  private:
    std::optional<std::string> problem_;
};

bool optional_index(uint32_t index, size_t size) {
    return index == none || index < size;
}

/// Follows lists that share no element, so that all together have at most `size`. Following one
/// list of damaged data once for each of its owners could take minutes.
class ListWalk {
  public:
    explicit ListWalk(size_t size) : size_(size), left_(size) {}

    /// Follows `next` from `first`; false if an index is out of range, or if the list does not end
    /// or shares an element with another one.
    bool ends(uint32_t first, auto next) {
        for (uint32_t i = first; i != none; i = next(i)) {
            if (i >= size_ || left_ == 0) return false;
            --left_;
        }
        return true;
    }

  private:
    size_t size_, left_;
};

template <class Record>
bool free_list_ends(const Slots& slots, const std::vector<Record>& records) {
    return ListWalk(records.size()).ends(slots.free, [&](uint32_t i) {
        return Record(records[i]).next_free();
    });
}

bool all_below(const std::vector<uint32_t>& list, size_t size) {
    for (const uint32_t i : list)
        if (i >= size) return false;
    return true;
}

/// Follows lists of edges, of which each record has two.
bool edges_end(ListWalk& walk, uint32_t first, const auto& records) {
    return walk.ends(first, [&](uint32_t edge) { return records[edge >> 1].edges[edge & 1].next; });
}

bool edge_in_range(const ListEdge& edge, size_t records) {
    return (edge.previous == none || edge.previous >> 1 < records) &&
           (edge.next == none || edge.next >> 1 < records);
}

void check_bodies(const WorldState& w, Findings& findings) {
    const size_t n = w.bodies.size(), shapes = w.shapes.size();
    findings.require(n > 0 && w.states.size() == n && w.rest_poses.size() == n &&
                         w.previous.size() == n && w.body_generations.size() == n,
                     "bodies");
    ListWalk shape_lists(shapes), contact_lists(2 * w.contact_links.size()),
        joint_lists(2 * w.joints.size());
    for (const BodyRecord& body : w.bodies) {
        findings.require(body.mobility <= Mobility::dynamic &&
                             body.type <= BodyType::dynamic_body &&
                             body.solver_index <= w.awake_bodies.size() &&
                             optional_index(body.traits, w.traits.size()) && body.listed <= 1 &&
                             optional_index(body.lists.island, w.islands.size()),
                         "a body");
        findings.require(optional_index(body.lists.last_shape, shapes) &&
                             shape_lists.ends(body.lists.first_shape,
                                              [&](uint32_t s) { return w.shapes[s].next; }),
                         "the shapes of a body");
        findings.require(edges_end(contact_lists, body.lists.first_contact, w.contact_links),
                         "the contacts of a body");
        findings.require(edges_end(joint_lists, body.lists.first_joint, w.joints),
                         "the joints of a body");
    }
    for (size_t i = 0; i < w.stays.size(); ++i)
        findings.require(w.stays[i].body < n && (i == 0 || w.stays[i - 1].body < w.stays[i].body),
                         "the stay of a body");
    findings.require(free_list_ends(w.body_slots, w.bodies), "free bodies");
    findings.require(free_list_ends(w.trait_slots, w.traits), "free traits of bodies");
    for (const BodyTraits& traits : w.traits)
        findings.require(traits.name.back() == 0, "the name of a body");
}

/// Checks parts: a shape is a piece if it has an owner, and only outlines have parts and are
/// owners.
void check_parts(const WorldState& w, Findings& findings) {
    if (findings.result()) return;
    const size_t n = w.shapes.size();
    ListWalk part_lists(n);
    for (size_t i = 0; i < n; ++i) {
        const ShapeRecord& shape = w.shapes[i];
        const FormKind kind = w.forms[i].kind;
        findings.require(optional_index(shape.owner, n) && optional_index(shape.next_part, n) &&
                             part_lists.ends(shape.first_part,
                                             [&](uint32_t s) { return w.shapes[s].next_part; }),
                         "the parts of a shape");
        if (findings.result()) return;
        findings.require((kind == FormKind::piece) == (shape.owner != none) &&
                             (kind == FormKind::ellipse) == (shape.type == ShapeType::ellipse) &&
                             (kind != FormKind::ellipse || w.forms[i].count == 1) &&
                             (kind != FormKind::piece || w.forms[i].count >= 2) &&
                             (kind != FormKind::outline ||
                              (w.forms[i].count == 0 && shape.proxy == Tree::none)) &&
                             (kind == FormKind::outline || shape.first_part == none),
                         "the kind of a shape");
        findings.require(shape.owner == none || w.forms[shape.owner].kind == FormKind::outline,
                         "the owner of a part");
        for (uint32_t p = shape.first_part; p != none; p = w.shapes[p].next_part)
            findings.require(w.shapes[p].owner == i && w.forms[p].body == w.forms[i].body,
                             "the owner of a part");
    }
}

/// Checks the number of vertices: it must fit the type of the shape, and must not exceed the limit
/// of the code for its kind.
bool has_valid_vertex_count(const ShapeForm& form, ShapeType type) {
    const uint32_t count = form.count;
    if (form.kind == FormKind::border) return type == ShapeType::border;
    if (form.kind == FormKind::large)
        return type == ShapeType::polygon && count > uint32_t(most_small_vertices);
    switch (type) {
        case ShapeType::circle:
        case ShapeType::ellipse:
            return count == 1;
        case ShapeType::segment:
            return count == 2;
        case ShapeType::box:
            return count == 4;
        case ShapeType::polygon:
            return count >= 3 && count <= uint32_t(most_small_vertices);
        case ShapeType::concave:
        case ShapeType::chain:
            return form.kind == FormKind::piece || form.kind == FormKind::outline;
        default:
            return false;
    }
}

void check_shapes(const WorldState& w, Findings& findings) {
    const size_t n = w.shapes.size(), vertices = w.pool.local.size();
    findings.require(n >= 4 && w.forms.size() == n && w.boxes.size() == n &&
                         w.fat_boxes.size() == n && w.paired_boxes.size() == n &&
                         w.shape_generations.size() == n && w.pool.is_walkable(),
                     "shapes");
    if (findings.result()) return;
    for (size_t i = 0; i < n; ++i) {
        const ShapeRecord& shape = w.shapes[i];
        const ShapeForm& form = w.forms[i];
        findings.require(optional_index(form.body, w.bodies.size()) &&
                             optional_index(shape.previous, n) && optional_index(shape.next, n) &&
                             shape.type <= ShapeType::border && shape.tree <= Mobility::dynamic,
                         "a shape");
        const bool border = shape.type == ShapeType::border;
        const uint64_t taken = std::max<uint64_t>(
            shape.outline, form.count * (form.kind == FormKind::piece ? uint64_t{3} : 1) +
                               (form.count == 3 || form.kind == FormKind::ellipse));
        const bool inside = border || shape.capacity == 0
                                ? taken == 0 || border
                                : taken <= shape.capacity && std::has_single_bit(shape.capacity) &&
                                      shape.capacity <= vertices &&
                                      form.begin <= vertices - shape.capacity;
        findings.require(
            form.kind <= FormKind::outline && border == (form.kind == FormKind::border) &&
                (w.shape_generations[i] == 0 || has_valid_vertex_count(form, shape.type)),
            "the form of a shape");
        findings.require(inside && border == (i < 4) && (!border || form.begin == i),
                         "the vertices of a shape");
    }
    check_parts(w, findings);
    findings.require(free_list_ends(w.shape_slots, w.shapes), "free shapes");
}

void check_proxies(const WorldState& w, Findings& findings) {
    const auto n = uint32_t(w.shapes.size());
    findings.require(w.fixed_tree.is_walkable(n) && w.moving_tree.is_walkable(n),
                     "the broad phase");
    for (const ShapeRecord& shape : w.shapes) {
        const Tree& in = shape.tree == Mobility::fixed ? w.fixed_tree : w.moving_tree;
        findings.require(shape.proxy == Tree::none || in.is_leaf(shape.proxy), "a proxy");
    }
    // A step moves the proxies of all awake bodies without checks. The proxies of an edited body
    // are created again before.
    std::vector<bool> edited(w.bodies.size());
    for (const uint32_t b : w.edited_bodies)
        if (b < edited.size())
            edited[b] = w.bodies[b].listed != 0 && w.bodies[b].flags.placement_dirty;
    for (size_t b = 0; b < w.bodies.size(); ++b) {
        const BodyRecord& body = w.bodies[b];
        if (body.solver_index == 0 || edited[b]) continue;
        for (uint32_t s = body.lists.first_shape; s != none; s = w.shapes[s].next) {
            const ShapeRecord& shape = w.shapes[s];
            findings.require(
                !w.is_solid(s) || (shape.proxy != Tree::none && shape.tree != Mobility::fixed),
                "the proxy of an awake shape");
        }
    }
}

void check_contacts(const WorldState& w, Findings& findings) {
    const size_t n = w.contacts.size();
    findings.require(w.contact_links.size() == n && w.manifold_poses.size() == n, "contacts");
    for (const ContactRecord& c : w.contacts) {
        const bool used = c.shape_a != none;
        findings.require(used || !c.touching,
                         "a contact");  // World::contacts checks only this
        findings.require(!used || (c.shape_a < w.shapes.size() && c.shape_b < w.shapes.size() &&
                                   c.body_a < w.bodies.size() && c.body_b < w.bodies.size()),
                         "a contact");
        findings.require(optional_index(c.awake_index, w.awake_contacts.size()) &&
                             c.manifold.count >= 0 && c.manifold.count <= 2 &&
                             (!c.kept || c.manifold.count > 0) && c.skipped <= Skipped::wedged,
                         "a contact");
    }
    for (const ContactLinks& links : w.contact_links)
        findings.require(edge_in_range(links.edges[0], n) && edge_in_range(links.edges[1], n),
                         "a contact");
    findings.require(free_list_ends(w.contact_slots, w.contact_links), "free contacts");
    findings.require(w.pairs.is_walkable(uint32_t(n)), "the pairs");
    // Checks that every contact in a list of a body or of awake contacts is in use.
    for (const BodyRecord& body : w.bodies)
        for (uint32_t e = body.lists.first_contact; e != none;
             e = w.contact_links[e >> 1].edges[e & 1].next)
            findings.require(w.contacts[e >> 1].shape_a != none, "the contacts of a body");
    for (size_t i = 0; i < w.awake_contacts.size(); ++i) {
        const ContactRecord& c = w.contacts[w.awake_contacts[i]];
        findings.require(c.shape_a != none && c.awake_index == i, "the awake contacts");
    }
    if (findings.result()) return;
    // Checks that a shape that collides has a form; the border is always the first of two shapes.
    for (const ContactRecord& c : w.contacts)
        findings.require(c.shape_a == none || (w.is_solid(c.shape_a) && w.is_solid(c.shape_b) &&
                                               w.forms[c.shape_b].kind != FormKind::border),
                         "a contact");
}

void check_links_of_joints(const WorldState& w, Findings& findings) {
    const size_t n = w.joints.size();
    findings.require(w.joint_generations.size() == n, "joints");
    if (findings.result()) return;
    for (const JointRecord& joint : w.joints) {
        findings.require(size_t(joint.type) < joint_type_count &&
                             joint.bodies[0] < w.bodies.size() &&
                             joint.bodies[1] < w.bodies.size() &&
                             (joint.bodies[0] != joint.bodies[1] || joint.dormant()) &&
                             edge_in_range(joint.edges[0], n) && edge_in_range(joint.edges[1], n),
                         "a joint");
    }
    if (findings.result()) return;  // the next checks use the lists of their types
    for (size_t type = 0; type < joint_type_count; ++type) {
        const auto& list = w.awake_joints[type];
        for (size_t i = 0; i < list.size(); ++i)
            findings.require(list[i] < n && w.joint_generations[list[i]] != 0 &&
                                 size_t(w.joints[list[i]].type) == type &&
                                 w.joints[list[i]].awake_index == i,
                             "the awake joints");
    }
    for (const JointRecord& joint : w.joints)
        findings.require(joint.awake_index == none ||
                             joint.awake_index < w.awake_joints[size_t(joint.type)].size(),
                         "the awake joints");
    findings.require(free_list_ends(w.joint_slots, w.joints), "free joints");
}

void check_fields(const WorldState& w, Findings& findings) {
    findings.require(free_list_ends(w.field_slots, w.fields), "free fields");
}

void check_lists(const WorldState& w, Findings& findings) {
    const size_t bodies = w.bodies.size(), shapes = w.shapes.size();
    findings.require(all_below(w.awake_bodies, bodies) && all_below(w.edited_bodies, bodies) &&
                         all_below(w.edited_shapes, shapes) && all_below(w.moved_shapes, shapes) &&
                         all_below(w.awake_contacts, w.contacts.size()),
                     "the lists of awake or edited objects");
    findings.require(w.strips.is_valid(), "the strips");
    ListWalk sleepers_of_islands(bodies);
    for (const Island& island : w.islands)
        findings.require(sleepers_of_islands.ends(
                             island.first, [&](uint32_t i) { return w.bodies[i].lists.next; }),
                         "an island");
    findings.require(free_list_ends(w.island_slots, w.islands), "free islands");
    const WorldDef& s = w.settings;
    findings.require(s.substeps >= 1 && s.substeps <= 64 && s.friction_mix <= MixRule::geometric &&
                         s.restitution_mix <= MixRule::geometric && s.solver <= Solver::direct,
                     "the settings");
    if (findings.result()) return;
    // Checks that every sleeping body is in an island, and that the island lists it.
    size_t sleepers = 0;
    for (uint32_t i = 0; i < w.islands.size(); ++i) {
        w.for_each_asleep(i, [&](uint32_t body) {
            findings.require(w.bodies[body].lists.island == i, "an island");
            ++sleepers;
        });
    }
    for (const BodyRecord& body : w.bodies) {
        findings.require(!body.asleep() || body.lists.island != none, "a sleeping body");
        sleepers -= body.lists.island != none;
    }
    findings.require(sleepers == 0, "an island");
    // Checks that each awake body stores its index in the list.
    size_t awake = 0;
    for (const BodyRecord& body : w.bodies) awake += body.solver_index != 0;
    findings.require(awake == w.awake_bodies.size(), "the awake bodies");
    for (size_t i = 0; i < w.awake_bodies.size(); ++i)
        findings.require(w.bodies[w.awake_bodies[i]].solver_index == i + 1, "the awake bodies");
}

}  // namespace

std::optional<std::string> links_problem(const WorldState& world) {
    Findings findings;
    // Each check relies on ranges that an earlier check has tested.
    check_bodies(world, findings);
    if (!findings.result()) check_shapes(world, findings);
    if (!findings.result()) check_proxies(world, findings);
    check_fields(world, findings);
    if (!findings.result()) check_lists(world, findings);
    if (!findings.result()) check_contacts(world, findings);
    if (!findings.result()) check_links_of_joints(world, findings);
    return findings.result();
}

}  // namespace fettle::physics::detail
