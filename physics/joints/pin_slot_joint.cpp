#include <joints/joint_types.h>
#include <joints/rail.h>

// A pin of b in a straight slot of a, in which it slides and rotates. It is held across the slot;
// spring, motor and limits act along the slot (`Rail`).

namespace fettle::physics {
namespace detail {

struct PinSlotSettings {
    static constexpr JointType type = JointType::pin_slot;
    RailSettings rail;

    void check() const { rail.check(); }
    bool gives_energy() const { return rail.gives_energy(); }
};

using PinSlotImpulses = SlotConstraint::Impulses;

struct PinSlotConstraint : SlotConstraint {
    using Settings = PinSlotSettings;

    static float separation(const Settings& settings, const JointPlace& place) {
        return settings.rail.separation(place);
    }
    void prepare(const Settings& settings, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        rail.prepare(settings.rail, impulses.rail, ends, frame, step, a, b);
    }
};

constinit const JointKind pin_slot_joint = JointFunctions<PinSlotConstraint>::kind("pin-slot");

}  // namespace detail

using namespace detail;

FETTLE_RAIL(PinSlot)
FETTLE_RAIL_MOTOR(PinSlot)

namespace {

void define(PinSlotSettings& settings, const PinSlotJointDef& def) {
    settings.rail = {def.axis, driven_translation(def)};
}

}  // namespace

FETTLE_CREATE_JOINT(PinSlot, create_pin_slot_joint, )

}  // namespace fettle::physics
