// The character mover: docs/design/physics.md, "The mover".

#include <checks/arguments.h>
#include <geometry/trigonometry.h>
#include <mover/ground_load.h>
#include <mover/momentum.h>
#include <mover/moving.h>
#include <world/world_data.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics {

using namespace detail;

void check(const MoverDef& def) {
    check_range("radius", def.radius, 0.01f, 1000.0f);
    check_range("height", def.height, 2.0f * def.radius, 1000.0f);
    check_direction("up", def.up);
    check_range("max_slope", def.max_slope, 0.0f, 1.5f);
    check_range("step_height", def.step_height, 0.0f, 1000.0f);
    check_range("snap", def.snap, 0.0f, 1000.0f);
    check_range("skin", def.skin, 0.001f, 0.1f);
    check_not_negative("mass", def.mass);
    check_not_negative("push_force", def.push_force);
}

Mover::Mover(const MoverDef& def, const Position& position) {
    set_definition(def);
    set_position(position);
}

void Mover::set_definition(const MoverDef& def) {
    check(def);
    def_ = def;
}

void Mover::set_position(const Position& position) {
    state_.position = check_coordinates("position", position);
    state_.on_ground = false;
    state_.ground_normal = {};
    state_.ground_velocity = {};
    state_.ground = {};
    state_.ground_part = 0;
    state_.dropped = {};
}

void Mover::set_state(const MoverState& state) {
    check_coordinates("position", state.position);
    check_finite("ground_normal", state.ground_normal);
    check_finite("ground_velocity", state.ground_velocity);
    state_ = state;
    // A normal of length 1 keeps its bits, so that a copy moves as the original does.
    const Vec2 normal = bounded(state.ground_normal, 1e6f);
    if (std::fabs(length_squared(normal) - 1.0f) > 1e-6f) state_.ground_normal = normalized(normal);
}

