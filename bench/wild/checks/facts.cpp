#include "wild/checks/facts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "wild/checks/gaps.h"
#include "wild/checks/outlines.h"
#include "wild/plans/fettle_world.h"

namespace fettle::bench::wild {
namespace {

bool stores_energy(const JointPlan& joint) {
    if (joint.type == JointType::mouse || joint.type == JointType::wheel) return true;
    for (const char* spring : {"set_hertz", "set_angular_hertz"})
        if (joint.number(spring, 0) > 0) return true;
    if (joint.type == JointType::motor) {
        return joint.vector("set_linear_velocity", Vec2{}) != Vec2{} ||
               joint.vector("set_linear_offset", Vec2{}) != Vec2{} ||
               joint.number("set_angular_velocity", 0) != 0;
    }
    return joint.number("set_motor_speed", 0) != 0;
}

/// True for an edit that drives bodies in all later steps, and not only at its moment.
bool drives(const Setting& setting) {
    for (const char* name : {"set_motor_speed", "set_target", "set_linear_offset", "set_hertz",
                             "set_surface_speed", "set_type", "set_gravity_scale", "set_length"})
        if (setting.setter == name) return true;
    return false;
}

/// A horizontal or upright line, as exact as a box that is not turned.
bool is_level(const Edge& edge, float angle) {
    const Vec2 along = placed(edge.to - edge.from, Vec2{}, angle);
    return std::abs(along.x) < 1e-3f * along.length() || std::abs(along.y) < 1e-3f * along.length();
}

bool is_quiet_ground(const BodyPlan& body) {
    for (const ShapePlan& shape : body.shapes) {
        if (std::holds_alternative<Circle>(shape.geometry) ||
            std::holds_alternative<Ellipse>(shape.geometry))
            return false;
        for (const Edge& edge : outline_of(shape.geometry).edges)
            if (!is_level(edge, body.def.angle)) return false;
    }
    return true;
}

/// Round shapes roll unless they resist, and ellipses and nearly round polygons cannot resist.
bool settles(const ShapePlan& shape) {
    if (std::holds_alternative<Ellipse>(shape.geometry)) return false;
    const auto* polygon = std::get_if<Polygon>(&shape.geometry);
    if (polygon != nullptr && (polygon->vertices.size() > 6 || polygon->rounding > 0)) return false;
    const bool round = std::holds_alternative<Circle>(shape.geometry) ||
                       std::holds_alternative<Segment>(shape.geometry);
    return shape.def.friction >= 0.3f && shape.def.restitution <= 0.3f &&
           (!round || shape.def.rolling_resistance >= 0.05f);
}

}  // namespace

bool is_driven(const WorldPlan& plan) {
    if (!plan.fields.empty()) return true;
    for (const BodyPlan& body : plan.bodies) {
        if (body.def.type == BodyType::kinematic_body) return true;
        for (const ShapePlan& shape : body.shapes)
            if (shape.def.surface_speed != 0) return true;
    }
    return std::ranges::any_of(plan.joints, stores_energy) ||
           std::ranges::any_of(plan.edits, [](const Edit& e) { return drives(e.setting); });
}

bool bounces_singly(const WorldPlan& plan) {
    if (plan.def.solver == Solver::soft_step) return false;
    return plan.def.bounds_restitution > 0 ||
           std::ranges::any_of(plan.bodies, [](const BodyPlan& body) {
               return std::ranges::any_of(
                   body.shapes, [](const ShapePlan& shape) { return shape.def.restitution > 0; });
           });
}

bool is_isolated(const WorldPlan& plan) {
    if (plan.def.gravity != Vec2{} || plan.def.bounds || !plan.fields.empty()) return false;
    for (const BodyPlan& body : plan.bodies)
        if (is_fixed(body) || body.def.linear_damping > 0 || body.def.locked_x || body.def.locked_y)
            return false;
    for (const JointPlan& joint : plan.joints)
        if (joint.a == the_world || joint.b == the_world || joint.type == JointType::pulley)
            return false;
    return std::ranges::none_of(plan.edits, [](const Edit& edit) {
        return edit.setting.setter == "set_type" || edit.setting.setter == "set_gravity";
    });
}

bool can_rest(const WorldPlan& plan) {
    if (is_driven(plan) || !plan.def.sleeping || plan.def.gravity != Vec2(0, -10)) return false;
    // Stacks tremble under `sequential` (docs/design/solvers.md).
    if (!plan.edits.empty() || plan.def.solver == Solver::sequential) return false;
    for (const BodyPlan& body : plan.bodies) {
        if (is_fixed(body) ? !is_quiet_ground(body)
                           : !std::ranges::all_of(body.shapes, settles) || !body.def.can_sleep)
            return false;
        if (body.def.gravity_scale != 1) return false;
        for (const ShapePlan& shape : body.shapes)
            if (shape.def.friction < 0.3f || shape.def.restitution > 0.3f) return false;
    }
    // Hinges have no friction: only what is welded is sure to rest.
    return std::ranges::all_of(
        plan.joints, [](const JointPlan& joint) { return joint.type == JointType::weld; });
}

float plausible_speed(const WorldPlan& plan, float seconds) {
    constexpr float pi = std::numbers::pi_v<float>;
    float reach = 2, speed = 0, pull = plan.def.gravity.length();
    for (const BodyPlan& body : plan.bodies)
        if (!is_fixed(body) || body.def.angular_velocity != 0)
            reach = std::max(reach, reach_of(body));
    for (const BodyPlan& body : plan.bodies) {
        speed = std::max(speed,
                         body.def.velocity.length() + reach * std::abs(body.def.angular_velocity));
        speed = std::max(speed, 2 * pi * body.swing.reach.length() * body.swing.hertz);
        for (const ShapePlan& shape : body.shapes)
            speed = std::max(speed, std::abs(shape.def.surface_speed));
    }
    float springs = 0;
    for (const JointPlan& joint : plan.joints) {
        speed = std::max(speed, reach * std::abs(joint.number("set_motor_speed", 0)));
        // A spring that is stretched by the size of the scene; a mouse has 5 Hz if nothing is set.
        const float hertz = joint.number("set_hertz", joint.type == JointType::mouse ? 5.0f : 0.0f);
        if (std::isfinite(hertz)) springs = std::max(springs, 2 * pi * hertz * reach);
    }
    for (const Edit& edit : plan.edits) {
        const std::string& setter = edit.setting.setter;
        const float size = edit.setting.value.length();
        if (setter == "set_velocity") speed = std::max(speed, size);
        // The lightest bodies of the generator have some grams, so an impulse may give any speed.
        if (setter == "apply_impulse") return infinity;
        // A joint pulls a teleported body back at any speed.
        if (setter == "set_position" && !plan.joints.empty()) return infinity;
        if (setter == "set_angular_velocity" || setter == "set_motor_speed")
            speed = std::max(speed, reach * size);
        if (setter == "set_surface_speed") speed = std::max(speed, size);
        if (setter == "set_gravity") pull = std::max(pull, size);
        if (setter == "set_type" || setter == "set_length" || setter == "set_target") springs += 20;
    }
    for (const FieldDef& field : plan.fields) {
        if (const auto* attractor = std::get_if<AttractorField>(&field.force))
            pull += 4 * std::abs(attractor->strength);
        else
            return infinity;  // wind may give a thin plate any speed
    }
    return speed + springs + pull * seconds;
}

float fault_at_start(const WorldPlan& plan) {
    FettleWorld start(plan);
    start.prepare(0);
    start.advance(1e-6f);
    std::vector<BodyNow> bodies;
    start.read(bodies);
    float fault = 0;
    for (const BodyNow& body : bodies) fault += std::max(body.deepest - 0.01f, 0.0f);
    for (const JointPlan& joint : plan.joints)
        if (const auto gap = gap_of(joint, bodies); gap && joint.born == 0)
            fault += std::max(gap->length - 0.01f, 0.0f) + std::max(gap->angle - 0.01f, 0.0f);
    return fault;
}

float reach_of(const BodyPlan& body) {
    float reach = 0;
    for (const ShapePlan& shape : body.shapes)
        for (const Edge& edge : outline_of(shape.geometry).edges)
            reach = std::max({reach, edge.from.length(), edge.to.length()});
    return reach;
}

}  // namespace fettle::bench::wild
