#pragma once

#include <cstdint>

namespace fettle::physics::detail {

/// A contact that acts in this step, as those see it who color it and put it into a group.
struct ActingContact {
    uint32_t slot = 0;
    uint32_t end_a = 0, end_b = 0;  ///< solver index << 1 | takes impulses
    float friction = 0.0f;
    uint32_t place = 0;  ///< among those of its color and block; then its lane
    uint8_t color = 0;
    bool serially = false;  ///< solved one at a time
    bool touching = false, hit_events = false;

    uint32_t a() const { return end_a >> 1; }
    uint32_t b() const { return end_b >> 1; }
    bool moves_a() const { return (end_a & 1) != 0; }
    bool moves_b() const { return (end_b & 1) != 0; }
    bool both_move() const { return (end_a & end_b & 1) != 0; }
    /// The one that takes impulses, or one of the two.
    uint32_t mover() const { return moves_a() ? a() : b(); }
};
static_assert(sizeof(ActingContact) == 24);

/// Those that a thread found, in the order of the awake contacts.
struct ActingPiece {
    uint32_t begin = 0, end = 0;
    uint32_t serially = 0;      ///< how many of them
    bool links_blocks = false;  ///< two blocks of an earlier step
};

}  // namespace fettle::physics::detail
