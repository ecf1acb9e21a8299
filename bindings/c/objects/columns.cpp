#include <fettle/physics_c/columns.h>

#include <cstddef>

#include <calls/calls.h>
#include <fettle/physics/host_access.h>

namespace fettle::physics_c {

using namespace physics;

namespace {

// A caller in C reads the columns of the library themselves, so the layouts must be equal.
static_assert(sizeof(fettle_body_state) == sizeof(BodyState));
static_assert(offsetof(fettle_body_state, angle) == offsetof(BodyState, angle));
static_assert(offsetof(fettle_body_state, angular_velocity) ==
              offsetof(BodyState, angular_velocity));
static_assert(offsetof(fettle_body_state, velocity) == offsetof(BodyState, velocity));
static_assert(offsetof(fettle_body_state, cosine) == offsetof(BodyState, cosine));
static_assert(offsetof(fettle_body_state, sine) == offsetof(BodyState, sine));
static_assert(sizeof(fettle_pose) == sizeof(Pose));
static_assert(offsetof(fettle_pose, angle) == offsetof(Pose, angle));

ContactId contact_named(const fettle_world* world, fettle_id shape_a, fettle_id shape_b) {
    return ContactId::of(handle<Shape>(world, shape_a).id(), handle<Shape>(world, shape_b).id());
}

/// As `contact_named`, also of shapes that were destroyed.
ContactId former_contact(fettle_id shape_a, fettle_id shape_b) {
    const auto id = [](fettle_id shape) {
        return ShapeId{unpacked(shape, kind_of<ShapeId>), uint32_t(shape >> 32)};
    };
    return ContactId::of(id(shape_a), id(shape_b));
}

uint32_t body_slot(const World& world, uint32_t slot) {
    if (HostAccess::body_generation(world, slot) == 0)
        throw Failure{FETTLE_STALE,
                      "slot = " + std::to_string(slot) + ": expected the slot of a live body"};
    return slot;
}

Written written(World& world, uint32_t slot, BodyNumber number, float value) {
    const auto not_negative = [&] {
        if (!(checked(Finite{"value", value}) >= 0.0f))
            throw Failure{FETTLE_INVALID, name_and_value("value", value) +
                                              ": expected a finite number of at least 0"};
        return value;
    };
    switch (number) {
        case BodyNumber::angular_velocity:
            return HostAccess::write<BodyNumber::angular_velocity>(world, slot,
                                                                   checked(Finite{"value", value}));
        case BodyNumber::torque:
            return HostAccess::write<BodyNumber::torque>(world, slot,
                                                         checked(Finite{"value", value}));
        case BodyNumber::gravity_scale:
            return HostAccess::write<BodyNumber::gravity_scale>(world, slot,
                                                                checked(Finite{"value", value}));
        case BodyNumber::linear_damping:
            return HostAccess::write<BodyNumber::linear_damping>(world, slot, not_negative());
        default:
            return HostAccess::write<BodyNumber::angular_damping>(world, slot, not_negative());
    }
}

/// `worlds` and `bodies` of a function for many worlds, all checked.
std::vector<Body> checked_bodies(const fettle_world* const* worlds, uint32_t world_count,
                                 const fettle_id* bodies, uint32_t body_count) {
    if (world_count > 0) needed("worlds", worlds);
    if (world_count > 0 && body_count > 0) needed("bodies", bodies);
    std::vector<Body> found;
    found.reserve(size_t(world_count) * body_count);
    for (size_t i = 0; i < world_count; ++i)
        for (size_t k = 0; k < body_count; ++k)
            found.push_back(
                body_named([&] { return "bodies[" + std::to_string(i * body_count + k) + "]"; },
                           worlds[i], bodies[i * body_count + k]));
    return found;
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics_c;
using namespace fettle::physics;

fettle_code fettle_world_columns(const fettle_world* world, fettle_columns* columns) {
    return guarded(__func__, [&] {
        fettle_columns& result = needed("columns", columns);
        const World& of = live(world);
        const auto states = HostAccess::states(of);
        const auto previous = HostAccess::previous_poses(of);
        result.states = reinterpret_cast<const fettle_body_state*>(states.data());
        result.previous = reinterpret_cast<const fettle_pose*>(previous.data());
        result.body_slots = uint32_t(states.size());
    });
}

fettle_code fettle_world_contacts(const fettle_world* world, fettle_contact* out, uint32_t room,
                                  uint32_t* count) {
    return list<&World::contacts>(__func__, world, out, room, count);
}

fettle_code fettle_world_is_touching(const fettle_world* world, fettle_id shape_a,
                                     fettle_id shape_b, bool* is_touching) {
    return guarded(__func__, [&] {
        bool& result = needed("is_touching", is_touching);
        const World& in = live(world);
        result = lives<ShapeId>(world, shape_a) && lives<ShapeId>(world, shape_b) &&
                 in.is_touching(contact_named(world, shape_a, shape_b));
    });
}

fettle_code fettle_world_contacts_of(const fettle_world* world, fettle_id shape_a,
                                     fettle_id shape_b, fettle_contact* out, uint32_t room,
                                     uint32_t* count) {
    return guarded(__func__, [&] {
        const World& in = live(world);
        write_list(in.contacts_of(contact_named(world, shape_a, shape_b)), out, room, count);
    });
}

fettle_code fettle_world_ignore_until_separated(fettle_world* world, fettle_id shape_a,
                                                fettle_id shape_b) {
    return guarded(__func__, [&] {
        editable(world).ignore_until_separated(handle<Shape>(world, shape_a),
                                               handle<Shape>(world, shape_b));
    });
}

fettle_code fettle_world_contact_data(const fettle_world* world, fettle_id shape_a,
                                      fettle_id shape_b, uint64_t* user_data) {
    return guarded(__func__, [&] {
        uint64_t& result = needed("user_data", user_data);
        result = live(world).contact_data(former_contact(shape_a, shape_b));
    });
}

fettle_code fettle_world_set_contact_data(fettle_world* world, fettle_id shape_a, fettle_id shape_b,
                                          uint64_t user_data) {
    return guarded(__func__, [&] {
        editable(world).set_contact_data(contact_named(world, shape_a, shape_b), user_data);
    });
}

fettle_code fettle_world_state(const fettle_world* world, uint32_t slot, fettle_body_state* state) {
    return guarded(__func__, [&] {
        const World& of = live(world);
        needed("state", state) = converted(HostAccess::state(of, body_slot(of, slot)));
    });
}

fettle_code fettle_world_previous(const fettle_world* world, uint32_t slot, fettle_pose* pose) {
    return guarded(__func__, [&] {
        const World& of = live(world);
        needed("pose", pose) = converted(HostAccess::previous(of, body_slot(of, slot)));
    });
}

fettle_code fettle_world_mass(const fettle_world* world, uint32_t slot, float* mass) {
    return guarded(__func__, [&] {
        const World& of = live(world);
        float& result = needed("mass", mass);
        result = HostAccess::mass(of, body_slot(of, slot));
    });
}

fettle_code fettle_world_velocity(const fettle_world* world, uint32_t slot, fettle_vec2* velocity) {
    return guarded(__func__, [&] {
        const World& of = live(world);
        needed("velocity", velocity) = converted(HostAccess::velocity(of, body_slot(of, slot)));
    });
}

fettle_code fettle_world_body_in(const fettle_world* world, uint32_t slot, fettle_id* body) {
    return guarded(__func__, [&] {
        const World& of = live(world);
        needed("body", body) = converted(BodyId{slot, HostAccess::body_generation(of, slot)});
    });
}

fettle_code fettle_world_shape_in(const fettle_world* world, uint32_t slot, fettle_id* shape) {
    return guarded(__func__, [&] {
        const World& of = live(world);
        needed("shape", shape) = converted(ShapeId{slot, HostAccess::shape_generation(of, slot)});
    });
}

fettle_code fettle_world_body_slots(const fettle_world* world, uint32_t* body_slots) {
    return guarded(__func__,
                   [&] { needed("body_slots", body_slots) = HostAccess::body_slots(live(world)); });
}

fettle_code fettle_world_shape_slots(const fettle_world* world, uint32_t* shape_slots) {
    return guarded(__func__, [&] {
        needed("shape_slots", shape_slots) = HostAccess::shape_slots(live(world));
    });
}

fettle_code fettle_world_write(fettle_world* world, uint32_t slot, int32_t number, float value,
                               int32_t* written) {
    return guarded(__func__, [&] {
        World& to = editable(world);
        int32_t& result = needed("written", written);
        const auto which = enumerator("number", number, BodyNumber::angular_damping);
        result = int32_t(fettle::physics_c::written(to, body_slot(to, slot), which, value));
    });
}

fettle_code fettle_world_write_velocity(fettle_world* world, uint32_t slot, float x, float y,
                                        int32_t* written) {
    return guarded(__func__, [&] {
        World& to = editable(world);
        int32_t& result = needed("written", written);
        result = int32_t(
            HostAccess::write_velocity(to, body_slot(to, slot), checked(FiniteVector{x, y})));
    });
}

fettle_code fettle_world_set_velocity(fettle_world* world, uint32_t slot, float x, float y,
                                      bool* moves) {
    return guarded(__func__, [&] {
        World& to = editable(world);
        bool& result = needed("moves", moves);
        result = HostAccess::set_velocity(to, body_slot(to, slot), checked(FiniteVector{x, y}));
    });
}

// --- Many worlds

fettle_code fettle_worlds_step(fettle_world* const* worlds, uint32_t world_count, float dt) {
    return guarded(__func__, [&] {
        if (std::isnan(dt))
            throw Failure{FETTLE_INVALID,
                          name_and_value("dt", dt) + ": expected a number of seconds"};
        if (world_count > 0) needed("worlds", worlds);
        for (uint32_t i = 0; i < world_count; ++i) editable(worlds[i]);
        for (uint32_t i = 0; i < world_count; ++i) editable(worlds[i]).step(dt);
    });
}

fettle_code fettle_worlds_read_states(const fettle_world* const* worlds, uint32_t world_count,
                                      const fettle_id* bodies, uint32_t body_count,
                                      fettle_body_state* states) {
    return guarded(__func__, [&] {
        const auto found = checked_bodies(worlds, world_count, bodies, body_count);
        if (!found.empty()) needed("states", states);
        for (size_t i = 0; i < found.size(); ++i)
            states[i] = converted(HostAccess::state(found[i].world(), found[i].index()));
    });
}

fettle_code fettle_worlds_apply_forces(fettle_world* const* worlds, uint32_t world_count,
                                       const fettle_id* bodies, uint32_t body_count,
                                       const fettle_vec2* forces) {
    return guarded(__func__, [&] {
        auto found = checked_bodies(worlds, world_count, bodies, body_count);
        if (!found.empty()) needed("forces", forces);
        for (uint32_t i = 0; i < world_count; ++i) editable(worlds[i]);
        for (size_t i = 0; i < found.size(); ++i) {
            if (std::isfinite(forces[i].x) && std::isfinite(forces[i].y)) continue;
            const std::string name = "forces[" + std::to_string(i) + "].";
            checked(Finite{(name + "x").c_str(), forces[i].x});
            checked(Finite{(name + "y").c_str(), forces[i].y});
        }
        for (size_t i = 0; i < found.size(); ++i) found[i].apply_force(vector_of(forces[i]));
    });
}