namespace {

constexpr float most_motion = 500.0f;  ///< m in one step
constexpr int most_parts = 2000;
constexpr float most_turn = 0.25f;   ///< rad in a step
constexpr float least_walk = 0.01f;  ///< m/s: a slower mover falls when its ground goes away

/// The box around the capsule anywhere between two positions.
Box4 box_between(const Capsule& capsule, const Position& a, const Position& b, float margin) {
    const float reach = capsule.height + margin;
    return grow(box_of(a.min(b), a.max(b)), reach);
}

Footing footing_on(const Obstacles& obstacles, const std::optional<Plane>& ground) {
    if (!ground || !obstacles[ground->obstacle].dynamic) return {};
    return {obstacles[ground->obstacle].body, ground->point};
}

/// True if a dynamic body runs into the mover. Then it keeps its contact with the body of the
/// mover, which stops it.
bool is_hit(const WorldData& data, const Push& push, float skin) {
    constexpr float fast = 0.5f;  // m/s
    if (push.separation < -0.5f * skin) return true;
    return dot(velocity_of(data, push.body, push.point), push.normal) > fast;
}

/// Stores in the world the velocity and the ground of the body of a mover.
void report_body(WorldData& data, const MoverBody& made) {
    std::vector<MoverBody>& all = data.mover_bodies;
    const auto own = std::lower_bound(all.begin(), all.end(), made.body.index, is_before);
    if (own == all.end() || own->body.index != made.body.index) {
        all.insert(own, made);
        return;
    }
    if (!own->old) {  // it has moved in this step already
        const auto is_own = [&](const auto& each) { return each.mover == made.body; };
        std::erase_if(data.mover_pairs, is_own);
        std::erase_if(data.mover_weights, is_own);
    }
    *own = made;
}

/// Stores in the world the dynamic bodies with which the body of a mover has no contact in the next
/// step: its ground, what it pushes, and the ledges that it may be passing.
void report_pairs(WorldData& data, const MoverDef& def, const Footing& footing,
                  const Moving& moving, const Obstacles& obstacles) {
    const auto add = [&](uint32_t other) {
        data.mover_pairs.push_back({def.body, data.body_id(other)});
    };
    if (footing.body != none) add(footing.body);
    for (const Push& push : moving.pushes)
        if (!is_hit(data, push, def.skin)) add(push.body);
    obstacles.for_each_dynamic_ledge(add);
}

/// The motion in a step of the ground on which a mover stands.
struct Ride {
    uint32_t carrier = none;  ///< body of the ground
    Vec2 motion;
    Vec2 belt;  ///< its part by a conveyor belt
};

Ride ride_on(const WorldData& data, const MoverState& state, float dt) {
    const uint32_t carrier = data.forms[state.ground.index].body;
    if (carrier == none) return {};
    const Vec2 belt =
        belt_velocity(data, state.ground.index, state.ground_part, state.ground_normal);
    const Vec2 along = bounded(dt * belt, 1e3f);
    return {carrier, motion_of(data, carrier, state.position, dt) + along, along};
}

/// The part of a ride that is due to the turn of the ground. The round foot of an upright mover
/// touches a slope beside its lowest point. So when the slope changes, the feet stay at their place
/// along the ground only if the foot keeps its distance from it.
Vec2 keeps_distance(const WorldData& data, const Obstacles& obstacles, const Capsule& capsule,
                    const Position& feet, uint32_t carrier, float least_cosine, float dt) {
    const auto ground = obstacles.floor_of(carrier, feet, capsule.radius, least_cosine);
    if (!ground) return {};
    const float turn = turn_of(data.states[carrier], dt);
    // On what turns faster, a ball that rolls, the slope does not turn with the body.
    if (std::fabs(turn) > most_turn) return {};
    const Position foot = feet + capsule.lower();
    const Vec2 turned = motion_of(data, carrier, foot, dt) - motion_of(data, carrier, feet, dt);
    const Vec2 normal = rotate(rotation_of(turn), ground->normal);
    return dot(turned, normal) * normal;
}

/// The motion in a step of a mover that walks with the velocity `aside`, along the slope of the
/// ground.
Vec2 motion_along_ground(Vec2 aside, Vec2 normal, float dt) {
    const Vec2 along = aside - dot(aside, normal) * normal;
    return dt * length(aside) * normalized(along);
}

/// Moves in parts that are at most half of the radius long, if 2000 parts are enough for that.
void advance(Moving& moving, Obstacles& obstacles, const Capsule& capsule, Vec2 motion,
             Vec2 ridden) {
    const float longest = max(length(motion), obstacles.farthest_shift());
    const int parts =
        int(clamp(std::ceil(longest / (0.5f * capsule.radius)), 1.0f, float(most_parts)));
    for (int i = 1; i <= parts; ++i) {
        obstacles.set_time(float(i) / float(parts));
        moving.advance((1.0f / float(parts)) * motion, (1.0f / float(parts)) * ridden);
    }
}

/// What is below the feet of a mover after its motion. `own`: its body, or `none`. `stands`: false
/// while it climbs or rises; then only the edge of a step that it has climbed is ground.
std::optional<Plane> ground_after(const WorldData& data, const Obstacles& obstacles, Moving& moving,
                                  uint32_t own, bool stands, Vec2 up) {
    if (stands) {
        const std::optional<Plane> ground = moving.ground();
        // A body that falls freely is not ground: nothing has weight on it, and it carries no
        // mover. One without weight does not fall.
        const auto carries = [&](const Obstacle& below) {
            return !below.dynamic || data.bodies[below.body].gravity_scale == 0.0f ||
                   is_supported(data, below.body, own);
        };
        if (ground && carries(obstacles[ground->obstacle])) return ground;
    }
    std::optional<Plane> edge = moving.step;
    if (edge) edge->normal = up;
    return edge;
}

/// The least velocity with which a mover leaves its ground, m/s.
constexpr float least_lift = 0.05f;

/// True if ground that moves up catches a mover that rises more slowly, as a lift in which it has
/// jumped.
bool catches(const WorldData& data, const Obstacle& ground, const Position& feet, Vec2 velocity,
             Vec2 up, float dt) {
    if (ground.border) return false;
    const Vec2 moves = (1.0f / dt) * motion_of(data, ground.body, feet, dt);
    return dot(velocity - moves, up) <= least_lift;
}

/// The shape through which a mover falls, while it exists.
std::optional<ShapeId> dropped_in(const World& world, const MoverState& state) {
    return world.is_valid(state.dropped) ? std::optional(state.dropped) : std::nullopt;
}

/// The velocity that a mover keeps on the ground: without its part along `up`, and without the part
/// that a wall stops.
Vec2 kept_on_ground(const WorldData& data, const Obstacles& obstacles, const Moving& moving,
                    Vec2 wanted, Vec2 up) {
    const Vec2 kept = wanted - dot(wanted, up) * up;
    if (!moving.wall || moving.step) return kept;
    const Vec2 wall = moving.wall->normal;
    const Vec2 aside = normalized(wall - dot(wall, up) * up);
    const Obstacle& by = obstacles[moving.wall->obstacle];
    // The speed of a pushed body is kept.
    const Vec2 by_velocity = by.dynamic ? data.states[by.body].velocity : Vec2{};
    return kept - min(0.0f, dot(kept - by_velocity, aside)) * aside;
}

/// The velocity relative to the ground on which a mover lands. The ground takes along a mover that
/// would otherwise be faster relative to it than it was in the air.
Vec2 landing(Vec2 velocity, Vec2 ground_velocity, Vec2 up) {
    const auto aside = [up](Vec2 v) { return std::fabs(cross(up, v)); };
    const Vec2 relative = velocity - ground_velocity;
    return aside(relative) < aside(velocity) ? relative : velocity;
}

void report_hits(Moved& moved, const Moving& moving, const Obstacles& obstacles, World& world,
                 WorldData& data) {
    const auto set_wall = [&](const Plane& plane) {
        moved.wall_normal = plane.normal;
        const uint32_t shape = obstacles[plane.obstacle].shape;
        moved.wall = Shape(&world, data.shape_id(data.named_shape(shape)));
    };
    if (moving.wall) set_wall(*moving.wall);
    if (moving.ceiling) set_wall(*moving.ceiling);
    moved.hit_wall = moving.wall.has_value() && !moving.step;
    moved.hit_ceiling = moving.ceiling.has_value();
}

void report_ground(Moved& moved, const Obstacle& below, const Plane& ground,
                   const Position& position, World& world, WorldData& data, float dt) {
    const uint32_t named = data.named_shape(below.shape);
    moved.ground = Shape(&world, data.shape_id(named));
    moved.ground_normal = ground.normal;
    if (below.border) return;
    const Vec2 carried = motion_of(data, below.body, position, dt);
    moved.ground_velocity =
        (1.0f / dt) * carried +
        belt_velocity(data, named, data.part_number(below.shape), ground.normal);
}

/// What a mover wants to do in a step, and where it begins.
struct Plan {
    Vec2 wanted;  ///< m/s; relative to the ground if it walks
    Vec2 motion;  ///< m, with that of the ride
    Ride ride;
    bool stood, lifts;
    bool rides;  ///< it stood on ground that still exists
    bool walks;  ///< it stood, and does not leave the ground by itself
};

Plan plan_of(const World& world, const WorldData& data, const MoverState& state, Vec2 up,
             Vec2 velocity, float dt) {
    Plan plan;
    plan.wanted = bounded(velocity, 1e6f);
    // It keeps the velocity of ground that was destroyed below it, or through which it drops.
    const bool has_ground = state.on_ground && world.is_valid(state.ground);
    if (!has_ground) plan.wanted = plan.wanted + bounded(state.ground_velocity, 1e6f);
    plan.stood = state.on_ground && !state.climbing;
    plan.rides = plan.stood && has_ground;
    plan.lifts = dot(plan.wanted, up) > least_lift;
    plan.walks = plan.stood && !plan.lifts;
    if (plan.rides) plan.ride = ride_on(data, state, dt);
    if (plan.walks) plan.wanted = plan.wanted - dot(plan.wanted, up) * up;
    plan.motion =
        plan.walks ? motion_along_ground(plan.wanted, state.ground_normal, dt) : dt * plan.wanted;
    plan.motion = bounded(plan.motion, 1e6f) + plan.ride.motion;
    if (length(plan.motion) > most_motion) plan.motion = most_motion * normalized(plan.motion);
    return plan;
}

/// Adds the turn of the ground to the ride; the other shapes of this ground move alike.
void add_turn_of_ground(Plan& plan, const WorldData& data, Obstacles& obstacles,
                        const Capsule& capsule, const Position& start, float least_cosine,
                        float dt) {
    const Vec2 kept =
        keeps_distance(data, obstacles, capsule, start, plan.ride.carrier, least_cosine, dt);
    plan.ride.motion = plan.ride.motion + kept;
    plan.motion = plan.motion + kept;
    obstacles.take_along(plan.ride.carrier, plan.ride.motion - plan.ride.belt, start);
}

/// Moves along the planned way, and back onto the ground from which it would go away.
void follow_plan(const Plan& plan, Moving& moving, Obstacles& obstacles, const Capsule& capsule,
                 float snap, float dt) {
    const Vec2 own = dt * plan.wanted + plan.ride.belt;  // the motion that is not the ground's
    advance(moving, obstacles, capsule, plan.motion,
            plan.walks ? plan.ride.motion - plan.ride.belt : Vec2{});
    if (plan.walks && !moving.step && !moving.follow(plan.ride.carrier, snap) && !moving.ground() &&
        length(own) > dt * least_walk)
        moving.snap_to_ground(snap);
}

/// The part of a velocity that the ground gives to a mover with which the mover has moved. If
/// obstacles stop both it and its walk, they stop the walk first.
Vec2 as_moved(Vec2 carried, Vec2 walk, Vec2 moved) {
    const float speed = length(carried);
    if (!(speed > 0.0f)) return {};
    const Vec2 direction = (1.0f / speed) * carried;
    const float planned = speed + min(0.0f, dot(walk, direction));
    const float lost = max(0.0f, planned - dot(moved, direction));
    return max(0.0f, speed - lost) * direction;
}

/// What is known without a move.
void report_state(Moved& moved, const MoverState& state, World& world, const WorldData& data) {
    moved.on_ground = state.on_ground;
    moved.ground_normal = state.ground_normal;
    moved.ground_velocity = state.ground_velocity;
    if (data.is_valid(state.ground)) moved.ground = Shape(&world, state.ground);
}

}  // namespace

