#include <collision/ellipse.h>
#include <contacts/mixing.h>
#include <edits/edits.h>
#include <forms/corners.h>
#include <geometry/trigonometry.h>
#include <state/active_lists.h>
#include <state/crowding.h>
#include <state/limits.h>
#include <state/place_shape.h>

#include <algorithm>

namespace fettle::physics::detail {
namespace {

/// Mass and inertia are kept in this range, so that their inverses and products stay finite.
constexpr double least_mass = 1e-12, greatest_mass = 1e18;

float bounded_inverse(double value) {
    if (!(value > 0.0) || !(value < greatest_mass)) return 0.0f;
    return float(1.0 / std::max(value, least_mass));
}

void list_body(ObjectState& objects, ActiveLists& active, uint32_t body) {
    if (objects.bodies[body].listed) return;
    objects.bodies[body].listed = true;
    active.edited_bodies.push_back(body);
}

}  // namespace

void mark_geometry(ObjectState& objects, ActiveLists& active, uint32_t shape) {
    objects.shapes[shape].geometry_dirty = true;
    if (!objects.shapes[shape].listed) {
        objects.shapes[shape].listed = true;
        active.edited_shapes.push_back(shape);
    }
    if (objects.forms[shape].body == none) return;
    mark_mass(objects, active, objects.forms[shape].body);
    mark_placement(objects, active, objects.forms[shape].body);
}

void mark_mass(ObjectState& objects, ActiveLists& active, uint32_t body) {
    objects.bodies[body].flags.mass_dirty = true;
    list_body(objects, active, body);
}

void mark_placement(ObjectState& objects, ActiveLists& active, uint32_t body) {
    objects.bodies[body].flags.placement_dirty = true;
    list_body(objects, active, body);
}

void mark_joints(ObjectState& objects, ActiveLists& active, uint32_t body) {
    if (body != 0 && objects.bodies[body].lists.joint_count >= least_crowding)
        list_body(objects, active, body);
}

void mark_moved(ObjectState& objects, BroadPhaseState& broad_phase, uint32_t shape) {
    if (!objects.is_solid(shape)) return;
    broad_phase.paired_boxes[shape] = no_box;
    const ShapeRecord& record = objects.shapes[shape];
    if (record.proxy != Tree::none)
        (record.tree == Mobility::fixed ? broad_phase.fixed_tree : broad_phase.moving_tree)
            .clear_pairs(record.proxy);
    if (objects.shapes[shape].moved) return;
    objects.shapes[shape].moved = true;
    broad_phase.moved_shapes.push_back(shape);
}

void mark_refiltered(ObjectState& objects, const Columns& columns, BroadPhaseState& broad_phase,
                     uint32_t shape) {
    const uint32_t body = objects.forms[shape].body;
    const Tree& moving_tree = broad_phase.moving_tree;
    if (objects.bodies[body].mobility != Mobility::fixed ||
        objects.shapes[shape].outline <= moving_tree.size()) {
        objects.for_each_solid(shape,
                               [&](uint32_t solid) { mark_moved(objects, broad_phase, solid); });
        return;
    }
    // A long outline that does not move: the shapes near it are marked, which are fewer than its
    // parts.
    const BodyState& state = columns.states[body];
    Box4 box = no_box;
    for (const Vec2 point : objects.outline_of(shape)) {
        const Position place = state.position + rotate({state.cosine, state.sine}, point);
        box = unite(box, box_of(place, place));
    }
    moving_tree.query(grow(box, speculative_margin),
                      [&](uint32_t other) { mark_moved(objects, broad_phase, other); });
}

void refilter(const Editing& e, const UserFilter& filter, uint32_t shape) {
    ObjectState& objects = e.objects;
    const uint32_t body = objects.forms[shape].body;
    if (body == none) return;
    wake_for_edit(e.activity, body);
    objects.for_each_contact_of(shape, [&](uint32_t contact) {
        const ContactRecord& c = objects.contacts[contact];
        const bool sensor =
            objects.shapes[c.shape_a].surface.sensor || objects.shapes[c.shape_b].surface.sensor;
        if (c.sensor != sensor || !may_collide(objects, filter, c.shape_a, c.shape_b))
            destroy_contact(e.contacts, contact);
    });
    mark_refiltered(objects, e.columns, e.broad_phase, shape);
}

void remove_proxy(ObjectState& objects, BroadPhaseState& broad_phase, uint32_t shape) {
    ShapeRecord& record = objects.shapes[shape];
    if (record.proxy == Tree::none) return;
    (record.tree == Mobility::fixed ? broad_phase.fixed_tree : broad_phase.moving_tree)
        .remove(record.proxy);
    record.proxy = Tree::none;
}

namespace {

void set_proxy(ObjectState& objects, BroadPhaseState& broad_phase, uint32_t shape) {
    ShapeRecord& record = objects.shapes[shape];
    const Mobility mobility = objects.bodies[objects.forms[shape].body].mobility;
    const Mobility tree = mobility == Mobility::fixed ? Mobility::fixed : Mobility::dynamic;
    broad_phase.fat_boxes[shape] =
        mobility == Mobility::fixed
            ? broad_phase.boxes[shape]
            : grow(broad_phase.boxes[shape], fat_margin(broad_phase.boxes[shape]));
    if (record.proxy != Tree::none && record.tree != tree)
        remove_proxy(objects, broad_phase, shape);
    Tree& target = tree == Mobility::fixed ? broad_phase.fixed_tree : broad_phase.moving_tree;
    if (record.proxy == Tree::none)
        record.proxy = target.insert(broad_phase.fat_boxes[shape], shape);
    else
        target.move(record.proxy, broad_phase.fat_boxes[shape]);
    record.tree = tree;
}

void stop(BodyState& state) {
    state.velocity = {};
    state.angular_velocity = 0.0f;
}

/// Sets the mobility: fixed, kinematic or dynamic. A change also changes the tree of its shapes,
/// and which shapes they collide with.
void update_mobility(const Editing& e, uint32_t body) {
    BodyRecord& record = e.objects.bodies[body];
    Mobility mobility = Mobility::dynamic;
    if (record.type == BodyType::kinematic_body) mobility = Mobility::kinematic;
    if (record.type == BodyType::static_body) mobility = Mobility::fixed;
    if (record.type == BodyType::dynamic_body && !(record.mass < float(greatest_mass)))
        mobility = Mobility::fixed;
    if (record.flags.disabled) mobility = Mobility::fixed;
    if (mobility == record.mobility) return;

    wake_for_edit(e.activity, body);
    wake_touching(e.activity, body);
    destroy_contacts_of_body(e.contacts, body);
    e.objects.kinematic_bodies -= record.mobility == Mobility::kinematic;
    e.objects.kinematic_bodies += mobility == Mobility::kinematic;
    record.mobility = mobility;
    if (mobility == Mobility::fixed) {
        if (record.solver_index != 0) remove_awake(e.objects, e.active, body);
        if (!record.flags.disabled) stop(e.columns.states[body]);
        e.columns.previous[body] = {e.columns.states[body].position, e.columns.states[body].angle};
    } else if (record.solver_index == 0) {
        add_awake(e.objects, e.active, body);
    }
    e.objects.for_each_joint(
        body, [&](uint32_t joint, uint32_t) { list_joint(e.objects, e.active, joint); });
    record.sleep_time = 0.0f;
    mark_placement(e.objects, e.active, body);
}

void refresh_placement(const Editing& e, uint32_t body) {
    BodyRecord& record = e.objects.bodies[body];
    if (!record.flags.placement_dirty) return;
    record.flags.placement_dirty = false;
    const BodyState& state = e.columns.states[body];
    const Rotation q = {state.cosine, state.sine};
    record.center = state.position + rotate(q, record.local_center);
    for (uint32_t s = record.lists.first_shape; s != none; s = e.objects.shapes[s].next) {
        if (!e.objects.is_solid(s)) continue;
        place_shape(e.objects, e.broad_phase.boxes, s, q, state.angle);
        if (record.flags.disabled) continue;
        set_proxy(e.objects, e.broad_phase, s);
        mark_moved(e.objects, e.broad_phase, s);
    }
    drop_kept_manifolds(e.objects, body);
}

}  // namespace

void drop_kept_manifolds(ObjectState& objects, uint32_t body) {
    objects.for_each_contact(body,
                             [&](uint32_t contact) { objects.contacts[contact].kept = false; });
}

void set_body_enabled(const Editing& e, uint32_t body, bool enabled) {
    ObjectState& objects = e.objects;
    BodyRecord& record = objects.bodies[body];
    if (record.flags.disabled == !enabled) return;
    wake_for_edit(e.activity, body);
    wake_touching(e.activity, body);
    record.flags.disabled = !enabled;
    if (!enabled) {
        destroy_contacts_of_body(e.contacts, body);
        for (uint32_t s = record.lists.first_shape; s != none; s = objects.shapes[s].next) {
            if (!objects.is_solid(s)) continue;
            remove_proxy(objects, e.broad_phase, s);
            objects.set_crowded(s, false);
        }
    }
    mark_mass(objects, e.active, body);
    mark_placement(objects, e.active, body);
    refresh_mass(e, body);
    if (enabled && record.mobility == Mobility::fixed) stop(e.columns.states[body]);
    objects.for_each_joint(body,
                           [&](uint32_t joint, uint32_t) { list_joint(objects, e.active, joint); });
    wake_touching(e.activity, body);
}

void refresh(const Editing& e) {
    // Refreshing a shape marks its body, and refreshing a mass may mark its placement. So shapes
    // come first, then bodies until the list is empty.
    for (size_t i = 0; i < e.active.edited_shapes.size(); ++i) {
        const uint32_t shape = e.active.edited_shapes[i];
        if (!e.objects.shapes[shape].listed) continue;  // destroyed since
        e.objects.shapes[shape].listed = false;
        refresh_shape(e, shape);
    }
    e.active.edited_shapes.clear();
    for (size_t i = 0; i < e.active.edited_bodies.size(); ++i) {
        const uint32_t body = e.active.edited_bodies[i];
        if (!e.objects.bodies[body].listed) continue;
        refresh_mass(e, body);
        refresh_placement(e, body);
        e.objects.bodies[body].may_be_crowded = may_be_crowded(e.objects, body);
        e.objects.bodies[body].listed = false;
    }
    e.active.edited_bodies.clear();
}

void refresh_shape(const Editing& e, uint32_t shape) {
    ObjectState& objects = e.objects;
    ShapeRecord& record = objects.shapes[shape];
    if (!record.geometry_dirty) return;
    record.geometry_dirty = false;
    ++record.rebuilds;
    if (!objects.is_solid(shape)) {
        rebuild_parts(e, shape);
        return;
    }
    ShapeForm& form = objects.forms[shape];
    const float radius_before = form.radius;
    Vec2* local = &objects.pool.local[form.begin];
    switch (record.type) {
        case ShapeType::circle:
            local[0] = record.figure.as<Circle>().center;
            form.radius = record.figure.as<Circle>().radius;
            break;
        case ShapeType::box:
            box_corners(record.figure.as<Box>(), local);
            form.radius = fitting_rounding(record.figure.as<Box>());
            break;
        case ShapeType::segment:
            local[0] = record.figure.as<Segment>().from;
            local[1] = kept_apart(record.figure.as<Segment>().to, local[0]);
            form.radius = record.figure.as<Segment>().rounding;
            break;
        case ShapeType::ellipse:
            write_ellipse(record.figure.as<Ellipse>(), form.begin, objects.pool);
            form.radius = 0.0f;
            break;
        default:
            // Its vertices are already in `objects.pool`. A piece has no rounding.
            form.radius = record.owner == none ? record.figure.as<PolygonFigure>().rounding : 0.0f;
            break;
    }
    write_normals({local, form.count}, objects.pool.normals.data() + form.begin);
    // A large polygon must be centered again.
    objects.pool.vertices[form.begin] = {infinity, infinity};
    record.set_moments(record.type == ShapeType::ellipse
                           ? moments_of(record.figure.as<Ellipse>())
                           : moments_of({local, form.count}, form.radius));
    if (form.radius != radius_before || record.type == ShapeType::ellipse)
        remix_shape(objects, e.settings, shape);  // for the rolling resistance
    if (form.body == none) place_shape(objects, e.broad_phase.boxes, shape, {}, 0.0f);
}

namespace {

/// The mass of the shapes of a body, and their mean point weighted by mass.
struct ShapeMass {
    double mass = 0.0, x = 0.0, y = 0.0;
};

ShapeMass mass_of_shapes(const ObjectState& objects, const BodyRecord& body) {
    ShapeMass sum;
    for (uint32_t s = body.lists.first_shape; s != none; s = objects.shapes[s].next) {
        if (objects.shapes[s].owner != none) continue;  // parts are processed with their owner
        const ShapeRecord& shape = objects.shapes[s];
        const double part = double(shape.area) * double(shape.surface.density);
        sum.mass += part;
        sum.x += part * double(shape.centroid.x);
        sum.y += part * double(shape.centroid.y);
    }
    sum.x = sum.mass > 0.0 ? sum.x / sum.mass : 0.0;
    sum.y = sum.mass > 0.0 ? sum.y / sum.mass : 0.0;
    return sum;
}

/// The inertia of the shapes about a point (body coordinates).
double inertia_about(const ObjectState& objects, const BodyRecord& body, double x, double y) {
    double inertia = 0.0;
    for (uint32_t s = body.lists.first_shape; s != none; s = objects.shapes[s].next) {
        const ShapeRecord& shape = objects.shapes[s];
        if (shape.owner != none) continue;
        const double dx = double(shape.centroid.x) - x, dy = double(shape.centroid.y) - y;
        inertia += double(shape.surface.density) *
                   (double(shape.moment) + double(shape.area) * (dx * dx + dy * dy));
    }
    return inertia;
}

/// Lines have no area. A body that has only lines is a wire: its mass is distributed along them.
struct Wire {
    double length = 0.0, x = 0.0, y = 0.0;

