#include <collision/collide_solids.h>
#include <collision/covered_outline.h>
#include <contacts/flush_shapes.h>
#include <contacts/overlaps/overlaps.h>
#include <state/limits.h>

namespace fettle::physics::detail {
namespace {

/// A direction in which the overlap is more than this times the least one, and by more than this
/// (m), is not the way out: it would press a shape through to the other side of a tile.
constexpr float most_times_deeper = 3.0f, little_deeper = 0.01f;

bool leads_through(const Manifold& pushed, const Manifold& least) {
    return pushed.count > 0 &&
           overlap_of(pushed) > most_times_deeper * max(overlap_of(least), 0.0f) + little_deeper;
}

/// True if two bodies that are not dynamic do not move against each other.
bool rest_together(const ObjectState& objects, const Columns& columns, uint32_t a, uint32_t b) {
    if (a == b) return true;
    const Mobility mobility = objects.bodies[a].mobility;
    if (mobility != objects.bodies[b].mobility) return false;
    if (mobility == Mobility::fixed) return true;
    if (mobility == Mobility::dynamic) return false;
    const BodyState &s = columns.states[a], &t = columns.states[b];
    return s.velocity.x == t.velocity.x && s.velocity.y == t.velocity.y &&
           s.angular_velocity == 0.0f && t.angular_velocity == 0.0f;
}

struct Sides {
    uint32_t resting, moving;  ///< shapes
    bool first;                ///< the resting one is shape a
};

Sides sides_of(const ObjectState& objects, const ContactRecord& c) {
    const bool first = objects.bodies[c.body_a].mobility != Mobility::dynamic;
    return {first ? c.shape_a : c.shape_b, first ? c.shape_b : c.shape_a, first};
}

bool may_be_covered(const ShapeForm& form) {
    return CoveredOutline::may_be(form.kind, int(form.count), form.radius);
}

/// More contacts of a body are not walked through; the shapes around are searched instead.
constexpr uint32_t many_contacts = 24;

/// Calls `visit` for each contact of `moving` with another shape that lies beside `resting`.
void for_each_beside(const NarrowPhaseInput& in, uint32_t slot, uint32_t resting, uint32_t moving,
                     auto&& visit) {
    const ObjectState& objects = in.objects;
    const ShapeForm& form = objects.forms[resting];
    const Box4 around = grow(in.boxes.boxes[resting], seam);
    const uint32_t owner = objects.shapes[resting].owner;
    const auto consider = [&](uint32_t contact) {
        const ContactRecord& c = objects.contacts[contact];
        if (contact == slot || (c.shape_a != moving && c.shape_b != moving)) return;
        const uint32_t shape = c.shape_a == moving ? c.shape_b : c.shape_a;
        if (!overlap(around, in.boxes.boxes[shape])) return;
        const ShapeForm& other = objects.forms[shape];
        if (c.sensor || c.skipped == Skipped::by_callback || c.skipped == Skipped::crushed) return;
        if (!may_be_covered(other) || !rest_together(objects, in.columns, form.body, other.body) ||
            (owner != none && objects.shapes[shape].owner == owner))
            return;
        visit(contact, shape);
    };
    const uint32_t body = objects.forms[moving].body;
    if (objects.bodies[body].lists.contact_count <= many_contacts) {
        objects.for_each_contact(body, consider);
        return;
    }
    const Tree& tree = objects.bodies[form.body].mobility == Mobility::fixed ? in.boxes.fixed_tree
                                                                             : in.boxes.moving_tree;
    const Box4& box = in.boxes.fat_boxes[moving];
    const Box4 both = {{max(around.low.x, box.low.x), max(around.low.y, box.low.y)},
                       {min(around.high.x, box.high.x), min(around.high.y, box.high.y)}};
    tree.query(both, [&](uint32_t shape) {
        const uint32_t contact = in.boxes.pairs.find(shape, moving);
        if (contact != PairSet::absent) consider(contact);
    });
}

}  // namespace

void push_with_common_outline(const NarrowPhaseInput& in, uint32_t slot, const OldPoints& before) {
    const ObjectState& objects = in.objects;
    ContactRecord& c = in.objects.contacts[slot];
    const auto [resting, moving, first] = sides_of(objects, c);
    const ShapeForm &form = objects.forms[resting], &other_form = objects.forms[moving];
    if (!may_be_covered(form) || c.skipped == Skipped::crushed ||
        (other_form.kind == FormKind::piece && other_form.count == 2))
        return;
    const Solid shape = solid_of(objects, in.columns, resting);
    CoveredOutline outline(shape);
    for_each_beside(in, slot, resting, moving, [&](uint32_t, uint32_t beside) {
        outline.add_neighbor(solid_of(objects, in.columns, beside),
                             objects.forms[beside].center - form.center);
    });
    if (!outline.has_neighbors()) return;

    const Solid other = solid_of(objects, in.columns, moving);
    const Vec2 to_other = other_form.center - form.center;
    const Vec2 normal = first ? c.manifold.normal : -c.manifold.normal;
    if (outline.is_bare_face(normal, other, to_other)) return;
    const Solid* const piece = outline.piece_for(other, to_other, normal);
    if (piece == nullptr) return;
    Manifold pushed = {};
    collide(*piece, other, to_other, speculative_margin, c.touching, pushed);
    // A segment has no inside: its face is the way out to the side of the other shape.
    if (shape.form.count > 2 && leads_through(pushed, c.manifold)) pushed.count = 0;
    // A shape that is deep inside of a covered one must get out somewhere.
    if (pushed.count == 0 && is_inside(shape.form, middle_of(other) + to_other)) return;
    if (!first) swap_shapes(pushed);
    c.manifold = pushed;
    before.give_impulses(c.manifold);
}

void drop_kept_beside(const NarrowPhaseInput& in, uint32_t slot) {
    const auto [resting, moving, first] = sides_of(in.objects, in.objects.contacts[slot]);
    if (!may_be_covered(in.objects.forms[resting])) return;
    for_each_beside(in, slot, resting, moving, [&](uint32_t contact, uint32_t) {
        ContactRecord& c = in.objects.contacts[contact];
        if (c.manifold.count == 2) c.kept = false;
    });
}

}  // namespace fettle::physics::detail
