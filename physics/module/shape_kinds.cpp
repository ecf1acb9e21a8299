// Circle, Box, Segment, Capsule, Polygon: the geometries a shape can have.

#include "bindings.h"
#include "classes.h"

namespace fettle::physics_module {
namespace {

using physics::Shape;

constexpr Range size{.min = 1e-5, .max = 1e6};
constexpr Range thickness{.min = 0.0, .max = 1e6};

Property length(std::string name, double default_value, Range range, std::string doc,
                Binding binding) {
    return {.name = std::move(name),
            .default_value = default_value,
            .unit = "m",
            .range = range,
            .doc = std::move(doc),
            .binding = binding,
            .single_precision = true};
}

Property point(std::string name, const physics::Vec2& default_value, std::string doc,
               Binding binding) {
    return {.name = std::move(name),
            .type = Type::vec2,
            .default_value = widen(default_value),
            .unit = "m",
            .doc = std::move(doc),
            .binding = binding,
            .single_precision = true};
}

Property rounding(Hosting& hosting, std::string doc) {
    return length("rounding", 0.0, thickness, std::move(doc),
                  bound<&Shape::rounding, &Shape::set_rounding>(hosting));
}

template <class Points>
Value list_of(const Points& points) {
    property::List list;
    for (const physics::Vec2& v : points) list.push_back(widen(v));
    return list;
}

Property vertices(Hosting& hosting) {
    const auto get = [](Hosting& h, Row row) { return list_of(h.shape(row).vertices()); };
    const auto set = [](Hosting& h, Row row, const Value& value) {
        std::vector<physics::Vec2> points;
        for (const Value& v : value.list()) points.push_back(narrow(v.vec2()));
        h.shape(row).set_vertices(points);
    };
    return {
        .name = "vertices",
        .type = Type::list,
        .default_value = list_of(std::get<physics::Polygon>(hosting.kinds[4].geometry).vertices),
        .unit = "m",
        .doc =
            "Its corners in the body's coordinates, counter-clockwise. What is written is "
            "made convex: the hull of the points becomes the shape.",
        .binding = accessor(hosting, get, set),
        .element = Type::vec2,
        .single_precision = true};
}

property::Method add_vertex(Hosting& hosting) {
    property::Method method{
        .name = "add_vertex",
        .parameters = {{.name = "point",
                        .type = Type::vec2,
                        .unit = "m",
                        .doc = "In the body's coordinates."}},
        .required = 1,
        .doc = "Makes the polygon reach as far as that point; one inside changes nothing."};
    method.context = &hosting;
    method.effect = property::Effect::tree;
    method.call = [](void*, property::Tree& tree, Handle self, Row,
                     std::span<const Value> arguments) -> property::Result {
        const Property& corners = tree.property(self, "vertices");
        property::List points = tree.get(self, corners).list();
        points.push_back(arguments[0]);
        tree.set(self, corners, Value(std::move(points)));
        return Value();
    };
    return method;
}

void define(Hosting& hosting, std::size_t kind, std::string name, std::string doc,
            std::vector<Property> properties, std::vector<property::Method> methods = {}) {
    property::ClassDescriptor described;
    described.name = std::move(name);
    described.base = "Shape";
    described.doc = std::move(doc);
    described.properties = std::move(properties);
    described.methods = std::move(methods);
    described.lifecycle = shape_lifecycle(hosting.kinds[kind]);
    hosting.tree.define(std::move(described));
}

std::vector<Property> ends(Hosting& hosting, const physics::Segment& defaults) {
    return {point("from", defaults.from, "One end, in the body's coordinates.",
                  bound<&Shape::from, &Shape::set_from>(hosting)),
            point("to", defaults.to, "The other end, in the body's coordinates.",
                  bound<&Shape::to, &Shape::set_to>(hosting))};
}

}  // namespace

void define_shapes(Hosting& hosting) {
    define_shape(hosting);
    const physics::Circle circle;
    const physics::Box box;
    const Property center = point("center", {0.0f, 0.0f}, "Its middle, in the body's coordinates.",
                                  bound<&Shape::center, &Shape::set_center>(hosting));
    define(hosting, 0, "Circle", "A disc.",
           {length("radius", circle.radius, size, "From its center to its rim.",
                   bound<&Shape::radius, &Shape::set_radius>(hosting)),
            center});
    define(hosting, 1, "Box", "A rectangle.",
           {length("width", box.width, size, "From its left to its right side, rounding included.",
                   bound<&Shape::width, &Shape::set_width>(hosting)),
            length("height", box.height, size, "From bottom to top, rounding included.",
                   bound<&Shape::height, &Shape::set_height>(hosting)),
            center,
            {.name = "angle",
             .unit = "rad",
             .doc = "How far it is turned on its body, counter-clockwise.",
             .binding = bound<&Shape::angle, &Shape::set_angle>(hosting),
             .single_precision = true},
            rounding(hosting, "Radius of its corners, at most half the smaller side.")});
    define(hosting, 2, "Segment", "A straight line without thickness; it weighs nothing.",
           ends(hosting, std::get<physics::Segment>(hosting.kinds[2].geometry)));
    const auto& capsule = std::get<physics::Segment>(hosting.kinds[3].geometry);
    std::vector<Property> rounded = ends(hosting, capsule);
    rounded.push_back(length("radius", capsule.rounding, size, "Around the line between its ends.",
                             bound<&Shape::rounding, &Shape::set_rounding>(hosting)));
    define(hosting, 3, "Capsule", "A straight line with round ends and a thickness.",
           std::move(rounded));
    define(hosting, 4, "Polygon", "A convex polygon.",
           {vertices(hosting), rounding(hosting, "Radius that is added all round it.")},
           {add_vertex(hosting)});
}

}  // namespace fettle::physics_module
