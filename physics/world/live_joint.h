#pragma once

#include <checks/arguments.h>
#include <world/world_data.h>

#include <stdexcept>
#include <string>

// For the handles of joints: from the handle to what the joint is set to.

namespace fettle::physics {

namespace detail {
[[noreturn]] void wrong_joint(JointType expected, JointType is);

/// Of b relative to a, rad.
inline float angle_between(const Joint& joint) {
    const Body a = joint.body_a(), b = joint.body_b();
    return (b ? b.angle() : 0.0f) - (a ? a.angle() : 0.0f);
}

/// From anchor a to anchor b, world axes, m.
inline Vec2 gap_between(const Joint& joint) {
    return joint.world_anchor_b() - joint.world_anchor_a();
}
}  // namespace detail

template <class Data>
Data& Joint::own() const {
    detail::WorldData& data = live();
    const detail::JointRecord& record = data.joints[id_.index];
    if (record.type != detail::joint_type<Data>)
        detail::wrong_joint(detail::joint_type<Data>, record.type);
    return std::get<std::vector<Data>>(data.joint_lists)[record.place];
}

template <class Data>
Data& Joint::edit(const char* of, const char* function) const {
    Data& own_data = own<Data>();
    detail::WorldData& data = live();
    data.self.may_edit(of, function);
    wake_joint(data.activity(), id_.index);
    return own_data;
}

}  // namespace fettle::physics

// A setting that is kept in `field`, read as it is, and written after a check.
#define FETTLE_JOINT_FIELD(Class, Data, name, field, check)   \
    float Class::name() const {                               \
        return own<detail::Data>().field;                     \
    }                                                         \
    void Class::set_##name(float value) {                     \
        using namespace detail;                               \
        (void)own<detail::Data>();                            \
        const float checked = check;                          \
        edit<detail::Data>(#Class, __func__).field = checked; \
    }
#define FETTLE_JOINT_SETTING(Class, Data, name, check) \
    FETTLE_JOINT_FIELD(Class, Data, name, name, check)
#define FETTLE_JOINT_VECTOR(Class, Data, name, field, check)         \
    Vec2 Class::name() const {                                       \
        return detail::to_vec2(own<detail::Data>().field);           \
    }                                                                \
    void Class::set_##name(const Vec2& value) {                      \
        using namespace detail;                                      \
        (void)own<detail::Data>();                                   \
        const Vec2 checked = check;                                  \
        edit<detail::Data>(#Class, __func__).field = to_v2(checked); \
    }
