#include <collision/large_polygon.h>
#include <contacts/mixing.h>
#include <edits/edits.h>
#include <fettle/physics/hull.h>
#include <geometry/make_room.h>
#include <geometry/trigonometry.h>
#include <state/active_lists.h>
#include <state/limits.h>
#include <state/place_shape.h>
#include <state/segment_surfaces.h>

#include <algorithm>

// Objects are created and destroyed in slots. An object keeps its slot until it is destroyed. No
// other object of this world ever has the same generation in that slot.

namespace fettle::physics::detail {
namespace {

void link_shape(ObjectState& objects, uint32_t shape, uint32_t body) {
    ShapeRecord& record = objects.shapes[shape];
    BodyRecord& owner = objects.bodies[body];
    objects.forms[shape].body = body;
    record.previous = owner.lists.last_shape;
    record.next = none;
    if (owner.lists.last_shape != none)
        objects.shapes[owner.lists.last_shape].next = shape;
    else
        owner.lists.first_shape = shape;
    owner.lists.last_shape = shape;
}

}  // namespace

void make_border(const Editing& e) {
    ObjectState& objects = e.objects;
    BodyDef def;
    def.type = BodyType::static_body;
    create_body(e, def);
    for (uint32_t side = 0; side < border_sides; ++side) {
        objects.forms.emplace_back();
        objects.shapes.emplace_back();
        e.broad_phase.boxes.emplace_back();
        e.broad_phase.fat_boxes.emplace_back();
        e.broad_phase.paired_boxes.push_back(no_box);
        e.columns.shape_generations.push_back(e.generations.create());
        objects.forms[side] = ShapeForm{side, 0, FormKind::border, 0.0f, 0, {}};
        objects.shapes[side].type = ShapeType::border;
    }
    objects.body_slots.count = 0;
    apply_bounds(e);
}

void apply_bounds(const Editing& e) {
    wake_all(e.activity);
    for (uint32_t side = 0; side < border_sides; ++side) {
        e.objects.shapes[side].surface.friction = e.settings.bounds_friction;
        e.objects.shapes[side].surface.restitution = e.settings.bounds_restitution;
        remix_shape(e.objects, e.settings, side);
        if (!e.settings.bounds) {
            destroy_contacts_of_shape(e.contacts, side);
            continue;
        }
        const float far = 2.0f * greatest_coordinate;
        const Box4 b = box_of(*e.settings.bounds);
        Box4 box = {{-far, -far}, {far, far}};
        if (side == 0) box.high.x = b.low.x;
        if (side == 1) box.low.x = b.high.x;
        if (side == 2) box.high.y = b.low.y;
        if (side == 3) box.low.y = b.high.y;
        e.broad_phase.boxes[side] = e.broad_phase.fat_boxes[side] =
            e.broad_phase.paired_boxes[side] = box;
    }
    if (!e.settings.bounds) return;
    drop_kept_manifolds(e.objects, 0);
    for (uint32_t shape = border_sides; shape < e.objects.shapes.size(); ++shape) {
        if (e.columns.shape_generations[shape] != 0 && e.objects.forms[shape].body != none)
            mark_moved(e.objects, e.broad_phase, shape);
    }
}

void make_room_for_body(const Editing& e) {
    if (e.objects.body_slots.free == none)
        make_room_in_each(e.objects.bodies, e.objects.rest_poses, e.columns.states,
                          e.columns.previous, e.columns.body_generations);
    make_room_in_each(e.active.awake_bodies, e.active.edited_bodies);
}

void make_room_for_shape(const Editing& e, const Geometry& geometry) {
    ObjectState& objects = e.objects;
    if (objects.shape_slots.free == none)
        make_room_in_each(objects.shapes, objects.forms, e.broad_phase.boxes,
                          e.broad_phase.fat_boxes, e.broad_phase.paired_boxes,
                          e.columns.shape_generations);
    make_room_in_each(e.active.edited_shapes, e.active.edited_bodies);
    size_t vertices = 4;
    if (const Polygon* polygon = std::get_if<Polygon>(&geometry))
        vertices = polygon->vertices.size();
    if (const Concave* concave = std::get_if<Concave>(&geometry))
        vertices = concave->vertices.size();
    if (const Chain* chain = std::get_if<Chain>(&geometry)) vertices = chain->points.size();
    objects.pool.make_room_for(VertexPool::capacity_for(uint32_t(vertices)));
}

uint32_t create_body(const Editing& e, const BodyDef& def) {
    const uint32_t slot =
        e.objects.body_slots.allocate(e.objects.bodies, e.objects.rest_poses, e.columns.states,
                                      e.columns.previous, e.columns.body_generations);
    e.columns.body_generations[slot] = e.generations.create();

    BodyRecord& record = e.objects.bodies[slot];
    record.type = def.type;
    record.gravity_scale = def.gravity_scale;
    record.linear_damping = def.linear_damping;
    record.angular_damping = def.angular_damping;
    record.load.force = def.force;
    record.load.torque = def.torque;
    record.flags.locked_x = def.locked_x;
    record.flags.locked_y = def.locked_y;
    record.flags.locked_rotation = def.locked_rotation;
    record.flags.can_sleep = def.can_sleep;
    record.flags.bullet = def.bullet;
    e.objects.bullets += def.bullet;
    record.given.mass = def.mass.value_or(not_given);
    record.given.inertia = def.inertia.value_or(not_given);
    if (def.center) record.given.center = record.local_center = *def.center;
    record.user_data = def.user_data;
    record.flags.disabled = !def.enabled;
    if (def.sleep_speed || def.max_speed < infinity) {
        BodyTraits& traits = traits_of(e.objects, slot);
        traits.sleep_speed = def.sleep_speed.value_or(not_given);
        traits.max_speed = def.max_speed;
    }
    set_name(e.objects, slot, def.name);

    BodyState& state = e.columns.states[slot];
    const Rotation q = rotation_of(def.angle);
    state.position = def.position;
    state.angle = def.angle;
    state.cosine = q.c;
    state.sine = q.s;
    e.columns.previous[slot] = {def.position, def.angle};
    record.center = def.position + rotate(q, record.local_center);
    mark_mass(e.objects, e.active, slot);
    refresh_mass(e, slot);  // sets its mobility; the body has no shapes yet
    record.rebuilds = 0;
    if (record.mobility != Mobility::fixed || keeps_motion(record)) {
        state.velocity = def.velocity;
        state.angular_velocity = def.angular_velocity;
        if (record.flags.disabled) return slot;
        if (!def.awake && e.settings.sleeping) {
            // A body that was never awake causes no sleep event and gets an island of its own at
            // once.
            const uint32_t only[1] = {slot};
            remove_awake(e.objects, e.active, slot);
            put_to_sleep(e.activity, only, e.objects.island_slots.allocate(e.objects.islands));
            e.activity.events.slept.pop_back();
            record.flags.never_awake = true;
            state.velocity = def.velocity;  // stored until it wakes
            state.angular_velocity = def.angular_velocity;
        }
    }
    return slot;
}

void destroy_body(const Editing& e, uint32_t body) {
    ObjectState& objects = e.objects;
    wake_for_edit(e.activity, body);
    wake_touching(e.activity, body);
    while (objects.bodies[body].lists.first_joint != none)
        destroy_joint(e, objects.bodies[body].lists.first_joint >> 1);
    destroy_contacts_of_body(e.contacts, body);
    while (objects.bodies[body].lists.first_shape != none)
        destroy_shape(e, objects.bodies[body].lists.first_shape);
    if (objects.bodies[body].solver_index != 0) remove_awake(objects, e.active, body);
    leave_island(objects, body);
    if (objects.bodies[body].traits != none)
        objects.trait_slots.release(objects.traits, objects.bodies[body].traits);
    objects.kinematic_bodies -= objects.bodies[body].mobility == Mobility::kinematic;
    objects.bullets -= objects.bodies[body].flags.bullet;
    objects.body_slots.release(objects.bodies, body);
    e.columns.body_generations[body] = 0;
}

uint32_t create_shape(const Editing& e, const ShapeDef& def, const Geometry& geometry) {
    // The hull is computed first, because an invalid polygon must change nothing. Callers have
    // checked that it is valid.
    std::vector<Vec2> hull;
    const Polygon* polygon = std::get_if<Polygon>(&geometry);
    if (polygon && convex_hull(polygon->vertices, hull) != HullStatus::ok) return none;

    const uint32_t slot = new_shape(e);
    e.objects.shapes[slot].surface = def;
    e.objects.sensors += def.sensor;
    set_form(e, slot, geometry, hull);
    return slot;
}

uint32_t new_shape(const Editing& e) {
    ObjectState& objects = e.objects;
    Slots& slots = objects.shape_slots;
    const bool listed = slots.free != none && objects.shapes[slots.free].moved;
    const uint32_t slot =
        slots.allocate(objects.shapes, objects.forms, e.broad_phase.boxes, e.broad_phase.fat_boxes,
                       e.broad_phase.paired_boxes, e.columns.shape_generations);
    objects.shapes[slot].moved = listed;
    e.broad_phase.paired_boxes[slot] = no_box;
    e.columns.shape_generations[slot] = e.generations.create();
    return slot;
}

void reserve_vertices(ObjectState& objects, uint32_t slot, uint32_t count) {
    const uint32_t capacity = VertexPool::capacity_for(count);
    if (capacity == objects.shapes[slot].capacity) return;
    objects.pool.release(objects.forms[slot].begin, objects.shapes[slot].capacity);
    objects.forms[slot].begin = objects.pool.allocate(capacity);
    objects.shapes[slot].capacity = capacity;
}

void set_form(const Editing& e, uint32_t slot, const Geometry& geometry,
              const std::vector<Vec2>& hull) {
    ObjectState& objects = e.objects;
    ShapeRecord& record = objects.shapes[slot];
    drop_parts(e, slot, none);
    if (!std::holds_alternative<Chain>(geometry)) remove_segment_surfaces(objects, slot);
    record.outline = 0;
    FormKind kind = FormKind::convex;
    uint32_t count = 0, room = 0;
    std::span<const Vec2> outline;
    const auto become = [&](const auto* figure, ShapeType type, uint32_t vertices) {
        if (figure == nullptr) return;
        record.type = type;
        record.figure.become(*figure);
        count = vertices;
    };
    become(std::get_if<Circle>(&geometry), ShapeType::circle, 1);
    become(std::get_if<Box>(&geometry), ShapeType::box, 4);
    become(std::get_if<Segment>(&geometry), ShapeType::segment, 2);
    become(std::get_if<Ellipse>(&geometry), ShapeType::ellipse, 1);
    if (std::holds_alternative<Ellipse>(geometry)) {
        kind = FormKind::ellipse;
        room = 2;  // two entries: see collision/ellipse.h
    }
    if (const Polygon* polygon = std::get_if<Polygon>(&geometry)) {
        record.type = ShapeType::polygon;
        record.figure.become(PolygonFigure{polygon->rounding});
        count = uint32_t(hull.size());
        if (count > uint32_t(most_small_vertices)) kind = FormKind::large;
    } else if (const Concave* concave = std::get_if<Concave>(&geometry)) {
        record.type = ShapeType::concave;
        kind = FormKind::outline;
        outline = concave->vertices;
    } else if (const Chain* chain = std::get_if<Chain>(&geometry)) {
        record.type = ShapeType::chain;
        record.closed = chain->closed;
        kind = FormKind::outline;
        outline = chain->points;
    }
    // The old contacts belonged to another kind of form.
    if (objects.forms[slot].kind != kind && objects.forms[slot].body != none) {
        destroy_contacts_of_shape(e.contacts, slot);
        if (kind == FormKind::outline) remove_proxy(objects, e.broad_phase, slot);
    }
    objects.forms[slot].kind = kind;
    objects.forms[slot].count = count;
    if (kind == FormKind::outline) {
        e.broad_phase.boxes[slot] = e.broad_phase.fat_boxes[slot] = no_box;
        objects.forms[slot].radius = 0.0f;
        write_outline(objects, e.active, slot, outline);
        if (objects.forms[slot].body != none) refresh_shape(e, slot);
        return;
    }
    reserve_vertices(objects, slot, std::max(count, room));
    if (record.type == ShapeType::polygon) {
        for (uint32_t i = 0; i < count; ++i)
            objects.pool.local[objects.forms[slot].begin + i] = hull[i];
    }
    mark_geometry(objects, e.active, slot);
}

void destroy_shape(const Editing& e, uint32_t shape) {
    ObjectState& objects = e.objects;
    if (objects.forms[shape].body != none) detach_shape(e, shape);
    drop_parts(e, shape, none);
    remove_segment_surfaces(objects, shape);
    objects.pool.release(objects.forms[shape].begin, objects.shapes[shape].capacity);
    const bool part = objects.shapes[shape].owner != none;
    const bool listed = objects.shapes[shape].moved;
    objects.sensors -= !part && objects.shapes[shape].surface.sensor;
    objects.set_crowded(shape, false);
    objects.shape_slots.release(objects.shapes, shape);
    objects.shape_slots.count += part;     // parts are not counted
    objects.shapes[shape].moved = listed;  // also for the next shape in the slot
    objects.forms[shape] = ShapeForm{};
    e.columns.shape_generations[shape] = 0;
}

void attach_shape(const Editing& e, uint32_t shape, uint32_t body) {
    if (e.objects.forms[shape].body != none) detach_shape(e, shape);
    // Not later: the slots of the parts, and with them the order of pairs, must not depend on when
    // the world is read.
    if (!e.objects.is_solid(shape)) refresh_shape(e, shape);
    if (!e.objects.bodies[body].flags.never_awake) wake_for_edit(e.activity, body);
    link_shape(e.objects, shape, body);
    if (!e.objects.is_solid(shape))
        e.objects.for_each_solid(shape, [&](uint32_t part) { link_shape(e.objects, part, body); });
    mark_mass(e.objects, e.active, body);
    mark_placement(e.objects, e.active, body);
}

void detach_shape(const Editing& e, uint32_t shape) {
    const uint32_t body = e.objects.forms[shape].body;
    wake_for_edit(e.activity, body);
    wake_touching(e.activity, body);
    destroy_contacts_of_shape(e.contacts, shape);
    e.objects.for_each_solid(
        shape, [&](uint32_t solid) { unlink_shape(e.objects, e.broad_phase, solid); });
    if (!e.objects.is_solid(shape)) unlink_shape(e.objects, e.broad_phase, shape);
    mark_mass(e.objects, e.active, body);
    mark_placement(e.objects, e.active, body);
    // Without a body, its boxes are in its own coordinates again.
    e.objects.for_each_solid(shape, [&](uint32_t solid) {
        place_shape(e.objects, e.broad_phase.boxes, solid, {}, 0.0f);
    });
}

/// Must be called when the shape has no contacts any more.
void unlink_shape(ObjectState& objects, BroadPhaseState& broad_phase, uint32_t shape) {
    remove_proxy(objects, broad_phase, shape);
    ShapeRecord& record = objects.shapes[shape];
    BodyRecord& owner = objects.bodies[objects.forms[shape].body];
    if (record.previous != none)
        objects.shapes[record.previous].next = record.next;
    else
        owner.lists.first_shape = record.next;
    if (record.next != none)
        objects.shapes[record.next].previous = record.previous;
    else
        owner.lists.last_shape = record.previous;
    record.previous = record.next = none;
    objects.forms[shape].body = none;
}

}  // namespace fettle::physics::detail
