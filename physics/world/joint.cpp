#include <world/arguments.h>
#include <world/world_data.h>

#include <stdexcept>

namespace fettle::physics {

using namespace detail;

#define FETTLE_LIVE_JOINT                                                                          \
    if (world_ == nullptr || !world_->is_valid(id_)) dangling("joint", id_.index, id_.generation); \
    WorldData& data = *world_->data_;                                                              \
    [[maybe_unused]] JointRecord& record = data.joints[id_.index];

bool MouseJoint::is_valid() const {
    return world_ != nullptr && world_->is_valid(id_);
}

void MouseJoint::destroy() {
    FETTLE_LIVE_JOINT
    data.destroy_joint(id_.index);
}

Body MouseJoint::body() const {
    FETTLE_LIVE_JOINT
    return {world_, data.body_id(record.body)};
}

void MouseJoint::set_body(const Body& body) {
    FETTLE_LIVE_JOINT
    if (!world_->is_valid(body.id())) dangling("body", body.index(), body.id().generation);
    if (&body.world() != world_)
        throw std::invalid_argument("body: expected a body of the same world");
    data.wake_for_edit(record.body);
    --data.bodies[record.body].joint_count;
    record.body = body.index();
    record.impulse = {};
    ++data.bodies[record.body].joint_count;
    data.wake_for_edit(record.body);
}

Vec2 MouseJoint::anchor() const {
    FETTLE_LIVE_JOINT
    return to_vec2(record.anchor);
}

void MouseJoint::set_anchor(const Vec2& anchor) {
    FETTLE_LIVE_JOINT
    record.anchor = to_v2(check_coordinates("anchor", anchor));
    data.wake_body(record.body);
}

Vec2 MouseJoint::target() const {
    FETTLE_LIVE_JOINT
    return to_vec2(record.target);
}

void MouseJoint::set_target(const Vec2& target) {
    FETTLE_LIVE_JOINT
    record.target = to_v2(check_coordinates("target", target));
    data.wake_body(record.body);
}

float MouseJoint::hertz() const {
    FETTLE_LIVE_JOINT
    return record.hertz;
}

void MouseJoint::set_hertz(float hertz) {
    FETTLE_LIVE_JOINT
    record.hertz = check_not_negative("hertz", hertz);
    data.wake_body(record.body);
}

float MouseJoint::damping_ratio() const {
    FETTLE_LIVE_JOINT
    return record.damping_ratio;
}

void MouseJoint::set_damping_ratio(float ratio) {
    FETTLE_LIVE_JOINT
    record.damping_ratio = check_not_negative("damping_ratio", ratio);
    data.wake_body(record.body);
}

float MouseJoint::max_force() const {
    FETTLE_LIVE_JOINT
    return record.max_force;
}

void MouseJoint::set_max_force(float force) {
    FETTLE_LIVE_JOINT
    record.max_force = check_range("max_force", force, 0.0f, infinity);
    data.wake_body(record.body);
}

bool MouseJoint::enabled() const {
    FETTLE_LIVE_JOINT
    return record.enabled;
}

void MouseJoint::set_enabled(bool enabled) {
    FETTLE_LIVE_JOINT
    record.enabled = enabled;
    data.wake_body(record.body);
}

Vec2 MouseJoint::force() const {
    FETTLE_LIVE_JOINT
    return data.last_substep > 0.0f ? Vec2(to_vec2(record.impulse) / data.last_substep)
                                    : Vec2(Vec2::Zero());
}

uint64_t MouseJoint::user_data() const {
    FETTLE_LIVE_JOINT
    return record.user_data;
}

void MouseJoint::set_user_data(uint64_t value) {
    FETTLE_LIVE_JOINT
    record.user_data = value;
}

#undef FETTLE_LIVE_JOINT

}  // namespace fettle::physics
