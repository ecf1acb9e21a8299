#include <fettle/physics_c/world.h>

#include <cmath>
#include <span>

#include <calls/calls.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

// --- Life and steps

fettle_code fettle_world_create(const fettle_world_def* def, fettle_world** world) {
    return guarded(__func__, [&] {
        fettle_world*& made = needed("world", world);
        made = adopt(std::make_unique<World>(definition_of(def)));
    });
}

fettle_code fettle_world_destroy(fettle_world* world) {
    return guarded(__func__, [&] {
        if (world == nullptr) return;
        if (editable(world).locked())
            throw Failure{FETTLE_LOCKED,
                          "the world is calling a function: destroy it after the call"};
        retire(world);
    });
}

fettle_code fettle_world_step(fettle_world* world, float dt) {
    return guarded(__func__, [&] {
        World& stepped = editable(world);
        if (std::isnan(dt))
            throw Failure{FETTLE_INVALID,
                          name_and_value("dt", dt) + ": expected a number of seconds"};
        stepped.step(dt);
    });
}

fettle_code fettle_world_after_step(fettle_world* world, fettle_after_step function, void* user) {
    return guarded(__func__, [&] {
        if (function == nullptr)
            throw Failure{FETTLE_INVALID, "function: expected a function, got null"};
        live(world).after_step([world, function, user] { function(user, world); });
    });
}

fettle_code fettle_world_reserve(fettle_world* world, uint32_t bodies, uint32_t shapes,
                                 uint32_t contacts, uint32_t joints) {
    return edit<&World::reserve>(__func__, world, Capacity{bodies, shapes, contacts, joints});
}

fettle_code fettle_world_wake_all(fettle_world* world) {
    return edit<&World::wake_all>(__func__, world);
}

fettle_code fettle_world_clear(fettle_world* world) {
    return edit<&World::clear>(__func__, world);
}

// --- Snapshots

fettle_code fettle_world_clone(const fettle_world* world, fettle_world** clone) {
    return guarded(__func__, [&] {
        fettle_world*& made = needed("clone", clone);
        made = adopt(std::make_unique<World>(live(world).clone()));
    });
}

fettle_code fettle_world_assign(fettle_world* world, const fettle_world* from) {
    return guarded(__func__, [&] {
        World& to = editable(world);
        to.restore(live(from));
    });
}

fettle_code fettle_world_take(fettle_world* world, fettle_world* from) {
    return guarded(__func__, [&] {
        World& to = editable(world);
        World& other = editable(from);
        if (&to == &other)
            throw Failure{FETTLE_INVALID, "from: expected another world, got the same one"};
        to.take(std::move(other));
    });
}

fettle_code fettle_world_save(fettle_world* world, const void** bytes, size_t* size) {
    return guarded(__func__, [&] {
        const void*& begin = needed("bytes", bytes);
        size_t& length = needed("size", size);
        std::vector<std::byte> saved;
        editable(world).save(saved);
        world->saved = std::move(saved);
        begin = world->saved.data();
        length = world->saved.size();
    });
}

fettle_code fettle_world_restore(fettle_world* world, const void* bytes, size_t size) {
    return guarded(__func__, [&] {
        World& to = editable(world);
        if (size > 0) needed("bytes", static_cast<const char*>(bytes));
        to.restore(std::span(static_cast<const std::byte*>(bytes), size));
    });
}

fettle_code fettle_world_hash(const fettle_world* world, uint64_t* hash) {
    return read<&World::hash>(__func__, world, hash);
}

// --- Measuring and checking

fettle_code fettle_world_statistics(const fettle_world* world, fettle_statistics* statistics) {
    return guarded(__func__, [&] {
        fettle_statistics& result = needed("statistics", statistics);
        const StepStatistics& of = live(world).statistics();
        result = {of.steps,         of.bodies,        of.awake_bodies,    of.shapes,   of.joints,
                  of.awake_joints,  of.contacts,      of.awake_contacts,  of.touching, of.islands,
                  of.moved_proxies, of.direct_solves, of.direct_failures, of.edits_ms, of.pairs_ms,
                  of.narrow_ms,     of.solve_ms,      of.finish_ms,       of.sleep_ms, of.total_ms};
    });
}

fettle_code fettle_world_memory(const fettle_world* world, fettle_memory_share* out, uint32_t room,
                                uint32_t* count) {
    return list<&World::memory>(__func__, world, out, room, count);
}

fettle_code fettle_world_validate(fettle_world* world, const char** fault) {
    return guarded(__func__, [&] {
        const char*& result = needed("fault", fault);
        auto found = editable(world).validate();
        world->fault = found ? std::move(*found) : std::string();
        result = found ? world->fault.c_str() : nullptr;
    });
}
