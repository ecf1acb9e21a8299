// Body: the class of bodies of the physics library.

#include <cmath>
#include <limits>
#include <stdexcept>

#include <bindings/bindings.h>
#include <bodies/body_class.h>
#include <bodies/mass_explanations.h>
#include <bodies/touches.h>
#include <drawing/drawn_pose.h>
#include <events/events.h>

namespace fettle::physics_module {
namespace {

using physics::Body;

bool immovable(const Body& body) {
    return body.type() == physics::BodyType::static_body ||
           (body.type() == physics::BodyType::dynamic_body && std::isinf(body.mass()));
}

/// Throws if the library would ignore a velocity, because the body cannot move.
void require_movable(const Body& body) {
    if (!immovable(body)) return;
    throw std::invalid_argument(body.type() == physics::BodyType::static_body
                                    ? "a static body does not move: make it kinematic or dynamic"
                                    : "a body of infinite mass does not move");
}

/// To be called before the pose of a body is written.
void note_written(Hosting& hosting, Row row) {
    const auto [in, slot] = hosting.at(row);
    in.written_poses.note(in.world, slot);
}

// Data that the step writes are read directly from the library's array.

Binding position(Hosting& hosting) {
    return accessor(
        hosting,
        [](Hosting& h, Row row) {
            const physics::Vec2& p = h.state(row).position;
            return widen(p.x, p.y);
        },
        [](Hosting& h, Row row, const Value& value) {
            note_written(h, row);
            h.body(row).set_position(narrow(value.vec2()));
        });
}

Binding body_angle(Hosting& hosting) {
    return accessor(
        hosting, [](Hosting& h, Row row) { return h.state(row).angle; },
        [](Hosting& h, Row row, const Value& value) {
            note_written(h, row);
            h.body(row).set_angle(from_value<float>(value));
        });
}

Binding velocity(Hosting& hosting) {
    Binding binding = accessor(
        hosting, [](Hosting& h, Row row) { return widen(h.velocity(row)); },
        [](Hosting& h, Row row, const Value& value) {
            const physics::Vec2 wanted = narrow(value.vec2());
            if (!h.set_velocity(row, wanted) && wanted != physics::Vec2{}) {
                h.set_velocity(row, physics::Vec2{});
                require_movable(h.body(row));
            }
        });
    binding.vec2.plain = true;
    binding.vec2.put = [](const Binding& self, Row row, const property::Vec2& value) {
        // Outside of a world, the velocity is kept until the body is in a world.
        if (world_number(row) == limbo) return property::WriteResult::declined;
        const auto [in, slot] = static_cast<Hosting*>(self.context)->at(row);
        return put(physics::HostAccess::write_velocity(in.world, slot, narrow(value)));
    };
    return binding;
}

Binding angular_velocity(Hosting& hosting) {
    Binding binding = accessor(
        hosting, [](Hosting& h, Row row) { return h.state(row).angular_velocity; },
        [](Hosting& h, Row row, const Value& value) {
            const auto wanted = from_value<float>(value);
            const Body body = h.body(row);
            h.body(row).set_angular_velocity(wanted);
            if (wanted != 0.0f) require_movable(body);
        });
    put_by_slot<physics::BodyNumber::angular_velocity>(binding);
    return binding;
}

/// A number of the library that hosts may write by slot.
template <auto Get, auto Set, physics::BodyNumber number>
Binding by_slot(Hosting& hosting) {
    Binding binding = bound<Get, Set>(hosting);
    put_by_slot<number>(binding);
    return binding;
}

Binding type(Hosting& hosting) {
    return accessor(
        hosting,
        [](Hosting& h, Row row) {
            return h.type_names[static_cast<std::size_t>(h.body(row).type())];
        },
        [](Hosting& h, Row row, const Value& value) {
            for (std::size_t i = 0; i < h.type_names.size(); ++i)
                if (h.type_names[i].text() == value.text())
                    h.body(row).set_type(static_cast<physics::BodyType>(i));
        });
}

/// A body that cannot move, or is disabled, is never awake, although no edit put it to sleep. So
/// its `awake` does not count as overridden.
Binding awake(Hosting& hosting) {
    Binding binding = bound<&Body::awake, &Body::set_awake>(hosting);
    binding.overridden = [](void* context, Row row) {
        const Body body = static_cast<Hosting*>(context)->body(row);
        return !body.awake() && body.enabled() && !immovable(body);
    };
    return binding;
}

Value contact_force(Hosting& hosting, Row row) {
    float sum = 0.0f;
    for (const physics::Contact& contact : hosting.body(row).contacts())
        sum += contact.normal_force;
    return to_value(sum);
}

Binding color(Hosting& hosting) {
    return accessor(
        hosting,
        [](Hosting& h, Row row) {
            const auto color = h.hosted(row).body_colors.get(slot_of(row));
            return color ? Value(*color) : Value();
        },
        [](Hosting& h, Row row, const Value& value) {
            std::optional<property::Color> color;
            if (!value.is_nil()) color = value.color();
            h.hosted(row).body_colors.set(slot_of(row), color);
        });
}

std::vector<Property> motion(Hosting& hosting) {
    return {
        {.name = "type",
         .type = Type::text,
         .default_value = "dynamic",
         .doc = "How it moves. \"static\": not at all; \"kinematic\": with its velocity, and no "
                "force changes that; \"dynamic\": by forces, contacts and joints.",
         .binding = type(hosting),
         .enumerators = {"static", "kinematic", "dynamic"}},
        simulated(within(coordinates,
                         vector("position", {0, 0}, "m",
                                "Position of its origin in the world. A write moves it at once.",
                                position(hosting)))),
        simulated(within(
            turns, number("angle", 0, "rad",
                          "Angle by which it is turned, counter-clockwise; not wrapped after a "
                          "full turn.",
                          body_angle(hosting)))),
        simulated(vector("velocity", {0, 0}, "m/s",
                         "Velocity of its `center`. A step limits it to 10000 m/s.",
                         velocity(hosting))),
        simulated(number(
            "angular_velocity", 0, "rad/s",
            "Angular velocity, counter-clockwise, about its `center`. A step limits it to 3 rad "
            "in each of its parts (`World.substeps`): 720 rad/s with the defaults.",
            angular_velocity(hosting))),
    };
}

/// Reads the mass without the checks of the library's getter, because scripts read it often.
Binding mass(Hosting& hosting) {
    Binding binding = overridable<&Body::mass, &Body::set_mass, &Body::mass_override>(hosting);
    binding.number.get = [](const Binding& self, Row row) -> double {
        auto& h = *static_cast<Hosting*>(self.context);
        const auto [in, slot] = h.at(row);
        return static_cast<double>(physics::HostAccess::mass(in.world, slot));
    };
    return binding;
}

// These properties are marked as simulated, because an edit of a shape changes them without a
// report of the change.
std::vector<Property> weight(Hosting& hosting) {
    const std::vector<std::string> sources = {
        "type",       "*.density",  "*.radius", "*.center", "*.width",    "*.height",  "*.angle",
        "*.rounding", "*.vertices", "*.from",   "*.to",     "*.radius_x", "*.radius_y"};
    std::vector<std::string> of_inertia = sources;
    of_inertia.insert(of_inertia.end(), {"mass", "center"});
    return {
        {.name = "mass",
         .default_value = 1.0,
         .unit = "kg",
         .range = inertial,
         .doc = "Mass: area times density of its shapes, unless it is set; nil computes it "
                "again. With infinite mass, or 1e18 kg and more, nothing moves it, not even "
                "gravity. A "
                "dynamic body without shapes, or of lines alone, has 1 kg.",
         .binding = mass(hosting),
         .simulated = true,
         .infinity = true,
         .derives_from = sources,
         .single_precision = true},
        {.name = "inertia",
         .unit = "kg m\xC2\xB2",
         .range = inertial,
         .doc = "Rotational inertia about the center of mass, computed from the shapes unless it "
                "is set; nil computes it again. Segments without rounding have no area: a dynamic "
                "body of nothing else has its mass along them, like a wire. With infinite inertia, "
                "or more than 1e18, nothing turns it.",
         .binding =
             overridable<&Body::inertia, &Body::set_inertia, &Body::inertia_override>(hosting),
         .simulated = true,
         .infinity = true,
         .derives_from = of_inertia,
         .single_precision = true},
        {.name = "center",
         .type = Type::vec2,
         .unit = "m",
         .range = coordinates,
         .doc = "Center of mass in the coordinates of the body, computed from the shapes unless "
                "it is set; nil computes it again. A kinematic body turns about its `position`, "
                "as a door about its hinge: its center is (0, 0) unless it is set.",
         .binding = overridable<&Body::center, &Body::set_center, &Body::center_override>(hosting),
         .simulated = true,
         .derives_from = sources,
         .single_precision = true},
    };
}

std::vector<Property> forces(Hosting& hosting) {
    return {
        vector("force", {0, 0}, "N",
               "Force on its center of mass in every step until it is changed.",
               bound<&Body::force, &Body::set_force>(hosting)),
        number("torque", 0, "N m", "Torque in every step until it is changed.",
               by_slot<&Body::torque, &Body::set_torque, physics::BodyNumber::torque>(hosting)),
        number("gravity_scale", 1.0, "",
               "Factor of the world's gravity for this body: 0 floats, -1 falls upwards.",
               by_slot<&Body::gravity_scale, &Body::set_gravity_scale,
                       physics::BodyNumber::gravity_scale>(hosting)),
        amount("linear_damping", 0, "1/s",
               "Share of its velocity that it loses in a second, for small values.",
               by_slot<&Body::linear_damping, &Body::set_linear_damping,
                       physics::BodyNumber::linear_damping>(hosting)),
        amount("angular_damping", 0, "1/s",
               "Share of its angular velocity that it loses in a second, for small values.",
               by_slot<&Body::angular_damping, &Body::set_angular_damping,
                       physics::BodyNumber::angular_damping>(hosting)),
    };
}

Property sleep_speed(Hosting& hosting) {
    Property property =
        amount("sleep_speed", physics::WorldDef().sleep_speed, "m/s",
               "Speed below which it counts as at rest. Unless it is set, that of the world; nil "
               "uses that of the world again.",
               overridable<&Body::sleep_speed, &Body::set_sleep_speed, &Body::sleep_speed_override>(
                   hosting));
    property.simulated = true;  // an edit of the world changes it
    return property;
}

Property max_speed(Hosting& hosting) {
    Property property = limit_number("max_speed", std::numeric_limits<double>::infinity(), "m/s",
                                     "Limit of the speed. World.substeps says how often it is "
                                     "applied in a step.",
                                     bound<&Body::max_speed, &Body::set_max_speed>(hosting));
    property.range = inertial;
    return property;
}

std::vector<Property> switches(Hosting& hosting) {
    return {
        simulated(
            flag("awake", true,
                 "True if it takes part in the step. A body that rests for a while falls asleep, "
                 "together with all bodies that it touches, until one of them is disturbed.",
                 awake(hosting))),
        flag("can_sleep", true, "True if it may fall asleep.",
             bound<&Body::can_sleep, &Body::set_can_sleep>(hosting)),
        flag("enabled", true,
             "False if it takes no part in the world: it does not move, nothing collides with it, "
             "no query finds it, and its joints do not act. It is drawn, and keeps its velocity.",
             bound<&Body::enabled, &Body::set_enabled>(hosting)),
        sleep_speed(hosting),
        max_speed(hosting),
        flag("bullet", false, "True if it cannot pass through other moving bodies at any speed.",
             bound<&Body::bullet, &Body::set_bullet>(hosting)),
        flag("locked_x", false, "True if it cannot move along x.",
             bound<&Body::locked_x, &Body::set_locked_x>(hosting)),
        flag("locked_y", false, "True if it cannot move along y.",
             bound<&Body::locked_y, &Body::set_locked_y>(hosting)),
        flag("locked_rotation", false, "True if it cannot turn.",
             bound<&Body::locked_rotation, &Body::set_locked_rotation>(hosting)),
        {.name = "color",
         .type = Type::color,
         .doc = "Color of its shapes that have no own color; nil: a color for the type of the "
                "body.",
         .binding = color(hosting),
         .nullable = true},
        figure("contact_force", "N", "Sum of the forces of its contacts.",
               accessor(hosting, [](Hosting& h, Row row) { return contact_force(h, row); })),
    };
}

}  // namespace

void define_body(Hosting& hosting) {
    property::ClassDescriptor body;
    body.snapshots = property::Snapshots::natively;
    body.name = "Body";
    body.weight = 250;
    body.doc =
        "A rigid body: its shapes are its children. It is simulated while it is below a World.";
    for (const auto& group : {motion(hosting), weight(hosting), forces(hosting), switches(hosting),
                              touch_properties(hosting)})
        body.properties.insert(body.properties.end(), group.begin(), group.end());
    body.methods = body_methods(hosting);
    body.events = contact_events("body");
    body.events.push_back({.name = "woke", .doc = "Its sleep was disturbed."});
    body.events.push_back({.name = "slept", .doc = "It rested long enough and fell asleep."});
    body.lifecycle =
        lifecycle_of<&Hosting::create_body, &Hosting::place_body, &Hosting::destroy_body>(hosting);
    body.lifecycle.pose = drawn_pose;
    const property::Class& defined = hosting.tree.define(std::move(body));
    hosting.classes.body = &defined;
    hosting.declared.woke = defined.event("woke");
    hosting.declared.slept = defined.event("slept");
    hosting.register_pair_events(defined, &PairEvent::of_body);
    explain_bodies(hosting, defined);
}

}  // namespace fettle::physics_module
