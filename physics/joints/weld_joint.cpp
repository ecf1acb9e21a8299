#include <joints/coordinate.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

// Holds two bodies together at a point and an angle, rigidly or as a spring.
//
// Three rows: C = p_b - p_a and C_θ = θ_b - θ_a - reference. The inertia couples them,
//
//     K = | M + I_a⁻¹·a aᵀ + I_b⁻¹·b bᵀ    I_a⁻¹·a + I_b⁻¹·b |     M = M_a⁻¹ + M_b⁻¹,
//         | (I_a⁻¹·a + I_b⁻¹·b)ᵀ           I_a⁻¹ + I_b⁻¹     |     a = r_a⊥, b = r_b⊥,
//
// and a cantilever is stiff only if they are solved together. Eliminating the angle leaves
//
//     K' = M + I_a⁻¹I_b⁻¹/(I_a⁻¹ + I_b⁻¹) · (a - b)(a - b)ᵀ
//
// for the point, in a form without cancellation; then λ_θ = -(v_θ + k·λ)/(I_a⁻¹ + I_b⁻¹) with k =
// I_a⁻¹·a + I_b⁻¹·b. If the point or the angle is a spring, each is solved by itself. A spring at
// the point pushes both bodies at one point, in the middle between the anchors: pushed at points
// that are apart, they would gain or lose angular momentum.

namespace fettle::physics {
namespace detail {

struct WeldSettings {
    static constexpr JointType type = JointType::weld;
    float reference_angle = 0.0f;
    Stiffness point = {infinity, 0.0f}, angle = {infinity, 0.0f};

    void check() const {
        check_finite("reference_angle", reference_angle);
        check_strength("hertz", point.hertz);
        check_not_negative("damping_ratio", point.damping_ratio);
        check_strength("angular_hertz", angle.hertz);
        check_not_negative("angular_damping_ratio", angle.damping_ratio);
    }
    bool gives_energy() const { return point.is_spring() || angle.is_spring(); }
};

struct WeldConstraint {
    using Settings = WeldSettings;
    struct Impulses {
        Vec2 point;
        float angle = 0.0f;
        void scale(float s) { point = s * point, angle *= s; }
    };

    JointEnds ends;
    Impulses impulses;
    float reference = 0.0f, angular_mass = 0.0f;
    bool rigid_point = true, rigid_angle = true, springy_point = false, springy_angle = false;
    PointSpring point_spring;
    Spring angle_spring;

    static float separation(const Settings& settings, const JointPlace& place) {
        return settings.point.is_rigid() ? length(place.gap()) : 0.0f;
    }
    static bool holds(const Settings& settings) { return settings.point.is_rigid(); }
    bool holds_point() const { return rigid_point; }
    void prepare(const Settings& settings, const JointFrame&, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        reference = ends.nearest(settings.reference_angle);
        angular_mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
        rigid_point = settings.point.is_rigid();
        rigid_angle = settings.angle.is_rigid();
        springy_point = settings.point.is_spring();
        springy_angle = settings.angle.is_spring();
        if (springy_point)
            point_spring = PointSpring::make(settings.point, step.h, ends.spring_mass(a, b),
                                             PointInverse::make(ends, a, b), ends.joints);
        if (springy_angle)
            angle_spring =
                Spring::make(settings.angle, step.h, angular_mass, angular_mass, ends.joints);
        // A part that stops acting begins with impulse 0 when it acts again.
        if (!rigid_point && !springy_point) impulses.point = {};
        if ((!rigid_angle && !springy_angle) || angular_mass == 0.0f) impulses.angle = 0.0f;
        follow(a, b);
    }
    /// Rotates the levers with the bodies; returns the vector from anchor a to anchor b.
    Vec2 follow(const SolverBody& a, const SolverBody& b) {
        ends.follow(a, b);
        const Vec2 gap = ends.gap(a, b);
        if (springy_point) {
            ends.lever_a = ends.lever_a + 0.5f * gap;
            ends.lever_b = ends.lever_b - 0.5f * gap;
        }
        return gap;
    }
    void warm_start(SolverBody& a, SolverBody& b) const {
        ends.push(a, b, impulses.point);
        detail::twist(a, b, impulses.angle);
    }
    void solve(SolverBody& a, SolverBody& b, const JointStep& step) {
        const Vec2 gap = follow(a, b);
        solve_springs(a, b, gap);
        if (rigid_point) ends.close_wide_gap(a, b, ends.gap(a, b), step);
        if (rigid_point || rigid_angle) solve_rigid<true>(a, b, step);
    }
    void relax(SolverBody& a, SolverBody& b, const JointStep& step) {
        // Springs do not act here, but the next sub-step begins with their impulses.
        follow(a, b);
        if (rigid_point || rigid_angle) solve_rigid<false>(a, b, step);
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        const Vec2 gap = follow(a, b);
        const Jacobian turning = Jacobian::turning(ends);
        const float angle = ends.angle_now(a, b) - reference;
        if (rigid_angle)
            rows.hold(turning, angle, impulses.angle);
        else if (springy_angle)
            rows.spring(turning, angle_spring, angle, impulses.angle);
        if (rigid_point)
            rows.hold_point(ends, gap, impulses.point);
        else if (springy_point)
            rows.springs(ends, point_spring, gap, infinity, impulses.point);
    }
    JointLoad load() const { return {impulses.point, impulses.angle}; }

