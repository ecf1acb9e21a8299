#pragma once

#include <world/world_data.h>

/// What the world has inside.
struct fettle::physics::detail::WorldInside {
    static WorldData& of(World& world) { return *world.data_; }
};
