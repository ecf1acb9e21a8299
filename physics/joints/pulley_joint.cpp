#include <joints/coordinate.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

// A rope from a over two wheels of the world to b.
//
// With l the distance from a wheel g to its anchor p and u = (p - g)/l, the rope can only pull:
//
//     room = length - l_a - ratio·l_b >= 0,   d(room)/dt = -u_a·ṗ_a - ratio·u_b·ṗ_b,
//     K = k_a + ratio²·k_b,   k = uᵀM⁻¹u + I⁻¹(r×u)².
//
// A tension λ pulls a by -λu_a and b by -ratio·λu_b, like a block and tackle with `ratio` parts at
// b.

namespace fettle::physics {
namespace detail {

struct PulleySettings {
    static constexpr JointType type = JointType::pulley;
    Position ground_a = {-1.0f, 1.0f}, ground_b = {1.0f, 1.0f};  ///< world
    float ratio = 1.0f;
    float length = 2.0f;  ///< of a's part plus ratio times b's part

    void check() const {
        check_coordinates("ground_a", ground_a);
        check_coordinates("ground_b", ground_b);
        check_range("ratio", ratio, 1e-3f, 1e3f);
        check_not_negative("length", length);
    }
};

struct PulleyImpulses {
    float tension = 0.0f;
    /// At a wheel, under the solver `direct` only: what stops the anchor, and friction.
    struct AtWheel {
        float stop = 0.0f, friction = 0.0f;
    };
    AtWheel at_a, at_b;
    void scale(float s) { tension *= s; }
};

struct PulleyConstraint {
    using Settings = PulleySettings;

    /// One side of the rope: from a wheel to a body.
    struct Side {
        Vec2 start;  ///< from the wheel to the center of mass at the start of the step
        Vec2 arm;    ///< from the center of mass to the anchor
        Vec2 direction;
        float lever = 0.0f, length = 0.0f;

        void follow(Vec2 anchor_lever, const SolverBody& body) {
            arm = anchor_lever;
            const Vec2 rope = start + body.shift + arm;
            length = detail::length(rope);
            // At its wheel an anchor keeps the last direction; without one, the rope does not pull.
            if (length > 1e-3f) direction = (1.0f / length) * rope;
            lever = cross(arm, direction);
        }
        float inverse_without_turn(Vec2 inverse_mass) const {
            return dot(direction, scaled(inverse_mass, direction));
        }
        float inverse(Vec2 inverse_mass, const SolverBody& body) const {
            return inverse_along(direction, lever, inverse_mass, body);
        }
        void pull(Vec2 inverse_mass, SolverBody& body, float p) const {
            push_along(direction, lever, inverse_mass, body, -p);
        }
        /// Friction of an anchor that is drawn to its wheel, which would circle it for ever.
        /// `radius`: of the wheel, m.
        void rub(Vec2 inverse_mass, SolverBody& body, float most, float radius) const {
            if (length > radius) return;
            const Vec2 across = right_perp(direction);
            const float turn = cross(arm, across);
            const float speed = dot(across, body.velocity) + turn * body.angular_velocity;
            const float stops =
                -speed * inverse_or_zero(inverse_along(across, turn, inverse_mass, body));
            push_along(across, turn, inverse_mass, body, clamp(stops, -most, most));
        }
        /// Stops an anchor at its wheel, which it would pass within `h` seconds. Behind the wheel,
        /// the rope would pull it back, and so on.
        void stop_at_wheel(Vec2 inverse_mass, SolverBody& body, float h) const {
            const float too_fast = -lengthening(body) - length / h;
            if (too_fast > 0.0f)
                pull(inverse_mass, body, -too_fast * inverse_or_zero(inverse(inverse_mass, body)));
        }
        float lengthening(const SolverBody& body) const {
            return dot(direction, body.velocity) + lever * body.angular_velocity;
        }
        void write(float times, double (&on)[3]) const {
            on[0] = -double(times) * double(direction.x);
            on[1] = -double(times) * double(direction.y);
            on[2] = -double(times) * double(lever);
        }
        void write_across(double (&on)[3]) const {
            const Vec2 across = right_perp(direction);
            on[0] = double(across.x);
            on[1] = double(across.y);
            on[2] = double(cross(arm, across));
        }

      private:
        /// For an impulse at the anchor along a unit vector, with the lever `turn`.
        static float inverse_along(Vec2 along, float turn, Vec2 inverse_mass,
                                   const SolverBody& body) {
            return dot(along, scaled(inverse_mass, along)) + body.inverse_inertia * turn * turn;
        }
        static void push_along(Vec2 along, float turn, Vec2 inverse_mass, SolverBody& body,
                               float p) {
            body.velocity = body.velocity + p * scaled(inverse_mass, along);
            body.angular_velocity += body.inverse_inertia * turn * p;
        }
    };

    /// The radius of the wheels, as a part of the rope.
    static constexpr float wheel_radius = 0.04f;

    JointEnds ends;
    PulleyImpulses impulses;
    Side side_a, side_b;
    float ratio = 1.0f, length = 0.0f, mass = 0.0f;
    /// m: how much shorter the rope can get until its movable ends are at their wheels.
    float way = 0.0f;
    bool too_long = false;  ///< at the start of the step

