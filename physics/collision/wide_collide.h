// `collide` for sixteen pairs of triangles and quadrilaterals with exactly the same operations. It
// is compiled for the instruction set of the including file: see simd/vector.h.
#pragma once

#include <collision/batch.h>
#include <simd/vector.h>

namespace fettle::physics::detail {
namespace {

struct WidePolygon {
    Wide vx[4], vy[4], nx[4], ny[4], offset[4];
};

WidePolygon load_polygon(const ConvexArrays& from, const uint32_t* begin) {
    WidePolygon p;
    const auto pair = [&](const Vec2* at, int first, Wide* x, Wide* y) {
        const Columns4 c = gather4([=](int lane) { return at + begin[lane] + first; });
        x[first] = c.a, y[first] = c.b, x[first + 1] = c.c, y[first + 1] = c.d;
    };
    pair(from.vertices, 0, p.vx, p.vy), pair(from.vertices, 2, p.vx, p.vy);
    pair(from.normals, 0, p.nx, p.ny), pair(from.normals, 2, p.nx, p.ny);
    const Columns4 c = gather4([&](int lane) { return from.offsets + begin[lane]; });
    p.offset[0] = c.a, p.offset[1] = c.b, p.offset[2] = c.c, p.offset[3] = c.d;
    return p;
}

/// The edge with the greatest separation from the other shape.
struct WideEdge {
    Wide separation = splat(-1e30f);
    Wide nx = {}, ny = {}, plane = {};
    Wide x1 = {}, y1 = {}, x2 = {}, y2 = {};  ///< its ends
    WideInt index = {};
};

inline WideEdge pick(WideInt first, const WideEdge& u, const WideEdge& v) {
    return {first ? u.separation : v.separation,
            first ? u.nx : v.nx,
            first ? u.ny : v.ny,
            first ? u.plane : v.plane,
            first ? u.x1 : v.x1,
            first ? u.y1 : v.y1,
            first ? u.x2 : v.x2,
            first ? u.y2 : v.y2,
            first ? u.index : v.index};
}

inline WideEdge deepest_edge(const WidePolygon& a, const WidePolygon& b, Wide x, Wide y) {
    WideEdge best;
    for (int i = 0; i < 4; ++i) {
        const Wide nx = a.nx[i], ny = a.ny[i];
        const auto along = [&](int k) { return nx * b.vx[k] + ny * b.vy[k]; };
        const Wide nearest = lesser(lesser(along(0), along(1)), lesser(along(2), along(3)));
        const Wide separation = nearest + (nx * x + ny * y) - a.offset[i];
        const int next = (i + 1) & 3;
        const WideEdge edge = {separation, nx,         ny,         a.offset[i], a.vx[i],
                               a.vy[i],    a.vx[next], a.vy[next], splat_int(i)};
        best = pick(separation > best.separation, edge, best);
    }
    return best;
}

/// The edge of `other` whose normal is most opposed to that of the reference: its ends and their
/// indices.
struct WideIncident {
    /// The second vertex, then the first: opposite to the direction of the reference edge.
    Wide x1, y1, x2, y2;
    WideInt index;
};

inline WideIncident incident_edge(const WideEdge& reference, const WidePolygon& u,
                                  const WidePolygon& v, WideInt first, Wide to_x, Wide to_y) {
    WideIncident best = {};
    Wide least = {};
    for (int i = 0; i < 4; ++i) {
        const int next = (i + 1) & 3;
        const Wide d =
            reference.nx * (first ? u.nx[i] : v.nx[i]) + reference.ny * (first ? u.ny[i] : v.ny[i]);
        const WideInt lower = i == 0 ? ~WideInt{} : d < least;
        least = lower ? d : least;
        best.x1 = lower ? (first ? u.vx[next] : v.vx[next]) : best.x1;
        best.y1 = lower ? (first ? u.vy[next] : v.vy[next]) : best.y1;
        best.x2 = lower ? (first ? u.vx[i] : v.vx[i]) : best.x2;
        best.y2 = lower ? (first ? u.vy[i] : v.vy[i]) : best.y2;
        best.index = lower ? splat_int(i) : best.index;
    }
    best.x1 += to_x, best.y1 += to_y, best.x2 += to_x, best.y2 += to_y;
    return best;
}

/// Lanes in which the nearest points of two edges are ends of both and not level.
inline WideInt meet_at_corners(const WideEdge& r, const WideIncident& i) {
    const Wide zero = {}, one = splat(1.0f);
    const Wide d1x = r.x2 - r.x1, d1y = r.y2 - r.y1;
    const Wide d2x = i.x1 - i.x2, d2y = i.y1 - i.y2;
    const Wide rx = r.x1 - i.x2, ry = r.y1 - i.y2;
    const Wide a = d1x * d1x + d1y * d1y, e = d2x * d2x + d2y * d2y, f = d2x * rx + d2y * ry;
    const Wide c = d1x * rx + d1y * ry, b = d1x * d2x + d1y * d2y;
    const Wide denominator = a * e - b * b;
    Wide s = denominator > splat(1e-12f) * a * e ? limit((b * f - c * e) / denominator, zero, one)
                                                 : zero;
    Wide t = e > zero ? (b * s + f) / e : zero;
    const WideInt before = t<zero, behind = t> one;
    s = before ? (a > zero ? limit(-c / a, zero, one) : zero) : s;
    s = behind ? (a > zero ? limit((b - c) / a, zero, one) : zero) : s;
    t = before ? zero : (behind ? one : t);
    const WideInt ends = ((s == zero) | (s == one)) & ((t == zero) | (t == one));
    const Wide dx = (t == zero ? i.x2 : i.x1) - (s == zero ? r.x1 : r.x2);
    const Wide dy = (t == zero ? i.y2 : i.y1) - (s == zero ? r.y1 : r.y2);
    const Wide level = dx * -r.ny + dy * r.nx;
    const Wide length = root(dx * dx + dy * dy);
    return ends & ((level < zero ? -level : level) > splat(1e-3f) * length);
}

/// Lanes in which vertices of both shapes are nearest to each other.
struct WideCorners {
    WideInt all = {};
    WideInt touching = {};  ///< `collide` makes their manifolds; the others may pass each other
};

inline WideCorners find_corners(const WideEdge& r, const WideIncident& i, WideInt apart,
                                Wide radii) {
    if (!any(apart)) return {};
    const WideInt corners = apart & meet_at_corners(r, i);
    const Wide r_x = r.x2 - r.x1, r_y = r.y2 - r.y1, i_x = i.x2 - i.x1, i_y = i.y2 - i.y1;
    const Wide shorter = lesser(r_x * r_x + r_y * r_y, i_x * i_x + i_y * i_y);
    constexpr float thin = 20.0f * seam;
    const WideInt passing = (radii == Wide{}) & (shorter > splat(thin * thin));
    return {corners, corners & ~passing};
}

/// The incident edge, clipped against the ends of the reference edge.
struct WideClip {
    Wide x[2], y[2];
    WideInt meets;  ///< lanes in which the edges are opposite to each other by more than a seam
};

inline WideClip clip_edge(const WideEdge& reference, const WideIncident& incident, Wide radii) {
    const Wide nx = reference.nx, ny = reference.ny;
    const Wide along_x = incident.x2 - incident.x1, along_y = incident.y2 - incident.y1;
    const Wide low = -ny * reference.x1 + nx * reference.y1;
    const Wide high = -ny * reference.x2 + nx * reference.y2;
    const Wide w1 = -ny * incident.x1 + nx * incident.y1;
    const Wide w2 = -ny * incident.x2 + nx * incident.y2;
    const Wide run = w2 - w1;
    const Wide facing = lesser(high, w2) - greater(low, w1);
    const WideInt inside = ((w1 >= low) & (w2 <= high)) | ((low >= w1) & (high <= w2));
    const Wide least = lesser(splat(seam), splat(0.1f) * lesser(high - low, run));
    const WideInt left = w2 < low, right = (w1 > high) & ~left, beside = left | right;
    const WideInt long_enough = run > splat(1e-9f);
    const WideInt cut1 = (w1 < low) & long_enough & ~beside;
    const WideInt cut2 = (w2 > high) & long_enough & ~beside;
    const Wide t1 = (low - w1) / run, t2 = (high - w1) / run;
    return {{left ? incident.x2 : (cut1 ? incident.x1 + t1 * along_x : incident.x1),
             right ? incident.x1 : (cut2 ? incident.x1 + t2 * along_x : incident.x2)},
            {left ? incident.y2 : (cut1 ? incident.y1 + t1 * along_y : incident.y1),
             right ? incident.y1 : (cut2 ? incident.y1 + t2 * along_y : incident.y2)},
            inside | ~(facing < least) | (radii != Wide{})};
}

struct WideCandidate {
    Wide separation, x, y;  ///< midway between the surfaces
    WideInt valid, feature;
};

inline WideInt next_of(WideInt index, WideInt count) {
    return index + 1 == count ? WideInt{} : index + 1;
}

/// The old points: their impulses are kept if the vertices are the same.
struct OldPoints {
    Columns4 point[2];
    WideInt count;