Moved Mover::move(World& world, const Vec2& velocity, float dt) {
    check_finite("velocity", velocity);
    WorldData& data = MoverWorld::of(world);
    data.self.may_edit("Mover", "move");
    Moved moved;
    moved.velocity = velocity;
    if (!(dt > 0.0f) || !std::isfinite(dt)) {
        report_state(moved, state_, world, data);
        return moved;
    }

    const Capsule capsule(def_, def_.height);
    Obstacles obstacles(world, def_, capsule);
    const Vec2 up = capsule.up;
    const Position start = state_.position;
    data.read_all();
    if (state_.on_ground && !state_.climbing) hold_ground(world, def_, state_, dt);
    Plan plan = plan_of(world, data, state_, up, velocity, dt);
    const Vec2 wanted = plan.wanted;

    // Obstacles may deflect the motion to any side.
    const float margin = def_.step_height + def_.snap + 4.0f * def_.skin + length(plan.motion);
    const std::optional<ShapeId> dropped = dropped_in(world, state_);
    const float least_cosine = rotation_of(def_.max_slope).c - 1e-3f;
    if (!plan.stood && !state_.climbing) obstacles.set_landing(least_cosine);
    obstacles.find(box_between(capsule, start, start + plan.motion, margin), start,
                   plan.ride.carrier, dt, dropped);
    if (plan.walks) add_turn_of_ground(plan, data, obstacles, capsule, start, least_cosine, dt);
    const MoveSettings settings{.skin = def_.skin,
                                .least_cosine = least_cosine,
                                .step_height = plan.walks ? def_.step_height : 0.0f,
                                .walks = plan.walks};
    Moving moving(obstacles, capsule, settings, start);
    follow_plan(plan, moving, obstacles, capsule, def_.snap, dt);
    const uint32_t own = world.is_valid(def_.body) ? def_.body.index : none;
    const bool may_stand = !state_.climbing && !(plan.lifts && plan.stood);
    std::optional<Plane> ground = ground_after(data, obstacles, moving, own, may_stand, up);
    if (ground && plan.lifts && !catches(data, obstacles[ground->obstacle], start, wanted, up, dt))
        ground.reset();
    const Footing footing = footing_on(obstacles, ground);
    if (footing.body != none && !plan.stood) land_on(world, def_, footing, ground->normal, wanted);
    state_.position = moving.position;
    const Vec2 carried = (1.0f / dt) * plan.ride.motion;
    const Vec2 walk = (1.0f / dt) * (plan.motion - plan.ride.motion);
    // A wall that pushes the mover pushes what is in front of it, too.
    const Vec2 free = bounded(velocity, 1e6f) + carried, driven = moving.driven(free, dt);
    moving.find_pushed(dt * driven);

    moved.motion = moving.position - start;
    moved.stepped = moving.step.has_value();
    moved.crushed = !moving.has_room();
    report_hits(moved, moving, obstacles, world, data);

    moved.velocity = moving.clipped(wanted + as_moved(carried, walk, moved.motion / dt));
    state_.on_ground = moved.on_ground = ground.has_value();
    state_.ground = {};
    state_.ground_part = 0;
    state_.ground_normal = {};
    if (ground) {
        const Obstacle& below = obstacles[ground->obstacle];
        state_.ground = data.shape_id(data.named_shape(below.shape));
        state_.ground_part = data.part_number(below.shape);
        state_.ground_normal = ground->normal;
        report_ground(moved, below, *ground, moving.position, world, data, dt);
        if (plan.rides)
            moved.ground_velocity = as_moved(moved.ground_velocity, walk, moved.motion / dt);
        const Vec2 relative = plan.rides ? wanted : landing(wanted, moved.ground_velocity, up);
        moved.velocity = kept_on_ground(data, obstacles, moving, relative, up);
    }
    state_.ground_velocity = moved.ground_velocity;
    if (own != none && data.bodies[own].mobility == Mobility::kinematic) {
        MoverBody made = {def_.body, {}, moved.velocity + moved.ground_velocity};
        const bool stands = ground && !moved.crushed && !obstacles[ground->obstacle].border;
        if (stands) made.ground = data.body_id(obstacles[ground->obstacle].body);
        report_body(data, made);
        if (!moved.crushed) report_pairs(data, def_, footing, moving, obstacles);
    }
    if (dropped && !overlaps_dropped(world)) state_.dropped = {};

    for (const Push& push : moving.pushes) push_body(world, def_, push, footing, driven, dt);
    if (footing.body != none) press_on_ground(world, def_, footing, own);
    return moved;
}

