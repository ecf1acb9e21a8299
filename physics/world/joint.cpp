#include <world/live_joint.h>

// The handles of joints: what all have, and the mouse.

namespace fettle::physics {

using namespace detail;

namespace detail {

void wrong_joint(JointType expected, JointType is) {
    throw std::invalid_argument(std::string("expected a ") + joint_type_names[size_t(expected)] +
                                " joint, got a " + joint_type_names[size_t(is)] + " joint");
}

}  // namespace detail

bool Joint::is_valid() const {
    return link_ != nullptr && link_->data != nullptr && link_->data->is_valid(id_);
}

WorldData& Joint::live() const {
    if (!is_valid()) [[unlikely]]
        dangling("joint", link_, id_.index, id_.generation);
    return *link_->data;
}

WorldData& Joint::edited(const char* function) const {
    WorldData& data = live();
    data.self.may_edit("Joint", function);
    return data;
}

World& Joint::world() const {
    live();
    return *link_->world;
}

void Joint::destroy() {
    WorldData& data = live();
    data.self.may_populate("Joint", __func__);
    detail::destroy_joint(data.editing(), id_.index);
}

JointType Joint::type() const {
    return live().joints[id_.index].type;
}

Body Joint::body_a() const {
    const WorldData& data = live();
    const uint32_t body = data.joints[id_.index].bodies[0];
    return body == 0 ? Body() : Body(link_->world, data.body_id(body));
}

Body Joint::body_b() const {
    const WorldData& data = live();
    const uint32_t body = data.joints[id_.index].bodies[1];
    return body == 0 ? Body() : Body(link_->world, data.body_id(body));
}

void Joint::set_body(uint32_t side, const Body& body, const char* function) {
    WorldData& data = edited(function);
    const char* name = side == 0 ? "body_a" : "body_b";
    const bool is_world = body == Body();
    if (data.joints[id_.index].type == JointType::mouse) {
        if (side == 0)
            throw std::invalid_argument(
                "body_a: a mouse joint has a target there: set that instead");
        if (is_world) throw std::invalid_argument("body: a mouse joint drags a body");
    }
    if (!is_world && !body.is_valid())
        dangling("body", body.link_, body.index(), body.id().generation);
    if (!is_world && body.link_ != link_)
        throw std::invalid_argument(std::string(name) + ": expected a body of the same world");
    const uint32_t slot = is_world ? 0 : body.index();
    if (slot == 0 && data.joints[id_.index].type == JointType::mouse)
        throw std::invalid_argument(
            "body: a mouse joint drags a body, not the bounds of the world");
    if (slot == data.joints[id_.index].bodies[side ^ 1])
        throw std::invalid_argument(std::string(name) + ": expected another body than the other's");
    detail::set_joint_body(data.editing(), id_.index, side, slot);
}

void Joint::set_body_a(const Body& body) {
    set_body(0, body, __func__);
}
void Joint::set_body_b(const Body& body) {
    set_body(1, body, __func__);
}

Vec2 Joint::anchor_a() const {
    return to_vec2(live().joints[id_.index].anchors[0]);
}
void Joint::set_anchor_a(const Vec2& anchor) {
    WorldData& data = edited(__func__);
    data.joints[id_.index].anchors[0] = to_v2(check_coordinates("anchor_a", anchor));
    wake_joint(data.activity(), id_.index);
}

Vec2 Joint::anchor_b() const {
    return to_vec2(live().joints[id_.index].anchors[1]);
}
void Joint::set_anchor_b(const Vec2& anchor) {
    WorldData& data = edited(__func__);
    data.joints[id_.index].anchors[1] = to_v2(check_coordinates("anchor_b", anchor));
    wake_joint(data.activity(), id_.index);
}

Vec2 Joint::world_anchor_a() const {
    const Body body = body_a();
    return body ? body.world_point(anchor_a()) : anchor_a();
}
Vec2 Joint::world_anchor_b() const {
    const Body body = body_b();
    return body ? body.world_point(anchor_b()) : anchor_b();
}

bool Joint::enabled() const {
    return live().joints[id_.index].enabled;
}
void Joint::set_enabled(bool enabled) {
    detail::set_joint_enabled(edited(__func__).editing(), id_.index, enabled);
}

bool Joint::collide() const {
    return live().joints[id_.index].collide;
}
void Joint::set_collide(bool collide) {
    detail::set_joint_collide(edited(__func__).editing(), id_.index, collide);
}

float Joint::break_force() const {
    return live().joints[id_.index].break_force;
}
void Joint::set_break_force(float force) {
    WorldData& data = edited(__func__);
    data.joints[id_.index].break_force = check_strength("break_force", force);
    wake_joint(data.activity(), id_.index);
}
float Joint::break_torque() const {
    return live().joints[id_.index].break_torque;
}
void Joint::set_break_torque(float torque) {
    WorldData& data = edited(__func__);
    data.joints[id_.index].break_torque = check_strength("break_torque", torque);
    wake_joint(data.activity(), id_.index);
}
bool Joint::broken() const {
    return live().joints[id_.index].broken;
}
void Joint::set_broken(bool broken) {
    detail::set_joint_broken(edited(__func__).editing(), id_.index, broken);
}

float Joint::per_substep(float impulse) const {
    const float h = live().last_substep;
    return h > 0.0f ? impulse / h : 0.0f;
}

Vec2 Joint::force() const {
    return to_vec2(live().joints[id_.index].force);
}
float Joint::torque() const {
    return live().joints[id_.index].torque;
}

uint64_t Joint::user_data() const {
    return live().joints[id_.index].user_data;
}
void Joint::set_user_data(uint64_t value) {
    WorldData& data = live();
    data.self.may_populate("Joint", __func__);
    data.joints[id_.index].user_data = value;
}

void MouseJoint::set_body(const Body& body) {
    (void)own<MouseData>();
    set_body_b(body);
}
void MouseJoint::set_anchor(const Vec2& anchor) {
    (void)own<MouseData>();
    set_anchor_b(anchor);
}
void MouseJoint::set_target(const Vec2& target) {
    (void)own<MouseData>();
    set_anchor_a(check_coordinates("target", target));
}
FETTLE_JOINT_SETTING(MouseJoint, MouseData, hertz, check_not_negative("hertz", value))
FETTLE_JOINT_SETTING(MouseJoint, MouseData, damping_ratio,
                     check_not_negative("damping_ratio", value))
FETTLE_JOINT_SETTING(MouseJoint, MouseData, max_force,
                     check_range("max_force", value, 0.0f, infinity))

}  // namespace fettle::physics
