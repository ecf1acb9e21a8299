#pragma once

#include <partition/strips.h>
#include <state/records.h>

#include <vector>

// Notes of one stage of a step for a later stage.

namespace fettle::physics::detail {

/// A body that moved far for its thickness in this step.
struct FastBody {
    uint32_t body = none;
    V2 start;  ///< center of mass before
    V2 shift;
    float turn = 0.0f;
};

/// What is left to do for some contacts after their manifolds: slots, in the order of the list.
struct CollidedPiece {
    std::vector<uint32_t> over;  ///< pairs that end
    std::vector<uint32_t> more;  ///< a touch ends, or a sleeping body is about to be hit

    void clear() {
        over.clear();
        more.clear();
    }
    static void scratch(auto& io, auto& self) { io(self.over), io(self.more); }
};

/// What is left to do for some bodies that have moved.
struct FinishedPiece {
    std::vector<int32_t> placed;  ///< leaves of the shapes that left their fat boxes
    std::vector<uint32_t> moved;  ///< those of these shapes that were not listed as moved
    std::vector<FastBody> fast;
    uint32_t sleep_candidates = 0;

    void clear() {
        placed.clear();
        moved.clear();
        fast.clear();
        sleep_candidates = 0;
    }
    static void scratch(auto& io, auto& self) { io(self.placed), io(self.moved), io(self.fast); }
};

/// A list that is put into the order of the strips.
struct Reordering {
    std::vector<uint32_t> list;
    std::vector<StripNode> strips;  ///< of the entries, in their old order

    static void scratch(auto& io, auto& self) { io(self.list), io(self.strips); }
};

/// What a joint that can break bore in this step, summed over the sub-steps.
struct Strain {
    uint32_t joint = none;
    uint32_t index = 0;  ///< among the constraints of its type
    V2 force;
    float torque = 0.0f;
};

}  // namespace fettle::physics::detail