    static float separation(const Settings& settings, const JointPlace& place) {
        const float rope = detail::length(place.anchor_a - settings.ground_a) +
                           settings.ratio * detail::length(place.anchor_b - settings.ground_b);
        return max(0.0f, rope - settings.length);
    }
    void prepare(const Settings& settings, const JointFrame& frame, const JointStep&,
                 const SolverBody& a, const SolverBody& b) {
        ratio = settings.ratio;
        length = settings.length;
        side_a.start = frame.center_a - settings.ground_a;
        side_b.start = frame.center_b - settings.ground_b;
        follow(a, b);
        too_long = room() < -obstructed_gap;
    }
    void warm_start(SolverBody& a, SolverBody& b) const { pull(a, b, impulses.tension); }
    template <bool biased>
    void pass(SolverBody& a, SolverBody& b, const JointStep& step) {
        follow(a, b);
        if (biased) close_wide_gap(a, b, step);
        const float velocity = -side_a.lengthening(a) - ratio * side_b.lengthening(b);
        pull(a, b,
             push_limit<biased>(impulses.tension, mass, velocity, room(), step,
                                step.greatest_length_gap, ends.greatest_pull));
        side_a.stop_at_wheel(ends.inverse_a, a, step.h);
        side_b.stop_at_wheel(ends.inverse_b, b, step.h);
        const float wheel = wheel_radius * (side_a.length + ratio * side_b.length);
        side_a.rub(ends.inverse_a, a, impulses.tension, wheel);
        side_b.rub(ends.inverse_b, b, ratio * impulses.tension, wheel);
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        follow(a, b);
        Jacobian rope = {ends.a, ends.b, {}, {}};
        side_a.write(1.0f, rope.on_a);
        side_b.write(ratio, rope.on_b);
        rows.limit(rope, room(), impulses.tension).high =
            double(ends.greatest_impulse(mass, float(rows.h())));
        const float wheel = wheel_radius * (side_a.length + ratio * side_b.length);
        const auto write_wheel = [&](const Side& side, const SolverBody& body, float times,
                                     bool is_a, PulleyImpulses::AtWheel& at) {
            if (side.length + side.lengthening(body) * float(rows.h()) > wheel)
                return void(at = {});
            Jacobian along = {ends.a, ends.b, {}, {}}, across = along;
            side.write(-1.0f, is_a ? along.on_a : along.on_b);
            side.write_across(is_a ? across.on_a : across.on_b);
            rows.limit(along, side.length, at.stop);
            rows.motor(across, 0.0f, times * impulses.tension, at.friction);
        };
        write_wheel(side_a, a, 1.0f, true, impulses.at_a);
        write_wheel(side_b, b, ratio, false, impulses.at_b);
    }
    Pull pull_now() const {
        return {too_long, true, false, {-side_a.direction, -side_b.direction}};
    }
    JointLoad load() const { return {-(ratio * impulses.tension) * side_b.direction, 0.0f}; }

  private:
    void follow(const SolverBody& a, const SolverBody& b) {
        ends.follow(a, b);
        side_a.follow(ends.lever_a, a);
        side_b.follow(ends.lever_b, b);
        const float of_a = side_a.inverse(ends.inverse_a, a);
        const float of_b = side_b.inverse(ends.inverse_b, b);
        mass = inverse_or_zero(of_a + ratio * ratio * of_b);
        way = (of_a > 0.0f ? side_a.length : 0.0f) + (of_b > 0.0f ? ratio * side_b.length : 0.0f);
    }
    /// As `JointEnds::close_wide_gap`: moves the bodies towards their wheels.
    void close_wide_gap(SolverBody& a, SolverBody& b, const JointStep& step) {
        const float excess = -room() - step.wide_gap;
        if (excess <= 0.0f) return;
        const float of_a = side_a.inverse_without_turn(ends.inverse_a);
        const float of_b = side_b.inverse_without_turn(ends.inverse_b);
        const float pull = step.wide_share * excess * inverse_or_zero(of_a + ratio * ratio * of_b);
        const float pull_a = min(pull, side_a.length * inverse_or_zero(of_a));
        const float pull_b = min(ratio * pull, side_b.length * inverse_or_zero(of_b));
        a.shift = a.shift - pull_a * scaled(ends.inverse_a, side_a.direction);
        b.shift = b.shift - pull_b * scaled(ends.inverse_b, side_b.direction);
        follow(a, b);
    }
    /// m; negative: too long by that. An anchor gets no nearer to its wheel than to be there.
    float room() const {
        return max(length - side_a.length - ratio * side_b.length, -min(way, ends.greatest_error));
    }
    void pull(SolverBody& a, SolverBody& b, float tension) const {
        side_a.pull(ends.inverse_a, a, tension);
        side_b.pull(ends.inverse_b, b, ratio * tension);
    }
};

constinit const JointKind pulley_joint = JointFunctions<PulleyConstraint>::kind("pulley");

}  // namespace detail

using namespace detail;

FETTLE_JOINT_POSITION(Pulley, ground_a, ground_a)
FETTLE_JOINT_POSITION(Pulley, ground_b, ground_b)
FETTLE_JOINT_NUMBER(Pulley, ratio, ratio)
FETTLE_JOINT_NUMBER(Pulley, length, length)
FETTLE_JOINT_FORCE(Pulley, tension, tension)

float PulleyJoint::length_a() const {
    return (world_anchor_a() - ground_a()).length();
}
float PulleyJoint::length_b() const {
    return (world_anchor_b() - ground_b()).length();
}
float PulleyJoint::length_now() const {
    return length_a() + ratio() * length_b();
}

namespace {

void define(PulleySettings& settings, const PulleyJointDef& def) {
    settings.ground_a = def.ground_a;
    settings.ground_b = def.ground_b;
    settings.ratio = def.ratio;
    settings.length = def.length.value_or(settings.length);
}

}  // namespace

FETTLE_CREATE_JOINT(Pulley, create_pulley_joint,
                    if (!def.length) joint.set_length(joint.length_now()))

}  // namespace fettle::physics
