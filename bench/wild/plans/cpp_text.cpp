#include "wild/plans/cpp_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "wild/plans/setters.h"

namespace fettle::bench::wild {
namespace {

/// The shortest text that is this number again.
std::string text_of(float number) {
    if (std::isinf(number)) return number > 0 ? "infinity" : "-infinity";
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    std::string text(digits.data(), end);
    if (text.find_first_of(".e") != std::string::npos) text += "f";
    return text;
}
std::string text_of(int number) {
    return std::to_string(number);
}
std::string text_of(std::uint64_t number) {
    return number == ~std::uint64_t{0} ? "~uint64_t{0}" : std::to_string(number);
}
std::string text_of(bool value) {
    return value ? "true" : "false";
}
std::string text_of(const Vec2& v) {
    return "{" + text_of(v.x) + ", " + text_of(v.y) + "}";
}
std::string text_of(const Aabb& box) {
    return "Aabb{" + text_of(box.min) + ", " + text_of(box.max) + "}";
}
std::string text_of(BodyType type) {
    constexpr const char* names[] = {"static_body", "kinematic_body", "dynamic_body"};
    return std::string("BodyType::") + names[std::size_t(type)];
}
std::string text_of(Solver solver) {
    constexpr const char* names[] = {"soft_step", "sequential", "direct"};
    return std::string("Solver::") + names[std::size_t(solver)];
}
std::string text_of(JointType type) {
    constexpr const char* names[] = {"mouse", "distance", "revolute", "prismatic",
                                     "wheel", "weld",     "motor",    "pulley",
                                     "gear",  "groove",   "pin_slot", "ratchet"};
    return std::string("JointType::") + names[std::size_t(type)];
}
template <class Value>
std::string text_of(const std::optional<Value>& value) {
    return value ? text_of(*value) : "{}";
}
std::string text_of(const std::vector<Vec2>& points) {
    std::string text = "{";
    for (const Vec2& point : points) text += (text.size() > 1 ? ", " : "") + text_of(point);
    return text + "}";
}

/// `{.a = 1, .b = 2}`, without the members that have their defaults.
class Members {
  public:
    template <class Value>
    Members& add(const char* name, const Value& value, const Value& otherwise) {
        if (!(value == otherwise)) put(name, text_of(value));
        return *this;
    }
    Members& put(const char* name, const std::string& text) {
        if (!text_.empty()) text_ += ", ";
        text_ += std::string(".") + name + " = " + text;
        return *this;
    }
    std::string text() const { return "{" + text_ + "}"; }
    bool empty() const { return text_.empty(); }

