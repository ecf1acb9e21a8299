#include <collision/large_polygon.h>
#include <fettle/physics/hull.h>
#include <geometry/growth.h>
#include <geometry/trigonometry.h>
#include <world/world_data.h>

#include <algorithm>

// Birth and death in slots. A slot keeps its place until its object dies; every object gets a
// generation that no other ever had in this world.

namespace fettle::physics::detail {

/// Body 0 is the world's own: it carries the four half-planes of the bounds in shapes 0 to 3.
void WorldData::make_border() {
    BodyDef def;
    def.type = BodyType::static_body;
    create_body(def);
    for (uint32_t side = 0; side < 4; ++side) {
        forms.emplace_back();
        shapes.emplace_back();
        boxes.emplace_back();
        fat_boxes.emplace_back();
        paired_boxes.push_back(no_box);
        shape_generations.push_back(new_generation());
        forms[side] = {side, 0, FormKind::border, 0.0f, 0, {}};
        shapes[side].type = ShapeType::border;
    }
    body_slots.count = 0;
    apply_bounds();
}

void WorldData::apply_bounds() {
    wake_all(activity());
    for (uint32_t side = 0; side < 4; ++side) {
        shapes[side].surface.friction = settings.bounds_friction;
        shapes[side].surface.restitution = settings.bounds_restitution;
        remix_shape(*this, settings, side);
        if (!settings.bounds) {
            destroy_contacts_of_shape(contact_list(), side);
            continue;
        }
        const float far = 2.0f * greatest_coordinate;
        const Aabb& b = *settings.bounds;
        Box4 box = {{-far, -far}, {far, far}};
        if (side == 0) box.high.x = b.min.x();
        if (side == 1) box.low.x = b.max.x();
        if (side == 2) box.high.y = b.min.y();
        if (side == 3) box.low.y = b.max.y();
        boxes[side] = fat_boxes[side] = paired_boxes[side] = box;
    }
    if (!settings.bounds) return;
    for (uint32_t shape = 4; shape < shapes.size(); ++shape) {
        if (shape_generations[shape] != 0 && forms[shape].body != none) mark_moved(shape);
    }
}

uint32_t WorldData::create_body(const BodyDef& def) {
    uint32_t slot = body_slots.free;
    if (slot != none) {
        body_slots.free = bodies[slot].next;
        bodies[slot] = BodyRecord();
        states[slot] = {};
    } else {
        slot = uint32_t(bodies.size());
        make_room_in_each(bodies, states, previous, body_generations);
        bodies.emplace_back();
        states.emplace_back();
        previous.emplace_back();
        body_generations.push_back(0);
    }
    body_generations[slot] = new_generation();
    ++body_slots.count;

    BodyRecord& record = bodies[slot];
    record.type = def.type;
    record.gravity_scale = def.gravity_scale;
    record.linear_damping = def.linear_damping;
    record.angular_damping = def.angular_damping;
    record.force = to_v2(def.force);
    record.torque = def.torque;
    record.locked_x = def.locked_x;
    record.locked_y = def.locked_y;
    record.locked_rotation = def.locked_rotation;
    record.can_sleep = def.can_sleep;
    record.bullet = def.bullet;
    record.given_mass = def.mass.value_or(not_given);
    record.given_inertia = def.inertia.value_or(not_given);
    if (def.center) record.given_center = record.local_center = to_v2(*def.center);
    record.user_data = def.user_data;

    BodyState& state = states[slot];
    const Rotation q = rotation_of(def.angle);
    state.position = def.position;
    state.angle = def.angle;
    state.cosine = q.c;
    state.sine = q.s;
    previous[slot] = {def.position, def.angle};
    record.center = to_v2(def.position) + rotate(q, record.local_center);
    mark_mass(slot);
    refresh_mass(slot);  // finds its mobility: no shapes yet, nothing else to compute
    record.rebuilds = 0;
    if (record.mobility != Mobility::fixed) {
        state.velocity = def.velocity;
        state.angular_velocity = def.angular_velocity;
        if (!def.awake && settings.sleeping) {
            // No sleep event for what was never awake: straight into an island of its own.
            const uint32_t only[1] = {slot};
            remove_awake(*this, *this, slot);
            put_to_sleep(activity(), only);
            event_sink().slept.pop_back();
            record.never_awake = true;
            state.velocity = def.velocity;  // kept until it wakes
            state.angular_velocity = def.angular_velocity;
        }
    }
    return slot;
}

void WorldData::destroy_body(uint32_t body) {
    wake_for_edit(body);
    wake_touching(activity(), body);
    while (bodies[body].first_joint != none) destroy_joint(bodies[body].first_joint >> 1);
    destroy_contacts_of_body(contact_list(), body);
    while (bodies[body].first_shape != none) destroy_shape(bodies[body].first_shape);
    if (bodies[body].solver_index != 0) remove_awake(*this, *this, body);
    leave_island(*this, body);
    bodies[body] = BodyRecord();
    bodies[body].next = body_slots.free;
    body_slots.free = body;
    body_generations[body] = 0;
    --body_slots.count;
}

uint32_t WorldData::create_shape(const ShapeDef& def, const Geometry& geometry) {
    // The hull first: a polygon that is none must leave nothing behind. Callers have checked that
    // it is one.
    std::vector<Vec2> hull;
    const Polygon* polygon = std::get_if<Polygon>(&geometry);
    if (polygon && convex_hull(polygon->vertices, hull) != HullStatus::ok) return none;

    const uint32_t slot = new_shape();
    ++shape_slots.count;
    shapes[slot].surface = def;
    set_form(slot, geometry, hull);
    return slot;
}

uint32_t WorldData::new_shape() {
    uint32_t slot = shape_slots.free;
    if (slot != none) {
        shape_slots.free = shapes[slot].next;
        const bool listed = shapes[slot].moved;
        shapes[slot] = {};
        shapes[slot].moved = listed;
        forms[slot] = {};
    } else {
        slot = uint32_t(shapes.size());
        make_room_in_each(shapes, forms, boxes, fat_boxes, paired_boxes, shape_generations);
        shapes.emplace_back();
        forms.emplace_back();
        boxes.emplace_back();
        fat_boxes.emplace_back();
        paired_boxes.push_back(no_box);
        shape_generations.push_back(0);
    }
    shape_generations[slot] = new_generation();
    return slot;
}

/// Room for that many in the pool; what was there is lost where it moves.
void WorldData::reserve_vertices(uint32_t slot, uint32_t count) {
    const uint32_t capacity = VertexPool::capacity_for(count);
    if (capacity == shapes[slot].capacity) return;
    pool.release(forms[slot].begin, shapes[slot].capacity);
    forms[slot].begin = pool.allocate(capacity);
    shapes[slot].capacity = capacity;
}

/// Takes over a geometry of any type; `hull` is that of a polygon's vertices.
void WorldData::set_form(uint32_t slot, const Geometry& geometry, const std::vector<Vec2>& hull) {
    ShapeRecord& record = shapes[slot];
    drop_parts(slot, none);
    record.outline = 0;
    FormKind kind = FormKind::convex;
    uint32_t count = 0, room = 0;
    std::span<const Vec2> outline;
    if (const Circle* circle = std::get_if<Circle>(&geometry)) {
        record.type = ShapeType::circle;
        record.figure.become(*circle);
        count = 1;
    } else if (const Box* box = std::get_if<Box>(&geometry)) {
        record.type = ShapeType::box;
        record.figure.become(*box);
        count = 4;
    } else if (const Segment* segment = std::get_if<Segment>(&geometry)) {
        record.type = ShapeType::segment;
        record.figure.become(*segment);
        count = 2;
    } else if (const Polygon* polygon = std::get_if<Polygon>(&geometry)) {
        record.type = ShapeType::polygon;
        record.figure.become(PolygonFigure{polygon->rounding});
        count = uint32_t(hull.size());
        if (count > uint32_t(most_small_vertices)) kind = FormKind::large;
    } else if (const Ellipse* ellipse = std::get_if<Ellipse>(&geometry)) {
        record.type = ShapeType::ellipse;
        record.figure.become(*ellipse);
        kind = FormKind::ellipse;
        count = 1;
        room = 2;  // its axes
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
    // It collides no more as what it was.
    if (forms[slot].kind != kind && forms[slot].body != none) {
        destroy_contacts_of_shape(contact_list(), slot);
        if (kind == FormKind::outline) remove_proxy(slot);
    }
    forms[slot].kind = kind;
    forms[slot].count = count;
    if (kind == FormKind::outline) {
        boxes[slot] = fat_boxes[slot] = no_box;
        forms[slot].radius = 0.0f;
        write_outline(slot, outline);
        return;
    }
    reserve_vertices(slot, std::max(count, room));
    if (record.type == ShapeType::polygon) {
        for (uint32_t i = 0; i < count; ++i) pool.local[forms[slot].begin + i] = to_v2(hull[i]);
    }
    mark_geometry(slot);
}

void WorldData::destroy_shape(uint32_t shape) {
    if (forms[shape].body != none) detach_shape(shape);
    drop_parts(shape, none);
    if (shapes[shape].owner == none) --shape_slots.count;
    pool.release(forms[shape].begin, shapes[shape].capacity);
    const bool listed = shapes[shape].moved;
    shapes[shape] = {};
    shapes[shape].moved = listed;  // once is enough, whoever comes into the slot
    forms[shape] = {};
    shapes[shape].next = shape_slots.free;
    shape_slots.free = shape;
    shape_generations[shape] = 0;
}

void WorldData::attach_shape(uint32_t shape, uint32_t body) {
    if (forms[shape].body != none) detach_shape(shape);
    if (!bodies[body].never_awake) wake_for_edit(body);
    link_shape(shape, body);
    if (!is_solid(shape)) for_each_solid(shape, [&](uint32_t part) { link_shape(part, body); });
    mark_mass(body);
    mark_placement(body);
}

void WorldData::link_shape(uint32_t shape, uint32_t body) {
    ShapeRecord& record = shapes[shape];
    BodyRecord& owner = bodies[body];
    forms[shape].body = body;
    record.previous = owner.last_shape;
    record.next = none;
    if (owner.last_shape != none)
        shapes[owner.last_shape].next = shape;
    else
        owner.first_shape = shape;
    owner.last_shape = shape;
}

void WorldData::detach_shape(uint32_t shape) {
    const uint32_t body = forms[shape].body;
    wake_for_edit(body);
    wake_touching(activity(), body);
    destroy_contacts_of_shape(contact_list(), shape);
    for_each_solid(shape, [&](uint32_t solid) { unlink_shape(solid); });
    if (!is_solid(shape)) unlink_shape(shape);
    mark_mass(body);
    mark_placement(body);
    // Alone, its box is in its own coordinates again.
    for_each_solid(shape, [&](uint32_t solid) { place_shape(*this, boxes, solid, {}); });
}

/// It has no contacts any more.
void WorldData::unlink_shape(uint32_t shape) {
    remove_proxy(shape);
    ShapeRecord& record = shapes[shape];
    BodyRecord& owner = bodies[forms[shape].body];
    if (record.previous != none)
        shapes[record.previous].next = record.next;
    else
        owner.first_shape = record.next;
    if (record.next != none)
        shapes[record.next].previous = record.previous;
    else
        owner.last_shape = record.previous;
    record.previous = record.next = none;
    forms[shape].body = none;
}

}  // namespace fettle::physics::detail
