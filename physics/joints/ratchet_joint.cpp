#include <joints/coordinate.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

#include <cmath>

// Lets b rotate relative to a in one direction only.
//
// With θ = ±(θ_b - θ_a - reference), positive in the free direction, a pawl falls behind every
// tooth that passes: caught = tooth·⌊θ/tooth⌋, and never decreases; a tooth of 0 is a continuous
// ratchet, caught = θ. Then θ - caught >= 0 is a limit that pushes in one direction only, with the
// effective mass 1/(I_a⁻¹ + I_b⁻¹). The position of the pawl is part of the state.

namespace fettle::physics {
namespace detail {

struct RatchetSettings {
    static constexpr JointType type = JointType::ratchet;
    float tooth = 0.0f;      ///< rad
    float direction = 1.0f;  ///< direction in which b may rotate: 1, or -1 for backwards
    float reference_angle = 0.0f;

    void check() const {
        check_not_negative("tooth", tooth);
        check_range("direction", std::fabs(direction), 1.0f, 1.0f);
        check_finite("reference_angle", reference_angle);
    }
};

struct RatchetImpulses {
    float pawl = 0.0f;
    float caught = 0.0f;   ///< angle of the tooth that holds the pawl, rad
    float engaged = 0.0f;  ///< 1: a tooth holds the pawl
    void scale(float s) { pawl *= s; }
};

struct RatchetConstraint {
    using Settings = RatchetSettings;

    JointEnds ends;
    RatchetImpulses impulses;
    float direction = 1.0f, reference = 0.0f, mass = 0.0f;

    void prepare(const Settings& settings, const JointFrame&, const JointStep&, const SolverBody& a,
                 const SolverBody& b) {
        direction = settings.direction;
        reference = settings.reference_angle;
        mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
        const float angle = direction * (ends.angle - reference);
        float tooth = angle;
        if (settings.tooth > 0.0f) {
            // At a tooth, the load may push the pawl a little below the tooth.
            const float slack = min(0.01f, 0.1f * settings.tooth);
            const float passed = settings.tooth * std::floor((angle + slack) / settings.tooth);
            // For too many teeth to count, the ratchet is continuous.
            if (std::isfinite(passed)) tooth = passed;
        }
        if (impulses.engaged == 0.0f || tooth > impulses.caught) impulses.caught = tooth;
        impulses.engaged = 1.0f;
    }
    void warm_start(SolverBody& a, SolverBody& b) const { detail::twist(a, b, load().twist); }
    template <bool biased>
    void pass(SolverBody& a, SolverBody& b, const JointStep& step) {
        const float velocity = direction * (b.angular_velocity - a.angular_velocity);
        detail::twist(a, b,
                      direction * push_limit<biased>(impulses.pawl, mass, velocity, room(a, b),
                                                     step, step.greatest_angle_gap));
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        const Jacobian turning = Jacobian::turning(ends);
        rows.limit(direction > 0.0f ? turning : turning.opposite(), room(a, b), impulses.pawl);
    }
    JointLoad load() const { return {{}, direction * impulses.pawl}; }

  private:
    float room(const SolverBody& a, const SolverBody& b) const {
        return direction * (ends.angle_now(a, b) - reference) - impulses.caught;
    }
};

constinit const JointKind ratchet_joint = JointFunctions<RatchetConstraint>::kind("ratchet");

}  // namespace detail

using namespace detail;

FETTLE_JOINT_NUMBER(Ratchet, tooth, tooth)

float RatchetJoint::reference_angle() const {
    return settings_as<RatchetSettings>().reference_angle;
}
void RatchetJoint::set_reference_angle(float angle) {
    settings_as<RatchetSettings>();
    const float checked = check_finite("reference_angle", angle);
    edit<RatchetSettings>("RatchetJoint", __func__).reference_angle = checked;
    // The teeth have moved, so the pawl must find its tooth again.
    live().joints[id().index].impulses = {};
}
bool RatchetJoint::backwards() const {
    return settings_as<RatchetSettings>().direction < 0.0f;
}
void RatchetJoint::set_backwards(bool backwards) {
    edit<RatchetSettings>("RatchetJoint", __func__).direction = backwards ? -1.0f : 1.0f;
    live().joints[id().index].impulses = {};
}
float RatchetJoint::angle() const {
    return angle_between(*this) - reference_angle();
}
float RatchetJoint::caught_angle() const {
    const float direction = settings_as<RatchetSettings>().direction;
    const auto& pawl = live().joints[id().index].impulses.as<RatchetImpulses>();
    return pawl.engaged == 0.0f ? angle() : direction * pawl.caught;
}

namespace {

void define(RatchetSettings& settings, const RatchetJointDef& def) {
    settings.tooth = def.tooth;
    settings.direction = def.backwards ? -1.0f : 1.0f;
    settings.reference_angle = def.reference_angle.value_or(0.0f);
}

}  // namespace

FETTLE_CREATE_JOINT(Ratchet, create_ratchet_joint,
                    if (!def.reference_angle) joint.set_reference_angle(angle_between(joint)))

}  // namespace fettle::physics