    Wire(const ObjectState& objects, const BodyRecord& body) {
        for_each_line(objects, body, [&](Vec2 a, Vec2 b, double l) {
            length += l;
            x += 0.5 * l * (double(a.x) + double(b.x));
            y += 0.5 * l * (double(a.y) + double(b.y));
        });
        x = length > 0.0 ? x / length : 0.0;
        y = length > 0.0 ? y / length : 0.0;
    }
    /// The square of the radius of gyration about a point (body coordinates), m².
    static double gyration(const ObjectState& objects, const BodyRecord& body, double at_x,
                           double at_y) {
        double length = 0.0, moment = 0.0;
        for_each_line(objects, body, [&](Vec2 a, Vec2 b, double l) {
            const double dx = 0.5 * (double(a.x) + double(b.x)) - at_x,
                         dy = 0.5 * (double(a.y) + double(b.y)) - at_y;
            length += l;
            moment += l * (l * l / 12.0 + dx * dx + dy * dy);
        });
        return length > 0.0 ? moment / length : 0.0;
    }

  private:
    static void for_each_line(const ObjectState& objects, const BodyRecord& body, auto&& visit) {
        for (uint32_t s = body.lists.first_shape; s != none; s = objects.shapes[s].next) {
            const ShapeForm& form = objects.forms[s];
            if (objects.shapes[s].type != ShapeType::segment || form.radius > 0.0f) continue;
            const Vec2 a = objects.pool.local[form.begin], b = objects.pool.local[form.begin + 1];
            const double x = double(b.x) - double(a.x), y = double(b.y) - double(a.y);
            visit(a, b, std::sqrt(x * x + y * y));
        }
    }
};

/// Stores how far the solid shapes reach from a point (body coordinates), and how thin they are.
void measure_shapes(const ObjectState& objects, Vec2 center, BodyRecord& body) {
    float extent = 0.0f, thickness = infinity;
    for (uint32_t s = body.lists.first_shape; s != none; s = objects.shapes[s].next) {
        if (!objects.is_solid(s)) continue;
        const ShapeForm& form = objects.forms[s];
        for (uint32_t i = form.begin; i < form.begin + form.count; ++i)
            extent = max(extent, length(objects.pool.local[i] - center) + form.radius);
        if (form.kind == FormKind::ellipse) {
            const Ellipse ellipse = objects.shapes[s].figure.as<Ellipse>();
            extent += max(ellipse.radius_x, ellipse.radius_y);
        }
        thickness = min(thickness, inner_radius(objects, s));
    }
    body.extent = extent;
    body.thickness = thickness == infinity ? 0.0f : thickness;
}

}  // namespace

void refresh_edited_mass(const Editing& e, uint32_t body) {
    ObjectState& objects = e.objects;
    BodyRecord& record = objects.bodies[body];
    for (uint32_t s = record.lists.first_shape; s != none; s = objects.shapes[s].next)
        refresh_shape(e, s);
    if (!record.flags.mass_dirty) return;
    record.flags.mass_dirty = false;
    ++record.rebuilds;

    auto [mass, cx, cy] = mass_of_shapes(objects, record);
    const bool weightless = !(mass > 0.0);
    const bool is_wire = weightless && record.type == BodyType::dynamic_body;
    if (is_wire) {
        const Wire wire(objects, record);
        cx = wire.x;
        cy = wire.y;
    }
    if (is_given(record.given.center.x)) {
        cx = record.given.center.x;
        cy = record.given.center.y;
    } else if (record.type == BodyType::kinematic_body) {
        // It turns about its position: a door about its hinge, a flipper about its pin.
        cx = cy = 0.0;
    }
    const Vec2 local_center = {float(cx), float(cy)};
    // Only bodies that move need their size, and a static body may have many shapes.
    const bool is_static = record.type == BodyType::static_body;
    if (is_static)
        record.extent = record.thickness = 0.0f;
    else
        measure_shapes(objects, local_center, record);
    double inertia = inertia_about(objects, record, cx, cy);
    if (is_given(record.given.mass)) {
        const double wanted = double(record.given.mass);
        if (std::isfinite(wanted)) inertia = weightless ? 0.0 : inertia * (wanted / mass);
        mass = wanted;
    } else if (weightless && record.type == BodyType::dynamic_body) {
        mass = 1.0;
    }
    if (is_wire && std::isfinite(mass)) inertia = mass * Wire::gyration(objects, record, cx, cy);
    if (is_given(record.given.inertia)) inertia = double(record.given.inertia);

    const BodyState& state = e.columns.states[body];
    const Vec2 old_local_center = record.local_center;
    record.mass = float(mass);
    record.inertia = float(inertia);
    record.local_center = local_center;
    const Rotation q = {state.cosine, state.sine};
    record.center = state.position + rotate(q, record.local_center);
    // The motion of the body does not change, but its velocity refers to another point now.
    const Vec2 drift =
        cross(state.angular_velocity, rotate(q, record.local_center - old_local_center));
    e.columns.states[body].velocity = bounded(state.velocity + drift, 1e30f);
    if (!is_static || record.local_center.x != old_local_center.x ||
        record.local_center.y != old_local_center.y)
        mark_placement(objects, e.active, body);
    update_mobility(e, body);
    const bool moves = record.mobility == Mobility::dynamic;
    record.inverse_mass =
        moves && !(record.flags.locked_x && record.flags.locked_y) ? bounded_inverse(mass) : 0.0f;
    record.inverse_inertia =
        moves && !record.flags.locked_rotation ? bounded_inverse(inertia) : 0.0f;
    objects.for_each_joint(body, [&](uint32_t joint, uint32_t side) {
        mark_joints(objects, e.active, objects.joints[joint].bodies[side ^ 1]);
    });
}

void teleport(const Activity& activity, uint32_t body, const Position& position, float angle) {
    wake_for_edit(activity, body);
    wake_touching(activity, body);
    BodyState& state = activity.columns.states[body];
    BodyRecord& record = activity.objects.bodies[body];
    state.position = position;
    if (state.angle != angle) {
        const Rotation q = rotation_of(angle);
        state.angle = angle;
        state.cosine = q.c;
        state.sine = q.s;
        record.angle_rest = 0.0f;
    }
    activity.columns.previous[body] = {position, angle};
    record.center = position + rotate({state.cosine, state.sine}, record.local_center);
    mark_placement(activity.objects, activity.active, body);
}

}  // namespace fettle::physics::detail
