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
    return row;
}

void Joints::place(std::uint32_t row, std::uint32_t world) {
    MouseJointRecord& record = records_[row];
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

physics::MouseJoint Joints::native(std::uint32_t row) const {
    const MouseJointRecord& record = records_[row];
    return hosting_.world_at(record.world)->world.mouse_joint(record.native);
}

property::Handle Joints::body(std::uint32_t row) const {
    const property::Handle body = records_[row].body;
    return hosting_.tree.alive(body) ? body : property::Handle{};
}

void Joints::set_body(std::uint32_t row, property::Handle body) {
    MouseJointRecord& record = records_[row];
    disconnect(record);
    record.body = body;
    if (!record.anchor_given) record.anchor.reset();
    loosen();
}

physics::Vec2 Joints::anchor(std::uint32_t row) const {
    const MouseJointRecord& record = records_[row];
    if (record.anchor) return *record.anchor;
    if (!hosting_.tree.alive(record.body)) return physics::Vec2::Zero();
    return hosting_.body(hosting_.tree.row(record.body)).local_point(record.target);
}

void Joints::set_anchor(std::uint32_t row, std::optional<physics::Vec2> anchor) {
    MouseJointRecord& record = records_[row];
    if (const physics::MouseJoint joint = native(row); joint && anchor)
        physics::MouseJoint(joint).set_anchor(*anchor);
    else
        disconnect(record);  // made anew with the other anchor
    record.anchor = anchor;
    record.anchor_given = anchor.has_value();
    loosen();
}

void Joints::disconnect(MouseJointRecord& record) {
    physics::World& world = hosting_.world_at(record.world)->world;
    if (world.is_valid(record.native)) world.mouse_joint(record.native).destroy();
    record.native = {};
}

void Joints::connect(MouseJointRecord& record) {
    physics::World& world = hosting_.world_at(record.world)->world;
    physics::MouseJointDef def;
    def.body = hosting_.body(hosting_.tree.row(record.body)).id();
    def.target = record.target;
    def.anchor = record.anchor;
    def.hertz = record.frequency;
    def.damping_ratio = record.damping_ratio;
    def.max_force = record.max_force;
    def.enabled = record.enabled;
    const physics::MouseJoint made = world.create_mouse_joint(def);
    record.native = made.id();
    record.anchor = made.anchor();
}

void Joints::tighten() {
    if (!loose_) return;
    loose_ = false;
    for (MouseJointRecord& record : records_) {
        if (!record.used) continue;
        const bool wanted = record.world != limbo && hosting_.tree.alive(record.body) &&
                            world_number(hosting_.tree.row(record.body)) == record.world;
        const bool acts = hosting_.world_at(record.world)->world.is_valid(record.native);
        if (wanted && !acts) connect(record);
        if (!wanted && acts) disconnect(record);
    }
}

}  // namespace fettle::physics_module
