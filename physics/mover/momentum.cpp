// The impulses and forces by which a mover and the bodies around it exchange momentum.

#include <geometry/trigonometry.h>
#include <mover/ground_load.h>
#include <mover/momentum.h>
#include <mover/obstacles.h>
#include <state/limits.h>
#include <state/segment_surfaces.h>

namespace fettle::physics::detail {

namespace {

/// How much an impulse of 1 N s along a unit vector changes the speed of a point of a body.
float yielding(const BodyRecord& body, Vec2 arm, Vec2 direction) {
    const float lever = cross(arm, direction);
    return body.inverse_mass + lever * lever * body.inverse_inertia;
}

/// Ground and mover get one velocity at a point, as in an inelastic collision, where the ground was
/// faster than the mover by `change` (m/s). Only the impulse on the ground is applied here, up to
/// `greatest` (N s).
void take_momentum(World& world, const MoverDef& def, const Footing& footing, Vec2 change,
                   float greatest = infinity) {
    constexpr float least = 1e-3f;  // m/s; what is slower may fall asleep
    const float speed = length(change);
    if (!(def.mass > 0.0f) || !(speed > least)) return;
    const WorldData& data = MoverWorld::of(world);
    const BodyRecord& record = data.bodies[footing.body];
    const Vec2 arm = footing.point - record.center, direction = (1.0f / speed) * change;
    const float impulse =
        min(speed / (1.0f / def.mass + yielding(record, arm, direction)), greatest);
    Body body = world.body(data.body_id(footing.body));
    body.apply_impulse(bounded(-impulse * direction, 1e12f), footing.point);
}

}  // namespace

Vec2 belt_velocity(const WorldData& data, uint32_t shape, uint32_t part, Vec2 normal) {
    const SegmentSurface* own = own_surface(data, shape, part);
    const ShapeDef& surface = data.shapes[shape].surface;
    const float given =
        own != nullptr ? with_own(surface, *own).surface_speed : surface.surface_speed;
    const float speed = bounded(given, greatest_speed);
    return {-speed * normal.y, speed * normal.x};
}

// The mover holds on to its ground, which gets the opposite impulse: without it, a mover that
// pushes what hangs on its ground, or lies on it, would drive both ever faster.
void push_body(World& world, const MoverDef& def, const Push& push, const Footing& footing,
               Vec2 velocity, float dt) {
    if (push.body == footing.body) return;
    WorldData& data = MoverWorld::of(world);
    const BodyRecord& record = data.bodies[push.body];
    const Vec2 arm = push.point - record.center;
    const Vec2 moves = velocity_of(data, push.body, push.point);
    const float approach = -dot(push.normal, velocity - moves);
    if (!(approach > 0.0f)) return;
    float yields = 1.0f / max(def.mass, 1e-3f) + yielding(record, arm, push.normal);
    if (footing.body != none) {
        const BodyRecord& ground = data.bodies[footing.body];
        yields += yielding(ground, footing.point - ground.center, push.normal);
    }
    const Vec2 impulse = -min(approach / yields, def.push_force * dt) * push.normal;
    const auto push_at = [&](uint32_t body, Vec2 by, const Position& point) {
        Body pushed = world.body(data.body_id(body));
        pushed.apply_impulse(by, point);
    };
    push_at(push.body, impulse, push.point);
    if (footing.body != none) push_at(footing.body, -impulse, footing.point);
}

void land_on(World& world, const MoverDef& def, const Footing& footing, Vec2 normal,
             Vec2 velocity) {
    const Vec2 ground = velocity_of(MoverWorld::of(world), footing.body, footing.point);
    take_momentum(world, def, footing, max(0.0f, dot(ground - velocity, normal)) * normal);
}

namespace {

/// Ground that rises faster than in the last step by more than this hits the mover, m/s.
constexpr float resting_speed = 0.1f;

}  // namespace

// What changes the velocity of the ground along its surface must change that of the mover, too, and
// ground that hits the mover from below pushes it up no faster than a collision would.
// Otherwise a barrel would gain energy: the weight of the mover makes the barrel roll, and the
// barrel carries the mover along without losing speed.
void hold_ground(World& world, const MoverDef& def, const MoverState& state, float dt) {
    const WorldData& data = MoverWorld::of(world);
    if (!world.is_valid(state.ground)) return;
    const uint32_t body = data.forms[state.ground.index].body;
    if (body == none || data.bodies[body].mobility != Mobility::dynamic) return;
    const Footing footing = {body, state.position};
    const Vec2 normal = state.ground_normal;
    const Vec2 now = velocity_of(data, footing.body, footing.point) +
                     belt_velocity(data, state.ground.index, state.ground_part, normal);
    const Vec2 change = bounded(now - state.ground_velocity, 1e6f);
    // Ground whose supports have stopped a landing does not hit the mover.
    const float known = max(0.0f, dot(state.ground_velocity, normal));
    const float hits = max(0.0f, dot(now, normal) - known - resting_speed);
    // The friction of its feet: what holds the mover, but not its ground, does not stop the ground.
    const float grip = def.mass * length(world.gravity()) * dt;
    take_momentum(world, def, footing, change - dot(change, normal) * normal, grip);
    take_momentum(world, def, footing, hits * normal);
}

// A force, not an impulse: a body much lighter than the mover would jump under it. It is kept apart
// from the forces of the host, which may carry the body: a weight does not.
void press_on_ground(World& world, const MoverDef& def, const Footing& footing, uint32_t own) {
    if (!(def.mass > 0.0f)) return;
    WorldData& data = MoverWorld::of(world);
    const Vec2 weight = def.mass * world.gravity();
    const float share =
        weight_share(data, footing.body, footing.point, normalized(weight), def.mass, own);
    const Vec2 force = bounded(share * weight, 1e12f);
    const Vec2 arm = footing.point - data.bodies[footing.body].center;
    data.change<wake_body>(footing.body);
    data.mover_weights.push_back(
        {def.body, data.body_id(footing.body), {force, cross(arm, force)}});
}

}  // namespace fettle::physics::detail
