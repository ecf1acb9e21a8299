#pragma once
// The setters of the library that plans call, by name.

#include "wild/plans/plan.h"

namespace fettle::bench::wild {

/// The objects a setter is called for; those that it does not need may be empty.
struct SetterTarget {
    World& world;
    Body body{};
    Shape shape{};
    JointId joint{};
};

enum class ValueKind : std::uint8_t { nothing, number, flag, vector, body_type, solver, geometry };

struct Setter {
    Target target;
    JointType joint;  // if the target is a joint
    const char* name;
    ValueKind value;
    void (*call)(const SetterTarget&, const Vec2& value);  // null for `set_geometry`
};

/// Throws std::invalid_argument if there is none.
const Setter& setter_named(const std::string& name, Target target, JointType joint);

/// "RevoluteJoint" and the like.
const char* class_of(JointType type);

}  // namespace fettle::bench::wild
