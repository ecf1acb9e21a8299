// Methods of Body: conversion between coordinate systems, forces and impulses.

#include <fettle/property/drawing.h>

#include <bindings/bindings.h>
#include <bodies/body_class.h>
#include <bodies/touches.h>
#include <drawing/drawn_pose.h>

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
    return Frame(in, slot, property::Drawing::alpha());
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
                        .doc = "A point in the world; the center of mass if it is left out."};

}  // namespace

std::vector<Method> body_methods(Hosting& hosting) {
    const auto vec2 = [](std::string name, std::string unit, std::string doc) {
        return Field{std::move(name), Type::vec2, std::move(unit), std::move(doc)};
    };
    return {
        touches_method(hosting),
        method(hosting,
               {.name = "to_world",
                .parameters = {vec2("point", "m", "A point in the coordinates of the body.")},
                .required = 1,
                .returns = {vec2("point", "m", "The point in the world.")},
                .doc = "Converts a point of the body to the world.",
                .effect = Effect::nothing},
               [](const physics::Body& body, Arguments a) -> Result {
                   return to_value(body.world_point(vec2_argument(a[0])));
               }),
        method(hosting,
               {.name = "to_local",
                .parameters = {vec2("point", "m", "A point in the world.")},
                .required = 1,
                .returns = {vec2("point", "m", "The point in the coordinates of the body.")},
                .doc = "Converts a point of the world to the coordinates of the body.",
                .effect = Effect::nothing},
               [](const physics::Body& body, Arguments a) -> Result {
                   return to_value(body.local_point(vec2_argument(a[0])));
               }),
        drawn_method(hosting,
                     {.name = "drawn_position",
                      .returns = {vec2("position", "m", "The position in the world.")},
                      .doc = "Position of its origin in the picture that is being drawn: "
                             "pictures are drawn between the last two steps. Outside of `draw`: "
                             "its position."},
                     [](const Frame& frame, Arguments) { return Value(frame.position()); }),
        drawn_method(hosting,
                     {.name = "drawn_angle",
                      .returns = {{.name = "angle", .unit = "rad", .doc = "Counter-clockwise."}},
                      .doc = "Its angle in the picture that is being drawn. Outside of `draw`: "
                             "its angle."},
                     [](const Frame& frame, Arguments) { return Value(frame.angle()); }),
        drawn_method(hosting,
                     {.name = "to_drawn",
                      .parameters = {vec2("point", "m", "A point in the coordinates of the body.")},
                      .required = 1,
                      .returns = {vec2("point", "m", "The point in the world.")},
                      .doc = "Converts a point of the body to the picture that is being drawn. "
                             "Outside of `draw`: as `to_world`."},
                     [](const Frame& frame, Arguments a) {
                         return Value(frame.point(vec2_argument(a[0])));
                     }),
        method(hosting,
               {.name = "velocity_at",
                .parameters = {vec2("point", "m", "A point in the world.")},
                .required = 1,
                .returns = {vec2("velocity", "m/s", "Velocity of that point in the world.")},
                .doc = "Velocity of a point of the body.",
                .effect = Effect::nothing},
               [](const physics::Body& body, Arguments a) -> Result {
                   return to_value(body.velocity_at(vec2_argument(a[0])));
               }),
        method(hosting,
               {.name = "apply_impulse",
                .parameters = {vec2("impulse", "N s", "Mass times the change of velocity."),
                               world_point},
                .required = 1,
                .doc = "Changes its velocity at once."},
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
                .parameters = {vec2("force", "N", "Force in world coordinates."), world_point},
                .required = 1,
                .doc = "Applies a force during the next step only; the property `force` is not "
                       "changed. It is constant for the whole step: a spring needs a joint or an "
                       "Attractor, or it gains energy."},
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
                .doc = "Applies a torque during the next step only; the property `torque` is not "
                       "changed."},
               [](physics::Body body, Arguments a) -> Result {
                   body.apply_torque(float_argument(a[0]));
                   return Value();
               }),
    };
}

}  // namespace fettle::physics_module