  private:
    std::string text_;
};

std::string text_of(const WorldDef& def) {
    const WorldDef usual;
    return Members()
        .add("gravity", def.gravity, usual.gravity)
        .add("substeps", def.substeps, usual.substeps)
        .add("bounds", def.bounds, usual.bounds)
        .add("bounds_friction", def.bounds_friction, usual.bounds_friction)
        .add("bounds_restitution", def.bounds_restitution, usual.bounds_restitution)
        .add("sleeping", def.sleeping, usual.sleeping)
        .add("continuous", def.continuous, usual.continuous)
        .add("solver", def.solver, usual.solver)
        .text();
}

std::string text_of(const BodyDef& def) {
    const BodyDef usual;
    return Members()
        .add("type", def.type, usual.type)
        .add("position", def.position, usual.position)
        .add("angle", def.angle, usual.angle)
        .add("velocity", def.velocity, usual.velocity)
        .add("angular_velocity", def.angular_velocity, usual.angular_velocity)
        .add("gravity_scale", def.gravity_scale, usual.gravity_scale)
        .add("linear_damping", def.linear_damping, usual.linear_damping)
        .add("angular_damping", def.angular_damping, usual.angular_damping)
        .add("awake", def.awake, usual.awake)
        .add("can_sleep", def.can_sleep, usual.can_sleep)
        .add("bullet", def.bullet, usual.bullet)
        .add("locked_x", def.locked_x, usual.locked_x)
        .add("locked_y", def.locked_y, usual.locked_y)
        .add("locked_rotation", def.locked_rotation, usual.locked_rotation)
        .text();
}

std::string text_of(const ShapeDef& def) {
    const ShapeDef usual;
    const Members members =
        Members()
            .add("density", def.density, usual.density)
            .add("friction", def.friction, usual.friction)
            .add("restitution", def.restitution, usual.restitution)
            .add("rolling_resistance", def.rolling_resistance, usual.rolling_resistance)
            .add("surface_speed", def.surface_speed, usual.surface_speed)
            .add("sensor", def.sensor, usual.sensor)
            .add("category", def.category, usual.category)
            .add("mask", def.mask, usual.mask)
            .add("group", def.group, usual.group);
    return members.empty() ? "" : ", " + members.text();
}

struct GeometryText {
    std::string operator()(const Circle& c) const {
        const Circle usual;
        return "Circle" + Members()
                              .add("radius", c.radius, usual.radius)
                              .add("center", c.center, usual.center)
                              .text();
    }
    std::string operator()(const Box& b) const {
        const Box usual;
        return "Box" + Members()
                           .add("width", b.width, usual.width)
                           .add("height", b.height, usual.height)
                           .add("center", b.center, usual.center)
                           .add("angle", b.angle, usual.angle)
                           .add("rounding", b.rounding, usual.rounding)
                           .text();
    }
    std::string operator()(const Segment& s) const {
        return "Segment" + Members()
                               .put("from", text_of(s.from))
                               .put("to", text_of(s.to))
                               .add("rounding", s.rounding, 0.0f)
                               .text();
    }
    std::string operator()(const Polygon& p) const {
        return "Polygon" + Members()
                               .put("vertices", text_of(p.vertices))
                               .add("rounding", p.rounding, 0.0f)
                               .text();
    }
    std::string operator()(const Ellipse& e) const {
        const Ellipse usual;
        return "Ellipse" + Members()
                               .put("radius_x", text_of(e.radius_x))
                               .put("radius_y", text_of(e.radius_y))
                               .add("center", e.center, usual.center)
                               .add("angle", e.angle, usual.angle)
                               .text();
    }
    std::string operator()(const Concave& c) const {
        return "Concave" + Members().put("vertices", text_of(c.vertices)).text();
    }
    std::string operator()(const Chain& c) const {
        return "Chain" +
               Members().put("points", text_of(c.points)).add("closed", c.closed, false).text();
    }
};

struct FieldText {
    std::string operator()(const WindField& wind) const {
        return "WindField" + Members()
                                 .put("velocity", text_of(wind.velocity))
                                 .put("density", text_of(wind.density))
                                 .text();
    }
    std::string operator()(const DragField& drag) const {
        return "DragField" + Members()
                                 .put("flow", text_of(drag.flow))
                                 .put("linear", text_of(drag.linear))
                                 .put("quadratic", text_of(drag.quadratic))
                                 .text();
    }
    std::string operator()(const BuoyancyField& liquid) const {
        return "BuoyancyField" + Members()
                                     .put("level", text_of(liquid.level))
                                     .put("density", text_of(liquid.density))
                                     .put("drag", text_of(liquid.drag))
                                     .put("flow", text_of(liquid.flow))
                                     .text();
    }
    std::string operator()(const AttractorField& pull) const {
        return "AttractorField" + Members()
                                      .put("center", text_of(pull.center))
                                      .put("strength", text_of(pull.strength))
                                      .put("falloff", text_of(pull.falloff))
                                      .text();
    }
};

std::string value_text(const Setter& setter, const Vec2& value) {
    switch (setter.value) {
        case ValueKind::nothing:
        case ValueKind::geometry:
            return "";
        case ValueKind::number:
            return text_of(value.x);
        case ValueKind::flag:
            return text_of(value.x != 0);
        case ValueKind::vector:
            return text_of(value);
        case ValueKind::body_type:
            return text_of(BodyType(int(value.x)));
        case ValueKind::solver:
            return text_of(Solver(int(value.x)));
    }
    return "";
}

std::string bodies_at(const WorldPlan& plan, int step, const std::string& indent) {
    std::string text;
    for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
        const BodyPlan& body = plan.bodies[i];
        if (body.born != step) continue;
        const std::string name = "b[" + std::to_string(i) + "]";
        text += indent + name + " = world.create_body(" + text_of(body.def) + ");\n";
        for (const ShapePlan& shape : body.shapes)
            text += indent + name + ".add(" + std::visit(GeometryText{}, shape.geometry) +
                    text_of(shape.def) + ");\n";
    }
    return text;
}

std::string joints_at(const WorldPlan& plan, int step, const std::string& indent) {
    std::string text;
    const auto end = [](int body) {
        return body == the_world ? std::string("Body()") : "b[" + std::to_string(body) + "]";
    };
    for (std::size_t i = 0; i < plan.joints.size(); ++i) {
        const JointPlan& joint = plan.joints[i];
        if (joint.born != step) continue;
        const std::string name = "j" + std::to_string(i);
        const std::string type = class_of(joint.type);
        text +=
            indent + name + " = {&world, world.create_joint(" + text_of(joint.type) + ").id()};\n";
        text += indent + name + ".connect(" + end(joint.a) + ", " + end(joint.b) + ");\n";
        if (joint.anchor_a != Vec2{})
            text += indent + name + ".set_anchor_a(" + text_of(joint.anchor_a) + ");\n";
        if (joint.anchor_b != Vec2{})
            text += indent + name + ".set_anchor_b(" + text_of(joint.anchor_b) + ");\n";
        if (joint.collide) text += indent + name + ".set_collide(true);\n";
        for (const Setting& setting : joint.settings) {
            const Setter& setter = setter_named(setting.setter, Target::joint, joint.type);
            text += indent + name + "." + setter.name + "(" + value_text(setter, setting.value) +
                    ");\n";
        }
    }
    return text;
}

std::string edit_text(const WorldPlan& plan, const Edit& edit) {
    std::string object;
    JointType joint{};
    switch (edit.target) {
        case Target::world:
            object = "world";
            break;
        case Target::body:
            object = "b[" + std::to_string(edit.object) + "]";
            break;
        case Target::shape:
            object = "b[" + std::to_string(edit.object) + "].shapes()[" +
                     std::to_string(edit.shape) + "]";
            break;
        case Target::joint:
            object = "j" + std::to_string(edit.object);
            joint = plan.joints[std::size_t(edit.object)].type;
            break;
    }
    const Setter& setter = setter_named(edit.setting.setter, edit.target, joint);
    const std::string value = edit.geometry ? std::visit(GeometryText{}, *edit.geometry)
                                            : value_text(setter, edit.setting.value);
    return object + "." + setter.name + "(" + value + ");\n";
}

std::string steps_text(const WorldPlan& plan) {
    std::string text, lengths;
    for (const float length : plan.lengths)
        lengths += (lengths.empty() ? "" : ", ") + text_of(length);
    const bool alike = plan.lengths.size() == 1;
    if (!alike) text += "const float lengths[] = {" + lengths + "};\n";
    bool swings = false;
    for (const BodyPlan& body : plan.bodies) swings = swings || body.swing.hertz > 0;
    if (swings) text += "double time = 0;\n";
    text += "for (int i = 0; i < " + std::to_string(plan.steps) + "; ++i) {\n";
    for (int step = 1; step <= plan.last_edit(); ++step) {
        if (!plan.edited_at(step)) continue;
        text += "    if (i == " + std::to_string(step) + ") {\n";
        text += bodies_at(plan, step, "        ") + joints_at(plan, step, "        ");
        for (const Edit& edit : plan.edits)
            if (edit.step == step) text += "        " + edit_text(plan, edit);
        text += "    }\n";
    }
    for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
        const Swing& swing = plan.bodies[i].swing;
        if (swing.hertz <= 0) continue;
        const std::string rate = "2 * std::numbers::pi * " + text_of(swing.hertz);
        text += "    b[" + std::to_string(i) + "].set_velocity(Vec2" + text_of(swing.reach) +
                " * float(" + rate + " * std::cos(" + rate + " * time)));\n";
    }
    const std::string length =
        alike ? lengths : "lengths[i % " + std::to_string(plan.lengths.size()) + "]";
    if (swings) text += "    time += " + length + ";\n";
    text += "    world.step(" + length + ");\n}\n";
    return text;
}

}  // namespace

std::string cpp_text(const WorldPlan& plan) {
    std::string text = "World world(WorldDef" + text_of(plan.def) + ");\n";
    text += "Body b[" + std::to_string(std::max<std::size_t>(plan.bodies.size(), 1)) + "];\n";
    for (std::size_t i = 0; i < plan.joints.size(); ++i)
        text += std::string(class_of(plan.joints[i].type)) + " j" + std::to_string(i) + ";\n";
    for (const FieldDef& field : plan.fields)
        text += "world.create_field({.force = " + std::visit(FieldText{}, field.force) +
                (field.region ? ", .region = " + text_of(*field.region) : "") + "});\n";
    text += bodies_at(plan, 0, "") + joints_at(plan, 0, "");
    return text + steps_text(plan);
}

}  // namespace fettle::bench::wild