    Wide impulse(WideInt feature, Wide Columns4::*kind) const {
        Wide impulse = {};
        for (int k = 1; k >= 0; --k) {
            const WideInt same = (as_int(point[k].d) == feature) & (count > k);
            impulse = same ? point[k].*kind : impulse;
        }
        return impulse;
    }
};

/// Writes the candidates that are valid as the points of the manifolds; points with the same
/// vertices as before keep their impulses. `manifold(lane)` returns the address of a manifold.
template <typename At>
void write_manifolds(At&& manifold, Wide nx, Wide ny, const WideCandidate (&c)[2], WideInt flipped,
                     Wide offset_x, Wide offset_y) {
    const auto part = [&](size_t at) {
        return [=](int lane) { return reinterpret_cast<char*>(manifold(lane)) + at; };
    };
    constexpr size_t points = offsetof(Manifold, points), second = points + sizeof(ManifoldPoint);
    OldPoints old;
    old.count = as_int(gather4(part(0)).c);
    old.point[0] = gather4(part(points + 16));
    old.point[1] = gather4(part(second + 16));
    const WideInt count = (c[0].valid & 1) + (c[1].valid & 1);
    scatter4({nx, ny, as_float(count), Wide{}}, part(0));
    for (int k = 0; k < 2; ++k) {
        // If only the second point remains, it becomes the first.
        const WideInt other = k == 0 ? ~c[0].valid : WideInt{} - 1;
        const Wide x = other ? c[1].x : c[0].x, y = other ? c[1].y : c[0].y;
        const WideInt feature = other ? c[1].feature : c[0].feature;
        const size_t at = k == 0 ? points : second;
        scatter4({flipped ? x + offset_x : x, flipped ? y + offset_y : y,
                  flipped ? x : x - offset_x, flipped ? y : y - offset_y},
                 part(at));
        scatter4({other ? c[1].separation : c[0].separation, old.impulse(feature, &Columns4::b),
                  old.impulse(feature, &Columns4::c), as_float(feature)},
                 part(at + 16));
    }
}

/// Collides the lanes from `at` on. Returns the lanes that `collide` must process, one bit each;
/// their manifolds are unchanged.
uint32_t collide_lanes(const ConvexArrays& arrays, const CollisionBatch& batch, int at) {
    const WidePolygon a = load_polygon(arrays, batch.begin_a + at);
    const WidePolygon b = load_polygon(arrays, batch.begin_b + at);
    const Wide offset_x = load(batch.offset_x + at), offset_y = load(batch.offset_y + at);
    const Wide radius_a = load(batch.radius_a + at), radius_b = load(batch.radius_b + at);
    const Wide margin = load(batch.margin + at);
    const Wide radii = radius_a + radius_b;
    const WideEdge on_a = deepest_edge(a, b, offset_x, offset_y);
    const WideEdge on_b = deepest_edge(b, a, -offset_x, -offset_y);
    const WideInt near = ~((on_a.separation > radii + margin) | (on_b.separation > radii + margin));
    Manifold unused;
    if (!any(near)) {
        for (int lane = 0; lane < width; ++lane) batch.manifolds[at + lane]->count = 0;
        return 0;
    }
    const WideInt flipped = on_b.separation > on_a.separation + splat(face_preference);
    const WideEdge reference = pick(flipped, on_b, on_a);
    const Wide to_x = flipped ? -offset_x : offset_x, to_y = flipped ? -offset_y : offset_y;
    const WideIncident incident = incident_edge(reference, a, b, flipped, to_x, to_y);
    const Wide nx = reference.nx, ny = reference.ny;
    const WideInt apart = near & (reference.separation > splat(face_preference));
    const WideCorners corners = find_corners(reference, incident, apart, radii);
    const WideClip clipped = clip_edge(reference, incident, radii);
    const WideInt keep = near & ~corners.all & clipped.meets;

    const WideInt count_a = load_int(batch.count_a + at), count_b = load_int(batch.count_b + at);
    const WideInt edge2 = next_of(reference.index, flipped ? count_b : count_a);
    const WideInt incident2 = next_of(incident.index, flipped ? count_a : count_b);
    const WideInt on_reference[2] = {reference.index, edge2};
    const WideInt on_other[2] = {incident2, incident.index};
    const Wide radius = flipped ? radius_b - radius_a : radius_a - radius_b;
    WideCandidate candidates[2];
    for (int k = 0; k < 2; ++k) {
        const Wide x = clipped.x[k], y = clipped.y[k];
        const Wide gap = nx * x + ny * y - reference.plane;
        const Wide to_middle = splat(0.5f) * (radius - gap);
        candidates[k] = {
            gap - radii, x + to_middle * nx, y + to_middle * ny, keep & ~(gap - radii > margin),
            flipped ? on_other[k] << 8 | on_reference[k] : on_reference[k] << 8 | on_other[k]};
    }
    const uint32_t again = bits(corners.touching);
    const auto manifold = [&](int lane) {
        return (again >> lane & 1) != 0 ? &unused : batch.manifolds[at + lane];
    };
    write_manifolds(manifold, flipped ? -nx : nx, flipped ? -ny : ny, candidates, flipped, offset_x,
                    offset_y);
    return again;
}

uint32_t collide_batch(const ConvexArrays& arrays, const CollisionBatch& batch) {
    uint32_t again = 0;
    for (int at = 0; at < batch.count; at += width) again |= collide_lanes(arrays, batch, at) << at;
    return again;
}

}  // namespace
}  // namespace fettle::physics::detail
