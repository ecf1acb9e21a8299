#include <forms/outline_parts.h>
#include <geometry/decomposition.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

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

/// Maximum number of vertices of a part. Colliding with a part takes time for each of its vertices,
/// while the tree of boxes skips the parts that are far away.
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

/// The part of a straight edge of a piece that is on the outline.
struct OnOutline {
    bool any = false;     ///< some of it is; the rest are diagonals on the same line
    bool at_end = false;  ///< the part before its second end is
};

/// `piece` has all of its vertices, also those on its straight edges; the outline has n vertices.
OnOutline on_outline(const std::vector<uint32_t>& piece, uint32_t from, uint32_t to, uint32_t n) {
    auto at = size_t(std::find(piece.begin(), piece.end(), from) - piece.begin());
    OnOutline found;
    for (uint32_t vertex = from; vertex != to;) {
        at = (at + 1) % piece.size();
        found.at_end = piece[at] == (vertex + 1) % n;  // NOLINT: n is not 0
        found.any |= found.at_end;
        vertex = piece[at];
    }
    return found;
}

}  // namespace

/// A chain is solid on its left side. Each segment becomes a piece with the direction opposite to
/// the chain, so that its outward normal is the first.
OutlineParts chain_parts(std::span<const Vec2> points, bool closed) {
    const std::vector<Vec2> p = distinct(points, closed);
    const size_t n = p.size();
    OutlineParts parts;
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

OutlineParts concave_parts(std::span<const Vec2> points) {
    std::vector<Vec2> p = distinct(points, true);
    OutlineParts parts;
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
            // An edge belongs to the outline if its normal is equal bit for bit. A straight edge
            // that is on the outline here and a diagonal there belongs to it as a whole: the
            // diagonal is inside the polygon, where only a shape that already overlaps the polygon
            // meets it.
            Vec2* limits = &parts.values[begin + count];
            for (size_t i = 0; i < count; ++i) {
                const uint32_t here = part[i], there = part[(i + 1) % count];
                const uint32_t from = piece[here], to = piece[there];
                if (there != (here + 1) % piece.size()) continue;
                const OnOutline outer = on_outline(whole, from, to, n);
                if (!outer.any) continue;
                const Vec2 own = normal_between(p[from], p[to]);
                limits[2 * i + 1] = own;
                if (outer.at_end) limits[2 * ((i + 1) % count)] = own;
            }
        }
    }
    return parts;
}

AreaMoments chain_moments(std::span<const Vec2> points) {
    return moments_of(points.first(std::min(points.size(), size_t{2})), 0.0f);
}

AreaMoments concave_moments(std::span<const Vec2> outline) {
    std::vector<Vec2> points(outline.begin(), outline.end());
    if (signed_area(points) < 0.0) std::reverse(points.begin(), points.end());
    return moments_of(points, 0.0f);
}

}  // namespace fettle::physics::detail
