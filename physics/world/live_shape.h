#pragma once

#include <world/arguments.h>
#include <world/world_data.h>

namespace fettle::physics::detail {

inline WorldData& live(World* world, WorldData* data, ShapeId id) {
    if (world == nullptr || !world->is_valid(id)) dangling("shape", id.index, id.generation);
    return *data;
}

}  // namespace fettle::physics::detail

// The first line of every method of `Shape` that needs a live one: `data`, and its records.
#define FETTLE_LIVE_SHAPE                                                        \
    WorldData& data = live(world_, world_ ? world_->data_.get() : nullptr, id_); \
    [[maybe_unused]] ShapeRecord& record = data.shapes[id_.index];               \
    [[maybe_unused]] ShapeForm& form = data.forms[id_.index];
