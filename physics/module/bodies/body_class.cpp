// Body: the class of bodies of the physics library.

#include <cmath>
#include <stdexcept>

#include <bindings/bindings.h>
#include <bodies/body_class.h>
#include <bodies/touches.h>
#include <events/events.h>

namespace fettle::physics_module {
namespace {

using physics::Body;

bool immovable(const Body& body) {
    return body.type() == physics::BodyType::static_body ||
           (body.type() == physics::BodyType::dynamic_body && std::isinf(body.mass()));
}

/// A body that does not move by itself stays at rest in the library; refuses an edit that would
/// have no effect.
void require_movable(const Body& body) {
    if (!immovable(body)) return;
    throw std::invalid_argument(body.type() == physics::BodyType::static_body
                                    ? "a static body does not move: make it kinematic or dynamic"
                                    : "a body of infinite mass does not move");
}

// Data that the step writes are read directly from the library's array.

Binding position(Hosting& hosting) {
    return accessor(
        hosting,
        [](Hosting& h, Row row) {
            const physics::Vec2& p = h.state(row).position;
            return widen(p.x(), p.y());
        },
        [](Hosting& h, Row row, const Value& value) {
            h.body(row).set_position(narrow(value.vec2()));
        });
}

Binding body_angle(Hosting& hosting) {
    return accessor(
        hosting, [](Hosting& h, Row row) { return h.state(row).angle; },
        [](Hosting& h, Row row, const Value& value) {
            h.body(row).set_angle(from_value<float>(value));
        });
}

Binding velocity(Hosting& hosting) {
    Binding binding = accessor(
        hosting, [](Hosting& h, Row row) { return widen(h.velocity(row)); },
        [](Hosting& h, Row row, const Value& value) {
            const physics::Vec2 wanted = narrow(value.vec2());
            if (!h.set_velocity(row, wanted) && wanted != physics::Vec2::Zero()) {
                h.set_velocity(row, physics::Vec2::Zero());
                require_movable(h.body(row));
            }
        });
    binding.vec2.plain = true;
    binding.vec2.put = [](const Binding& self, Row row, const property::Vec2& value) {
        // Outside of a world, the velocity is kept until the body is in a world.
        if (world_number(row) == limbo) return property::Put::declined;
        const auto [in, slot] = static_cast<Hosting*>(self.context)->at(row);
        return put(in.world.write_velocity(slot, narrow(value)));
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

/// A body that cannot move is never awake, although it was never put to sleep.
Binding awake(Hosting& hosting) {
    Binding binding = bound<&Body::awake, &Body::set_awake>(hosting);
    binding.overridden = [](void* context, Row row) {
        const Body body = static_cast<Hosting*>(context)->body(row);
        return !body.awake() && !immovable(body);
    };
    return binding;
}

Value pressed(Hosting& hosting, Row row) {
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
         .doc =
             "What moves it. \"static\": nothing; \"kinematic\": its velocity, and nothing pushes "
             "it; \"dynamic\": forces, contacts and joints.",
         .binding = type(hosting),
         .enumerators = {"static", "kinematic", "dynamic"}},
        simulated(within(
            coordinates,
            vector("position", {0, 0}, "m",
                   "Where its origin is in the world. Writing it teleports.", position(hosting)))),
        simulated(within(
            turns, number("angle", 0, "rad",
                          "How far it is turned, counter-clockwise; not wrapped after a full turn.",
                          body_angle(hosting)))),
        simulated(vector("velocity", {0, 0}, "m/s",
                         "Of its center of mass. A step limits it to 10000 m/s.",
                         velocity(hosting))),
        simulated(
            number("angular_velocity", 0, "rad/s",
                   "How fast it turns, counter-clockwise. A step limits it to 3 rad in each of its "
                   "parts (`World.substeps`): 720 rad/s with the defaults.",
                   angular_velocity(hosting))),
    };
}

/// The library's getter without its checks: scripts read the mass often.
Binding mass(Hosting& hosting) {
    Binding binding = overridable<&Body::mass, &Body::set_mass, &Body::mass_override>(hosting);
    binding.number.get = [](const Binding& self, Row row) -> double {
        auto& h = *static_cast<Hosting*>(self.context);
        const auto [in, slot] = h.at(row);
        return static_cast<double>(in.world.mass(slot));
    };
    return binding;
}

// Marked as simulated, because an edit of a shape changes them without a change report.
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
         .doc = "Area times density of its shapes, unless a mass is given; nil computes it again. "
                "Infinite: nothing moves it. A dynamic body without shapes weighs 1 kg.",
         .binding = mass(hosting),
         .simulated = true,
         .infinity = true,
         .derives_from = sources,
         .single_precision = true},
        {.name = "inertia",
         .unit = "kg m\xC2\xB2",
         .range = inertial,
         .doc = "Rotational inertia about the center of mass, from the shapes unless one is given; "
                "nil computes it again. Infinite: nothing turns it.",
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
         .doc = "Center of mass in its own coordinates, from the shapes unless one is given; nil "
                "computes it again.",
         .binding = overridable<&Body::center, &Body::set_center, &Body::center_override>(hosting),
         .simulated = true,
         .derives_from = sources,
         .single_precision = true},
    };
}