bool Mover::drop(const World& world) {
    if (!state_.on_ground || !world.is_valid(state_.ground)) return false;
    const Shape ground = world.shape(state_.ground);
    const bool ledge = (ground.category() & def_.ledges) != 0;
    if (!ledge && ground.type() != ShapeType::chain) return false;
    state_.dropped = state_.ground;
    state_.on_ground = false;
    state_.ground = {};
    state_.ground_part = 0;
    state_.ground_normal = {};
    // The velocity with which a ledge rises would hold it on the ledge.
    const Vec2 up = Capsule(def_, def_.height).up;
    state_.ground_velocity =
        state_.ground_velocity - max(0.0f, dot(state_.ground_velocity, up)) * up;
    return true;
}

/// True until the mover has left the shape through which it falls.
bool Mover::overlaps_dropped(const World& world) const {
    const Capsule capsule(def_, def_.height);
    WorldData& data = MoverWorld::of(world);
    bool near = false;
    if (data.forms[state_.dropped.index].body == none) return false;
    data.for_each_solid(state_.dropped.index, [&](uint32_t shape) {
        const Vec2 offset = data.bodies[data.forms[shape].body].center - state_.position;
        const Nearest found =
            nearest_points(capsule.solid(capsule.radius), data.solid(shape), offset);
        near |= found.distance < 3.0f * def_.skin;
    });
    return near;
}

