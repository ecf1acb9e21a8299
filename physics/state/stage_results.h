#pragma once

#include <geometry/motion.h>
#include <partition/strips.h>
#include <state/records.h>

#include <vector>

// Results of one stage of a step for later stages.

namespace fettle::physics::detail {

/// A body whose motion in a step is swept: it moved far compared with its thickness, or it was
/// moved by such a body.
struct FastBody {
    uint32_t body = none;
    Motion motion;
    bool meets_moving = false;  ///< moving bodies may stop it or carry it along
    bool joined = false;        ///< a fixed shape stopped it, and it has joints
};

/// The motion of an awake kinematic body, and its boxes on the way: `boxes` of them,
/// after those of the bodies listed before it.
struct DrivenBody {
    uint32_t body = none;
    Motion motion;
    Box4 box = no_box;  ///< around its shapes on their way
    uint32_t first_box = 0, boxes = 0;
};

/// A shape moved through a sensor, or a part of the shape through a part of the sensor.
struct Crossing {
    uint32_t sensor = none, visitor = none;  ///< as the user sees them
    uint32_t part_of_sensor = none, part_of_visitor = none;
    bool overlapped = false;  ///< at the end of the step
};

/// Contacts that need more work after their manifolds: slots, in the order of the list.
struct CollidedPiece {
    std::vector<uint32_t> over;  ///< pairs that end
    std::vector<uint32_t> more;  ///< touch ends, or about to hit a sleeping body

    void clear() {
        over.clear();
        more.clear();
    }
    static void scratch(auto& io, auto& self) { io(self.over), io(self.more); }
};

/// Bodies that need more work after they have moved.
struct FinishedPiece {
    std::vector<int32_t> placed;  ///< leaves of the shapes that left their fat boxes
    std::vector<uint32_t> moved;  ///< the shapes among them that are not yet listed as moved
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

/// Memory for sorting a list into the order of the strips.
struct Reordering {
    std::vector<uint32_t> list;
    std::vector<StripNode> strips;  ///< strips of the entries, in their old order

    static void scratch(auto& io, auto& self) { io(self.list), io(self.strips); }
};

/// Load of a joint that can break in this step, summed over the sub-steps.
struct Strain {
    uint32_t joint = none;
    uint32_t array = 0;  ///< index of its array
    uint32_t index = 0;  ///< place in the constraints of that array
    Vec2 force;
    float torque = 0.0f;
};

}  // namespace fettle::physics::detail
