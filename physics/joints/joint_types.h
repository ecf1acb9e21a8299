#pragma once

#include <fettle/physics/types.h>
#include <joints/distance_joint.h>
#include <joints/gear_joint.h>
#include <joints/motor_joint.h>
#include <joints/mouse_joint.h>
#include <joints/pin_slot_joint.h>
#include <joints/prismatic_joint.h>
#include <joints/pulley_joint.h>
#include <joints/ratchet_joint.h>
#include <joints/revolute_joint.h>
#include <joints/weld_joint.h>
#include <joints/wheel_joint.h>
#include <partition/strips.h>

#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace fettle::physics::detail {

/// All types of joints, in the order of `JointType`.
template <template <class...> class List>
using OfAllJoints =
    List<MouseConstraint, DistanceConstraint, RevoluteConstraint, PrismaticConstraint,
         WheelConstraint, WeldConstraint, MotorConstraint, PulleyConstraint, GearConstraint,
         GrooveConstraint, PinSlotConstraint, RatchetConstraint>;
inline constexpr const char* joint_type_names[] = {"mouse", "distance", "revolute", "prismatic",
                                                   "wheel", "weld",     "motor",    "pulley",
                                                   "gear",  "groove",   "pin-slot", "ratchet"};
inline constexpr size_t joint_type_count = std::size(joint_type_names);

template <class... Constraint>
using DataLists = std::tuple<std::vector<typename Constraint::Data>...>;
template <class... Constraint>
using ConstraintLists = std::tuple<std::vector<Constraint>...>;

using JointLists = OfAllJoints<DataLists>;              ///< what joints are set to
using JointConstraints = OfAllJoints<ConstraintLists>;  ///< what they are in a step
static_assert(std::tuple_size_v<JointLists> == joint_type_count);

/// The type of joint that is set to `Data`.
template <class Data>
inline constexpr JointType joint_type = [] {
    size_t type = 0;
    [&]<class... List>(std::tuple<List...>*) {
        (void)((std::is_same_v<typename List::value_type, Data> || (++type, false)) || ...);
    }(static_cast<JointLists*>(nullptr));
    return JointType(type);
}();

/// Calls `visit` with the list of that type.
template <class Lists, class Visit>
void with_list(Lists& lists, JointType type, Visit&& visit) {
    [&]<size_t... I>(std::index_sequence<I...>) {
        ((size_t(type) == I ? visit(std::get<I>(lists)) : void()), ...);
    }
    (std::make_index_sequence<joint_type_count>());
}

/// The joints of a type that act in a step, in the order of the nodes they belong to.
struct JointPlan {
    std::vector<uint32_t> joints;  ///< slots
    NodeRanges nodes;
};

struct JointPlans {
    std::array<JointPlan, joint_type_count> of_type;

    template <class Io, class Self>
    static void scratch(Io& io, Self& self) {
        for (auto& plan : self.of_type) io(plan.joints);
    }
};

}  // namespace fettle::physics::detail
