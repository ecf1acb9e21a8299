#include <edits/edits.h>
#include <forms/outline_parts.h>
#include <state/segment_surfaces.h>

#include <cstring>

// Outlines: chains and concave polygons. For the user an outline is one shape with one set of
// properties. For the rest of the library, each convex part is a shape with its own leaf in the
// tree, so the cost of a body on a chain does not depend on the length of the chain. The pool
// contains the vertices of a part and, behind them, two unit normals for each vertex: those of the
// edges of the whole outline before and after it, zero at a free end: see
// collision/outline_piece.h.

namespace fettle::physics::detail {

void write_outline(ObjectState& objects, ActiveLists& active, uint32_t shape,
                   std::span<const Vec2> points) {
    reserve_vertices(objects, shape, uint32_t(points.size()));
    objects.shapes[shape].outline = uint32_t(points.size());
    for (size_t i = 0; i < points.size(); ++i)
        objects.pool.local[objects.forms[shape].begin + i] = points[i];
    mark_geometry(objects, active, shape);
}

void rebuild_parts(const Editing& e, uint32_t shape) {
    ObjectState& objects = e.objects;
    const bool chain = objects.shapes[shape].type == ShapeType::chain;
    const OutlineParts parts =
        chain ? chain_parts(objects.outline_of(shape), objects.shapes[shape].closed)
              : concave_parts(objects.outline_of(shape));
    uint32_t last = none, part = objects.shapes[shape].first_part;
    const Vec2* values = parts.values.data();
    uint32_t number = 0;
    for (const uint32_t count : parts.counts) {
        if (part == none) {
            part = new_shape(e);
            --objects.shape_slots.count;  // parts are not counted
            objects.shapes[part].type = objects.shapes[shape].type;
            const SegmentSurface* own = own_surface(objects, shape, number);
            objects.shapes[part].surface = own != nullptr
                                               ? with_own(objects.shapes[shape].surface, *own)
                                               : objects.shapes[shape].surface;
            objects.shapes[part].figure.become(PartFigure{number});
            objects.shapes[part].owner = shape;
            objects.forms[part].kind = FormKind::piece;
            (last == none ? objects.shapes[shape].first_part : objects.shapes[last].next_part) =
                part;
            if (objects.forms[shape].body != none) attach_shape(e, part, objects.forms[shape].body);
        }
        const size_t size = 3 * size_t{count} * sizeof(Vec2);
        // A part that the edit did not change keeps its contacts.
        if (objects.forms[part].count != count ||
            std::memcmp(&objects.pool.local[objects.forms[part].begin], values, size) != 0) {
            reserve_vertices(objects, part, 3 * count);
            objects.forms[part].count = count;
            std::memcpy(&objects.pool.local[objects.forms[part].begin], values, size);
            mark_geometry(objects, e.active, part);
        }
        values += 3 * count;
        ++number;
        last = part;
        part = objects.shapes[part].next_part;
    }
    drop_parts(e, shape, last);
    // The moments of the whole outline are exact and do not depend on the division into parts.
    ShapeRecord& record = objects.shapes[shape];
    record.set_moments(chain ? chain_moments(objects.outline_of(shape))
                             : concave_moments(objects.outline_of(shape)));
}

void drop_parts(const Editing& e, uint32_t shape, uint32_t last) {
    ObjectState& objects = e.objects;
    uint32_t part =
        last == none ? objects.shapes[shape].first_part : objects.shapes[last].next_part;
    (last == none ? objects.shapes[shape].first_part : objects.shapes[last].next_part) = none;
    if (part == none) return;
    if (const uint32_t body = objects.forms[shape].body; body != none) {
        // All contacts of all parts are handled in one walk over the list, because both may be
        // many.
        wake_for_edit(e.activity, body);
        wake_touching(e.activity, body);
        std::vector<bool> dropped(objects.shapes.size());
        for (uint32_t each = part; each != none; each = objects.shapes[each].next_part)
            dropped[each] = true;
        objects.for_each_contact(body, [&](uint32_t contact) {
            const ContactRecord& c = objects.contacts[contact];
            if (dropped[c.shape_a] || dropped[c.shape_b]) destroy_contact(e.contacts, contact);
        });
        for (uint32_t each = part; each != none; each = objects.shapes[each].next_part)
            unlink_shape(objects, e.broad_phase, each);
        mark_mass(objects, e.active, body);
        mark_placement(objects, e.active, body);
    }
    while (part != none) {
        const uint32_t next = objects.shapes[part].next_part;
        destroy_shape(e, part);
        part = next;
    }
}

void copy_surface_to_parts(ObjectState& objects, uint32_t shape) {
    if (objects.is_solid(shape)) return;
    const ShapeDef& surface = objects.shapes[shape].surface;
    objects.for_each_solid(shape, [&](uint32_t part) { objects.shapes[part].surface = surface; });
    std::span<const SegmentRecord> own = segment_surfaces_of(objects, shape);
    if (own.empty()) return;
    objects.for_each_solid(shape, [&](uint32_t part) {
        if (own.empty() || own.front().segment != objects.part_number(part)) return;
        objects.shapes[part].surface = with_own(surface, own.front().surface);
        own = own.subspan(1);
    });
}

}  // namespace fettle::physics::detail
