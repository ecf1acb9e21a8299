#pragma once

#include <state/records.h>

#include <cstdint>
#include <span>

namespace fettle::physics {
class World;
}

namespace fettle::physics::detail {

struct WorldData;

/// What handles hold of their world: the world and its data, or that it was destroyed.
/// Links are used again by later worlds and never freed, so a handle may outlive its world. They
/// give the generations too: one link never gives a number twice, and two links begin far apart.
/// Therefore an id names nothing in any other world, and nothing in a later world of the same link.
struct WorldLink {
    World* world = nullptr;     ///< null: destroyed
    WorldData* data = nullptr;  ///< null: destroyed
    Generations generations;

    /// Generations that are in a state which came from elsewhere: none that would soon be given
    /// here is given again.
    void skip(std::span<const uint32_t> given);
};

/// Of a new world.
WorldLink& take_link();
/// Its world was destroyed.
void return_link(WorldLink& link);

/// Throws for a handle without an object: default-made, or its object or its world was destroyed.
[[noreturn]] void dangling(const char* kind, const WorldLink* link, uint32_t index,
                           uint32_t generation);
/// Throws for an id of another world; `name` is what a definition calls it.
[[noreturn]] void foreign(const char* name, const char* kind, uint32_t index, uint32_t generation);

}  // namespace fettle::physics::detail
