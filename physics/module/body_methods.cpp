// Methods of Body: from one coordinate system to the other, pushes.

#include "bindings.h"
#include "classes.h"

namespace fettle::physics_module {
namespace {

using property::Effect;
using property::Field;
using property::Method;
using property::Result;
using Arguments = std::span<const Value>;

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

const std::vector<Field> touch_fields = {
    {"other", Type::reference, "", "The other body; the world itself for its bounds."},
    {"shape", Type::reference, "", "The shape of this body."},
    {"other_shape", Type::reference, "", "The shape of the other; nil for the bounds."},
    {"point", Type::vec2, "m", "Where, in the world."},
    {"normal", Type::vec2, "", "From this body to the other."},
    {"impulse", Type::number, "N s", "That pressed them apart in the last step."},
    {"tangent_impulse", Type::number, "N s", "Of friction, clockwise round this body."},
    {"friction", Type::number, "", "Mixed from both surfaces."},
    {"restitution", Type::number, "", "Mixed from both surfaces."},
};

/// Every touch of a body as it sees it, one record a pair of shapes.
Result touches(void* context, property::Tree&, Handle, Row row, Arguments) {
    Hosting& hosting = *static_cast<Hosting*>(context);
    physics::World& world = hosting.world(row);
    const physics::Body self = hosting.body(row);
    std::vector<property::Record> records;
    for (const physics::Contact& contact : self.contacts()) {
        const bool first = contact.body_a == self.id();
        const physics::BodyId other = first ? contact.body_b : contact.body_a;
        const physics::ShapeId own_shape = first ? contact.shape_a : contact.shape_b;
        const physics::ShapeId other_shape = first ? contact.shape_b : contact.shape_a;
        physics::Vec2 point = physics::Vec2::Zero();
        float impulse = 0.0f, tangent = 0.0f;
        for (int k = 0; k < contact.point_count; ++k) {
            const physics::ContactPoint& p = contact.points[static_cast<std::size_t>(k)];
            point += p.point / static_cast<float>(contact.point_count);
            impulse += p.normal_impulse * static_cast<float>(world.substeps());
            tangent += p.tangent_impulse * static_cast<float>(world.substeps());
        }
        const Handle body = unpack(world.body(other).user_data());
        records.push_back(
            {&touch_fields,
             {body ? body : hosting.hosted(row).self, unpack(world.shape(own_shape).user_data()),
              unpack(world.shape(other_shape).user_data()), to_value(point),
              to_value(first ? contact.normal : physics::Vec2(-contact.normal)), to_value(impulse),
              to_value(tangent), to_value(contact.friction), to_value(contact.restitution)}});
    }
    return records;
}

}  // namespace

std::vector<Method> body_methods(Hosting& hosting) {
    const auto vec2 = [](std::string name, std::string unit, std::string doc) {
        return Field{std::move(name), Type::vec2, std::move(unit), std::move(doc)};
    };
    return {
        {.name = "touches",
         .returns = touch_fields,
         .doc = "What `contacts` lists, with where and how hard: one record a pair of shapes.",
         .context = &hosting,
         .call = touches,
         .effect = Effect::nothing},
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