bool Mover::fits(const World& world, float height) const {
    check_range("height", height, 2.0f * def_.radius, 1000.0f);
    const Capsule capsule(def_, height);
    Obstacles obstacles(world, def_, capsule);
    const Position at = state_.position;
    obstacles.find(box_between(capsule, at, at, def_.skin), at, none, 0.0f,
                   dropped_in(world, state_));
    std::vector<Plane> found;
    obstacles.planes_at(at, 0.0f, none, found);
    return found.empty();
}

bool Mover::set_height(const World& world, float height) {
    MoverDef changed = def_;
    changed.height = height;
    check(changed);
    if (height > def_.height && !fits(world, height)) return false;
    def_ = changed;
    return true;
}

std::vector<MoverPlane> Mover::planes(const World& world, float distance) const {
    check_range("distance", distance, 0.0f, 1000.0f);
    const Capsule capsule(def_, def_.height);
    Obstacles obstacles(world, def_, capsule);
    const Position at = state_.position;
    obstacles.find(box_between(capsule, at, at, distance), at, none, 0.0f, std::nullopt);
    std::vector<Plane> found;
    obstacles.planes_at(at, distance, none, found);
    std::vector<MoverPlane> planes;
    for (const Plane& plane : found) {
        WorldData& data = obstacles.data();
        const uint32_t shape = data.named_shape(obstacles[plane.obstacle].shape);
        planes.push_back(
            {plane.normal, plane.point, plane.separation, world.shape(data.shape_id(shape))});
    }
    return planes;
}

}  // namespace fettle::physics
