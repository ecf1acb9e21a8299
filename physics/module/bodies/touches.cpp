#include <bodies/touches.h>

#include <algorithm>

#include <bindings/bindings.h>

namespace fettle::physics_module {
namespace {

using property::Field;
using property::List;

/// Two touching shapes, as seen from one of the bodies.
struct Touch {
    physics::BodyId other;
    physics::ShapeId shape, other_shape;
    physics::Vec2 point = {};
    physics::Vec2 normal = {};               // to the other shape
    float impulse = 0, tangent_impulse = 0;  // N s, of the last step
    float friction = 0, restitution = 0;
};

Touch touch_of(const physics::Contact& contact, const physics::Body& self, float substeps) {
    const bool first = contact.body_a == self.id();
    Touch touch{.other = first ? contact.body_b : contact.body_a,
                .shape = first ? contact.shape_a : contact.shape_b,
                .other_shape = first ? contact.shape_b : contact.shape_a};
    for (int k = 0; k < contact.point_count; ++k) {
        const physics::ContactPoint& p = contact.points[static_cast<std::size_t>(k)];
        touch.point += p.point / static_cast<float>(contact.point_count);
        touch.impulse += p.normal_impulse * substeps;
        touch.tangent_impulse += p.tangent_impulse * substeps;
    }
    touch.normal = first ? contact.normal : physics::Vec2(-contact.normal);
    touch.friction = contact.friction;
    touch.restitution = contact.restitution;
    return touch;
}

/// Adds a contact. Several contacts between the pieces of two shapes (chains, concave polygons) are
/// one touch: its point is the mean of theirs, weighted by the impulses, and its normal is that of
/// the largest impulse.
void add(std::vector<Touch>& touches, const Touch& touch) {
    const auto same = std::ranges::find_if(touches, [&](const Touch& other) {
        return other.shape == touch.shape && other.other_shape == touch.other_shape;
    });
    if (same == touches.end()) {
        touches.push_back(touch);
        return;
    }
    const float sum = same->impulse + touch.impulse;
    const float share = sum > 0 ? touch.impulse / sum : 0.5f;
    if (touch.impulse > same->impulse) same->normal = touch.normal;
    same->point += share * (touch.point - same->point);
    same->impulse = sum;
    same->tangent_impulse += touch.tangent_impulse;
}

std::vector<Touch> touches_of(Hosting& hosting, Row row) {
    const physics::Body self = hosting.body(row);
    const physics::World& world = hosting.world(row);
    std::vector<Touch> touches;
    for (const physics::Contact& contact : self.contacts()) {
        // A contact of sleeping bodies has the impulses of the step in which they fell asleep.
        const bool of_last_step =
            world.body(contact.body_a).awake() || world.body(contact.body_b).awake();
        const int substeps = of_last_step ? world.last_substeps() : world.substeps();
        add(touches, touch_of(contact, self, static_cast<float>(substeps)));
    }
    return touches;
}

Handle body_of(Hosting& hosting, Row row, const Touch& touch) {
    const Handle body = unpack(hosting.world(row).body(touch.other).user_data());
    return body ? body : hosting.hosted(row).self;
}

Handle shape_of(Hosting& hosting, Row row, physics::ShapeId shape) {
    return unpack(hosting.world(row).shape(shape).user_data());
}

const std::vector<Field> touch_fields = {
    {"other", Type::reference, "", "The other body; the world itself for its bounds."},
    {"shape", Type::reference, "", "The shape of this body; nil for the capsule of a mover."},
    {"other_shape", Type::reference, "",
     "The shape of the other; nil for the bounds and the capsule of a mover."},
    {"point", Type::vec2, "m", "Point of the contact in the world."},
    {"normal", Type::vec2, "", "Direction from this body to the other."},
    {"impulse", Type::number, "N s", "Impulse that separated them in the last step."},
    {"tangent_impulse", Type::number, "N s", "Impulse of friction, clockwise around this body."},
    {"friction", Type::number, "", "Coefficient mixed from both surfaces."},
    {"restitution", Type::number, "", "Mixed from both surfaces."},
};

property::Result touches(void* context, property::Tree&, Handle, Row row, std::span<const Value>) {
    Hosting& hosting = *static_cast<Hosting*>(context);
    std::vector<property::Record> records;
    for (const Touch& touch : touches_of(hosting, row)) {
        records.push_back(
            {&touch_fields,
             {body_of(hosting, row, touch), shape_of(hosting, row, touch.shape),
              shape_of(hosting, row, touch.other_shape), to_value(touch.point),
              to_value(touch.normal), to_value(touch.impulse), to_value(touch.tangent_impulse),
              to_value(touch.friction), to_value(touch.restitution)}});
    }
    return records;
}

Value touching_bodies(Hosting& hosting, Row row) {
    List others;
    for (const Touch& touch : touches_of(hosting, row)) {
        const Value value(body_of(hosting, row, touch));
        if (std::find(others.begin(), others.end(), value) == others.end()) others.push_back(value);
    }
    return others;
}

/// Read-only lists with one entry for each touch, in the order of `touches`.
template <class Pick>
property::Property listed(Hosting& hosting, std::string name, Type element, std::string unit,
                          std::string doc, Pick) {
    return {.name = std::move(name),
            .type = Type::list,
            .unit = std::move(unit),
            .doc = std::move(doc),
            .binding = accessor(hosting,
                                [](Hosting& h, Row row) -> Value {
                                    List list;
                                    for (const Touch& touch : touches_of(h, row))
                                        list.push_back(Pick{}(h, row, touch));
                                    return list;
                                }),
            .read_only = true,
            .transient = true,
            .simulated = true,
            .element = element,
            .single_precision = element == Type::number || element == Type::vec2};
}

}  // namespace

std::vector<property::Property> touch_properties(Hosting& hosting) {
    return {
        {.name = "contacts",
         .type = Type::list,
         .doc = "The bodies that it touches now; the world itself if it touches the bounds. "
                "Sensors do not count.",
         .binding = accessor(hosting, [](Hosting& h, Row row) { return touching_bodies(h, row); }),
         .read_only = true,
         .transient = true,
         .simulated = true,
         .element = Type::reference},
        listed(hosting, "contact_shapes", Type::reference, "",
               "The shapes that it touches now, one for each touch; the world itself for its "
               "bounds. `contact_points`, `contact_normals` and `contact_impulses` have as many "
               "entries, in the same order.",
               [](Hosting& h, Row row, const Touch& t) -> Value {
                   const Handle shape = shape_of(h, row, t.other_shape);
                   return shape ? shape : h.hosted(row).self;
               }),
        listed(hosting, "contact_points", Type::vec2, "m", "Points of the contacts in the world.",
               [](Hosting&, Row, const Touch& t) { return to_value(t.point); }),
        listed(hosting, "contact_normals", Type::vec2, "",
               "Directions from this body to the touched one; of length 1.",
               [](Hosting&, Row, const Touch& t) { return to_value(t.normal); }),
        listed(hosting, "contact_impulses", Type::number, "N s",
               "Impulses that separated the two in the last step.",
               [](Hosting&, Row, const Touch& t) { return to_value(t.impulse); }),
    };
}

property::Method touches_method(Hosting& hosting) {
    return {.name = "touches",
            .returns = touch_fields,
            .many = true,
            .doc =
                "The touches of `contacts` with points and impulses: one record for each pair "
                "of shapes.",
            .context = &hosting,
            .call = touches,
            .effect = property::Effect::nothing};
}

}  // namespace fettle::physics_module
