#pragma once

#include <world/world_data.h>

/// Access to the data of a world.
struct fettle::physics::detail::WorldInside {
    static WorldData& of(World& world) { return *world.data_; }
};
