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

/// What a new manifold takes over from the points of the last step.
struct OldPoints {
    int count = 0;
    uint32_t features[2] = {};
    float normal_impulses[2] = {}, tangent_impulses[2] = {};

    static OldPoints of(const Manifold& m) {
        OldPoints old;
        old.count = m.count;
        for (int i = 0; i < m.count; ++i) {
            old.features[i] = m.points[i].feature;
            old.normal_impulses[i] = m.points[i].normal_impulse;
            old.tangent_impulses[i] = m.points[i].tangent_impulse;
        }
        return old;
    }
    /// A point with the same vertex and the same edge keeps its impulses for the warm start.
    void give_impulses(Manifold& m) const {
        for (int k = 0; k < m.count; ++k) {
            ManifoldPoint& point = m.points[k];
            for (int i = 0; i < count; ++i) {
                if (features[i] != point.feature) continue;
                point.normal_impulse = normal_impulses[i];
                point.tangent_impulse = tangent_impulses[i];
                break;
            }
        }
    }
};

/// A contact that other shapes may change: contacts/flush_shapes.h.
struct FlushContact {
    uint32_t slot = none;
    bool known = false;  ///< the geometry of its point is stored
    OldPoints before;
};

/// Contacts that need more work after their manifolds: slots, in the order of the list.
struct CollidedPiece {
    std::vector<uint32_t> over;       ///< pairs that end
    std::vector<uint32_t> more;       ///< touch ends, or about to hit a sleeping body
    std::vector<FlushContact> flush;  ///< not finished: they depend on other pairs

    void clear() {
        over.clear();
        more.clear();
        flush.clear();
    }
    static void scratch(auto& io, auto& self) { io(self.over), io(self.more), io(self.flush); }
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
