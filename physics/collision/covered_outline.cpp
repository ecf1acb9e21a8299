#include <collision/covered_outline.h>
#include <collision/ellipse.h>
#include <collision/outline_piece.h>

#include <cmath>

namespace fettle::physics::detail {
namespace {

struct Interval {
    float low = 0.0f, high = 0.0f;
    bool empty() const { return !(low < high); }
};

/// The extent of a shape along a unit vector.
Interval extent_of(const Solid& shape, Vec2 offset, Vec2 along) {
    const float at = dot(along, offset);
    if (shape.kind == FormKind::ellipse) {
        const EllipseForm e = ellipse_of(shape.form);
        const float middle = at + dot(along, e.center), reach = e.reach(along);
        return {middle - reach, middle + reach};
    }
    const Convex& form = shape.form;
    const Vec2 d = shape.kind == FormKind::large ? unrotate(shape.rotation, along) : along;
    return {at + dot(d, form.vertices[farthest_vertex(form, -d)]) - form.radius,
            at + dot(d, form.vertices[farthest_vertex(form, d)]) + form.radius};
}

/// The part of the line from + t · along that is inside a polygon.
Interval cut(const Convex& polygon, Vec2 from, Vec2 along, Interval part) {
    for (int i = 0; i < polygon.count; ++i) {
        const float gap = polygon.offsets[i] - dot(polygon.normals[i], from);
        const float slope = dot(polygon.normals[i], along);
        if (std::fabs(slope) < 1e-6f) {
            if (gap < 0.0f) return {};
        } else if (slope > 0.0f) {
            part.high = min(part.high, gap / slope);
        } else {
            part.low = max(part.low, gap / slope);
        }
    }
    return part;
}

/// Increases with the angle by which an outline turns from one edge to the next, counter-clockwise:
/// from -2 to 2 for half a turn to each side.
float turn_between(Vec2 before, Vec2 after) {
    const float c = cross(before, after);
    if (dot(before, after) >= 0.0f) return c;
    return c >= 0.0f ? 2.0f - c : -2.0f - c;
}

/// The edges of a shape that meet near a point: the normals before and after it, counter-clockwise.
bool find_turn(const Solid& shape, Vec2 point, float tolerance, Vec2& before, Vec2& after) {
    const Convex& form = shape.form;
    int vertex = -1;
    float least = tolerance * tolerance;
    for (int i = 0; i < form.count; ++i) {
        const float d = length_squared(form.vertices[i] - point);
        if (d > least) continue;
        least = d;
        vertex = i;
    }
    if (vertex >= 0) {
        const bool piece = shape.kind == FormKind::piece;
        before = piece ? rotate(shape.rotation, shape.limits[2 * vertex])
                       : form.normals[vertex > 0 ? vertex - 1 : form.count - 1];
        after = piece ? rotate(shape.rotation, shape.limits[2 * vertex + 1]) : form.normals[vertex];
        return true;
    }
    for (int i = 0; i < form.count && form.count > 2; ++i) {
        const Vec2 from = form.vertices[i];
        const Vec2 along = form.vertices[i + 1 < form.count ? i + 1 : 0] - from;
        const float t = dot(point - from, along);
        if (std::fabs(dot(form.normals[i], point) - form.offsets[i]) > tolerance || t < 0.0f ||
            t > length_squared(along))
            continue;
        before = after = form.normals[i];
        return true;
    }
    return false;
}

/// Steps, gaps and distances below this do not count beside an edge of that length.
float tolerance_of(float length) {
    return min(seam, 0.1f * length);
}

}  // namespace

Vec2 middle_of(const Solid& shape) {
    if (shape.kind == FormKind::ellipse) return shape.form.vertices[0];
    const Convex& form = shape.form;
    Vec2 sum;
    for (int i = 0; i < form.count; ++i) sum = sum + form.vertices[i];
    sum = (1.0f / float(form.count)) * sum;
    return shape.kind == FormKind::large ? rotate(shape.rotation, sum) : sum;
}

bool is_inside(const Convex& polygon, Vec2 point) {
    for (int i = 0; i < polygon.count; ++i)
        if (dot(polygon.normals[i], point) > polygon.offsets[i]) return false;
    return polygon.count > 2;
}

bool CoveredOutline::is_inner(int edge) const {
    return shape_.kind == FormKind::piece && OutlinePiece(shape_).is_inner(edge);
}

float CoveredOutline::length_of(int edge) const {
    return length(shape_.form.vertices[next(edge)] - shape_.form.vertices[edge]);
}

/// The length of the part of an edge between two places that no neighbor covers.
float CoveredOutline::bare_length(int edge, float low, float high) const {
    const Convex& form = shape_.form;
    const Vec2 n = form.normals[edge], along = {-n.y, n.x};
    const float tolerance = tolerance_of(length_of(edge));
    // The line is a little in front of the edge: shapes with a small gap between them cover each
    // other, and those whose faces are level do not cover these faces.
    const Vec2 from = form.vertices[edge] + (0.5f * tolerance) * n;
    std::array<Interval, most_neighbors> covered;
    int parts = 0;
    for (int k = 0; k < count_; ++k) {
        const Neighbor& other = neighbors_[size_t(k)];
        const Interval part =
            cut(other.solid.form, from - other.offset, along, {low - tolerance, high + tolerance});
        if (part.empty()) continue;
        int at = parts++;
        for (; at > 0 && covered[size_t(at - 1)].low > part.low; --at)
            covered[size_t(at)] = covered[size_t(at - 1)];
        covered[size_t(at)] = part;
    }
    float bare = 0.0f, reached = low;
    for (int k = 0; k < parts; ++k) {
        if (covered[size_t(k)].low > reached) bare += min(covered[size_t(k)].low, high) - reached;
        reached = max(reached, covered[size_t(k)].high);
        if (reached >= high) return bare;
    }
    return bare + (high - reached);
}

/// True if a part of an edge of the outline that is beside `other` is not covered.
bool CoveredOutline::is_bare(int edge, const Solid& other, Vec2 to_other) const {
    if (is_inner(edge)) return false;
    const Vec2 n = shape_.form.normals[edge], along = {-n.y, n.x};
    const float start = dot(along, shape_.form.vertices[edge]), whole = length_of(edge);
    const Interval extent = extent_of(other, to_other, along);
    const float least = min(4.0f * tolerance_of(whole), whole);
    float low = clamp(extent.low - start, 0.0f, whole);
    float high = clamp(extent.high - start, 0.0f, whole);
    if (high - low < least) {
        low = clamp(0.5f * (low + high - least), 0.0f, whole - least);
        high = low + least;
    }
    return bare_length(edge, low, high) > tolerance_of(whole);
}

/// True if an edge is not covered at its beginning or its end.
bool CoveredOutline::is_bare_at(int edge, bool end) const {
    const float whole = length_of(edge), part = min(2.0f * tolerance_of(whole), whole);
    return end ? bare_length(edge, whole - part, whole) > 0.5f * part
               : bare_length(edge, 0.0f, part) > 0.5f * part;
}

bool CoveredOutline::is_bare_face(Vec2 normal, const Solid& other, Vec2 to_other) const {
    const Convex& form = shape_.form;
    for (int i = 0; i < form.count; ++i)
        if (dot(form.normals[i], normal) > 1.0f - 1e-6f)
            return form.count == 2 || is_bare(i, other, to_other);
    return false;
}

CoveredOutline::Turn CoveredOutline::own_turn(int vertex) const {
    if (shape_.kind == FormKind::piece)
        return {rotate(shape_.rotation, shape_.limits[2 * vertex]),
                rotate(shape_.rotation, shape_.limits[2 * vertex + 1])};
    return {shape_.form.normals[previous(vertex)], shape_.form.normals[vertex]};
}

/// The outline at a vertex. A piece has an edge on the outline if the normal after its first vertex
/// is its own.
CoveredOutline::Turn CoveredOutline::turn_at(int vertex, bool bare_before, bool bare_after) const {
    const Vec2 own = shape_.form.normals[vertex], last = shape_.form.normals[previous(vertex)];
    const Vec2 none_there = {-own.y, own.x};
    if (!bare_before && !bare_after) return {own, none_there};
    const auto flat = [&](Vec2 n) {
        const Vec2 other = n.x == own.x && n.y == own.y ? none_there : n;
        return Turn{n, bare_after ? n : other};
    };
    if (bare_after && !is_bare_at(vertex, false)) return flat(own);
    if (bare_before && !is_bare_at(previous(vertex), true)) return flat(bare_after ? own : last);

    // Of all edges that meet here, the outline goes on at the one that is first reached through the
    // free space in front of the bare edge.
    Turn turn = own_turn(vertex);
    if (bare_after) turn.after = own;
    if (bare_before) turn.before = last;
    bool found = false;
    float least_before = turn_between(turn.before, own),
          least_after = turn_between(last, turn.after);
    Vec2 first = turn.before, second = turn.after;
    const float tolerance = tolerance_of(min(length_of(vertex), length_of(previous(vertex))));
    for (int k = 0; k < count_; ++k) {
        const Neighbor& other = neighbors_[size_t(k)];
        Vec2 before, after;
        if (!find_turn(other.solid, shape_.form.vertices[vertex] - other.offset, tolerance, before,
                       after))
            continue;
        found = true;
        const float turn_before = turn_between(before, own), turn_after = turn_between(last, after);
        if (turn_before < least_before) least_before = turn_before, first = before;
        if (turn_after < least_after) least_after = turn_after, second = after;
    }
    const float flat_turn = OutlinePiece::flat_angle;
    if (bare_before && bare_after) {
        const bool level = found && (least_before <= flat_turn || least_after <= flat_turn);
        return level ? flat(own) : turn;
    }
    if (bare_after) return {first, own};
    if (!found || (second.x == own.x && second.y == own.y)) return flat(last);
    return {last, second};
}

const Solid* CoveredOutline::polygon_for(const Solid& other, Vec2 to_other) {
    const Convex& form = shape_.form;
    if (form.count > most_vertices) return nullptr;
    std::array<bool, most_vertices> bare;
    for (int i = 0; i < form.count; ++i) bare[size_t(i)] = is_bare(i, other, to_other);
    bool changed = false;
    for (int i = 0; i < form.count; ++i) {
        const Turn turn = turn_at(i, bare[size_t(previous(i))], bare[size_t(i)]);
        const Turn own = own_turn(i);
        changed = changed || turn.before.x != own.before.x || turn.before.y != own.before.y ||
                  turn.after.x != own.after.x || turn.after.y != own.after.y;
        limits_[2 * size_t(i)] = turn.before;
        limits_[2 * size_t(i) + 1] = turn.after;
    }
    if (!changed) return nullptr;
    piece_ = {form, FormKind::piece, {}, limits_.data(), form.normals};
    return &piece_;
}

const Solid* CoveredOutline::segment_for(const Solid& other, Vec2 to_other, Vec2 normal) {
    const Convex& form = shape_.form;
    float side = dot(form.normals[0], normal);
    if (std::fabs(side) < 0.7f)
        side = dot(form.normals[0], middle_of(other) + to_other) - form.offsets[0];
    const int first = side >= 0.0f ? 0 : 1;
    const Vec2 n = form.normals[first];
    vertices_ = {form.vertices[first], form.vertices[1 - first]};
    normals_ = {n, -n};
    offsets_ = {form.offsets[first], -form.offsets[first]};
    limits_[0] = limits_[3] = {};
    limits_[1] = limits_[2] = n;
    const float tolerance = tolerance_of(length_of(0));
    bool found = false;
    float least[2] = {3.0f, 3.0f};
    for (int k = 0; k < count_; ++k) {
        const Neighbor& next = neighbors_[size_t(k)];
        for (size_t end = 0; end < 2; ++end) {
            Vec2 before, after;
            if (!find_turn(next.solid, vertices_[end] - next.offset, tolerance, before, after))
                continue;
            found = true;
            const float turn = end == 0 ? turn_between(before, n) : turn_between(n, after);
            if (turn >= least[end]) continue;
            least[end] = turn;
            limits_[3 * end] = end == 0 ? before : after;
        }
    }
    if (!found) return nullptr;
    piece_ = {{vertices_.data(), normals_.data(), offsets_.data(), 2, 0.0f},
              FormKind::piece,
              {},
              limits_.data(),
              normals_.data()};
    return &piece_;
}

const Solid* CoveredOutline::piece_for(const Solid& other, Vec2 to_other, Vec2 normal) {
    if (!has_neighbors()) return nullptr;
    return shape_.form.count == 2 ? segment_for(other, to_other, normal)
                                  : polygon_for(other, to_other);
}

}  // namespace fettle::physics::detail
