// The step of movers, and its events.

#include <algorithm>

#include <bindings/bindings.h>
#include <movers/mover_class.h>

namespace fettle::physics_module {
namespace {

using physics::Vec2;

enum Happened : std::uint32_t { landed = 1, left_ground = 2, bumped = 4, crushed = 8 };

Vec2 right_of(const Vec2& up) {
    return {up.y, -up.x};
}

physics::Mover mover_of(const MoverRecord& record, const physics::Body& body) {
    physics::Mover mover(definition(record, body), body.position());
    physics::MoverState state;
    state.position = body.position();
    state.ground_normal = {record.result.normal_x, record.result.normal_y};
    state.ground_velocity = {record.result.ground_x, record.result.ground_y};
    state.ground = record.result.ground;
    state.ground_part = record.result.ground_part;
    state.dropped = record.result.dropped;
    state.on_ground = record.result.on_ground != 0;
    state.climbing = record.settings.climbing != 0;
    mover.set_state(state);
    return mover;
}

/// Something else moved the body: it does not ride on its earlier ground.
bool was_moved(const MoverResult& result, const Vec2& position) {
    const Vec2 off = position - Vec2(result.place_x, result.place_y);
    return off.length() > 0.01f + 1e-5f * position.length();
}

/// The velocity relative to the ground. If the velocity of the body was written since the last
/// step, it is the written one.
Vec2 relative_velocity(const MoverResult& result, const physics::Body& body) {
    const Vec2 now = body.velocity();
    if (now.x == result.shown_x && now.y == result.shown_y)
        return {result.velocity_x, result.velocity_y};
    return result.on_ground != 0 ? Vec2(now - Vec2(result.ground_x, result.ground_y)) : now;
}

/// The velocity of the ground that it left; zero while it stands.
Vec2 left_ground_of(const MoverResult& result) {
    return {result.left_x, result.left_y};
}

void set_left_ground(MoverResult& result, const Vec2& velocity) {
    result.left_x = velocity.x;
    result.left_y = velocity.y;
}

float approached(float from, float to, float most) {
    return from + std::clamp(to - from, -most, most);
}

/// The target velocity of this step.
Vec2 wanted_velocity(const MoverRecord& record, const physics::Body& body, const Vec2& up,
                     float dt) {
    const Vec2 right = right_of(up);
    const float limit = 1e4f;  // m/s
    const float walk = std::clamp(record.settings.walk, -limit, limit);
    const float climb = std::clamp(record.settings.climb, -limit, limit);
    if (record.settings.climbing != 0) return walk * right + climb * up;
    const Vec2 before = relative_velocity(record.result, body);
    const bool stands = record.result.on_ground != 0;
    const float rate = stands ? record.settings.acceleration : record.settings.air_acceleration;
    // A jump in a moving train lands where it began.
    const float base = stands ? 0.0f : left_ground_of(record.result).dot(right);
    const float along = approached(before.dot(right), walk + base, rate * dt);
    Vec2 wanted = along * right + before.dot(up) * up;
    if (!stands) wanted += dt * body.gravity_scale() * body.world().gravity();
    return {std::clamp(wanted.x, -limit, limit), std::clamp(wanted.y, -limit, limit)};
}

void store_events(MoverEvents& events, const MoverResult& before, const physics::Moved& moved,
                  float fall) {
    events.happened = 0;
    if (moved.on_ground && before.on_ground == 0) {
        events.happened |= landed;
        events.landing_speed = std::max(0.0f, fall);
    }
    if (!moved.on_ground && before.on_ground != 0) events.happened |= left_ground;
    events.was_ground = before.ground;
    const bool wall = moved.hit_wall && before.on_wall == 0;
    const bool ceiling = moved.hit_ceiling && before.on_ceiling == 0;
    if (wall || ceiling) {
        events.happened |= bumped;
        events.bump_x = moved.wall_normal.x;
        events.bump_y = moved.wall_normal.y;
        events.bumped = moved.wall.id();
    }
    if (moved.crushed && before.crushed == 0) events.happened |= crushed;
}

void store(MoverResult& to, const physics::Mover& mover, const physics::Moved& moved) {
    const physics::MoverState& state = mover.state();
    to.on_ground = moved.on_ground;
    to.on_wall = moved.hit_wall;
    to.on_ceiling = moved.hit_ceiling;
    to.crushed = moved.crushed;
    to.ground = state.ground;
    to.ground_part = state.ground_part;
    to.dropped = state.dropped;
    to.normal_x = state.ground_normal.x;
    to.normal_y = state.ground_normal.y;
    to.ground_x = moved.ground_velocity.x;
    to.ground_y = moved.ground_velocity.y;
    to.place_x = state.position.x;
    to.place_y = state.position.y;
}

/// The slots of the live movers; a damaged save may contain others.
std::vector<std::uint32_t> slots_of(const HostedWorld& in) {
    std::vector<std::uint32_t> slots;
    for (const MoverRecord& record : in.movers.all()) {
        const auto slot = static_cast<std::uint32_t>(record.slot);
        if (physics::HostAccess::body_generation(in.world, slot) != 0) slots.push_back(slot);
    }
    return slots;
}

/// Gravity lifts it off the ground; it keeps the velocity of the ground.
void leave_ground(MoverResult& result) {
    if (result.on_ground == 0) return;
    result.velocity_x += result.ground_x;
    result.velocity_y += result.ground_y;
    set_left_ground(result, {result.ground_x, result.ground_y});
    result.ground_x = result.ground_y = 0.0f;
    result.on_ground = 0;
    result.ground = {};
}

/// `ground`: the velocity of the ground before the move; `left`: the velocity after it.
void remember_left_ground(MoverRecord& record, bool stood, const Vec2& ground, const Vec2& left,
                          const physics::Moved& moved, const Vec2& right) {
    MoverResult& result = record.result;
    if (moved.on_ground || record.settings.climbing != 0) return set_left_ground(result, {});
    if (stood) set_left_ground(result, ground);
    if (!moved.hit_wall) return;
    // A wall that does not move with the ground that it left ends this motion.
    const float base = left_ground_of(result).dot(right), along = left.dot(right);
    set_left_ground(result, std::clamp(base, std::min(0.0f, along), std::max(0.0f, along)) * right);
}

/// Its ground, and what it falls through, are not those of its place now.
void leave_place(MoverResult& result) {
    result.on_ground = 0;
    result.ground_x = result.ground_y = 0.0f;
    result.ground = result.dropped = {};
    set_left_ground(result, {});
}

void move_one(HostedWorld& in, std::uint32_t slot, float dt) {
    physics::Body body =
        in.world.body({slot, physics::HostAccess::body_generation(in.world, slot)});
    if (body.type() != physics::BodyType::kinematic_body || !body.enabled()) {
        MoverRecord record = in.movers.get(slot);
        leave_place(record.result);
        record.result.on_wall = record.result.on_ceiling = record.result.crushed =
            record.events.happened = 0;
        in.movers.set(slot, record);
        return;
    }
    adapt_capsule(in, slot);
    MoverRecord record = in.movers.get(slot);
    if (was_moved(record.result, body.position())) {
        leave_place(record.result);
    }
    const MoverRecord before = record;
    const Vec2 up = body.world_vector({0.0f, 1.0f});
    const Vec2 gravity = body.gravity_scale() * body.world().gravity();
    const bool rises = gravity.dot(up) > 1e-3f * gravity.length();
    if (rises) leave_ground(record.result);
    const bool stands = record.result.on_ground != 0;
    const Vec2 wanted = wanted_velocity(record, body, up, dt);
    physics::Mover mover = mover_of(record, body);
    if (rises) {
        physics::MoverState state = mover.state();
        state.climbing = true;  // It finds no ground.
        mover.set_state(state);
    }
    const physics::Moved moved = mover.move(in.world, wanted, dt);
    store(record.result, mover, moved);
    store_events(record.events, before.result, moved, -wanted.dot(up));

    const Vec2 ground(before.result.ground_x, before.result.ground_y);
    Vec2 left = moved.velocity;
    if (stands && moved.on_ground) {
        // The ground may have become faster or slower below its feet.
        left += ground - moved.ground_velocity;
        left -= left.dot(up) * up;
    }
    remember_left_ground(record, stands, ground, left, moved, right_of(up));
    record.result.velocity_x = left.x;
    record.result.velocity_y = left.y;
    const Vec2 shown = moved.motion / dt;
    if (body.velocity() != shown) body.set_velocity(shown);
    const Vec2 given = body.velocity();
    record.result.shown_x = given.x;
    record.result.shown_y = given.y;
    in.movers.set(slot, record);
}

/// The body and the shape with this id, if they exist and have instances.
std::pair<Handle, Handle> instances_of(Hosting& hosting, HostedWorld& hosted, physics::ShapeId id) {
    if (!hosted.world.is_valid(id)) return {};
    const physics::Shape shape = hosted.world.shape(id);
    const physics::Body body = shape.body();
    const Handle owner = body ? hosting.instance_of(body.user_data()) : Handle{};
    return {owner ? owner : hosted.self, hosting.instance_of(shape.user_data())};
}

}  // namespace

void adapt_capsule(HostedWorld& hosted, std::uint32_t slot) {
    physics::Body body =
        hosted.world.body({slot, physics::HostAccess::body_generation(hosted.world, slot)});
    physics::Shape shape = capsule_of(body);
    if (!shape) return;
    MoverRecord record = hosted.movers.get(slot);
    const bool crouches = record.settings.crouch != 0;
    const physics::Vec2 top = shape.to();
    const float now = top.y + shape.rounding();
    MoverRecord changed = record;
    changed.result.crouched = crouches;
    const physics::MoverDef def = definition(changed, body);
    if (def.height > now + 1e-4f) {
        physics::MoverDef small = def;
        small.height = std::max(now, 2.0f * def.radius);
        physics::Mover mover(small, body.position());
        if (!mover.fits(hosted.world, def.height)) return;
    }
    if (changed.result.crouched != record.result.crouched) hosted.movers.set(slot, changed);
    const physics::Segment wanted = capsule(def.radius, def.height);
    if (wanted.to != top || wanted.rounding != shape.rounding()) shape.set_geometry(wanted);
}

void move_movers(HostedWorld& hosted, float dt) {
    if (!(dt > 0.0f) || hosted.world.locked()) return;
    for (const std::uint32_t slot : slots_of(hosted)) move_one(hosted, slot, dt);
}

void report_movers(Hosting& hosting, HostedWorld& hosted) {
    struct Reported {
        Handle mover;
        MoverRecord record;
    };
    std::vector<Reported> all;
    for (const std::uint32_t slot : slots_of(hosted)) {
        MoverRecord record = hosted.movers.get(slot);
        if (record.events.happened == 0) continue;
        const physics::Body body =
            hosted.world.body({slot, physics::HostAccess::body_generation(hosted.world, slot)});
        all.push_back({hosting.instance_of(body.user_data()), record});
        record.events.happened = 0;
        hosted.movers.set(slot, record);
    }
    // All instances are found first: a handler may delete any of them.
    struct Event {
        Handle mover;
        const char* name;
        std::vector<Value> values;
    };
    std::vector<Event> events;
    for (const auto& [mover, record] : all) {
        if (!mover) continue;
        const auto below = instances_of(hosting, hosted, record.result.ground);
        const auto left = instances_of(hosting, hosted, record.events.was_ground);
        const auto [other, other_shape] = instances_of(hosting, hosted, record.events.bumped);
        if (record.events.happened & left_ground)
            events.push_back({mover, "left_ground", {left.first}});
        if (record.events.happened & landed)
            events.push_back(
                {mover, "landed", {below.first, to_value(record.events.landing_speed)}});
        if (record.events.happened & bumped)
            events.push_back(
                {mover,
                 "bumped",
                 {other, other_shape, widen(record.events.bump_x, record.events.bump_y)}});
        if (record.events.happened & crushed) events.push_back({mover, "crushed", {}});
    }
    for (Event& event : events) {
        if (!hosting.tree.alive(event.mover)) continue;
        const property::Event* which = hosting.tree.class_of(event.mover).event(event.name);
        if (which != nullptr && which->listeners != 0 && hosting.tree.listens(event.mover, *which))
            hosting.tree.emit(event.mover, *which, std::move(event.values));
    }
}

}  // namespace fettle::physics_module
