#include <fettle/physics_c/mover.h>

#include <fettle/physics/mover.h>

#include <calls/calls.h>

namespace fettle::physics_c {

using namespace physics;

namespace {

template <class Id>
fettle_id id_or_none(const Id& id) {
    return id ? converted(id) : 0;
}

ShapeId shape_or_none(const fettle_world* world, fettle_id id) {
    return lives<ShapeId>(world, id) ? handle<Shape>(world, id).id() : ShapeId{};
}

fettle_mover_def defaults(const MoverDef& def) {
    fettle_mover_def result{};
    result.group = def.group;
    result.category = def.category;
    result.mask = def.mask;
    result.ledges = def.ledges;
    result.up = converted(def.up);
    result.radius = def.radius;
    result.height = def.height;
    result.max_slope = def.max_slope;
    result.step_height = def.step_height;
    result.snap = def.snap;
    result.skin = def.skin;
    result.mass = def.mass;
    result.push_force = def.push_force;
    return result;
}

MoverDef definition_of(const fettle_world* world, const fettle_mover_def* given) {
    const fettle_mover_def& def = needed("def", given);
    check_size(def.size, sizeof def);
    MoverDef result;
    result.group = def.group;
    result.category = def.category;
    result.mask = def.mask;
    result.ledges = def.ledges;
    if (def.body != 0) result.body = handle<Body>(world, def.body).id();
    result.up = vector_of(def.up);
    result.radius = def.radius;
    result.height = def.height;
    result.max_slope = def.max_slope;
    result.step_height = def.step_height;
    result.snap = def.snap;
    result.skin = def.skin;
    result.mass = def.mass;
    result.push_force = def.push_force;
    return result;
}

/// The mover that the two structures describe.
Mover mover_of(const fettle_world* world, const fettle_mover_def* def,
               const fettle_mover_state* given) {
    const fettle_mover_state& state = needed("state", given);
    check_size(state.size, sizeof state);
    Mover mover(definition_of(world, def));
    MoverState result;
    result.on_ground = flag(state.on_ground);
    result.climbing = flag(state.climbing);
    result.position = position_of(state.position);
    result.ground_normal = vector_of(state.ground_normal);
    result.ground = shape_or_none(world, state.ground);
    result.dropped = shape_or_none(world, state.dropped);
    mover.set_state(result);
    return mover;
}

void write(const MoverState& state, fettle_mover_state* result) {
    result->size = sizeof *result;
    result->on_ground = state.on_ground;
    result->climbing = state.climbing;
    result->position = converted(state.position);
    result->ground_normal = converted(state.ground_normal);
    result->ground = id_or_none(state.ground);
    result->dropped = id_or_none(state.dropped);
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
    return init(__func__, def, size, defaults(MoverDef()));
}

fettle_code fettle_mover_state_init(fettle_mover_state* state, size_t size) {
    return init(__func__, state, size, fettle_mover_state{});
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
