#include <collision/ellipse.h>
#include <distance/shape_core.h>

namespace fettle::physics::detail {
namespace {

/// The tip of a sharp corner may be this near to the surface, m.
constexpr float tip_depth = 0.001f;

/// Distance of a point to the nearest edge line of a polygon without its radius, negative outside.
float distance_to_edges(const Convex& form, Vec2 p) {
    float nearest = 1e30f;
    for (int i = 0; i < form.count; ++i)
        nearest = min(nearest, form.offsets[i] - dot(form.normals[i], p));
    return nearest;
}

Vec2 in_own_frame(const Solid& shape, Vec2 p) {
    return shape.kind == FormKind::large ? unrotate(shape.rotation, p) : p;
}

}  // namespace

float inner_radius(const Solid& shape, Vec2 centroid) {
    const Convex& form = shape.form;
    if (shape.kind == FormKind::ellipse) {
        const EllipseForm ellipse = ellipse_of(form);
        return min(ellipse.first, ellipse.second);
    }
    if (form.count < 3) return form.radius;
    return max(distance_to_edges(form, in_own_frame(shape, centroid)), 0.0f) + form.radius;
}

Core::Core(const Solid& shape, Vec2 centroid, float depth) : solid_(shape) {
    Convex& form = solid_.form;
    if (shape.kind == FormKind::ellipse) {
        // Its center, and its radii in the place of a second vertex.
        few_vertices_[0] = form.vertices[0];
        few_vertices_[1] = form.vertices[1] - Vec2{depth, depth};
        form.vertices = few_vertices_;
        return;
    }
    const float rounded = min(form.radius, depth);
    form.radius -= rounded;
    if (form.count > 2 && depth > rounded)
        shrink_polygon(shape.form, in_own_frame(shape, centroid), depth - rounded);
}

/// Moves the lines of all edges inwards. Each vertex is where those of its two edges meet; where
/// that is outside of the polygon (a sharp corner behind a short edge), the vertex moves towards
/// the centroid instead.
void Core::shrink_polygon(const Convex& from, Vec2 centroid, float depth) {
    const size_t count = size_t(from.count);
    Vec2* vertices = few_vertices_;
    float* offsets = few_offsets_;
    if (from.count > most_small_vertices) {
        many_vertices_.resize(count);
        many_offsets_.resize(count);
        vertices = many_vertices_.data();
        offsets = many_offsets_.data();
    }
    const float inner = distance_to_edges(from, centroid);
    const float scale = inner > depth ? 1.0f - depth / inner : 0.0f;
    for (size_t i = 0; i < count; ++i) {
        const Vec2 before = from.normals[i > 0 ? i - 1 : count - 1], after = from.normals[i];
        const Vec2 v = from.vertices[i];
        // At a sharp corner, the point of the bisector that has this depth is far inside.
        const float sine = std::sqrt(max(0.5f * (1.0f + dot(before, after)), 1e-9f));
        const float back = min(depth / sine, max(2.0f * depth, tip_depth / sine));
        const Vec2 moved = v - (back / (2.0f * sine)) * (before + after);
        const auto outside = [&](size_t k) {
            return dot(from.normals[k], moved) > from.offsets[k];
        };
        bool inside = true;
        if (from.count > most_small_vertices)  // such polygons are mostly round, and a test of all
                                               // edges would be slow
            inside = !outside((i + 1) % count) && !outside((i + count - 2) % count);
        else
            for (size_t k = 0; k < count && inside; ++k) inside = !outside(k);
        vertices[i] = inside ? moved : centroid + scale * (v - centroid);
    }
    for (size_t i = 0; i < count; ++i) offsets[i] = from.offsets[i] - depth;
    solid_.form.vertices = vertices;
    solid_.form.offsets = offsets;
}

}  // namespace fettle::physics::detail
