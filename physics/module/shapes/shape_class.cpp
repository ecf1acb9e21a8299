// Shape, which has the common members of all shapes.

#include <algorithm>
#include <limits>

#include <bindings/bindings.h>
#include <drawing/drawing.h>
#include <events/events.h>
#include <shapes/shape_classes.h>

namespace fettle::physics_module {
namespace {

using physics::Shape;

Value world_vertices(Hosting& hosting, Row row) {
    property::List corners;
    for (const physics::Vec2& v : hosting.shape(row).world_vertices()) corners.push_back(widen(v));
    return corners;
}

Look look_of(Hosting& hosting, Row row) {
    return hosting.hosted(row).looks.get(slot_of(row));
}
void set_look(Hosting& hosting, Row row, const Look& look) {
    hosting.hosted(row).looks.set(slot_of(row), look);
}

template <bool Look::*Flag>
Binding look_flag(Hosting& hosting) {
    return accessor(
        hosting, [](Hosting& h, Row row) { return look_of(h, row).*Flag; },
        [](Hosting& h, Row row, const Value& value) {
            Look look = look_of(h, row);
            look.*Flag = value.boolean();
            set_look(h, row, look);
        });
}

/// A color that is computed unless it is set.
template <std::optional<property::Color> Look::*Given, property::Color (Hosting::*Effective)(Row)>
Binding paint(Hosting& hosting) {
    Binding binding = accessor(
        hosting, [](Hosting& h, Row row) { return (h.*Effective)(row); },
        [](Hosting& h, Row row, const Value& value) {
            Look look = look_of(h, row);
            look.*Given = value.color();
            set_look(h, row, look);
        });
    binding.reset = [](void* context, Row row) {
        auto& h = *static_cast<Hosting*>(context);
        Look look = look_of(h, row);
        if (!(look.*Given)) return;
        look.*Given = std::nullopt;
        set_look(h, row, look);
    };
    binding.overridden = [](void* context, Row row) {
        return (look_of(*static_cast<Hosting*>(context), row).*Given).has_value();
    };
    return binding;
}

std::vector<Property> surface(Hosting& hosting) {
    const physics::ShapeDef defaults;
    return {
        amount("density", defaults.density, "kg/m\xC2\xB2", "Mass per area.",
               bound<&Shape::density, &Shape::set_density>(hosting)),
        amount("friction", defaults.friction, "",
               "Coulomb coefficient: 0 is like ice, 1 like rubber. Two shapes in contact use the "
               "geometric mean of their coefficients, or the world's friction_mix.",
               bound<&Shape::friction, &Shape::set_friction>(hosting)),
        within(fraction,
               number("restitution", defaults.restitution, "",
                      "Share of the speed of approach with which shapes separate. Two shapes in "
                      "contact use the greater of their values, or the world's restitution_mix.",
                      bound<&Shape::restitution, &Shape::set_restitution>(hosting))),
        amount("rolling_resistance", defaults.rolling_resistance, "",
               "Resistance to rolling: the lever of the resisting torque as a share of the "
               "radius, of the other shape if this one has no round side. The radius of an "
               "ellipse is that of a circle of the same area.",
               bound<&Shape::rolling_resistance, &Shape::set_rolling_resistance>(hosting)),
        number("surface_speed", defaults.surface_speed, "m/s",
               "Speed of the surface, as of a conveyor belt, counter-clockwise around the shape.",
               bound<&Shape::surface_speed, &Shape::set_surface_speed>(hosting)),
        {.name = "material",
         .type = Type::integer,
         .default_value = 0,
         .range = {.min = 0, .max = std::numeric_limits<std::uint16_t>::max()},
         .doc = "A number for the game, for example to choose the sound of an impact. It has no "
                "effect on the simulation.",
         .binding = accessor(
             hosting,
             [](Hosting& h, Row row) {
                 return Value(static_cast<std::int64_t>(h.shape(row).material()));
             },
             [](Hosting& h, Row row, const Value& value) {
                 h.shape(row).set_material(static_cast<std::uint16_t>(value.integer()));
             })},
        flag("contact_events", true,
             "True if its touches are reported: contact_begin, contact_persist and contact_end. "
             "Both shapes must agree. It holds from the next touch on: a touch whose begin was "
             "reported is reported to its end.",
             bound<&Shape::contact_events, &Shape::set_contact_events>(hosting)),
        flag("sensor_events", true,
             "True if sensor_begin and sensor_end about it are reported, from the next touch on. "
             "Both shapes must agree.",
             bound<&Shape::sensor_events, &Shape::set_sensor_events>(hosting)),
        flag("sensor", defaults.sensor,
             "True if it reports overlapping shapes and does not push them. It is drawn faint, so "
             "that what is in it can be seen, unless it has a color of its own.",
             bound<&Shape::sensor, &Shape::set_sensor>(hosting)),
    };
}

std::vector<Property> filter(Hosting& hosting) {
    return {
        {.name = "category",
         .type = Type::integer,
         .default_value = 1,
         .doc = "Its categories, as bits. Two shapes collide if each one's mask has a bit of the "
                "other's category.",
         .binding = bound<&Shape::category, &Shape::set_category>(hosting),
         .bits = true},
        {.name = "mask",
         .type = Type::integer,
         .default_value = -1,
         .doc = "Categories with which it collides, as bits; -1 is all.",
         .binding = bound<&Shape::mask, &Shape::set_mask>(hosting),
         .bits = true},
        {.name = "group",
         .type = Type::integer,
         .range = {.min = std::numeric_limits<std::int32_t>::min(),
                   .max = std::numeric_limits<std::int32_t>::max()},
         .doc = "Shapes with an equal group other than 0 always collide (above 0) or never "
                "collide (below 0), whatever their masks are.",
         .binding = bound<&Shape::group, &Shape::set_group>(hosting)},
    };
}

std::vector<Property> looks(Hosting& hosting) {
    const property::Color fill = default_fill(physics::BodyType::dynamic_body);
    return {
        {.name = "color",
         .type = Type::color,
         .default_value = fill,
         .doc = "Color of the fill. Unless it is set, the color of the body, or a color for the "
                "type of the body.",
         .binding = paint<&Look::fill, &Hosting::fill_of>(hosting)},
        {.name = "border",
         .type = Type::color,
         .default_value = default_border(fill),
         .doc = "Color of its outline; a darker fill color unless it is set.",
         .binding = paint<&Look::border, &Hosting::border_of>(hosting)},
        flag("visible", true, "True if it is drawn; it collides in any case.",
             look_flag<&Look::visible>(hosting)),
    };
}

std::vector<Property> derived(Hosting& hosting) {
    const std::vector<std::string> form = {"radius",   "center",   "width",    "height", "angle",
                                           "from",     "rounding", "vertices", "to",     "radius_x",
                                           "radius_y", "points",   "closed"};
    std::vector<std::string> placed = form;
    placed.insert(placed.end(), {"parent.position", "parent.angle"});
    return {
        {.name = "area",
         .unit = "m\xC2\xB2",
         .doc = "Area of the shape, rounding included.",
         .binding = read_only<&Shape::area>(hosting),
         .read_only = true,
         .transient = true,
         .derives_from = form,
         .single_precision = true},
        {.name = "aabb",
         .type = Type::list,
         .unit = "m",
         .doc = "Lower left and upper right corner of its bounding box in the world.",
         .binding = read_only<&Shape::aabb>(hosting),
         .read_only = true,
         .transient = true,
         .simulated = true,
         .element = Type::vec2,
         .derives_from = placed,
         .single_precision = true},
        {.name = "world_vertices",
         .type = Type::list,
         .unit = "m",
         .doc = "Its corners or points in the world, without rounding; a circle or an ellipse "
                "has none.",
         .binding = accessor(hosting, [](Hosting& h, Row row) { return world_vertices(h, row); }),
         .read_only = true,
         .transient = true,
         .simulated = true,
         .element = Type::vec2,
         .derives_from = placed,
         .single_precision = true},
    };
}

}  // namespace

Property orientation_mark(Hosting& hosting) {
    return flag("orientation_mark", false,
                "True if a line from its middle to its rim is drawn, which shows how it is turned.",
                look_flag<&Look::orientation_mark>(hosting));
}

void define_shape(Hosting& hosting) {
    property::ClassDescriptor shape;
    shape.snapshots = property::Snapshots::natively;
    shape.name = "Shape";
    shape.weight = 350;
    shape.doc = "A part of a body with an outline, a density and a surface.";
    shape.creatable = false;
    for (const auto& group : {surface(hosting), filter(hosting), looks(hosting), derived(hosting)})
        shape.properties.insert(shape.properties.end(), group.begin(), group.end());
    shape.events = contact_events("shape");
    shape.lifecycle = shape_lifecycle(hosting.kinds.front());
    const property::Class& defined = hosting.tree.define(std::move(shape));
    hosting.classes.shape = &defined;
    hosting.classes.abstract.push_back(&defined);
    hosting.register_pair_events(defined, &PairEvent::of_shape);
}

property::Lifecycle shape_lifecycle(ShapeKind& kind) {
    property::Lifecycle lifecycle;
    lifecycle.context = &kind;
    lifecycle.create = [](void* context, property::Tree&, Handle self) {
        const auto& made = *static_cast<ShapeKind*>(context);
        return made.hosting->create_shape(self, made.geometry);
    };
    lifecycle.place = [](void* context, property::Tree&, Handle self, Row row) {
        return static_cast<ShapeKind*>(context)->hosting->place_shape(self, row);
    };
    lifecycle.destroy = [](void* context, property::Tree&, Handle, Row row) {
        static_cast<ShapeKind*>(context)->hosting->destroy_shape(row);
    };
    lifecycle.draw = draw_shape;
    return lifecycle;
}

}  // namespace fettle::physics_module
