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
    fettle_mover_def told{};
    told.group = def.group;
    told.category = def.category;
    told.mask = def.mask;
    told.ledges = def.ledges;
    told.up = converted(def.up);
    told.radius = def.radius;
    told.height = def.height;
    told.max_slope = def.max_slope;
    told.step_height = def.step_height;
    told.snap = def.snap;
    told.skin = def.skin;
    told.mass = def.mass;
    told.push_force = def.push_force;
    return told;
}

MoverDef definition_of(const fettle_world* world, const fettle_mover_def* given) {
    const fettle_mover_def& def = needed("def", given);
    check_size(def.size, sizeof def);
    MoverDef taken;
    taken.group = def.group;
    taken.category = def.category;
    taken.mask = def.mask;
    taken.ledges = def.ledges;
    if (def.body != 0) taken.body = handle<Body>(world, def.body).id();
    taken.up = vector_of(def.up);
    taken.radius = def.radius;
    taken.height = def.height;
    taken.max_slope = def.max_slope;
    taken.step_height = def.step_height;
    taken.snap = def.snap;
    taken.skin = def.skin;
    taken.mass = def.mass;
    taken.push_force = def.push_force;
    return taken;
}

/// The mover that the two structures describe.
Mover mover_of(const fettle_world* world, const fettle_mover_def* def,
               const fettle_mover_state* given) {
    const fettle_mover_state& state = needed("state", given);
    check_size(state.size, sizeof state);
    Mover mover(definition_of(world, def));
    MoverState taken;
    taken.on_ground = flag(state.on_ground);
    taken.climbing = flag(state.climbing);
    taken.position = position_of(state.position);
    taken.ground_normal = vector_of(state.ground_normal);
    taken.ground = shape_or_none(world, state.ground);
    taken.dropped = shape_or_none(world, state.dropped);
    mover.set_state(taken);
    return mover;
}

void tell(const MoverState& state, fettle_mover_state* told) {
    told->size = sizeof *told;
    told->on_ground = state.on_ground;
    told->climbing = state.climbing;
    told->position = converted(state.position);
    told->ground_normal = converted(state.ground_normal);
    told->ground = id_or_none(state.ground);
    told->dropped = id_or_none(state.dropped);
}

fettle_moved told_of(const Moved& moved) {
    fettle_moved told{};
    told.motion = converted(moved.motion);
    told.velocity = converted(moved.velocity);
    told.ground_normal = converted(moved.ground_normal);
    told.ground_velocity = converted(moved.ground_velocity);
    told.wall_normal = converted(moved.wall_normal);
    told.ground = id_or_none(moved.ground.id());
    told.wall = id_or_none(moved.wall.id());
    told.on_ground = moved.on_ground;
    told.hit_wall = moved.hit_wall;
    told.hit_ceiling = moved.hit_ceiling;
    told.stepped = moved.stepped;
    told.crushed = moved.crushed;
    return told;
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
        tell(mover.state(), state);
        if (moved != nullptr) *moved = told_of(done);
    });
}

fettle_code fettle_mover_drop(const fettle_world* world, const fettle_mover_def* def,
                              fettle_mover_state* state, bool* dropped) {
    return guarded(__func__, [&] {
        Mover mover = mover_of(world, def, state);
        const bool done = mover.drop(live(world));
        tell(mover.state(), state);
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
        uint32_t& told = needed("count", count);
        if (room > 0) needed("out", out);
        for (uint32_t i = 0; i < planes.size() && i < room; ++i) out[i] = planes[i];
        told = uint32_t(planes.size());
    });
}
