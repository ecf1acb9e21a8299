// Checks of the numbers of a deserialized world.

#include <checks/arguments.h>
#include <saving/saved_world.h>
#include <state/joint_kind.h>
#include <state/limits.h>

#include <cmath>
#include <stdexcept>

namespace fettle::physics::detail {
namespace {

using detail::check;  // the functions for definitions and geometries

template <class... Number>
bool are_finite(Number... numbers) {
    return (std::isfinite(numbers) && ...);
}
bool is_finite(Vec2 v) {
    return are_finite(v.x, v.y);
}
bool is_finite(const Box4& box) {
    return is_finite(box.low) && is_finite(box.high);
}
/// Upper bound of distances between points on shapes and of centers of mass in the world, m: such a
/// point is the sum of few coordinates within the limit of each.
constexpr float greatest_distance = 4.0f * greatest_coordinate;
bool is_near(const Position& v) {
    return std::fabs(v.x) <= greatest_distance && std::fabs(v.y) <= greatest_distance;
}
/// True for a valid amount. It may be infinite: an infinite mass, or a resting time beyond the
/// range of a float.
bool is_amount(float value) {
    return value >= 0.0f;
}

[[noreturn]] void refuse(const std::string& what) {
    throw std::invalid_argument(what);
}

void require(bool holds, const char* what, size_t slot) {
    if (!holds) refuse(what + (" " + std::to_string(slot)));
}

// --- Bodies

void check(const BodyRecord& body, const RestPose& rest, size_t slot) {
    const bool given = (!is_given(body.given.mass) || body.given.mass > 0.0f) &&
                       (!is_given(body.given.inertia) || body.given.inertia > 0.0f) &&
                       is_given(body.given.center.x) == is_given(body.given.center.y) &&
                       (!is_given(body.given.center.x) || is_finite(body.given.center));
    require(given && is_amount(body.mass) && is_amount(body.inertia), "the mass of body", slot);
    require(is_near(body.center) && is_near(body.local_center) &&
                are_finite(body.inverse_mass, body.inverse_inertia, body.angle_rest, body.extent,
                           body.thickness) &&
                is_amount(body.sleep_time) && rest.center.is_finite() && are_finite(rest.angle) &&
                is_finite(rest.first_way) && is_amount(rest.drawn_time) &&
                body.inverse_mass >= 0.0f && body.inverse_inertia >= 0.0f,
            "the state of body", slot);
    check_finite("gravity_scale", body.gravity_scale);
    check_not_negative("linear_damping", body.linear_damping);
    check_not_negative("angular_damping", body.angular_damping);
    require(is_finite(body.load.force) && is_finite(body.step_load.force) &&
                are_finite(body.load.torque, body.step_load.torque),
            "the forces on body", slot);
}

void check(const BodyState& state, const Pose& previous, size_t slot) {
    constexpr float off_unit = 1e-3f;
    check_coordinates("position", state.position);
    check_coordinates("position", previous.position);
    check_range("angle", state.angle, -greatest_coordinate, greatest_coordinate);
    check_range("angle", previous.angle, -greatest_coordinate, greatest_coordinate);
    const float length = state.cosine * state.cosine + state.sine * state.sine;
    require(is_finite(state.velocity) && are_finite(state.angular_velocity) &&
                std::fabs(length - 1.0f) < off_unit,
            "the state of body", slot);
}

// --- Shapes

std::span<const Vec2> points_of(const WorldState& w, size_t shape, size_t count) {
    return {&w.pool.local[w.forms[shape].begin], count};
}

void check_polygon(const WorldState& w, size_t shape) {
    check_range("rounding", w.shapes[shape].figure.as<PolygonFigure>().rounding, 0.0f, 1e6f);
    const auto points = points_of(w, shape, w.forms[shape].count);
    std::vector<Vec2> hull;
    const HullStatus status = convex_hull(points, hull);
    if (status != HullStatus::ok || hull.size() != points.size())
        refuse("vertices: not those of a convex polygon");
    for (const Vec2& v : points) check_range("vertices", v.abs().largest(), 0.0f, 1e6f);
}

void check_figure(const WorldState& w, size_t shape) {
    const ShapeRecord& record = w.shapes[shape];
    switch (record.type) {
        case ShapeType::circle:
            return check(Geometry(record.figure.as<Circle>()));
        case ShapeType::box:
            return check(Geometry(record.figure.as<Box>()));
        case ShapeType::segment:
            return check(Geometry(record.figure.as<Segment>()));
        case ShapeType::ellipse:
            return check(Geometry(record.figure.as<Ellipse>()));
        case ShapeType::polygon:
            return check_polygon(w, shape);
        case ShapeType::concave:
            return check_outline(points_of(w, shape, record.outline));
        case ShapeType::chain:
            return check_chain(points_of(w, shape, record.outline), record.closed);
        case ShapeType::border:
            return;
    }
}

/// The radii of an ellipse are behind its center. An edit of its geometry writes them later.
void check_radii(const WorldState& w, size_t shape) {
    if (w.forms[shape].kind != FormKind::ellipse || w.shapes[shape].geometry_dirty) return;
    const size_t at = w.forms[shape].begin + size_t{1};
    for (const Vec2 radii : {w.pool.local[at], w.pool.vertices[at]})
        check(Geometry(Ellipse{.radius_x = radii.x, .radius_y = radii.y}));
}

void check_shape(const WorldState& w, size_t shape) {
    const ShapeRecord& record = w.shapes[shape];
    const ShapeForm& form = w.forms[shape];
    check(record.surface);
    if (record.owner == none) check_figure(w, shape);  // a part has the figure of its owner
    require(are_finite(record.area, record.moment, form.radius, form.angle, form.turn) &&
                form.radius >= 0.0f && form.radius <= greatest_distance && record.area >= 0.0f &&
                record.moment >= 0.0f && is_near(record.centroid) && is_near(form.center) &&
                is_finite(w.boxes[shape]) && is_finite(w.fat_boxes[shape]) &&
                is_finite(w.paired_boxes[shape]),
            "the derived data of shape", shape);
    if (form.kind == FormKind::border || form.count == 0) return;
    const size_t stored = form.count * (form.kind == FormKind::piece ? size_t{3} : 1);
    for (size_t i = form.begin; i < form.begin + stored; ++i)
        require(is_near(w.pool.local[i]), "the vertices of shape", shape);
    // An edit marks the vertices that must be placed again.
    const bool placed = form.body == none || !w.bodies[form.body].flags.placement_dirty;
    for (size_t i = form.begin; i < form.begin + form.count; ++i)
        require((!placed || is_near(w.pool.vertices[i])) && is_near(w.pool.normals[i]) &&
                    is_near(w.pool.directions[i]) && are_finite(w.pool.offsets[i]),
                "the vertices of shape", shape);
    check_radii(w, shape);
}

void check_segment_surfaces(const WorldState& w) {
    const SegmentRecord* last = nullptr;
    for (const SegmentRecord& record : w.segment_surfaces) {
        const bool after = last == nullptr || last->shape < record.shape ||
                           (last->shape == record.shape && last->segment < record.segment);
        require(after && record.segment != none && record.shape < w.shapes.size() &&
                    w.shape_generations[record.shape] != 0 &&
                    w.shapes[record.shape].type == ShapeType::chain &&
                    w.shapes[record.shape].owner == none,
                "the surfaces of the segments of shape", record.shape);
        check(record.surface);
        last = &record;
    }
}

// --- Contacts

void check(const ContactRecord& contact, const ManifoldPose& pose, size_t slot) {
    const Manifold& m = contact.manifold;
    bool valid = is_finite(m.normal) && are_finite(m.corner, contact.rolling_impulse) &&
                 are_finite(pose.angle_a, pose.angle_b, pose.separations[0], pose.separations[1]);
    for (int i = 0; i < m.count; ++i) {
        const ManifoldPoint& p = m.points[i];
        valid &= is_near(p.anchor_a) && is_near(p.anchor_b) &&
                 are_finite(p.separation, p.normal_impulse, p.tangent_impulse);
    }
    require(valid, "contact", slot);
    check_not_negative("friction", contact.friction);
    check_range("restitution", contact.restitution, 0.0f, 1.0f);
    check_not_negative("rolling_resistance", contact.rolling_resistance);
    check_finite("surface_speed", contact.surface_speed);
}

// --- Joints: the checks of their setters

void check(const JointRecord& joint, size_t slot) {
    check_coordinates("anchor_a", joint.anchors[0]);
    check_coordinates("anchor_b", joint.anchors[1]);
    check_finite("force", joint.force);
    check_finite("torque", joint.torque);
    check_strength("break_force", joint.break_force);
    check_strength("break_torque", joint.break_torque);
    check_strength("report_force", joint.report_force);
    check_strength("report_torque", joint.report_torque);
    check_not_negative("constraint_hertz", joint.constraint_hertz);
    check_range("constraint_damping_ratio", joint.constraint_damping_ratio, 0.0f, 1000.0f);
    joint_kind(joint.type).check(joint);
    for (const float impulse : joint.impulses.as<std::array<float, 6>>())
        require(are_finite(impulse), "the impulses of joint", slot);
}

// --- The whole state

void check_all(const WorldState& w) {
    check(w.settings);
    for (size_t i = 0; i < w.bodies.size(); ++i) {
        check(w.bodies[i], w.rest_poses[i], i);
        check(w.states[i], w.previous[i], i);
    }
    for (const BodyTraits& traits : w.traits) {
        if (is_given(traits.sleep_speed)) check_not_negative("sleep_speed", traits.sleep_speed);
        require(traits.max_speed > 0.0f, "max_speed of traits", size_t(&traits - w.traits.data()));
    }
    for (size_t i = 0; i < w.shapes.size(); ++i)
        if (w.shape_generations[i] != 0) check_shape(w, i);
    check_segment_surfaces(w);
    for (size_t i = 0; i < w.contacts.size(); ++i)
        if (w.contacts[i].shape_a != none) check(w.contacts[i], w.manifold_poses[i], i);
    for (size_t i = 0; i < w.joints.size(); ++i)
        if (w.joint_generations[i] != 0) check(w.joints[i], i);
    for (const FieldRecord& field : w.fields) check(field.def);
    uint32_t last = 0;
    for (const MoverBody& mover : w.mover_bodies) {
        require(mover.body.index > last && is_finite(mover.velocity), "the mover of body",
                mover.body.index);
        last = mover.body.index;
    }
    for (const MoverWeight& weight : w.mover_weights)
        require(is_finite(weight.load.force) && are_finite(weight.load.torque),
                "the weight of a mover on body", weight.body.index);
    for (const Stay& stay : w.stays)
        require(stay.center.is_finite() && are_finite(stay.angle) && is_amount(stay.time) &&
                    is_amount(stay.far) && is_amount(stay.back) && is_amount(stay.fastest),
                "the stay of body", stay.body);
    require(are_finite(w.last_substep, w.last_length, w.long_substep) && w.last_substep >= 0.0f &&
                w.last_length >= 0.0f && w.long_substep >= 0.0f && w.last_substeps >= 0 &&
                is_amount(w.since_search),
            "the last step", 0);
}

}  // namespace

std::optional<std::string> numbers_problem(const WorldState& world) {
    try {
        check_all(world);
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return {};
}

}  // namespace fettle::physics::detail
