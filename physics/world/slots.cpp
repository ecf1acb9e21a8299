#include <fettle/physics/hull.h>
#include <geometry/trigonometry.h>
#include <world/world_data.h>

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
        shape_generations.push_back(next_generation++);
        forms[side] = {side, 0, FormKind::border, 0.0f, 0, {}};
        shapes[side].type = ShapeType::border;
    }
    body_count = 0;
    apply_bounds();
}

void WorldData::apply_bounds() {
    wake_all();
    for (uint32_t side = 0; side < 4; ++side) {
        shapes[side].surface.friction = settings.bounds_friction;
        shapes[side].surface.restitution = settings.bounds_restitution;
        remix_shape(side);
        if (!settings.bounds) {
            destroy_contacts_of_shape(side);
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

BorderPlane WorldData::border_plane(uint32_t side) const {
    const Aabb& bounds = *settings.bounds;
    switch (side) {
        case 0:
            return {{1.0f, 0.0f}, bounds.min.x()};
        case 1:
            return {{-1.0f, 0.0f}, -bounds.max.x()};
        case 2:
            return {{0.0f, 1.0f}, bounds.min.y()};
        default:
            return {{0.0f, -1.0f}, -bounds.max.y()};
    }
}

uint32_t WorldData::create_body(const BodyDef& def) {
    uint32_t slot = free_body;
    if (slot != none) {
        free_body = bodies[slot].next_free;
        bodies[slot] = {};
        states[slot] = {};
    } else {
        slot = uint32_t(bodies.size());
        bodies.emplace_back();
        states.emplace_back();
        previous.emplace_back();
        body_generations.push_back(0);
    }
    body_generations[slot] = next_generation++;
    ++body_count;

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
    record.mass_override = def.mass;
    record.inertia_override = def.inertia;
    if (def.center) record.center_override = to_v2(*def.center);
    record.user_data = def.user_data;

    BodyState& state = states[slot];
    const Rotation q = rotation_of(def.angle);
    state.position = def.position;
    state.angle = def.angle;
    state.cosine = q.c;
    state.sine = q.s;
    previous[slot] = {def.position, def.angle};
    record.local_center = record.center_override.value_or(V2{});
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
            remove_awake(slot);
            put_to_sleep(only);
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
    wake_touching(body);
    while (bodies[body].first_joint != none) destroy_joint(bodies[body].first_joint >> 1);
    while (bodies[body].first_shape != none) destroy_shape(bodies[body].first_shape);
    if (bodies[body].solver_index != 0) remove_awake(body);
    leave_island(body);
    bodies[body] = {};
    bodies[body].next_free = free_body;
    free_body = body;
    body_generations[body] = 0;
    --body_count;
}

uint32_t WorldData::create_shape(const ShapeDef& def, const Geometry& geometry) {
    // The hull first: a polygon that is none must leave nothing behind. Callers have checked that
    // it is one.
    std::vector<Vec2> hull;
    const Polygon* polygon = std::get_if<Polygon>(&geometry);
    if (polygon && convex_hull(polygon->vertices, hull) != HullStatus::ok) return none;

    uint32_t slot = free_shape;
    if (slot != none) {
        free_shape = shapes[slot].next_free;
        shapes[slot] = {};
        forms[slot] = {};
    } else {
        slot = uint32_t(shapes.size());
        shapes.emplace_back();
        forms.emplace_back();
        boxes.emplace_back();
        fat_boxes.emplace_back();
        paired_boxes.push_back(no_box);
        shape_generations.push_back(0);
    }
    shape_generations[slot] = next_generation++;
    ++shape_count;
    shapes[slot].surface = def;
    set_form(slot, geometry, hull);
    return slot;
}

/// Takes over a geometry of any type; `hull` is that of a polygon's vertices.
void WorldData::set_form(uint32_t slot, const Geometry& geometry, const std::vector<Vec2>& hull) {
    ShapeRecord& record = shapes[slot];
    uint32_t count = 0;
    if (const Circle* circle = std::get_if<Circle>(&geometry)) {
        record.type = ShapeType::circle;
        record.circle = *circle;
        count = 1;
    } else if (const Box* box = std::get_if<Box>(&geometry)) {
        record.type = ShapeType::box;
        record.box = *box;
        count = 4;
    } else if (const Segment* segment = std::get_if<Segment>(&geometry)) {
        record.type = ShapeType::segment;
        record.segment = *segment;
        count = 2;
    } else {
        record.type = ShapeType::polygon;
        record.polygon_rounding = std::get<Polygon>(geometry).rounding;
        count = uint32_t(hull.size());
    }
    const uint32_t capacity = VertexPool::capacity_for(count);
    if (capacity != record.capacity) {
        pool.release(forms[slot].begin, record.capacity);
        forms[slot].begin = pool.allocate(capacity);
        record.capacity = capacity;
    }
    forms[slot].count = count;
    if (record.type == ShapeType::polygon) {
        for (uint32_t i = 0; i < count; ++i) pool.local[forms[slot].begin + i] = to_v2(hull[i]);
    }
    mark_geometry(slot);
}

void WorldData::destroy_shape(uint32_t shape) {
    if (forms[shape].body != none) detach_shape(shape);
    pool.release(forms[shape].begin, shapes[shape].capacity);
    shapes[shape] = {};
    forms[shape] = {};
    shapes[shape].next_free = free_shape;
    free_shape = shape;
    shape_generations[shape] = 0;
    --shape_count;
}

void WorldData::attach_shape(uint32_t shape, uint32_t body) {
    if (forms[shape].body != none) detach_shape(shape);
    if (!bodies[body].never_awake) wake_for_edit(body);
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
    ++owner.shape_count;
    mark_mass(body);
    mark_placement(body);
}

void WorldData::detach_shape(uint32_t shape) {
    const uint32_t body = forms[shape].body;
    wake_for_edit(body);
    wake_touching(body);
    destroy_contacts_of_shape(shape);
    remove_proxy(shape);
    ShapeRecord& record = shapes[shape];
    BodyRecord& owner = bodies[body];
    if (record.previous != none)
        shapes[record.previous].next = record.next;
    else
        owner.first_shape = record.next;
    if (record.next != none)
        shapes[record.next].previous = record.previous;
    else
        owner.last_shape = record.previous;
    --owner.shape_count;
    record.previous = record.next = none;
    forms[shape].body = none;
    mark_mass(body);
    mark_placement(body);
    // Alone, its box is in its own coordinates again.
    place_shape(shape, {});
}

}  // namespace fettle::physics::detail
