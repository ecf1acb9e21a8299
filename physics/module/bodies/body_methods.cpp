// Methods of Body: conversion between coordinate systems, forces and impulses.

#include <fettle/property/drawing.h>

#include <bindings/bindings.h>
#include <bodies/body_class.h>
#include <bodies/touches.h>
#include <drawing/forms.h>

namespace fettle::physics_module {
namespace {

using property::Effect;
using property::Field;
using property::Method;
using property::Result;
using Arguments = std::span<const Value>;

/// Pose of the body in the current picture; outside of drawing, its current pose.
Frame drawn_frame(Hosting& hosting, Row row) {
    const auto [in, slot] = hosting.at(row);
    return Frame(in.world, slot, property::Drawing::alpha());
}

/// `Run`: captureless lambda (const Frame&, Arguments) -> Value.
template <class Run>
Method drawn_method(Hosting& hosting, Method described, Run) {
    described.context = &hosting;
    described.effect = Effect::nothing;
    described.call = [](void* context, property::Tree&, Handle, Row row,
                        Arguments arguments) -> Result {
        return Run{}(drawn_frame(*static_cast<Hosting*>(context), row), arguments);
    };
    return described;
}

/// `Run`: captureless lambda (physics::Body, Arguments) -> Result.
template <class Run>
Method method(Hosting& hosting, Method described, Run) {
    described.context = &hosting;
    described.call = [](void* context, property::Tree&, Handle, Row row, Arguments arguments) {
        auto& h = *static_cast<Hosting*>(context);
        const bool outside = world_number(row) == limbo;
        if (outside) h.velocity(row);
        Result result = Run{}(h.body(row), arguments);
        if (outside) h.set_velocity(row, h.body(row).velocity());
        return result;
    };
    return described;
}

const Field world_point{.name = "point",
                        .type = Type::vec2,
                        .unit = "m",
                        .doc = "In the world; the center of mass when left out."};

}  // namespace

std::vector<Method> body_methods(Hosting& hosting) {
    const auto vec2 = [](std::string name, std::string unit, std::string doc) {
        return Field{std::move(name), Type::vec2, std::move(unit), std::move(doc)};
    };
    return {
        touches_method(hosting),
        method(hosting,
               {.name = "to_world",
                .parameters = {vec2("point", "m", "In the body's coordinates.")},
                .required = 1,
                .returns = {vec2("point", "m", "In the world.")},
                .doc = "Where a point of the body is in the world.",
                .effect = Effect::nothing},
               [](const physics::Body& body, Arguments a) -> Result {
                   return to_value(body.world_point(vec2_argument(a[0])));
               }),
        method(hosting,
               {.name = "to_local",
                .parameters = {vec2("point", "m", "In the world.")},
                .required = 1,
                .returns = {vec2("point", "m", "In the body's coordinates.")},
                .doc = "Where a point of the world is as seen from the body.",
                .effect = Effect::nothing},
               [](const physics::Body& body, Arguments a) -> Result {
                   return to_value(body.local_point(vec2_argument(a[0])));
               }),
        drawn_method(hosting,
                     {.name = "drawn_position",
                      .returns = {vec2("position", "m", "In the world.")},
                      .doc = "Where the picture that is being drawn shows its origin: pictures are "
                             "drawn between the last two steps. Outside of `draw`: its position."},
                     [](const Frame& frame, Arguments) { return Value(frame.position()); }),
        drawn_method(hosting,
                     {.name = "drawn_angle",
                      .returns = {{.name = "angle", .unit = "rad", .doc = "Counter-clockwise."}},
                      .doc = "How far it is turned in the picture that is being drawn. Outside of "
                             "`draw`: its angle."},
                     [](const Frame& frame, Arguments) { return Value(frame.angle()); }),
        drawn_method(hosting,
                     {.name = "to_drawn",
                      .parameters = {vec2("point", "m", "In the body's coordinates.")},
                      .required = 1,
                      .returns = {vec2("point", "m", "In the world.")},
                      .doc = "Where the picture that is being drawn shows a point of the body. "
                             "Outside of `draw`: as `to_world`."},
                     [](const Frame& frame, Arguments a) {
                         return Value(frame.point(vec2_argument(a[0])));
                     }),
        method(hosting,
               {.name = "velocity_at",
                .parameters = {vec2("point", "m", "In the world.")},
                .required = 1,
                .returns = {vec2("velocity", "m/s", "Of that point, in the world.")},
                .doc = "How fast that point of the body moves.",
                .effect = Effect::nothing},
               [](const physics::Body& body, Arguments a) -> Result {
                   return to_value(body.velocity_at(vec2_argument(a[0])));
               }),
        method(hosting,
               {.name = "apply_impulse",
                .parameters = {vec2("impulse", "N s", "Mass times the change of velocity."),
                               world_point},
                .required = 1,
                .doc = "Changes its velocity at once: a kick."},
               [](physics::Body body, Arguments a) -> Result {
                   if (a[1].is_nil())
                       body.apply_impulse(vec2_argument(a[0]));
                   else
                       body.apply_impulse(vec2_argument(a[0]), vec2_argument(a[1]));
                   return Value();
               }),
        method(hosting,
               {.name = "apply_angular_impulse",
                .parameters = {{.name = "impulse",
                                .unit = "N m s",
                                .doc = "Inertia times the change of angular velocity, "
                                       "counter-clockwise."}},
                .required = 1,
                .doc = "Changes its angular velocity at once."},
               [](physics::Body body, Arguments a) -> Result {
                   body.apply_angular_impulse(float_argument(a[0]));
                   return Value();
               }),
        method(hosting,
               {.name = "apply_force",
                .parameters = {vec2("force", "N", "In the world."), world_point},
                .required = 1,
                .doc = "Pushes it during the next step only; the property `force` stays."},
               [](physics::Body body, Arguments a) -> Result {
                   if (a[1].is_nil())
                       body.apply_force(vec2_argument(a[0]));
                   else
                       body.apply_force(vec2_argument(a[0]), vec2_argument(a[1]));
                   return Value();
               }),
        method(hosting,
               {.name = "apply_torque",
                .parameters = {{.name = "torque", .unit = "N m", .doc = "Counter-clockwise."}},
                .required = 1,
                .doc = "Turns it during the next step only; the property `torque` stays."},
               [](physics::Body body, Arguments a) -> Result {
                   body.apply_torque(float_argument(a[0]));
                   return Value();
               }),
    };
}

}  // namespace fettle::physics_module
