#include <forms/corners.h>
#include <geometry/trigonometry.h>

#include <cmath>

namespace fettle::physics::detail {

float fitting_rounding(const Box& box) {
    return min(box.rounding, 0.5f * min(box.width, box.height));
}

void box_corners(const Box& box, Vec2* out) {
    const float least = min(box.width, box.height) * 1e-3f;
    const float rounding = fitting_rounding(box);
    const float hx = 0.5f * max(box.width - 2.0f * rounding, least);
    const float hy = 0.5f * max(box.height - 2.0f * rounding, least);
    const Rotation q = rotation_of(box.angle);
    const Vec2 corners[4] = {{-hx, -hy}, {hx, -hy}, {hx, hy}, {-hx, hy}};
    for (int i = 0; i < 4; ++i) out[i] = box.center + rotate(q, corners[i]);
}

Vec2 kept_apart(Vec2 to, Vec2 from) {
    const float least = 1e-4f + 1e-6f * max(std::fabs(from.x), std::fabs(from.y));
    return length(to - from) >= least ? to : from + Vec2{least, 0.0f};
}

void write_normals(std::span<const Vec2> vertices, Vec2* normals) {
    const size_t count = vertices.size();
    for (size_t i = 0; i < count && count > 1; ++i)
        normals[i] = normalized(right_perp(vertices[(i + 1) % count] - vertices[i]));
}

}  // namespace fettle::physics::detail
