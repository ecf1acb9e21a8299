#pragma once

#include <state/records.h>

#include <cstdint>
#include <span>

namespace fettle::physics {
class World;
}

namespace fettle::physics::detail {

struct WorldData;

/// The link from handles to their world: the world and its data, or null after its destruction.
/// Later worlds use links again, and links are never freed, so a handle may outlive its world. A
/// link also numbers the generations: it never uses a number twice, and two links begin far apart.
/// Therefore an id is invalid in any other world, and in a later world of the same link.
struct WorldLink {
    World* world = nullptr;     ///< null: destroyed
    WorldData* data = nullptr;  ///< null: destroyed
    Generations generations;

    /// Skips the generations of a state from another link, so that they are not used again soon.
    void skip(std::span<const uint32_t> given);
};

/// A link for a new world.
WorldLink& acquire_link();
/// Must be called when the world of the link was destroyed.
void release_link(WorldLink& link);

/// Throws for a handle without an object: it is default-constructed, or its object or its world was
/// destroyed.
[[noreturn]] void refuse_dangling(const char* kind, const WorldLink* link, uint32_t index,
                                  uint32_t generation);
/// Throws for an id of another world; `name`: its name in the definition.
[[noreturn]] void refuse_foreign(const char* name, const char* kind, uint32_t index,
                                 uint32_t generation);

}  // namespace fettle::physics::detail
