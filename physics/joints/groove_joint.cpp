#include <joints/joint_types.h>
#include <joints/rail.h>

// A pin of b in a groove of a between two points: a slot with given ends. The axis is the line
// between them, and the limits are 0 and its length |end - begin|.

namespace fettle::physics {
namespace detail {

struct GrooveSettings {
    static constexpr JointType type = JointType::groove;
    Position end = {1.0f, 0.0f};  ///< in the coordinates of body a; the groove begins at the anchor

    void check() const { check_coordinates("end", end); }
};

struct GrooveConstraint : SlotConstraint {
    using Settings = GrooveSettings;

    static float separation(const Settings& settings, const JointPlace& place) {
        return slot_of(settings, place.local_anchor_a).separation(place);
    }
    void prepare(const Settings& settings, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        rail.prepare(slot_of(settings, frame.anchor_a), impulses.rail, ends, frame, step, a, b);
    }

  private:
    static RailSettings slot_of(const Settings& settings, const Position& begin) {
        const Vec2 run = settings.end - begin;
        RailSettings slot;
        slot.along.limits = {0.0f, length(run)};
        // If both ends are at the same point, the pin is held there, and the direction does not
        // matter.
        if (slot.along.limits.upper > 1e-6f) slot.axis = run;
        return slot;
    }
};

constinit const JointKind groove_joint = JointFunctions<GrooveConstraint>::kind("groove");

}  // namespace detail

using namespace detail;

FETTLE_JOINT_POSITION(Groove, end, end)

float GrooveJoint::translation() const {
    return translation_along(*this, end() - anchor_a());
}

namespace {

void define(GrooveSettings& settings, const GrooveJointDef& def) {
    settings.end = def.end;
}

}  // namespace

FETTLE_CREATE_JOINT(Groove, create_groove_joint, )

}  // namespace fettle::physics
