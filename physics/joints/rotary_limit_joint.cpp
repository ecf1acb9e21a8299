#include <joints/coordinate.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

// Limits of the angle of b relative to a: θ - lower >= 0 and upper - θ >= 0 with θ = θ_b - θ_a -
// reference, each with an impulse in one direction only and the effective mass 1/(I_a⁻¹ + I_b⁻¹).

namespace fettle::physics {
namespace detail {

struct RotaryLimitSettings {
    static constexpr JointType type = JointType::rotary_limit;
    float reference_angle = 0.0f;
    Limits limits;

    void check() const {
        check_finite("reference_angle", reference_angle);
        check_limit("lower_angle", limits.lower);
        check_limit("upper_angle", limits.upper);
    }
};

struct RotaryLimitConstraint {
    using Settings = RotaryLimitSettings;

    JointEnds ends;
    LimitImpulses impulses;
    Limits limits;
    float reference = 0.0f, mass = 0.0f;

    void prepare(const Settings& settings, const JointFrame&, const JointStep&, const SolverBody& a,
                 const SolverBody& b) {
        reference = settings.reference_angle;
        mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
        limits = mass > 0.0f ? settings.limits.in_order() : Limits();
        // A limit that stops acting begins with impulse 0 when it acts again.
        if (limits.lower == -infinity) impulses.lower = 0.0f;
        if (limits.upper == infinity) impulses.upper = 0.0f;
    }
    void warm_start(SolverBody& a, SolverBody& b) const { detail::twist(a, b, impulses.sum()); }
    template <bool biased>
    void pass(SolverBody& a, SolverBody& b, const JointStep& step) {
        solve_limits<biased>(
            limits, impulses, mass, angle(a, b), step, step.greatest_angle_gap,
            [&] { return b.angular_velocity - a.angular_velocity; },
            [&](float p) { detail::twist(a, b, p); });
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        write_limits(limits, impulses, angle(a, b), Jacobian::turning(ends), infinity, rows);
    }
    JointLoad load() const { return {{}, impulses.sum()}; }

  private:
    float angle(const SolverBody& a, const SolverBody& b) const {
        return ends.angle_now(a, b) - reference;
    }
};

constinit const JointKind rotary_limit_joint =
    JointFunctions<RotaryLimitConstraint>::kind("rotary-limit");

}  // namespace detail

using namespace detail;

FETTLE_JOINT_ANGLE(RotaryLimit)
FETTLE_JOINT_NUMBER(RotaryLimit, lower_angle, limits.lower)
FETTLE_JOINT_NUMBER(RotaryLimit, upper_angle, limits.upper)

namespace {

void define(RotaryLimitSettings& settings, const RotaryLimitJointDef& def) {
    settings.reference_angle = def.reference_angle.value_or(0.0f);
    settings.limits = {def.lower_angle, def.upper_angle};
}

}  // namespace

FETTLE_CREATE_JOINT(RotaryLimit, create_rotary_limit_joint,
                    if (!def.reference_angle) joint.set_reference_angle(angle_between(joint)))

}  // namespace fettle::physics
