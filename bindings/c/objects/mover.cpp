#include <fettle/physics_c/mover.h>

#include <fettle/physics/mover.h>

#include <calls/members.h>

namespace fettle::physics_c {

using namespace physics;

/// All members but the body, whose id needs the world.
template <class InC, class Each>
void each_member(InC& c, MoverDef& def, const Each& each) {
    each(c.radius, def.radius);
    each(c.height, def.height);
    each(c.up, def.up);
    each(c.max_slope, def.max_slope);
    each(c.step_height, def.step_height);
    each(c.snap, def.snap);
    each(c.skin, def.skin);
    each(c.mass, def.mass);
    each(c.push_force, def.push_force);
    each(c.category, def.category);
    each(c.mask, def.mask);
    each(c.group, def.group);
    each(c.ledges, def.ledges);
}

/// All members but the shapes, whose ids need the world.
template <class InC, class Each>
void each_member(InC& c, MoverState& state, const Each& each) {
    each(c.position, state.position);
    each(c.ground_normal, state.ground_normal);
    each(c.ground_velocity, state.ground_velocity);
    each(c.on_ground, state.on_ground);
    each(c.climbing, state.climbing);
    each(c.ground_part, state.ground_part);
}

namespace {

template <class Id>
fettle_id id_or_none(const Id& id) {
    return id ? converted(id) : 0;
}

/// The shape; none if it was destroyed.
ShapeId shape_or_none(const fettle_world* world, fettle_id id) {
    return lives<ShapeId>(world, id) ? handle<Shape>(world, id).id() : ShapeId{};
}

MoverDef definition_of(const fettle_world* world, const fettle_mover_def* def) {
    MoverDef result = from_c<MoverDef>(needed("def", def));
    if (def->body != 0) result.body = handle<Body>(world, def->body).id();
    return result;
}

/// The mover that the two structures describe.
Mover mover_of(const fettle_world* world, const fettle_mover_def* def,
               const fettle_mover_state* given) {
    MoverState state = from_c<MoverState>(needed("state", given));
    state.ground = shape_or_none(world, given->ground);
    state.dropped = shape_or_none(world, given->dropped);
    Mover mover(definition_of(world, def));
    mover.set_state(state);
    return mover;
}

void write(const MoverState& state, fettle_mover_state* result) {
    *result = in_c<fettle_mover_state>(state);
    result->ground = id_or_none(state.ground);
    result->dropped = id_or_none(state.dropped);
}

std::vector<MoverPlane> planes_of(const fettle_mover_plane* planes, uint32_t count) {
    if (count > 0) needed("planes", planes);
    std::vector<MoverPlane> result(count);
    for (uint32_t i = 0; i < count; ++i) {
        const auto fault = [&](const char* expected) {
            return Failure{FETTLE_INVALID,
                           "planes[" + std::to_string(i) + "]: expected " + expected};
        };
        result[i].normal = vector_of(planes[i].normal);
        result[i].separation = planes[i].separation;
        if (!(std::fabs(result[i].normal.length() - 1.0f) < 1e-3f))
            throw fault("a normal of length 1");
        if (!std::isfinite(result[i].separation)) throw fault("a finite separation");
    }
    return result;
}

fettle_moved in_c(const Moved& moved) {
    fettle_moved result{};
    result.motion = converted(moved.motion);
    result.velocity = converted(moved.velocity);
    result.ground_normal = converted(moved.ground_normal);
    result.ground_velocity = converted(moved.ground_velocity);
    result.wall_normal = converted(moved.wall_normal);
    result.ground = id_or_none(moved.ground.id());
    result.wall = id_or_none(moved.wall.id());
    result.on_ground = moved.on_ground;
    result.hit_wall = moved.hit_wall;
    result.hit_ceiling = moved.hit_ceiling;
    result.stepped = moved.stepped;
    result.crushed = moved.crushed;
    return result;
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics;
using namespace fettle::physics_c;

fettle_code fettle_mover_def_init(fettle_mover_def* def, size_t size) {
    return init_as<MoverDef>(__func__, def, size);
}

fettle_code fettle_mover_state_init(fettle_mover_state* state, size_t size) {
    return init_as<MoverState>(__func__, state, size);
}

fettle_code fettle_mover_move(fettle_world* world, const fettle_mover_def* def,
                              fettle_mover_state* state, float velocity_x, float velocity_y,
                              float dt, fettle_moved* moved) {
    return guarded(__func__, [&] {
        World& in = editable(world);
        Mover mover = mover_of(world, def, state);
        const Moved done = mover.move(in, {velocity_x, velocity_y}, dt);
        write(mover.state(), state);
        if (moved != nullptr) *moved = in_c(done);
    });
}

fettle_code fettle_mover_drop(const fettle_world* world, const fettle_mover_def* def,
                              fettle_mover_state* state, bool* dropped) {
    return guarded(__func__, [&] {
        Mover mover = mover_of(world, def, state);
        const bool done = mover.drop(live(world));
        write(mover.state(), state);
        if (dropped != nullptr) *dropped = done;
    });
}

fettle_code fettle_mover_fits(const fettle_world* world, const fettle_mover_def* def,
                              const fettle_mover_state* state, float height, bool* fits) {
    return guarded(__func__, [&] {
        bool& result = needed("the result", fits);
        result = mover_of(world, def, state).fits(live(world), height);
    });
}

fettle_code fettle_mover_set_height(const fettle_world* world, fettle_mover_def* def,
                                    const fettle_mover_state* state, float height, bool* changed) {
    return guarded(__func__, [&] {
        Mover mover = mover_of(world, def, state);
        const bool done = mover.set_height(live(world), height);
        def->height = mover.definition().height;
        if (changed != nullptr) *changed = done;
    });
}

fettle_code fettle_mover_planes(const fettle_world* world, const fettle_mover_def* def,
                                const fettle_mover_state* state, float distance,
                                fettle_mover_plane* out, uint32_t room, uint32_t* count) {
    return guarded(__func__, [&] {
        std::vector<fettle_mover_plane> planes;
        for (const MoverPlane& plane : mover_of(world, def, state).planes(live(world), distance))
            planes.push_back({converted(plane.normal), converted(plane.point), plane.separation,
                              converted(plane.shape)});
        uint32_t& result = needed("count", count);
        if (room > 0) needed("out", out);
        for (uint32_t i = 0; i < planes.size() && i < room; ++i) out[i] = planes[i];
        result = uint32_t(planes.size());
    });
}

fettle_code fettle_solve_planes(float motion_x, float motion_y, const fettle_mover_plane* planes,
                                uint32_t plane_count, float distance, fettle_vec2* motion) {
    return guarded(__func__, [&] {
        fettle_vec2& result = needed("motion", motion);
        const Vec2 wanted = checked(FiniteVector{motion_x, motion_y});
        const float away = checked(Finite{"distance", distance});
        result = converted(solve_planes(wanted, planes_of(planes, plane_count), away));
    });
}

fettle_code fettle_clip_velocity(float velocity_x, float velocity_y,
                                 const fettle_mover_plane* planes, uint32_t plane_count,
                                 fettle_vec2* velocity) {
    return guarded(__func__, [&] {
        fettle_vec2& result = needed("velocity", velocity);
        const Vec2 wanted = checked(FiniteVector{velocity_x, velocity_y});
        result = converted(clip_velocity(wanted, planes_of(planes, plane_count)));
    });
}
