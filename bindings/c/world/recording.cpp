#include <fettle/physics_c/recording.h>

#include <fettle/physics/recording.h>

#include <memory>
#include <optional>

#include <calls/calls.h>
#include <calls/retired.h>

struct fettle_replay {
    bool is_destroyed() const { return !replay.has_value(); }

    std::optional<fettle::physics::Replay> replay;  ///< none: destroyed
    std::string calls;                              ///< before the last step
};

using namespace fettle::physics_c;
using fettle::physics::RecordingSink;
using fettle::physics::Replay;
using fettle::physics::World;

fettle_code fettle_world_start_recording(fettle_world* world, fettle_recording_sink function,
                                         void* user) {
    return guarded(__func__, [&] {
        World& recorded = editable(world);
        RecordingSink sink;
        if (function != nullptr)
            sink = [world, function, user](std::span<const std::byte> bytes) {
                function(user, world, bytes.data(), bytes.size());
            };
        recorded.start_recording(std::move(sink));
    });
}

fettle_code fettle_world_stop_recording(fettle_world* world) {
    return edit<&World::stop_recording>(__func__, world);
}

fettle_code fettle_world_is_recorded(const fettle_world* world, bool* is_recorded) {
    return read<&World::is_recorded>(__func__, world, is_recorded);
}

fettle_code fettle_replay_create(const void* bytes, size_t size, fettle_replay** replay) {
    return guarded(__func__, [&] {
        fettle_replay*& made = needed("replay", replay);
        if (size > 0) needed("bytes", static_cast<const char*>(bytes));
        const auto* const begin = static_cast<const std::byte*>(bytes);
        Replay replayed(std::span(begin, size));
        std::unique_ptr<fettle_replay> created = Retired<fettle_replay>::allocate();
        created->replay.emplace(std::move(replayed));
        made = created.release();
    });
}

fettle_code fettle_replay_destroy(fettle_replay* replay) {
    return guarded(__func__, [&] {
        if (replay == nullptr) return;
        existing("replay", replay) = {};
        Retired<fettle_replay>::keep(replay);
    });
}

fettle_code fettle_replay_steps(const fettle_replay* replay, uint64_t* steps) {
    return guarded(__func__, [&] {
        uint64_t& result = needed("steps", steps);
        result = existing("replay", replay).replay->steps();
    });
}

fettle_code fettle_replay_is_cut_off(const fettle_replay* replay, bool* is_cut_off) {
    return guarded(__func__, [&] {
        bool& result = needed("is_cut_off", is_cut_off);
        result = existing("replay", replay).replay->is_cut_off();
    });
}

fettle_code fettle_replay_step(fettle_replay* replay, fettle_replayed_step* step, bool* repeated) {
    return guarded(__func__, [&] {
        fettle_replay& stepped = existing("replay", replay);
        fettle_replayed_step& result = needed("step", step);
        bool& any = needed("repeated", repeated);
        const auto next = stepped.replay->step();
        any = next.has_value();
        result = {};
        if (!next) return;
        stepped.calls = next->calls;
        result = {next->number,
                  next->dt,
                  next->same,
                  next->recorded_hash.has_value(),
                  next->recorded_hash.value_or(0),
                  next->hash,
                  stepped.calls.c_str()};
    });
}

fettle_code fettle_replay_world(const fettle_replay* replay, fettle_world** world) {
    return guarded(__func__, [&] {
        fettle_world*& made = needed("world", world);
        const World& of = existing("replay", replay).replay->world();
        made = adopt(std::make_unique<World>(of.clone()));
    });
}
