#include <world/live_joint.h>

// Joints are made with what all have; what a type adds has defaults.

namespace fettle::physics {

using namespace detail;

namespace {

uint32_t slot_of(const World& world, const char* name, BodyId id) {
    if (!world.is_valid(id)) foreign(name, "body", id.index, id.generation);
    return id.index;
}

JointRecord checked(const World& world, const JointDef& def) {
    JointRecord record;
    if (def.body_a != BodyId()) record.bodies[0] = slot_of(world, "body_a", def.body_a);
    if (def.body_b != BodyId()) record.bodies[1] = slot_of(world, "body_b", def.body_b);
    if (record.bodies[0] == record.bodies[1])
        throw std::invalid_argument("body_a and body_b: expected two different bodies");
    record.anchors[0] = to_v2(check_coordinates("anchor_a", def.anchor_a));
    record.anchors[1] = to_v2(check_coordinates("anchor_b", def.anchor_b));
    record.collide = def.collide;
    record.enabled = def.enabled;
    record.user_data = def.user_data;
    return record;
}

}  // namespace

MouseJoint World::create_mouse_joint(const MouseJointDef& def) {
    WorldData& data = populate(__func__);
    if (def.body == BodyId()) throw std::invalid_argument("body: a mouse joint drags a body");
    JointRecord record;
    record.bodies[1] = slot_of(*this, "body", def.body);
    if (record.bodies[1] == 0)
        throw std::invalid_argument(
            "body: a mouse joint drags a body, not the bounds of the world");
    record.anchors[0] = to_v2(check_coordinates("target", def.target));
    // A target at one end of the world may be farther from a body at the other than an anchor is
    // ever set to.
    record.anchors[1] =
        def.anchor ? to_v2(check_coordinates("anchor", *def.anchor))
                   : bounded(to_v2(body(def.body).local_point(def.target)), greatest_coordinate);
    record.enabled = def.enabled;
    record.user_data = def.user_data;
    MouseData mouse;
    mouse.hertz = check_not_negative("hertz", def.hertz);
    mouse.damping_ratio = check_not_negative("damping_ratio", def.damping_ratio);
    mouse.max_force = check_range("max_force", def.max_force, 0.0f, infinity);
    const uint32_t slot = detail::create_joint(data.editing(), record, mouse);
    return {this, {slot, data.joint_generations[slot]}};
}

namespace {

template <class Any, class Data>
Any make(World& world, WorldData& data, const JointDef& def, const Data& settings) {
    const uint32_t slot = detail::create_joint(data.editing(), checked(world, def), settings);
    return {&world, {slot, data.joint_generations[slot]}};
}

}  // namespace

DistanceJoint World::create_distance_joint(const JointDef& def) {
    auto joint = make<DistanceJoint>(*this, populate(__func__), def, DistanceData{});
    joint.set_length(joint.distance());
    return joint;
}

RevoluteJoint World::create_revolute_joint(const JointDef& def) {
    auto joint = make<RevoluteJoint>(*this, populate(__func__), def, RevoluteData{});
    joint.set_reference_angle(angle_between(joint));
    return joint;
}

PrismaticJoint World::create_prismatic_joint(const JointDef& def) {
    auto joint = make<PrismaticJoint>(*this, populate(__func__), def, PrismaticData{});
    joint.set_reference_angle(angle_between(joint));
    return joint;
}

WheelJoint World::create_wheel_joint(const JointDef& def) {
    return make<WheelJoint>(*this, populate(__func__), def, WheelData{});
}

WeldJoint World::create_weld_joint(const JointDef& def) {
    auto joint = make<WeldJoint>(*this, populate(__func__), def, WeldData{});
    joint.set_reference_angle(angle_between(joint));
    return joint;
}

MotorJoint World::create_motor_joint(const JointDef& def) {
    auto joint = make<MotorJoint>(*this, populate(__func__), def, MotorData{});
    joint.set_angular_offset(angle_between(joint));
    return joint;
}

PulleyJoint World::create_pulley_joint(const JointDef& def) {
    auto joint = make<PulleyJoint>(*this, populate(__func__), def, PulleyData{});
    joint.set_length(joint.length_now());
    return joint;
}

GearJoint World::create_gear_joint(const JointDef& def) {
    auto joint = make<GearJoint>(*this, populate(__func__), def, GearData{});
    joint.set_phase(joint.phase_now());
    return joint;
}

GrooveJoint World::create_groove_joint(const JointDef& def) {
    return make<GrooveJoint>(*this, populate(__func__), def, GrooveData{});
}

PinSlotJoint World::create_pin_slot_joint(const JointDef& def) {
    return make<PinSlotJoint>(*this, populate(__func__), def, PinSlotData{});
}

RatchetJoint World::create_ratchet_joint(const JointDef& def) {
    auto joint = make<RatchetJoint>(*this, populate(__func__), def, RatchetData{});
    joint.set_reference_angle(angle_between(joint));
    return joint;
}

}  // namespace fettle::physics
