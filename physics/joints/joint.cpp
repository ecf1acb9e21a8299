#include <joints/joint_handle.h>
#include <joints/joint_types.h>

#include <string>

// The handles of joints: the methods of all types.

namespace fettle::physics {

using namespace detail;

namespace detail {
namespace {

#define FETTLE_LIST_TYPE(type) JointType::type,
constexpr JointType listed_types[] = {FETTLE_JOINT_TYPES(FETTLE_LIST_TYPE)};
#undef FETTLE_LIST_TYPE

constexpr bool are_in_order() {
    for (size_t i = 0; i < joint_type_count; ++i)
        if (listed_types[i] != JointType(i)) return false;
    return std::size(listed_types) == joint_type_count;
}
static_assert(are_in_order());

/// Beyond this damping ratio the coefficients of a soft row have no significant digits left.
float check_ratio(const char* what, float value) {
    return check_range(what, value, 0.0f, 1000.0f);
}

constexpr const char* two_bodies =
    "body_a and body_b: expected two different bodies, of which one may be the world";

}  // namespace

const JointKind& joint_kind(JointType type) {
#define FETTLE_LIST_KIND(type) &type##_joint,
    static constexpr const JointKind* kinds[] = {FETTLE_JOINT_TYPES(FETTLE_LIST_KIND)};
#undef FETTLE_LIST_KIND
    return *kinds[size_t(type)];
}

void refuse_wrong_joint(JointType expected, JointType is) {
    throw std::invalid_argument(std::string("expected a ") + joint_kind(expected).name +
                                " joint, got a " + joint_kind(is).name + " joint");
}

uint32_t slot_of(const World& world, const char* name, BodyId id) {
    if (!world.is_valid(id)) refuse_foreign(name, "body", id.index, id.generation);
    return id.index;
}

JointRecord record_of(JointType type) {
    JointRecord record;
    record.type = type;
    joint_kind(type).begin(record);
    return record;
}

JointRecord checked(const World& world, JointType type, const JointDef& def) {
    JointRecord record = record_of(type);
    if (def.body_a != BodyId()) record.bodies[0] = slot_of(world, "body_a", def.body_a);
    if (def.body_b != BodyId()) record.bodies[1] = slot_of(world, "body_b", def.body_b);
    if (record.bodies[0] == record.bodies[1]) throw std::invalid_argument(two_bodies);
    record.anchors[0] = check_coordinates("anchor_a", def.anchor_a);
    record.anchors[1] = check_coordinates("anchor_b", def.anchor_b);
    record.collide = def.collide;
    record.enabled = def.enabled;
    record.user_data = def.user_data;
    record.break_force = check_strength("break_force", def.break_force);
    record.break_torque = check_strength("break_torque", def.break_torque);
    record.report_force = check_strength("report_force", def.report_force);
    record.report_torque = check_strength("report_torque", def.report_torque);
    record.constraint_hertz = check_not_negative("constraint_hertz", def.constraint_hertz);
    record.constraint_damping_ratio =
        check_ratio("constraint_damping_ratio", def.constraint_damping_ratio);
    return record;
}

float angle_between(const Joint& joint) {
    const Body a = joint.body_a(), b = joint.body_b();
    return (b ? b.angle() : 0.0f) - (a ? a.angle() : 0.0f);
}

Vec2 gap_between(const Joint& joint) {
    return joint.world_anchor_b() - joint.world_anchor_a();
}

float translation_along(const Joint& joint, const Vec2& direction) {
    const Vec2 axis = normalized(direction);
    const Body a = joint.body_a();
    const Vec2 turned = a ? a.world_vector(axis) : axis;
    return turned.dot(gap_between(joint));
}

}  // namespace detail

bool Joint::is_valid() const noexcept {
    return link_ != nullptr && link_->data != nullptr && link_->data->is_valid(id_);
}

WorldData& Joint::live() const {
    if (!is_valid()) [[unlikely]]
        refuse_dangling("joint", link_, id_.index, id_.generation);
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
    data.change<detail::destroy_joint>(id_.index);
}

/// Checks that the joint may be attached to `body` at that end. Returns the slot of the body.
uint32_t Joint::end_at(uint32_t side, const Body& body) const {
    const WorldData& data = live();
    const char* name = side == 0 ? "body_a" : "body_b";
    const bool is_world = body == Body();
    if (data.joints[id_.index].type == JointType::mouse) {
        if (side == 0)
            throw std::invalid_argument(
                "body_a: a mouse joint has a target there: set that instead");
        if (is_world) throw std::invalid_argument("body: a mouse joint drags a body, got none");
    }
    if (!is_world && !body.is_valid())
        refuse_dangling("body", body.link_, body.index(), body.id().generation);
    if (!is_world && body.link_ != link_)
        throw std::invalid_argument(std::string(name) + ": expected a body of the same world");
    const uint32_t slot = is_world ? 0 : body.index();
    if (slot == 0 && data.joints[id_.index].type == JointType::mouse)
        throw std::invalid_argument(
            "body: a mouse joint drags a body, not the bounds of the world");
    return slot;
}

void Joint::set_body(uint32_t side, const Body& body, const char* function) {
    WorldData& data = edited(function);
    uint32_t ends[] = {data.joints[id_.index].bodies[0], data.joints[id_.index].bodies[1]};
    ends[side] = end_at(side, body);
    if (ends[0] == ends[1])
        throw std::invalid_argument(std::string(side == 0 ? "body_a" : "body_b") +
                                    ": expected a body other than the one at the other end");
    data.change<set_joint_bodies>(id_.index, ends[0], ends[1]);
}

void Joint::connect(const Body& a, const Body& b) {
    WorldData& data = edited(__func__);
    const uint32_t ends[] = {a == Body() ? 0 : end_at(0, a), end_at(1, b)};
    if (ends[0] == ends[1]) throw std::invalid_argument(two_bodies);
    data.change<set_joint_bodies>(id_.index, ends[0], ends[1]);
}

void Joint::disconnect() {
    edited(__func__).change<set_joint_bodies>(id_.index, 0, 0);
}

bool Joint::dormant() const {
    return live().joints[id_.index].dormant();
}

#define FETTLE_JOINT_READ(Value, name)        \
    Value Joint::name() const {               \
        return live().joints[id_.index].name; \
    }
FETTLE_JOINT_READ(JointType, type)
FETTLE_JOINT_READ(bool, enabled)
FETTLE_JOINT_READ(bool, collide)
FETTLE_JOINT_READ(bool, broken)
FETTLE_JOINT_READ(float, torque)
FETTLE_JOINT_READ(uint64_t, user_data)

// Defines the properties of a joint for one of its two bodies.
#define FETTLE_JOINT_SIDE(letter, side)                                                      \
    Body Joint::body_##letter() const {                                                      \
        const WorldData& data = live();                                                      \
        const uint32_t body = data.joints[id_.index].bodies[side];                           \
        return body == 0 ? Body() : Body(link_->world, data.body_id(body));                  \
    }                                                                                        \
    void Joint::set_body_##letter(const Body& body) {                                        \
        set_body(side, body, __func__);                                                      \
    }                                                                                        \
    Position Joint::anchor_##letter() const {                                                \
        return live().joints[id_.index].anchors[side];                                       \
    }                                                                                        \
    void Joint::set_anchor_##letter(const Position& anchor) {                                \
        WorldData& data = edited(__func__);                                                  \
        data.joints[id_.index].anchors[side] = check_coordinates("anchor_" #letter, anchor); \
        data.change<edit_joint>(id_.index);                                                  \
    }                                                                                        \
    Position Joint::world_anchor_##letter() const {                                          \
        const Body body = body_##letter();                                                   \
        return body ? body.world_point(Vec2(anchor_##letter())) : anchor_##letter();         \
    }
FETTLE_JOINT_SIDE(a, 0)
FETTLE_JOINT_SIDE(b, 1)

void Joint::set_enabled(bool enabled) {
    edited(__func__).change<detail::set_joint_enabled>(id_.index, enabled);
}

void Joint::set_collide(bool collide) {
    edited(__func__).change<detail::set_joint_collide>(id_.index, collide);
}

#define FETTLE_JOINT_VALUE(name, check)                    \
    FETTLE_JOINT_READ(float, name)                         \
    void Joint::set_##name(float value) {                  \
        WorldData& data = edited(__func__);                \
        data.joints[id_.index].name = check(#name, value); \
        data.change<edit_joint>(id_.index);                \
    }
FETTLE_JOINT_VALUE(break_force, check_strength)
FETTLE_JOINT_VALUE(break_torque, check_strength)
FETTLE_JOINT_VALUE(report_force, check_strength)
FETTLE_JOINT_VALUE(report_torque, check_strength)
FETTLE_JOINT_VALUE(constraint_hertz, check_not_negative)
FETTLE_JOINT_VALUE(constraint_damping_ratio, check_ratio)

void Joint::set_broken(bool broken) {
    edited(__func__).change<detail::set_joint_broken>(id_.index, broken);
}

float Joint::per_substep(float impulse) const {
    const float h = live().last_substep;
    return h > 0.0f ? impulse / h : 0.0f;
}

Vec2 Joint::force() const {
    return live().joints[id_.index].force;
}
void Joint::set_user_data(uint64_t value) {
    WorldData& data = live();
    data.self.may_populate("Joint", __func__);
    data.joints[id_.index].user_data = value;
}

Joint World::create_joint(JointType type, uint64_t user_data) {
    WorldData& data = populate(__func__);
    JointRecord record = record_of(check_enumerator("type", type, JointType::rotary_limit));
    record.user_data = user_data;
    return make_joint<Joint>(*this, data, record);
}

Joint World::create_joint(const Joint& like) {
    WorldData& data = populate(__func__);
    JointRecord record = like.live().joints[like.id().index];
    record.bodies[0] = record.bodies[1] = 0;
    record.awake_index = none;
    return make_joint<Joint>(*this, data, record);
}

}  // namespace fettle::physics