std::vector<Property> forces(Hosting& hosting) {
    return {
        vector("force", {0, 0}, "N", "Pushes its center of mass in every step until it is changed.",
               bound<&Body::force, &Body::set_force>(hosting)),
        number("torque", 0, "N m", "Turns it in every step until it is changed.",
               by_slot<&Body::torque, &Body::set_torque, physics::BodyNumber::torque>(hosting)),
        number("gravity_scale", 1.0, "",
               "How much of the world's gravity it feels: 0 floats, -1 falls upwards.",
               by_slot<&Body::gravity_scale, &Body::set_gravity_scale,
                       physics::BodyNumber::gravity_scale>(hosting)),
        amount("linear_damping", 0, "1/s",
               "Share of its velocity it loses in a second, for small values.",
               by_slot<&Body::linear_damping, &Body::set_linear_damping,
                       physics::BodyNumber::linear_damping>(hosting)),
        amount("angular_damping", 0, "1/s",
               "Share of its angular velocity it loses in a second, for small values.",
               by_slot<&Body::angular_damping, &Body::set_angular_damping,
                       physics::BodyNumber::angular_damping>(hosting)),
    };
}

std::vector<Property> switches(Hosting& hosting) {
    return {
        simulated(
            flag("awake", true,
                 "Whether it takes part in the step. What rests for a while sleeps, together with "
                 "what it touches, until something disturbs it.",
                 awake(hosting))),
        flag("can_sleep", true, "Whether it may fall asleep.",
             bound<&Body::can_sleep, &Body::set_can_sleep>(hosting)),
        flag("bullet", false, "However fast, it does not pass through other moving bodies either.",
             bound<&Body::bullet, &Body::set_bullet>(hosting)),
        flag("locked_x", false, "Nothing moves it along x.",
             bound<&Body::locked_x, &Body::set_locked_x>(hosting)),
        flag("locked_y", false, "Nothing moves it along y.",
             bound<&Body::locked_y, &Body::set_locked_y>(hosting)),
        flag("locked_rotation", false, "Nothing turns it.",
             bound<&Body::locked_rotation, &Body::set_locked_rotation>(hosting)),
        {.name = "color",
         .type = Type::color,
         .doc = "Fills its shapes that have no color of their own; nil goes by its type.",
         .binding = color(hosting),
         .nullable = true},
        figure("contact_force", "N", "How hard what it touches presses on it, all together.",
               accessor(hosting, [](Hosting& h, Row row) { return pressed(h, row); })),
    };
}

}  // namespace

void define_body(Hosting& hosting) {
    property::ClassDescriptor body;
    body.snapshots = property::Snapshots::natively;
    body.name = "Body";
    body.doc =
        "A rigid body: its shapes are its children. It is simulated while it hangs below a World.";
    for (const auto& group : {motion(hosting), weight(hosting), forces(hosting), switches(hosting),
                              touch_properties(hosting)})
        body.properties.insert(body.properties.end(), group.begin(), group.end());
    body.methods = body_methods(hosting);
    body.events = contact_events("body");
    body.events.push_back({.name = "woke", .doc = "Something disturbed its sleep."});
    body.events.push_back({.name = "slept", .doc = "It rested long enough and fell asleep."});
    body.lifecycle =
        lifecycle_of<&Hosting::create_body, &Hosting::place_body, &Hosting::destroy_body>(hosting);
    const property::Class& defined = hosting.tree.define(std::move(body));
    hosting.body_class = &defined;
    hosting.woke = defined.event("woke");
    hosting.slept = defined.event("slept");
    hosting.note_pair_events(defined, &PairEvent::of_body);
}

}  // namespace fettle::physics_module
