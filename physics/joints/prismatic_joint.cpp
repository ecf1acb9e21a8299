#include <joints/joint_types.h>
#include <joints/rail.h>

// Lets b slide along an axis of a (`Rail`) without rotating.
//
// The rows across the axis and about the angle are solved as one block, because the levers s_a =
// R×n and s_b = r_b×n of the first row couple them:
//
//     C₁ = n·d,   C₂ = θ_b - θ_a - reference
//     K = | nᵀ(M_a⁻¹ + M_b⁻¹)n + I_a⁻¹s_a² + I_b⁻¹s_b²    I_a⁻¹s_a + I_b⁻¹s_b |
//         | I_a⁻¹s_a + I_b⁻¹s_b                            I_a⁻¹ + I_b⁻¹       |
//
// If they were solved one after the other, a drawer pulled at its corner would jam.

namespace fettle::physics {
namespace detail {

struct PrismaticSettings {
    static constexpr JointType type = JointType::prismatic;
    RailSettings rail;
    float reference_angle = 0.0f;

    void check() const {
        rail.check();
        check_finite("reference_angle", reference_angle);
    }
    bool gives_energy() const { return rail.gives_energy(); }
};

struct PrismaticImpulses {
    RailImpulses rail;
    float angle = 0.0f;
    void scale(float s) { rail.scale(s), angle *= s; }
};

struct PrismaticConstraint {
    using Settings = PrismaticSettings;

    JointEnds ends;
    PrismaticImpulses impulses;
    Rail rail;
    float reference = 0.0f;

    static float separation(const Settings& settings, const JointPlace& place) {
        return settings.rail.separation(place);
    }
    void prepare(const Settings& settings, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        reference = ends.nearest(settings.reference_angle);
        rail.prepare(settings.rail, impulses.rail, ends, frame, step, a, b);
    }
    void warm_start(SolverBody& a, SolverBody& b) const {
        rail.warm_start(impulses.rail, ends, a, b);
        detail::twist(a, b, impulses.angle);
    }
    template <bool biased>
    void pass(SolverBody& a, SolverBody& b, const JointStep& step) {
        rail.follow(ends, a, b);
        rail.solve_alone<biased>(impulses.rail, ends, a, b, step);
        solve_block<biased>(a, b, step);
        rail.solve_bounds<biased>(impulses.rail, ends, a, b, step, &impulses.angle);
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        rail.follow(ends, a, b);
        rail.write_rows(impulses.rail, ends, rows);
        rows.hold(Jacobian::turning(ends), ends.angle_now(a, b) - reference, impulses.angle);
    }
    JointLoad load() const { return {rail.force(impulses.rail), impulses.angle}; }
    bool moves_bodies(const SolverBody& a, const SolverBody& b) const {
        return rail.moves_bodies(a, b);
    }
    Drive drive() { return rail.drive(impulses.rail); }

  private:
    template <bool biased>
    void solve_block(SolverBody& a, SolverBody& b, const JointStep& step) {
        const Line& across = rail.across;
        const float ia = a.inverse_inertia, ib = b.inverse_inertia;
        const float k11 = ends.inverse_along(across.direction) +
                          ia * across.lever_a * across.lever_a +
                          ib * across.lever_b * across.lever_b;
        const float k12 = ia * across.lever_a + ib * across.lever_b;
        // Neither body rotates: the row about the angle has no effect and must not influence the
        // other row.
        const float k22 = ia + ib > 0.0f ? ia + ib : 1.0f;
        float v1 = across.velocity(a, b), v2 = b.angular_velocity - a.angular_velocity;
        float scale = 1.0f, rest = 0.0f, angle_rest = 0.0f;
        RailReaction reaction;
        if (biased) {
            const float offset = rail.close_wide_gap(ends, a, b, step);
            const Softness soft = step.softness(offset);
            v1 += soft.bias_rate * offset;
            const float error = ends.angle_now(a, b) - reference;
            const Softness angle_soft = ends.angle_softness(step, error);
            v2 += angle_soft.bias_rate * error;
            scale = soft.mass_scale;
            rest = soft.impulse_scale;
            angle_rest = min(rest, angle_soft.impulse_scale);
            reaction = rail.reaction(impulses.rail, ends, a, b, true);
        }
        const float own1 = impulses.rail.across - reaction.across,
                    own2 = impulses.angle - reaction.turning;
        const float inverse = inverse_or_zero(k11 * k22 - k12 * k12);
        const float p1 = -scale * inverse * (k22 * v1 - k12 * v2) - rest * own1;
        const float p2 =
            ia + ib > 0.0f ? -scale * inverse * (k11 * v2 - k12 * v1) - angle_rest * own2 : 0.0f;
        impulses.rail.across += p1;
        impulses.angle += p2;
        across.push(ends, a, b, p1);
        detail::twist(a, b, p2);
    }
};

constinit const JointKind prismatic_joint = JointFunctions<PrismaticConstraint>::kind("prismatic");

}  // namespace detail

using namespace detail;

FETTLE_RAIL(Prismatic)
FETTLE_RAIL_MOTOR(Prismatic)
FETTLE_JOINT_HELD_ANGLE(Prismatic)

namespace {

void define(PrismaticSettings& settings, const PrismaticJointDef& def) {
    settings.rail = {def.axis, driven_translation(def)};
    settings.reference_angle = def.reference_angle.value_or(0.0f);
}

}  // namespace

FETTLE_CREATE_JOINT(Prismatic, create_prismatic_joint,
                    if (!def.reference_angle) joint.set_reference_angle(angle_between(joint)))

}  // namespace fettle::physics
