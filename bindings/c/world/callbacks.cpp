#include <fettle/physics_c/callbacks.h>

#include <functional>
#include <memory>

#include <calls/calls.h>
#include <calls/retired.h>
#include <fettle/physics/host_access.h>

namespace fettle::physics_c {

using namespace physics;

namespace {

/// Wraps a function in C as a callback of the library.
ContactCallback contact_callback(const fettle_world* world, fettle_contact_callback function,
                                 void* user) {
    if (function == nullptr) return {};
    return [world, function, user](ContactEdit& edit) {
        fettle_contact_edit result{converted(edit.shape_a),
                                   converted(edit.shape_b),
                                   converted(edit.point),
                                   converted(edit.normal),
                                   edit.speed,
                                   edit.impulse,
                                   edit.separation,
                                   edit.friction,
                                   edit.restitution,
                                   edit.surface_speed,
                                   edit.enabled,
                                   edit.ignored,
                                   edit.part_a,
                                   edit.part_b,
                                   edit.material_a,
                                   edit.material_b};
        function(user, world, &result);
        edit.friction = result.friction;
        edit.restitution = result.restitution;
        edit.surface_speed = result.surface_speed;
        edit.enabled = flag(result.enabled);
        edit.ignored = flag(result.ignored);
    };
}

PairFilter pair_filter(const fettle_world* world, fettle_pair_filter function, void* user) {
    if (function == nullptr) return {};
    return [world, function, user](const Shape& a, const Shape& b) {
        return function(user, world, converted(a), converted(b));
    };
}

RefreshCallback refresh_callback(const fettle_world* world, fettle_refresh_callback function,
                                 void* user) {
    if (function == nullptr) return {};
    return [world, function, user](const Refresh& refresh) {
        function(user, world, converted(refresh.of), refresh.slot);
    };
}

VelocityFunction velocity_function(const fettle_world* world, fettle_velocity_function function,
                                   void* user) {
    if (function == nullptr) return {};
    return [world, function, user](VelocityEdit& edit) {
        fettle_velocity_edit result{converted(edit.body),     edit.dt,
                                    converted(edit.before),   edit.angular_before,
                                    converted(edit.velocity), edit.angular_velocity};
        function(user, world, &result);
        edit.velocity = vector_of(result.velocity);
        edit.angular_velocity = result.angular_velocity;
    };
}

PositionFunction position_function(const fettle_world* world, fettle_position_function function,
                                   void* user) {
    if (function == nullptr) return {};
    return [world, function, user](PositionEdit& edit) {
        fettle_position_edit result{converted(edit.body), edit.dt, converted(edit.before),
                                    converted(edit.pose)};
        function(user, world, &result);
        edit.pose = pose_of(&result.pose);
    };
}

}  // namespace
}  // namespace fettle::physics_c

using namespace fettle::physics_c;
using fettle::physics::World;

fettle_code fettle_world_set_filter(fettle_world* world, fettle_pair_filter function, void* user) {
    return edit<&World::set_filter>(__func__, world, pair_filter(world, function, user));
}

fettle_code fettle_world_set_mixing(fettle_world* world, fettle_contact_callback function,
                                    void* user) {
    return edit<&World::set_mixing>(__func__, world, contact_callback(world, function, user));
}

fettle_code fettle_world_set_before_solve(fettle_world* world, fettle_contact_callback function,
                                          void* user) {
    return edit<&World::set_before_solve>(__func__, world, contact_callback(world, function, user));
}

fettle_code fettle_world_set_parallel_callbacks(fettle_world* world, bool parallel_callbacks) {
    return edit<&World::set_parallel_callbacks>(__func__, world, parallel_callbacks);
}

fettle_code fettle_world_parallel_callbacks(const fettle_world* world, bool* parallel_callbacks) {
    return read<&World::parallel_callbacks>(__func__, world, parallel_callbacks);
}

