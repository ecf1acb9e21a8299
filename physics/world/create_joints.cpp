#include <world/live_joint.h>

// Joints are made with what all have; what a type adds has defaults.

namespace fettle::physics {

using namespace detail;

namespace {

JointRecord checked(const World& world, const JointDef& def) {
    JointRecord record;
    const BodyId ids[2] = {def.body_a, def.body_b};
    for (int side = 0; side < 2; ++side) {
        if (!ids[side]) continue;
        if (!world.is_valid(ids[side])) dangling("body", ids[side].index, ids[side].generation);
        record.bodies[side] = ids[side].index;
    }
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
    if (!is_valid(def.body)) dangling("body", def.body.index, def.body.generation);
    JointRecord record;
    record.bodies[1] = def.body.index;
    record.anchors[0] = to_v2(check_coordinates("target", def.target));
    record.anchors[1] = to_v2(def.anchor ? check_coordinates("anchor", *def.anchor)
                                         : body(def.body).local_point(def.target));
    record.enabled = def.enabled;
    record.user_data = def.user_data;
    MouseData mouse;
    mouse.hertz = check_not_negative("hertz", def.hertz);
    mouse.damping_ratio = check_not_negative("damping_ratio", def.damping_ratio);
    mouse.max_force = check_range("max_force", def.max_force, 0.0f, infinity);
    const uint32_t slot = data_->create_joint(record, mouse);
    return {this, {slot, data_->joint_generations[slot]}};
}

namespace {

template <class Any, class Data>
Any make(World& world, WorldData& data, const JointDef& def, const Data& settings) {
    const uint32_t slot = data.create_joint(checked(world, def), settings);
    return {&world, {slot, data.joint_generations[slot]}};
}

}  // namespace

DistanceJoint World::create_distance_joint(const JointDef& def) {
    auto joint = make<DistanceJoint>(*this, *data_, def, DistanceData{});
    joint.set_length(joint.distance());
    return joint;
}

RevoluteJoint World::create_revolute_joint(const JointDef& def) {
    auto joint = make<RevoluteJoint>(*this, *data_, def, RevoluteData{});
    joint.set_reference_angle(angle_between(joint));
    return joint;
}

PrismaticJoint World::create_prismatic_joint(const JointDef& def) {
    auto joint = make<PrismaticJoint>(*this, *data_, def, PrismaticData{});
    joint.set_reference_angle(angle_between(joint));
    return joint;
}

WheelJoint World::create_wheel_joint(const JointDef& def) {
    return make<WheelJoint>(*this, *data_, def, WheelData{});
}

WeldJoint World::create_weld_joint(const JointDef& def) {
    auto joint = make<WeldJoint>(*this, *data_, def, WeldData{});
    joint.set_reference_angle(angle_between(joint));
    return joint;
}

MotorJoint World::create_motor_joint(const JointDef& def) {
    auto joint = make<MotorJoint>(*this, *data_, def, MotorData{});
    joint.set_angular_offset(angle_between(joint));
    return joint;
}

PulleyJoint World::create_pulley_joint(const JointDef& def) {
    auto joint = make<PulleyJoint>(*this, *data_, def, PulleyData{});
    joint.set_length(joint.length_now());
    return joint;
}

GearJoint World::create_gear_joint(const JointDef& def) {
    auto joint = make<GearJoint>(*this, *data_, def, GearData{});
    joint.set_phase(joint.phase_now());
    return joint;
}

GrooveJoint World::create_groove_joint(const JointDef& def) {
    return make<GrooveJoint>(*this, *data_, def, GrooveData{});
}

PinSlotJoint World::create_pin_slot_joint(const JointDef& def) {
    return make<PinSlotJoint>(*this, *data_, def, PinSlotData{});
}

RatchetJoint World::create_ratchet_joint(const JointDef& def) {
    auto joint = make<RatchetJoint>(*this, *data_, def, RatchetData{});
    joint.set_reference_angle(angle_between(joint));
    return joint;
}

}  // namespace fettle::physics
