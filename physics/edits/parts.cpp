#include <edits/edits.h>
#include <geometry/decomposition.h>

#include <algorithm>
#include <cstring>

// Outlines: chains and concave polygons. For the user an outline is one shape with one set of
// properties. For the rest of the library, each convex part is a shape with its own leaf in the
// tree, so the cost of a body on a chain does not depend on the length of the chain. The pool
// contains the vertices of a part and, behind them, two unit normals for each vertex: those of the
// edges of the whole outline before and after it, zero at a free end. collision/piece.h explains
// why.

namespace fettle::physics::detail {
namespace {

/// The parts of an outline in sequence: vertices, then limits.
struct Parts {
    std::vector<Vec2> values;
    std::vector<uint32_t> counts;  ///< number of vertices of each part
};

Vec2 normal_between(Vec2 from, Vec2 to) {
    return normalized(right_perp(to - from));
}

/// A point nearer than this (m) to the previous one is ignored.
constexpr float same_point = 1e-5f;

std::vector<Vec2> distinct(std::span<const Vec2> points, bool closed) {
    std::vector<Vec2> kept;
    kept.reserve(points.size());
    for (Vec2 p : points) {
        const float near = same_point + 1e-6f * max(std::fabs(p.x), std::fabs(p.y));
        if (kept.empty() || length(p - kept.back()) > near) kept.push_back(p);
    }
    while (closed && kept.size() > 1 && length(kept.back() - kept.front()) <= same_point)
        kept.pop_back();
    return kept;
}

/// A chain is solid on its left side. Each segment becomes a piece with the direction opposite to
/// the chain, so that its outward normal is the first.
Parts chain_parts(std::span<const Vec2> points, bool closed) {
    const std::vector<Vec2> p = distinct(points, closed);
    const size_t n = p.size();
    Parts parts;
    if (n < 2) return parts;
    closed = closed && n > 2;
    const size_t segments = closed ? n : n - 1;
    std::vector<Vec2> normals(segments);
    for (size_t i = 0; i < segments; ++i) normals[i] = normal_between(p[(i + 1) % n], p[i]);
    parts.values.reserve(6 * segments);
    parts.counts.assign(segments, 2);
    for (size_t i = 0; i < segments; ++i) {
        const Vec2 before = i > 0 ? normals[i - 1] : (closed ? normals.back() : Vec2{});
        const Vec2 after = i + 1 < segments ? normals[i + 1] : (closed ? normals.front() : Vec2{});
        for (Vec2 v : {p[(i + 1) % n], p[i], after, normals[i], normals[i], before})
            parts.values.push_back(v);
    }
    return parts;
}

/// Removes vertices on the line between their neighbors, so that a piece has one edge where the
/// outline has several collinear ones.
std::vector<uint32_t> without_flat(const std::vector<uint32_t>& piece, const std::vector<Vec2>& p) {
    std::vector<uint32_t> kept = piece;
    for (size_t i = 0; i < kept.size() && kept.size() > 3;) {
        const size_t n = kept.size();
        const Vec2 a = p[kept[(i + n - 1) % n]], b = p[kept[i]], c = p[kept[(i + 1) % n]];
        const Vec2 chord = c - a;
        if (std::fabs(cross(chord, b - a)) <= 1e-5f * length_squared(chord))
            kept.erase(kept.begin() + std::ptrdiff_t(i));
        else
            ++i;
    }
    return kept;
}

/// Limit for a part. Colliding with a part takes time for each of its vertices, and the tree finds
/// the parts.
constexpr size_t most_vertices = 16;

/// Divides the indices 0 … count of a convex piece into halves until each part has few vertices.
std::vector<std::vector<uint32_t>> in_parts(size_t count) {
    std::vector<std::vector<uint32_t>> parts(1);
    for (uint32_t i = 0; i < count; ++i) parts[0].push_back(i);
    for (size_t i = 0; i < parts.size();) {
        if (parts[i].size() <= most_vertices) {
            ++i;
            continue;
        }
        const auto middle = parts[i].begin() + std::ptrdiff_t(parts[i].size() / 2);
        std::vector<uint32_t> half(middle, parts[i].end());
        half.push_back(parts[i].front());
        parts[i].erase(middle + 1, parts[i].end());
        parts.push_back(std::move(half));
    }
    return parts;
}

/// Whether a piece follows the outline of n vertices from one vertex to another.
bool on_outline(const std::vector<uint32_t>& piece, uint32_t from, uint32_t to, uint32_t n) {
    auto at = size_t(std::find(piece.begin(), piece.end(), from) - piece.begin());
    for (uint32_t vertex = from; vertex != to;) {
        at = (at + 1) % piece.size();
        if (piece[at] != (vertex + 1) % n) return false;  // NOLINT: n is not 0
        vertex = piece[at];
    }
    return true;
}

Parts concave_parts(std::span<const Vec2> points) {
    std::vector<Vec2> p = distinct(points, true);
    Parts parts;
    if (p.size() < 3) return parts;
    if (signed_area(p) < 0.0) std::reverse(p.begin(), p.end());
    const auto n = uint32_t(p.size());
    std::vector<Vec2> normals(n);
    for (uint32_t i = 0; i < n; ++i) normals[i] = normal_between(p[i], p[(i + 1) % n]);
    for (const std::vector<uint32_t>& whole : convex_pieces(p)) {
        const std::vector<uint32_t> piece = without_flat(whole, p);
        for (const std::vector<uint32_t>& part : in_parts(piece.size())) {
            const size_t count = part.size(), begin = parts.values.size();
            parts.counts.push_back(uint32_t(count));
            for (uint32_t k : part) parts.values.push_back(p[piece[k]]);
            for (uint32_t k : part) {
                parts.values.push_back(normals[(piece[k] + n - 1) % n]);  // NOLINT: n is not 0
                parts.values.push_back(normals[piece[k]]);
            }
            // An edge belongs to the outline if its normal is equal bit for bit.
            Vec2* limits = &parts.values[begin + count];
            for (size_t i = 0; i < count; ++i) {
                const uint32_t here = part[i], there = part[(i + 1) % count];
                const uint32_t from = piece[here], to = piece[there];
                if (there != (here + 1) % piece.size() || !on_outline(whole, from, to, n)) continue;
                const Vec2 own = normal_between(p[from], p[to]);
                limits[2 * i + 1] = own;
                limits[2 * ((i + 1) % count)] = own;
            }
        }
    }
    return parts;
}

}  // namespace

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
    const Parts parts = chain ? chain_parts(objects.outline_of(shape), objects.shapes[shape].closed)
                              : concave_parts(objects.outline_of(shape));
    uint32_t last = none, part = objects.shapes[shape].first_part;
    const Vec2* values = parts.values.data();
    for (const uint32_t count : parts.counts) {
        if (part == none) {
            part = new_shape(e);
            --objects.shape_slots.count;  // parts are not counted
            objects.shapes[part].type = objects.shapes[shape].type;
            objects.shapes[part].surface = objects.shapes[shape].surface;
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
        last = part;
        part = objects.shapes[part].next_part;
    }
    drop_parts(e, shape, last);
    // The moments of the whole outline are exact and do not depend on the division into parts.
    ShapeRecord& record = objects.shapes[shape];
    if (chain) {
        record.set_moments(
            moments_of(objects.outline_of(shape).first(std::min(record.outline, 2u)), 0.0f));
    } else {
        std::vector<Vec2> points(objects.outline_of(shape).begin(),
                                 objects.outline_of(shape).end());
        if (signed_area(points) < 0.0) std::reverse(points.begin(), points.end());
        record.set_moments(moments_of(points, 0.0f));
    }
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

void share_surface(ObjectState& objects, uint32_t shape) {
    if (objects.is_solid(shape)) return;
    objects.for_each_solid(shape, [&](uint32_t part) {
        objects.shapes[part].surface = objects.shapes[shape].surface;
    });
}

}  // namespace fettle::physics::detail
