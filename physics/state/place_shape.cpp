#include <collision/ellipse.h>
#include <collision/large_polygon.h>
#include <state/limits.h>
#include <state/place_shape.h>

namespace fettle::physics::detail {
namespace {

/// In the pool, the vertices of a large polygon are relative to the body's center of mass but not
/// rotated. Only an edit changes them; a step computes just a bounding box. Not inlined, because
/// that would take registers from the loop over the vertices of all other shapes.
[[gnu::noinline]] Box4 place_large(ObjectState& objects, uint32_t shape, V2 local_center,
                                   Rotation q) {
    const ShapeForm& form = objects.forms[shape];
    VertexPool& pool = objects.pool;
    const V2 first = pool.local[form.begin] - local_center;
    if (pool.vertices[form.begin].x != first.x || pool.vertices[form.begin].y != first.y) {
        for (uint32_t i = form.begin; i < form.begin + form.count; ++i) {
            pool.vertices[i] = pool.local[i] - local_center;
            pool.directions[i] = pool.normals[i];
            pool.offsets[i] = dot(pool.normals[i], pool.vertices[i]);
        }
    }
    const Convex polygon = objects.convex(shape);
    const auto reach = [&](V2 direction) {
        const V2 d = unrotate(q, direction);
        return dot(d, polygon.vertices[farthest_vertex(polygon, d)]);
    };
    return {{-reach({-1.0f, 0.0f}), -reach({0.0f, -1.0f})},
            {reach({1.0f, 0.0f}), reach({0.0f, 1.0f})}};
}

}  // namespace

void place_shape(ObjectState& objects, std::span<Box4> boxes, uint32_t shape, Rotation q,
                 float angle) {
    ShapeForm& form = objects.forms[shape];
    VertexPool& pool = objects.pool;
    if (form.count == 0) return;
    form.turn = angle - form.angle;
    form.angle = angle;
    V2 center, local_center;
    if (form.body != none) {
        center = objects.bodies[form.body].center;
        local_center = objects.bodies[form.body].local_center;
    }
    if (form.kind == FormKind::large) {
        const Box4 box = place_large(objects, shape, local_center, q);
        form.center = center;
        boxes[shape] = grow({center + box.low, center + box.high}, form.radius);
        return;
    }
    V2 low, high;
    for (uint32_t i = form.begin; i < form.begin + form.count; ++i) {
        const V2 v = rotate(q, pool.local[i] - local_center);
        pool.vertices[i] = v;
        pool.directions[i] = rotate(q, pool.normals[i]);
        pool.offsets[i] = dot(pool.normals[i], pool.local[i] - local_center);
        low = i == form.begin ? v : V2{min(low.x, v.x), min(low.y, v.y)};
        high = i == form.begin ? v : V2{max(high.x, v.x), max(high.y, v.y)};
    }
    if (form.count == 3) pool.pad_triangle(form.begin);
    form.center = center;
    if (form.kind == FormKind::ellipse) {
        const V2 half = half_box(ellipse_of(objects.convex(shape)));
        low = low - half;
        high = high + half;
    }
    boxes[shape] = grow({center + low, center + high}, form.radius);
}

float fat_margin(const Box4& box) {
    const float extent = 0.5f * max(box.high.x - box.low.x, box.high.y - box.low.y);
    return speculative_margin + min(0.05f, 0.125f * extent);
}

}  // namespace fettle::physics::detail
