#pragma once

#include <world/arguments.h>
#include <world/world_data.h>

namespace fettle::physics::detail {

inline WorldData& live(World* world, WorldData* data, BodyId id) {
    if (world == nullptr || !world->is_valid(id)) dangling("body", id.index, id.generation);
    return *data;
}

}  // namespace fettle::physics::detail

// The first line of every method of `Body` that needs a live one: `data`, and its records.
#define FETTLE_LIVE_BODY                                                         \
    WorldData& data = live(world_, world_ ? world_->data_.get() : nullptr, id_); \
    [[maybe_unused]] BodyRecord& record = data.bodies[id_.index];                \
    [[maybe_unused]] BodyState& state = data.states[id_.index];
