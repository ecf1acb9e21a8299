#pragma once

#include <world/arguments.h>
#include <world/world_data.h>

#include <stdexcept>
#include <string>

// For the handles of joints: from the handle to what the joint is set to.

namespace fettle::physics {

namespace detail {
[[noreturn]] void wrong_joint(JointType expected, JointType is);

inline float check_stiffness(const char* what, float hertz) {
    return check_range(what, hertz, 0.0f, infinity);
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
Data& Joint::edit() const {
    Data& own_data = own<Data>();
    live().wake_joint(id_.index);
    return own_data;
}

}  // namespace fettle::physics

// A setting that is read as it is, and written after a check.
#define FETTLE_JOINT_SETTING(Class, Data, name, check) \
    float Class::name() const {                        \
        return own<detail::Data>().name;               \
    }                                                  \
    void Class::set_##name(float value) {              \
        using namespace detail;                        \
        (void)own<detail::Data>();                     \
        const float checked = check;                   \
        edit<detail::Data>().name = checked;           \
    }
