#include <joints/coordinate.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

// Rotates b with a, by a ratio.
//
//     C = θ_b - ratio·θ_a - phase,   Ċ = ω_b - ratio·ω_a,   K = I_b⁻¹ + ratio²·I_a⁻¹
//
// The ratio of two meshed wheels is -r_a/r_b; that of two wheels with a belt is r_a/r_b. An impulse
// rotates b by λ and a by -ratio·λ, which are not equal and opposite: the axles take the
// difference, as in a gear box. Angles are world angles over any number of turns, so they come from
// the states and not from the relative angle.

namespace fettle::physics {
namespace detail {

struct GearSettings {
    static constexpr JointType type = JointType::gear;
    float ratio = 1.0f, phase = 0.0f;

    void check() const {
        check_finite("ratio", ratio);
        check_finite("phase", phase);
    }
};

struct GearConstraint {
    using Settings = GearSettings;
    struct Impulses {
        float angle = 0.0f;
        void scale(float s) { angle *= s; }
    };

    JointEnds ends;
    Impulses impulses;
    float ratio = 1.0f, mass = 0.0f;
    float start = 0.0f;  ///< C at the start of the step

    void prepare(const Settings& settings, const JointFrame& frame, const JointStep&,
                 const SolverBody& a, const SolverBody& b) {
        ratio = settings.ratio;
        mass = inverse_or_zero(b.inverse_inertia + ratio * ratio * a.inverse_inertia);
        start = float(frame.angle_b - double(ratio) * frame.angle_a - double(settings.phase));
    }
    void warm_start(SolverBody& a, SolverBody& b) const { mesh(a, b, impulses.angle); }
    template <bool biased>
    void pass(SolverBody& a, SolverBody& b, const JointStep& step) {
        const float velocity = b.angular_velocity - ratio * a.angular_velocity;
        mesh(a, b, push_rigid<biased>(impulses.angle, mass, velocity, error(a, b), step.rigid));
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        rows.hold(Jacobian::turning(ends, ratio), error(a, b), impulses.angle);
    }
    JointLoad load() const { return {{}, impulses.angle}; }

  private:
    float error(const SolverBody& a, const SolverBody& b) const {
        return start + (b.turn - ratio * a.turn);
    }
    void mesh(SolverBody& a, SolverBody& b, float p) const {
        a.angular_velocity -= a.inverse_inertia * ratio * p;
        b.angular_velocity += b.inverse_inertia * p;
    }
};

constinit const JointKind gear_joint = JointFunctions<GearConstraint>::kind("gear");

}  // namespace detail

using namespace detail;

FETTLE_JOINT_NUMBER(Gear, ratio, ratio)
FETTLE_JOINT_NUMBER(Gear, phase, phase)

float GearJoint::phase_now() const {
    const Body a = body_a(), b = body_b();
    return (b ? b.angle() : 0.0f) - ratio() * (a ? a.angle() : 0.0f);
}

namespace {

void define(GearSettings& settings, const GearJointDef& def) {
    settings.ratio = def.ratio;
    settings.phase = def.phase.value_or(0.0f);
}

}  // namespace

FETTLE_CREATE_JOINT(Gear, create_gear_joint, if (!def.phase) joint.set_phase(joint.phase_now()))

}  // namespace fettle::physics