  private:
    template <bool biased>
    void solve_rigid(SolverBody& a, SolverBody& b, const JointStep& step) {
        Vec2 v = ends.velocity(a, b);
        float w = b.angular_velocity - a.angular_velocity;
        float scale = 1.0f, rest = 0.0f, angle_rest = 0.0f;
        if (biased) {
            const Vec2 gap = ends.gap(a, b);
            const Softness soft = step.softness(gap);
            v = v + soft.bias_rate * gap;
            const float error = ends.angle_now(a, b) - reference;
            const Softness angle_soft = ends.angle_softness(step, error);
            w += angle_soft.bias_rate * error;
            scale = soft.mass_scale;
            rest = soft.impulse_scale;
            angle_rest = min(rest, angle_soft.impulse_scale);
        }
        const float ia = a.inverse_inertia, ib = b.inverse_inertia;
        if (!rigid_angle || angular_mass == 0.0f) {
            const PointMass mass = PointMass::make(ends, a, b);
            return apply(a, b, -scale * (mass * v) - rest * impulses.point, 0.0f);
        }
        scale *= ends.share;
        if (!rigid_point)
            return apply(a, b, {}, -scale * angular_mass * w - angle_rest * impulses.angle);
        const Vec2 arm_a = cross(1.0f, ends.lever_a), arm_b = cross(1.0f, ends.lever_b);
        const Vec2 k = ia * arm_a + ib * arm_b, between = arm_a - arm_b;
        const float shared = ia * ib * angular_mass;
        const float xx = ends.inverse_a.x + ends.inverse_b.x + shared * between.x * between.x;
        const float yy = ends.inverse_a.y + ends.inverse_b.y + shared * between.y * between.y;
        const float xy = shared * between.x * between.y;
        const float inverse = inverse_or_zero(xx * yy - xy * xy);
        const Vec2 free = v - (w * angular_mass) * k;  // for an angle at rest
        const Vec2 point = {-inverse * (yy * free.x - xy * free.y),
                            -inverse * (xx * free.y - xy * free.x)};
        const float angle = -angular_mass * (w + dot(k, point));
        apply(a, b, scale * point - rest * impulses.point,
              scale * angle - angle_rest * impulses.angle);
    }
    void solve_springs(SolverBody& a, SolverBody& b, Vec2 gap) {
        if (springy_angle && angular_mass > 0.0f) {
            const float change =
                angle_spring.impulse(angular_mass, b.angular_velocity - a.angular_velocity,
                                     ends.angle_now(a, b) - reference, impulses.angle);
            apply(a, b, {}, change);
        }
        if (springy_point) {
            const Vec2 now = point_spring.impulse(PointInverse::make(ends, a, b),
                                                  ends.velocity(a, b), gap, impulses.point);
            apply(a, b, now - impulses.point, 0.0f);
        }
    }
    void apply(SolverBody& a, SolverBody& b, Vec2 point, float angle) {
        impulses.point = impulses.point + point;
        impulses.angle += angle;
        ends.push(a, b, point);
        detail::twist(a, b, angle);
    }
};

constinit const JointKind weld_joint = JointFunctions<WeldConstraint>::kind("weld");

}  // namespace detail

using namespace detail;

FETTLE_JOINT_HELD_ANGLE(Weld)
FETTLE_JOINT_NUMBER(Weld, hertz, point.hertz)
FETTLE_JOINT_NUMBER(Weld, damping_ratio, point.damping_ratio)
FETTLE_JOINT_NUMBER(Weld, angular_hertz, angle.hertz)
FETTLE_JOINT_NUMBER(Weld, angular_damping_ratio, angle.damping_ratio)

namespace {

void define(WeldSettings& settings, const WeldJointDef& def) {
    settings.reference_angle = def.reference_angle.value_or(0.0f);
    settings.point = {def.hertz, def.damping_ratio};
    settings.angle = {def.angular_hertz, def.angular_damping_ratio};
}

}  // namespace

FETTLE_CREATE_JOINT(Weld, create_weld_joint,
                    if (!def.reference_angle) joint.set_reference_angle(angle_between(joint)))

}  // namespace fettle::physics
