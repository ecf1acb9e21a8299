#include "joints.h"

#include "hosting.h"

namespace fettle::physics_module {

std::uint32_t Joints::create(std::uint32_t world) {
    std::uint32_t row = 0;
    if (free_.empty()) {
        row = static_cast<std::uint32_t>(records_.size());
        records_.emplace_back();
    } else {
        row = free_.back();
        free_.pop_back();
    }
    records_[row] = {};
    records_[row].used = true;
    records_[row].world = world;
    loosen();
    return row;
}

void Joints::place(std::uint32_t row, std::uint32_t world) {
    JointRecord& record = records_[row];
    if (record.world == world) return;
    disconnect(record);
    record.world = world;
    loosen();
}

void Joints::destroy(std::uint32_t row) {
    disconnect(records_[row]);
    records_[row] = {};
    free_.push_back(row);
}

physics::World& Joints::world_of(const JointRecord& record) const {
    return hosting_.world_at(record.world)->world;
}

property::Handle Joints::body(std::uint32_t row, std::size_t side) const {
    const property::Handle body = records_[row].bodies[side];
    return hosting_.tree.alive(body) ? body : property::Handle{};
}

void Joints::set_body(std::uint32_t row, std::size_t side, property::Handle body) {
    JointRecord& record = records_[row];
    record.bodies[side] = body;
    struct {
        void operator()(MouseSettings& s) const { s.anchor.look_again(); }
        void operator()(DistanceSettings& s) const { s.length.look_again(); }
        void operator()(RevoluteSettings& s) const { s.reference_angle.look_again(); }
    } look_again;
    std::visit(look_again, record.settings);
    remake(row);
}

void Joints::remake(std::uint32_t row) {
    disconnect(records_[row]);
    loosen();
}

physics::Vec2 Joints::mouse_anchor(std::uint32_t row) const {
    const JointRecord& record = records_[row];
    const auto& mouse = std::get<MouseSettings>(record.settings);
    if (mouse.anchor.value) return *mouse.anchor.value;
    if (!hosting_.tree.alive(record.bodies[1])) return physics::Vec2::Zero();
    return hosting_.body(hosting_.tree.row(record.bodies[1])).local_point(mouse.target);
}

physics::Vec2 Joints::world_anchor(const JointRecord& record, std::size_t side) const {
    const physics::Vec2& anchor = record.anchors[side];
    if (!hosting_.tree.alive(record.bodies[side])) return anchor;
    return hosting_.body(hosting_.tree.row(record.bodies[side])).world_point(anchor);
}

float Joints::angle_of(const JointRecord& record, std::size_t side) const {
    if (!hosting_.tree.alive(record.bodies[side])) return 0.0f;
    return hosting_.body(hosting_.tree.row(record.bodies[side])).angle();
}

void Joints::disconnect(JointRecord& record) {
    physics::World& world = world_of(record);
    if (world.is_valid(record.native)) world.joint(record.native).destroy();
    record.native = {};
}

physics::BodyId Joints::body_id(property::Handle body) const {
    return body ? hosting_.body(hosting_.tree.row(body)).id() : physics::BodyId{};
}

physics::JointDef Joints::description(const JointRecord& record) const {
    physics::JointDef def;
    def.body_a = body_id(record.bodies[0]);
    def.body_b = body_id(record.bodies[1]);
    def.anchor_a = record.anchors[0];
    def.anchor_b = record.anchors[1];
    def.collide = record.collide;
    def.enabled = record.enabled;
    return def;
}

physics::JointId Joints::connect(JointRecord& record, MouseSettings& settings) {
    physics::MouseJointDef def;
    def.body = body_id(record.bodies[1]);
    def.target = settings.target;
    def.anchor = settings.anchor.value;
    def.hertz = settings.frequency;
    def.damping_ratio = settings.damping_ratio;
    def.max_force = settings.max_force;
    def.enabled = record.enabled;
    const physics::MouseJoint made = world_of(record).create_mouse_joint(def);
    settings.anchor.value = made.anchor();
    return made.id();
}

physics::JointId Joints::connect(JointRecord& record, DistanceSettings& settings) {
    physics::DistanceJoint made = world_of(record).create_distance_joint(description(record));
    if (settings.length.value) made.set_length(*settings.length.value);
    settings.length.value = made.length();
    made.set_min_length(settings.min_length);
    made.set_max_length(settings.max_length);
    made.set_hertz(settings.hertz);
    made.set_damping_ratio(settings.damping_ratio);
    return made.id();
}

physics::JointId Joints::connect(JointRecord& record, RevoluteSettings& settings) {
    physics::RevoluteJoint made = world_of(record).create_revolute_joint(description(record));
    if (settings.reference_angle.value) made.set_reference_angle(*settings.reference_angle.value);
    settings.reference_angle.value = made.reference_angle();
    made.set_lower_angle(settings.lower_angle);
    made.set_upper_angle(settings.upper_angle);
    made.set_motor_speed(settings.motor_speed);
    made.set_max_motor_torque(settings.max_motor_torque);
    made.set_hertz(settings.hertz);
    made.set_damping_ratio(settings.damping_ratio);
    made.set_target_angle(settings.target_angle);
    return made.id();
}

bool Joints::can_act(const JointRecord& record) const {
    if (record.world == limbo || record.bodies[0] == record.bodies[1]) return false;
    for (const property::Handle body : record.bodies) {
        if (!body) continue;  // the world
        if (!hosting_.tree.alive(body)) return false;
        if (world_number(hosting_.tree.row(body)) != record.world) return false;
    }
    return true;
}

void Joints::tighten() {
    if (!loose_) return;
    loose_ = false;
    for (JointRecord& record : records_) {
        if (!record.used) continue;
        const bool wanted = can_act(record);
        const bool acts = world_of(record).is_valid(record.native);
        if (wanted && !acts) {
            record.native = std::visit([&](auto& settings) { return connect(record, settings); },
                                       record.settings);
        }
        if (!wanted && acts) disconnect(record);
    }
}

}  // namespace fettle::physics_module