fettle_code fettle_body_set_velocity_function(fettle_world* world, fettle_id body,
                                              fettle_velocity_function function, void* user) {
    return on<fettle::physics::Body>(__func__, world, body, [&](fettle::physics::Body it) {
        it.set_velocity_function(velocity_function(world, function, user));
    });
}

fettle_code fettle_body_set_position_function(fettle_world* world, fettle_id body,
                                              fettle_position_function function, void* user) {
    return on<fettle::physics::Body>(__func__, world, body, [&](fettle::physics::Body it) {
        it.set_position_function(position_function(world, function, user));
    });
}

fettle_code fettle_world_on_refresh(fettle_world* world, fettle_refresh_callback function,
                                    void* user) {
    return guarded(__func__, [&] {
        HostAccess::on_refresh(editable(world), refresh_callback(world, function, user));
    });
}

fettle_code fettle_world_refresh(fettle_world* world, int32_t of, uint32_t slot) {
    return guarded(__func__, [&] {
        using fettle::physics::Refresh;
        HostAccess::refresh(editable(world), {enumerator("of", of, Refresh::Of::shape), slot});
    });
}

fettle_code fettle_world_locked(const fettle_world* world, bool* locked) {
    return guarded(__func__, [&] {
        bool& result = needed("locked", locked);
        result = live(world).locked() || world->visiting > 0;
    });
}

// --- The owner

fettle_code fettle_owner_create(const char* advice, fettle_owner** owner) {
    return guarded(__func__, [&] {
        fettle_owner*& made = needed("owner", owner);
        const char* const text = &needed("advice", advice);
        std::unique_ptr<fettle_owner> created = Retired<fettle_owner>::allocate();
        created->advice = text;
        created->owner.emplace(created->advice.c_str());
        made = created.release();
    });
}

fettle_code fettle_owner_on_unlocked(fettle_owner* owner, fettle_unlocked_callback function,
                                     void* user) {
    return guarded(__func__, [&] {
        std::function<void()> call;
        if (function != nullptr) call = [function, user] { function(user); };
        existing("owner", owner).owner->on_unlocked(std::move(call));
    });
}

fettle_code fettle_owner_destroy(fettle_owner* owner) {
    return guarded(__func__, [&] {
        fettle_owner& ended = existing("owner", owner);
        if (ended.worlds > 0 || ended.depth > 0)
            throw Failure{FETTLE_LOCKED, ended.depth > 0 ? "it acts" : "a world has this owner"};
        ended.owner.reset();
        Retired<fettle_owner>::keep(owner);
    });
}

fettle_code fettle_owner_begin(fettle_owner* owner) {
    return guarded(__func__, [&] {
        fettle_owner& acting = existing("owner", owner);
        if (acting.depth == 0) acting.acting.emplace(*acting.owner);
        ++acting.depth;
    });
}

fettle_code fettle_owner_end(fettle_owner* owner) {
    return guarded(__func__, [&] {
        fettle_owner& acting = existing("owner", owner);
        if (acting.depth == 0) throw Failure{FETTLE_INVALID, "there was no begin"};
        if (--acting.depth == 0) acting.acting.reset();
    });
}

fettle_code fettle_owner_acts(const fettle_owner* owner, bool* acts) {
    return guarded(__func__, [&] {
        bool& result = needed("acts", acts);
        result = existing("owner", owner).owner->acts();
    });
}

fettle_code fettle_owner_advice(const fettle_owner* owner, const char** advice) {
    return guarded(__func__, [&] {
        const char*& result = needed("advice", advice);
        result = existing("owner", owner).owner->advice();
    });
}

fettle_code fettle_world_set_owner(fettle_world* world, fettle_owner* owner) {
    return guarded(__func__, [&] {
        const fettle::physics::Owner* const given =
            owner != nullptr ? &*existing("owner", owner).owner : nullptr;
        editable(world).set_owner(given);
        if (world->owner != nullptr) --world->owner->worlds;
        if (owner != nullptr) ++owner->worlds;
        world->owner = owner;
    });
}
