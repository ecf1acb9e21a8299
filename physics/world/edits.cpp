#include <collision/ellipse.h>
#include <geometry/trigonometry.h>
#include <world/world_data.h>

#include <algorithm>

// Derived data is pulled: an edit marks what it leaves out of date and puts it on a list; it is
// computed when somebody reads it or before the next step, whichever is first, and once however
// many edits there were.

namespace fettle::physics::detail {
namespace {

/// Mass and inertia are kept in this range, so that their inverses and products stay finite.
constexpr double least_mass = 1e-12, greatest_mass = 1e18;

float bounded_inverse(double value) {
    if (!(value > 0.0) || !(value < greatest_mass)) return 0.0f;
    return float(1.0 / std::max(value, least_mass));
}

}  // namespace

void WorldData::list_body(uint32_t body) {
    if (bodies[body].listed) return;
    bodies[body].listed = true;
    edited_bodies.push_back(body);
}

void WorldData::mark_geometry(uint32_t shape) {
    shapes[shape].geometry_dirty = true;
    if (!shapes[shape].listed) {
        shapes[shape].listed = true;
        edited_shapes.push_back(shape);
    }
    if (forms[shape].body == none) return;
    mark_mass(forms[shape].body);
    mark_placement(forms[shape].body);
}

void WorldData::mark_mass(uint32_t body) {
    bodies[body].mass_dirty = true;
    list_body(body);
}

void WorldData::mark_placement(uint32_t body) {
    bodies[body].placement_dirty = true;
    list_body(body);
}

/// An edit moved it, or changed with whom it collides: all its pairs are looked at again.
void WorldData::mark_moved(uint32_t shape) {
    if (!is_solid(shape)) return;
    paired_boxes[shape] = no_box;
    const ShapeRecord& record = shapes[shape];
    if (record.proxy != Tree::none)
        (record.tree == Mobility::fixed ? fixed_tree : moving_tree).touch(record.proxy);
    list_moved(shape);
}

void WorldData::refilter(uint32_t shape) {
    const uint32_t body = forms[shape].body;
    if (body == none) return;
    wake_for_edit(body);
    for_each_contact_of(shape, [&](uint32_t contact) {
        const ContactRecord& c = contacts[contact];
        const bool sensor = shapes[c.shape_a].surface.sensor || shapes[c.shape_b].surface.sensor;
        if (c.sensor != sensor || !may_collide(c.shape_a, c.shape_b))
            destroy_contact(contact_list(), contact);
    });
    for_each_solid(shape, [&](uint32_t solid) { mark_moved(solid); });
}

void WorldData::list_moved(uint32_t shape) {
    if (shapes[shape].moved) return;
    shapes[shape].moved = true;
    moved_shapes.push_back(shape);
}

void WorldData::refresh() {
    // Refreshing a shape marks its body, refreshing a mass may mark a placement: shapes first,
    // bodies while there are.
    for (size_t i = 0; i < edited_shapes.size(); ++i) {
        const uint32_t shape = edited_shapes[i];
        if (!shapes[shape].listed) continue;  // destroyed meanwhile
        shapes[shape].listed = false;
        refresh_shape(shape);
    }
    edited_shapes.clear();
    for (size_t i = 0; i < edited_bodies.size(); ++i) {
        const uint32_t body = edited_bodies[i];
        if (!bodies[body].listed) continue;
        refresh_mass(body);
        refresh_placement(body);
        bodies[body].listed = false;
    }
    edited_bodies.clear();
}

void WorldData::read_edited(const Refresh& wanted) {
    if (self.refresh && !self.locked()) {
        WorldLock lock(self, WorldLock::During::query, in_refresh);
        self.refresh(wanted);
        lock.finish();
    }
    refresh(wanted);
}

void WorldData::refresh(const Refresh& wanted) {
    switch (wanted.of) {
        case Refresh::Of::everything:
            return refresh();
        case Refresh::Of::body:
            if (wanted.slot < bodies.size() && body_generations[wanted.slot] != 0)
                refresh_mass(wanted.slot);
            return;
        case Refresh::Of::shape:
            if (wanted.slot < shapes.size() && shape_generations[wanted.slot] != 0)
                refresh_shape(wanted.slot);
            return;
    }
}

namespace {

/// What fits into the box. Sides and rounding are set one after the other, in any order: what is
/// too much for now is kept and limited here rather than refused.
float fitting_rounding(const Box& box) {
    return min(box.rounding, 0.5f * min(box.width, box.height));
}

/// Corners of a box without its rounding; the core never vanishes, so that it stays a polygon.
void box_corners(const Box& box, V2* out) {
    const float least = min(box.width, box.height) * 1e-3f;
    const float rounding = fitting_rounding(box);
    const float hx = 0.5f * max(box.width - 2.0f * rounding, least);
    const float hy = 0.5f * max(box.height - 2.0f * rounding, least);
    const Rotation q = rotation_of(box.angle);
    const V2 corners[4] = {{-hx, -hy}, {hx, -hy}, {hx, hy}, {-hx, hy}};
    for (int i = 0; i < 4; ++i) out[i] = to_v2(box.center) + rotate(q, corners[i]);
}

/// The ends of a segment are set one after the other too: while they are the same point, it is as
/// short as one can be.
V2 apart(V2 to, V2 from) {
    const float least = 1e-4f + 1e-6f * max(std::fabs(from.x), std::fabs(from.y));
    return length(to - from) >= least ? to : from + V2{least, 0.0f};
}

}  // namespace

void WorldData::refresh_shape(uint32_t shape) {
    ShapeRecord& record = shapes[shape];
    if (!record.geometry_dirty) return;
    record.geometry_dirty = false;
    ++record.rebuilds;
    if (!is_solid(shape)) {
        rebuild_parts(shape);
        return;
    }
    ShapeForm& form = forms[shape];
    const float radius_before = form.radius;
    V2* local = &pool.local[form.begin];
    switch (record.type) {
        case ShapeType::circle:
            local[0] = to_v2(record.figure.as<Circle>().center);
            form.radius = record.figure.as<Circle>().radius;
            break;
        case ShapeType::box:
            box_corners(record.figure.as<Box>(), local);
            form.radius = fitting_rounding(record.figure.as<Box>());
            break;
        case ShapeType::segment:
            local[0] = to_v2(record.figure.as<Segment>().from);
            local[1] = apart(to_v2(record.figure.as<Segment>().to), local[0]);
            form.radius = record.figure.as<Segment>().rounding;
            break;
        case ShapeType::ellipse:
            write_ellipse(record.figure.as<Ellipse>(), form.begin, pool);
            form.radius = 0.0f;
            break;
        default:
            // Its vertices are already in the pool. A piece has no rounding.
            form.radius = record.figure.as<PolygonFigure>().rounding;
            break;
    }
    for (uint32_t i = 0; i < form.count && form.count > 1; ++i) {
        pool.normals[form.begin + i] =
            normalized(right_perp(local[(i + 1) % form.count] - local[i]));
    }
    pool.vertices[form.begin] = {infinity, infinity};  // a large polygon is to be centered anew
    record.set_moments(record.type == ShapeType::ellipse
                           ? moments_of(record.figure.as<Ellipse>())
                           : moments_of({local, form.count}, form.radius));
    if (form.radius != radius_before)
        remix_shape(*this, settings, shape);  // for the rolling resistance
    if (form.body == none) place_shape(*this, boxes, shape, {});
}

void WorldData::refresh_edited_mass(uint32_t body) {
    BodyRecord& record = bodies[body];
    for (uint32_t s = record.first_shape; s != none; s = shapes[s].next) refresh_shape(s);
    if (!record.mass_dirty) return;
    record.mass_dirty = false;
    ++record.rebuilds;

    double mass = 0.0, first_x = 0.0, first_y = 0.0;
    for (uint32_t s = record.first_shape; s != none; s = shapes[s].next) {
        if (shapes[s].owner != none) continue;  // its owner knows better
        const ShapeRecord& shape = shapes[s];
        const double part = double(shape.area) * double(shape.surface.density);
        mass += part;
        first_x += part * double(shape.centroid.x);
        first_y += part * double(shape.centroid.y);
    }
    double cx = mass > 0.0 ? first_x / mass : 0.0, cy = mass > 0.0 ? first_y / mass : 0.0;
    if (is_given(record.given_center.x)) {
        cx = record.given_center.x;
        cy = record.given_center.y;
    }
    double inertia = 0.0;
    float extent = 0.0f, thickness = infinity;
    for (uint32_t s = record.first_shape; s != none; s = shapes[s].next) {
        const ShapeRecord& shape = shapes[s];
        const double dx = double(shape.centroid.x) - cx, dy = double(shape.centroid.y) - cy;
        if (shape.owner == none)
            inertia += double(shape.surface.density) *
                       (double(shape.moment) + double(shape.area) * (dx * dx + dy * dy));
        if (!is_solid(s)) continue;
        const ShapeForm& form = forms[s];
        float inner = infinity;
        for (uint32_t i = form.begin; i < form.begin + form.count; ++i) {
            const V2 v = pool.local[i] - V2{float(cx), float(cy)};
            extent = max(extent, length(v) + form.radius);
            if (form.count > 2)
                inner = min(inner, dot(pool.normals[i], pool.local[i] - shape.centroid));
        }
        if (form.kind == FormKind::ellipse) {
            const Ellipse ellipse = shape.figure.as<Ellipse>();
            extent += max(ellipse.radius_x, ellipse.radius_y);
            thickness = min(thickness, min(ellipse.radius_x, ellipse.radius_y));
            continue;
        }
        thickness = min(thickness, form.count > 2 ? max(inner, 0.0f) + form.radius : form.radius);
    }
    const bool weightless = !(mass > 0.0);
    if (is_given(record.given_mass)) {
        const double wanted = double(record.given_mass);
        if (std::isfinite(wanted)) inertia = weightless ? 0.0 : inertia * (wanted / mass);
        mass = wanted;
    } else if (weightless && record.type == BodyType::dynamic_body) {
        mass = 1.0;
    }
    if (is_given(record.given_inertia)) inertia = double(record.given_inertia);

    const BodyState& state = states[body];
    const V2 old_center = record.center;
    record.mass = float(mass);
    record.inertia = float(inertia);
    record.extent = extent;
    record.thickness = thickness == infinity ? 0.0f : thickness;
    record.local_center = {float(cx), float(cy)};
    record.center = to_v2(state.position) + rotate({state.cosine, state.sine}, record.local_center);
    // The body goes on as it moved: only the point whose velocity is kept is another one.
    const V2 drift = cross(state.angular_velocity, record.center - old_center);
    states[body].velocity = to_vec2(bounded(to_v2(state.velocity) + drift, 1e30f));
    mark_placement(body);
    update_mobility(body);
    const bool moves = record.mobility == Mobility::dynamic;
    record.inverse_mass =
        moves && !(record.locked_x && record.locked_y) ? bounded_inverse(mass) : 0.0f;
    record.inverse_inertia = moves && !record.locked_rotation ? bounded_inverse(inertia) : 0.0f;
}

void WorldData::refresh_placement(uint32_t body) {
    BodyRecord& record = bodies[body];
    if (!record.placement_dirty) return;
    record.placement_dirty = false;
    const BodyState& state = states[body];
    const Rotation q = {state.cosine, state.sine};
    record.center = to_v2(state.position) + rotate(q, record.local_center);
    for (uint32_t s = record.first_shape; s != none; s = shapes[s].next) {
        if (!is_solid(s)) continue;
        place_shape(*this, boxes, s, q);
        set_proxy(s);
        mark_moved(s);
    }
}

/// Static, kinematic or dynamic as the step sees it; where that changes, so does the tree its
/// shapes are in and whom they collide with.
void WorldData::update_mobility(uint32_t body) {
    BodyRecord& record = bodies[body];
    Mobility mobility = Mobility::dynamic;
    if (record.type == BodyType::kinematic_body) mobility = Mobility::kinematic;
    if (record.type == BodyType::static_body) mobility = Mobility::fixed;
    if (record.type == BodyType::dynamic_body && !(record.mass < float(greatest_mass)))
        mobility = Mobility::fixed;
    if (mobility == record.mobility) return;

    wake_for_edit(body);
    wake_touching(activity(), body);
    destroy_contacts_of_body(contact_list(), body);
    record.mobility = mobility;
    if (mobility == Mobility::fixed) {
        if (record.solver_index != 0) remove_awake(*this, *this, body);
        states[body].velocity.setZero();
        states[body].angular_velocity = 0.0f;
        previous[body] = {states[body].position, states[body].angle};
    } else if (record.solver_index == 0) {
        add_awake(*this, *this, body);
    }
    for_each_joint(body, [&](uint32_t joint, uint32_t) { list_joint(*this, *this, joint); });
    record.sleep_time = 0.0f;
    mark_placement(body);
}

void WorldData::set_proxy(uint32_t shape) {
    ShapeRecord& record = shapes[shape];
    const Mobility mobility = bodies[forms[shape].body].mobility;
    const Mobility tree = mobility == Mobility::fixed ? Mobility::fixed : Mobility::dynamic;
    fat_boxes[shape] =
        mobility == Mobility::fixed ? boxes[shape] : grow(boxes[shape], fat_margin(boxes[shape]));
    if (record.proxy != Tree::none && record.tree != tree) remove_proxy(shape);
    Tree& target = tree == Mobility::fixed ? fixed_tree : moving_tree;
    if (record.proxy == Tree::none)
        record.proxy = target.insert(fat_boxes[shape], shape);
    else
        target.move(record.proxy, fat_boxes[shape]);
    record.tree = tree;
}

void WorldData::remove_proxy(uint32_t shape) {
    ShapeRecord& record = shapes[shape];
    if (record.proxy == Tree::none) return;
    (record.tree == Mobility::fixed ? fixed_tree : moving_tree).remove(record.proxy);
    record.proxy = Tree::none;
}

}  // namespace fettle::physics::detail
