#include <joints/coordinate.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

// Pulls a point of a body (b) softly towards a point of the world (a).
//
// A spring between two points (C = p_b - p_a, both coordinates) with a limited impulse. It is a
// force, not a constraint: the relax pass does not solve it. Its damping also slows the rotation,
// so that a body that is dragged beside its center comes to rest: a torque of -2·ζ·ω·I/5 times the
// angular velocity.

namespace fettle::physics {
namespace detail {

struct MouseSettings {
    static constexpr JointType type = JointType::mouse;
    Stiffness stiffness = {5.0f, 0.7f};
    float max_force = infinity;

    void check() const {
        detail::check(stiffness);
        check_strength("max_force", max_force);
    }
    bool gives_energy() const { return true; }
};

struct MouseConstraint {
    using Settings = MouseSettings;
    struct Impulses {
        Vec2 pull;
        float twist = 0.0f;
        void scale(float s) { pull = s * pull, twist *= s; }
    };

    JointEnds ends;
    Impulses impulses;
    float greatest = 0.0f, angular_mass = 0.0f;
    PointSpring spring;
    Spring turning;

    void prepare(const Settings& settings, const JointFrame&, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        greatest = settings.max_force * step.h;
        angular_mass = inverse_or_zero(a.inverse_inertia + b.inverse_inertia);
        if (!settings.stiffness.is_spring()) return;
        spring = PointSpring::make(settings.stiffness, step.h, ends.spring_mass(a, b),
                                   PointInverse::make(ends, a, b), ends.joints);
        constexpr float of_rotation = 0.2f;
        const auto [hertz, damping_ratio] = settings.stiffness;
        turning.resistance =
            min(2.0f * damping_ratio * two_pi<float> * hertz * of_rotation * step.h, 1.0f) *
            angular_mass;
    }
    void warm_start(SolverBody& a, SolverBody& b) const {
        ends.push(a, b, impulses.pull);
        detail::twist(a, b, impulses.twist);
    }
    void solve(SolverBody& a, SolverBody& b, const JointStep&) {
        ends.follow(a, b);
        Vec2 total = spring.impulse(PointInverse::make(ends, a, b), ends.velocity(a, b),
                                    ends.gap(a, b), impulses.pull);
        const float size = length(total);
        if (size > greatest) total = (greatest / size) * total;
        ends.push(a, b, total - impulses.pull);
        impulses.pull = total;
        const float slowing = turning.impulse(angular_mass, b.angular_velocity - a.angular_velocity,
                                              0.0f, impulses.twist);
        detail::twist(a, b, slowing);
        impulses.twist += slowing;
    }
    void relax(SolverBody& a, SolverBody& b, const JointStep&) {
        ends.follow(a, b);  // the next sub-step begins with the impulse
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        ends.follow(a, b);
        rows.springs(ends, spring, ends.gap(a, b), greatest, impulses.pull);
        rows.spring(Jacobian::turning(ends), turning, 0.0f, impulses.twist);
    }
    JointLoad load() const { return {impulses.pull, impulses.twist}; }
    Drive drive() { return Drive::of_force(greatest, impulses.pull); }
};

constinit const JointKind mouse_joint = JointFunctions<MouseConstraint>::kind("mouse");

}  // namespace detail

using namespace detail;

void MouseJoint::set_body(const Body& body) {
    settings_as<MouseSettings>();
    set_body_b(body);
}
void MouseJoint::set_anchor(const Position& anchor) {
    settings_as<MouseSettings>();
    set_anchor_b(anchor);
}
void MouseJoint::set_target(const Position& target) {
    settings_as<MouseSettings>();
    set_anchor_a(check_coordinates("target", target));
}
FETTLE_JOINT_NUMBER(Mouse, hertz, stiffness.hertz)
FETTLE_JOINT_NUMBER(Mouse, damping_ratio, stiffness.damping_ratio)
FETTLE_JOINT_NUMBER(Mouse, max_force, max_force)

MouseJoint World::create_mouse_joint(const MouseJointDef& def) {
    WorldData& data = populate(__func__);
    if (def.body == BodyId())
        throw std::invalid_argument("body: a mouse joint drags a body, got none");
    JointRecord record = record_of(JointType::mouse);
    record.bodies[1] = slot_of(*this, "body", def.body);
    if (record.bodies[1] == 0)
        throw std::invalid_argument(
            "body: a mouse joint drags a body, not the bounds of the world");
    record.anchors[0] = check_coordinates("target", def.target);
    // The target may be at one end of the world and the body at the other. Their distance may
    // exceed the greatest coordinate of an anchor, so it is limited.
    record.anchors[1] = def.anchor
                            ? check_coordinates("anchor", *def.anchor)
                            : bounded(body(def.body).local_point(def.target), greatest_coordinate);
    record.enabled = def.enabled;
    record.user_data = def.user_data;
    const MouseSettings settings = {{def.hertz, def.damping_ratio}, def.max_force};
    settings.check();
    record.settings.become(settings);
    return make_joint<MouseJoint>(*this, data, record);
}

}  // namespace fettle::physics
