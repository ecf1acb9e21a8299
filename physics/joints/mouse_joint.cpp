#include <joints/coordinate.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

// Pulls a point of a body (b) softly towards a point of the world (a).
//
// A soft point (C = p_b - p_a, both coordinates) with a limited impulse. It is a force, not a
// constraint: the relax pass does not solve it. The levers remain those of the start of the step.
// This damps the rotation a little, so that a dragged body comes to rest.

namespace fettle::physics {
namespace detail {

struct MouseSettings {
    static constexpr JointType type = JointType::mouse;
    Stiffness stiffness = {5.0f, 0.7f};
    float max_force = infinity;

    void check() const {
        stiffness.check();
        check_strength("max_force", max_force);
    }
    bool gives_energy() const { return true; }
};

struct MouseConstraint {
    using Settings = MouseSettings;
    struct Impulses {
        Vec2 pull;
        void scale(float s) { pull = s * pull; }
    };

    JointEnds ends;
    Impulses impulses;
    float greatest = 0.0f;
    Softness softness;
    PointMass mass;

    void prepare(const Settings& settings, const JointFrame&, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        const auto [hertz, damping_ratio] = settings.stiffness;
        greatest = settings.max_force * step.h;
        softness = make_softness(hertz, damping_ratio, step.h);
        // A slack joint does not pull.
        if (hertz > 0.0f) mass = PointMass::make(ends, a, b);
    }
    void warm_start(SolverBody& a, SolverBody& b) const { ends.push(a, b, impulses.pull); }
    void solve(SolverBody& a, SolverBody& b, const JointStep&) {
        const Vec2 velocity = ends.velocity(a, b) + softness.bias_rate * gap(a, b);
        const Vec2 wanted = -softness.mass_scale * (mass * velocity);
        Vec2 total = impulses.pull + (wanted - softness.impulse_scale * impulses.pull);
        const float size = length(total);
        if (size > greatest) total = (greatest / size) * total;
        ends.push(a, b, total - impulses.pull);
        impulses.pull = total;
    }
    void relax(SolverBody&, SolverBody&, const JointStep&) {}
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        // Its softness in the form of a spring: λ = -m·(mass_scale·v + mass_scale·bias_rate·C).
        const Softness& soft = softness;
        const Spring spring = {soft.mass_scale * soft.bias_rate, soft.mass_scale,
                               soft.impulse_scale};
        // A slack joint has no mass. Without this case its softness would be rigid.
        const bool slack = !(soft.impulse_scale > 0.0f);
        rows.springs(ends, slack ? Spring{} : spring, mass, gap(a, b), greatest, impulses.pull);
    }
    JointLoad load() const { return {impulses.pull, 0.0f}; }
    Drive drive() { return Drive::of_force(greatest, impulses.pull); }

  private:
    Vec2 gap(const SolverBody& a, const SolverBody& b) const {
        return ends.gap(a, b) + cross(b.turn, ends.lever_b);
    }
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
