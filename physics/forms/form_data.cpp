#include <collision/ellipse.h>
#include <collision/extreme_points.h>
#include <fettle/physics/hull.h>
#include <forms/corners.h>
#include <forms/form_data.h>
#include <forms/outline_parts.h>
#include <geometry/trigonometry.h>

namespace fettle::physics::detail {
namespace {

void add_convex(FormData& form, std::vector<Vec2> vertices, float radius) {
    const auto count = uint32_t(vertices.size());
    const bool large = count > uint32_t(most_small_vertices);
    form.parts = {{0, count, large ? FormKind::large : FormKind::convex}};
    form.vertices = std::move(vertices);
    form.normals.resize(count);
    write_normals(form.vertices, form.normals.data());
    form.radius = radius;
    form.moments = moments_of(form.vertices, radius);
}

void add_ellipse(FormData& form, const Ellipse& ellipse) {
    form.parts = {{0, 1, FormKind::ellipse}};
    form.vertices.resize(2);
    form.normals.resize(2);
    write_ellipse(ellipse, form.vertices.data(), form.normals.data());
    form.moments = moments_of(ellipse);
}

void add_outline(FormData& form, const OutlineParts& parts, const AreaMoments& moments) {
    form.vertices = parts.values;
    form.normals.resize(parts.values.size());
    size_t begin = 0;
    for (const uint32_t count : parts.counts) {
        form.parts.push_back({begin, count, FormKind::piece});
        write_normals({&form.vertices[begin], count}, &form.normals[begin]);
        begin += 3 * size_t{count};
    }
    form.moments = moments;
}

std::vector<Vec2> converted(std::span<const Vec2> points) {
    std::vector<Vec2> list;
    list.reserve(points.size());
    for (const Vec2& p : points) list.push_back(p);
    return list;
}

}  // namespace

FormData form_of(const Geometry& geometry) {
    FormData form;
    form.type = static_cast<ShapeType>(geometry.index());
    if (const Circle* circle = std::get_if<Circle>(&geometry)) {
        add_convex(form, {circle->center}, circle->radius);
    } else if (const Box* box = std::get_if<Box>(&geometry)) {
        std::vector<Vec2> corners(4);
        box_corners(*box, corners.data());
        add_convex(form, corners, fitting_rounding(*box));
    } else if (const Segment* segment = std::get_if<Segment>(&geometry)) {
        const Vec2 from = segment->from;
        add_convex(form, {from, kept_apart(segment->to, from)}, segment->rounding);
    } else if (const Polygon* polygon = std::get_if<Polygon>(&geometry)) {
        std::vector<Vec2> hull;
        convex_hull(polygon->vertices, hull);
        add_convex(form, converted(hull), polygon->rounding);
    } else if (const Ellipse* ellipse = std::get_if<Ellipse>(&geometry)) {
        add_ellipse(form, *ellipse);
    } else if (const Concave* concave = std::get_if<Concave>(&geometry)) {
        const std::vector<Vec2> outline = converted(concave->vertices);
        add_outline(form, concave_parts(outline), concave_moments(outline));
    } else if (const Chain* chain = std::get_if<Chain>(&geometry)) {
        const std::vector<Vec2> points = converted(chain->points);
        add_outline(form, chain_parts(points, chain->closed), chain_moments(points));
    }
    return form;
}

PosedForm::PosedForm(const FormData& form, const Pose& pose, Vec2 center) {
    const Rotation q = rotation_of(pose.angle);
    center_ = pose.position + rotate(q, center);
    const size_t size = form.vertices.size();
    std::vector<Vec2>&vertices = *vertices_, &normals = *normals_;
    std::vector<float>& offsets = *offsets_;
    vertices.resize(size);
    normals.resize(size);
    offsets.resize(size);
    solids_->reserve(form.parts.size());
    for (const FormPart& part : form.parts) {
        // A large polygon is not rotated: collision/large_polygon.h.
        const Rotation turn = part.kind == FormKind::large ? Rotation() : q;
        for (size_t i = part.begin; i < part.begin + part.count; ++i) {
            const Vec2 vertex = form.vertices[i] - center;
            vertices[i] = rotate(turn, vertex);
            normals[i] = rotate(turn, form.normals[i]);
            offsets[i] = dot(form.normals[i], vertex);
        }
        if (part.kind == FormKind::ellipse) vertices[1] = form.vertices[1];
        solids_->push_back({.form = {&vertices[part.begin], &normals[part.begin],
                                     &offsets[part.begin], int(part.count), form.radius},
                            .kind = part.kind,
                            .rotation = q,
                            .limits = &form.vertices[part.begin] + part.count,
                            .normals = &form.normals[part.begin]});
    }
}

float PosedForm::extent() const {
    float farthest = 0.0f;
    for (const Solid& solid : *solids_) {
        if (solid.kind == FormKind::ellipse) {
            const Vec2 radii = solid.form.vertices[1];
            farthest = max(farthest, length(solid.form.vertices[0]) + max(radii.x, radii.y));
            continue;
        }
        for (int i = 0; i < solid.form.count; ++i)
            farthest = max(farthest, length(solid.form.vertices[i]) + solid.form.radius);
    }
    return farthest;
}

}  // namespace fettle::physics::detail
