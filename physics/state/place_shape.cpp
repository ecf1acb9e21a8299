#include <collision/ellipse.h>
#include <collision/large_polygon.h>
#include <state/limits.h>
#include <state/place_shape.h>

#include <cstring>

namespace fettle::physics::detail {
namespace {

/// In the pool, the vertices of a large polygon are relative to the body's center of mass but not
/// rotated. Only an edit changes them; a step computes just a bounding box. Not inlined, because
/// that would take registers from the loop over the vertices of all other shapes.
[[gnu::noinline]] Box4 place_large(ObjectState& objects, uint32_t shape, Vec2 local_center,
                                   Rotation q) {
    const ShapeForm& form = objects.forms[shape];
    VertexPool& pool = objects.pool;
    const Vec2 first = pool.local[form.begin] - local_center;
    if (pool.vertices[form.begin].x != first.x || pool.vertices[form.begin].y != first.y) {
        for (uint32_t i = form.begin; i < form.begin + form.count; ++i) {
            pool.vertices[i] = pool.local[i] - local_center;
            pool.directions[i] = pool.normals[i];
            pool.offsets[i] = dot(pool.normals[i], pool.vertices[i]);
        }
    }
    const Convex polygon = objects.convex(shape);
    const auto reach = [&](Vec2 direction) {
        const Vec2 d = unrotate(q, direction);
        return dot(d, polygon.vertices[farthest_vertex(polygon, d)]);
    };
    return {{-reach({-1.0f, 0.0f}), -reach({0.0f, -1.0f})},
            {reach({1.0f, 0.0f}), reach({0.0f, 1.0f})}};
}

/// Two vectors: one operation computes with both.
using V2Pair = float __attribute__((vector_size(4 * sizeof(float))));

V2Pair pair_of(const Vec2& first, const Vec2& second) {
    const V2Pair v = {first.x, first.y, second.x, second.y};
    return v;
}
V2Pair load_pair(const Vec2* from) {
    V2Pair v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
void store_pair(Vec2* to, V2Pair v) {
    to[0] = {v[0], v[1]};
    to[1] = {v[2], v[3]};
}
/// The operations of `rotate`.
V2Pair rotated(V2Pair v, V2Pair cosine, V2Pair sine) {
    return v * cosine + __builtin_shufflevector(v, v, 1, 0, 3, 2) * sine;
}

/// Rotates the vertices and normals of a shape with three or more vertices; returns the box of the
/// vertices. After an odd number of vertices the first one is repeated, which code that processes
/// four at a time needs for triangles; the block has room for an even number.
Box4 rotate_vertices(VertexPool& pool, const ShapeForm& form, Vec2 local_center, Rotation q) {
    const Vec2* const local = &pool.local[form.begin];
    const Vec2* const normals = &pool.normals[form.begin];
    Vec2* const vertices = &pool.vertices[form.begin];
    Vec2* const directions = &pool.directions[form.begin];
    const V2Pair center = pair_of(local_center, local_center);
    const V2Pair cosine = {q.c, q.c, q.c, q.c}, sine = {-q.s, q.s, -q.s, q.s};
    const uint32_t count = form.count;
    V2Pair low, high;
    for (uint32_t i = 0; i < count; i += 2) {
        const bool last = i + 1 == count;
        const V2Pair at = last ? pair_of(local[i], local[0]) : load_pair(local + i);
        const V2Pair along = last ? pair_of(normals[i], normals[0]) : load_pair(normals + i);
        const V2Pair v = rotated(at - center, cosine, sine);
        const V2Pair d = rotated(along, cosine, sine);
        store_pair(vertices + i, v);
        store_pair(directions + i, d);
        low = i == 0 ? v : (low < v ? low : v);
        high = i == 0 ? v : (high > v ? high : v);
    }
    return {{min(low[0], low[2]), min(low[1], low[3])},
            {max(high[0], high[2]), max(high[1], high[3])}};
}

}  // namespace

void place_shape(ObjectState& objects, std::span<Box4> boxes, uint32_t shape, Rotation q,
                 float angle) {
    const ShapeForm& form = objects.forms[shape];
    VertexPool& pool = objects.pool;
    const Vec2 local_center = form.body != none ? objects.bodies[form.body].local_center : Vec2{};
    for (uint32_t i = form.begin; i < form.begin + form.count; ++i)
        pool.offsets[i] = dot(pool.normals[i], pool.local[i] - local_center);
    move_shape(objects, boxes, shape, q, angle);
    objects.forms[shape].turn = 0.0f;  // an edit is no rotation of a step
    if (form.count == 3) pool.pad_triangle(form.begin);
}

void move_shape(ObjectState& objects, std::span<Box4> boxes, uint32_t shape, Rotation q,
                float angle) {
    ShapeForm& form = objects.forms[shape];
    VertexPool& pool = objects.pool;
    if (form.count == 0) return;
    form.turn = angle - form.angle;
    form.angle = angle;
    Position center;
    Vec2 local_center;
    if (form.body != none) {
        center = objects.bodies[form.body].center;
        local_center = objects.bodies[form.body].local_center;
    }
    if (form.kind == FormKind::large) {
        const Box4 box = place_large(objects, shape, local_center, q);
        form.center = center;
        boxes[shape] = grow(box_around(center, box), form.radius);
        return;
    }
    Box4 box;
    if (form.count > 2) {
        box = rotate_vertices(pool, form, local_center, q);
    } else {
        for (uint32_t i = form.begin; i < form.begin + form.count; ++i) {
            const Vec2 v = rotate(q, pool.local[i] - local_center);
            pool.vertices[i] = v;
            pool.directions[i] = rotate(q, pool.normals[i]);
            box = i == form.begin ? Box4{v, v} : unite(box, {v, v});
        }
    }
    form.center = center;
    if (form.kind == FormKind::ellipse) {
        const Vec2 half = half_box(ellipse_of(objects.convex(shape)));
        box = {box.low - half, box.high + half};
    }
    boxes[shape] = grow(box_around(center, box), form.radius);
}

float inner_radius(const ObjectState& objects, uint32_t shape) {
    const ShapeForm& form = objects.forms[shape];
    if (form.kind == FormKind::ellipse) {
        const Ellipse ellipse = objects.shapes[shape].figure.as<Ellipse>();
        return min(ellipse.radius_x, ellipse.radius_y);
    }
    if (form.count <= 2) return form.radius;
    const VertexPool& pool = objects.pool;
    float inner = infinity;
    for (uint32_t i = form.begin; i < form.begin + form.count; ++i)
        inner = min(inner, dot(pool.normals[i], pool.local[i] - objects.shapes[shape].centroid));
    return max(inner, 0.0f) + form.radius;
}

float fat_margin(const Box4& box) {
    const float extent = 0.5f * max(box.high.x - box.low.x, box.high.y - box.low.y);
    return speculative_margin + min(0.05f, 0.125f * extent);
}

}  // namespace fettle::physics::detail
