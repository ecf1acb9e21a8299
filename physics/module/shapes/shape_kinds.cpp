// Circle, Box, Segment, Capsule, Polygon, Ellipse, Concave, Chain: the geometries a shape can have.

#include <bindings/bindings.h>
#include <shapes/shape_classes.h>

namespace fettle::physics_module {
namespace {

using physics::Shape;

constexpr Range size{.min = 1e-5, .max = 1e6};
constexpr Range thickness{.min = 0.0, .max = 1e6};

Property length(std::string name, double default_value, Range range, std::string doc,
                Binding binding) {
    return within(range, number(std::move(name), default_value, "m", std::move(doc), binding));
}

Property point(std::string name, const physics::Vec2& default_value, std::string doc,
               Binding binding) {
    return within(shape_coordinates,
                  vector(std::move(name), widen(default_value), "m", std::move(doc), binding));
}

Property rounding(Hosting& hosting, std::string doc) {
    return length("rounding", 0.0, thickness, std::move(doc),
                  bound<&Shape::rounding, &Shape::set_rounding>(hosting));
}

constexpr std::size_t most_points = std::size_t{1} << 20;

Value list_of(const auto& points) {
    property::List list;
    for (const physics::Vec2& v : points) list.push_back(widen(v));
    return list;
}

/// A list of points that the shape is made of. `weight`: bytes that physics needs for each.
template <std::size_t most>
Property points(Hosting& hosting, std::string name, const std::vector<physics::Vec2>& given,
                std::uint32_t weight, std::string doc) {
    const auto get = [](Hosting& h, Row row) { return list_of(h.shape(row).vertices()); };
    const auto set = [](Hosting& h, Row row, const Value& value) {
        if (value.list().size() > most)
            throw property::Error(property::ErrorKind::out_of_range,
                                  "there are " + std::to_string(value.list().size()) +
                                      " points, and at most " + std::to_string(most) +
                                      " are possible");
        std::vector<physics::Vec2> points;
        for (const Value& v : value.list()) points.push_back(narrow(v.vec2()));
        h.shape(row).set_vertices(points);
    };
    return {.name = std::move(name),
            .type = Type::list,
            .default_value = list_of(given),
            .unit = "m",
            .range = shape_coordinates,
            .doc = std::move(doc),
            .binding = accessor(hosting, get, set),
            .element_weight = weight,
            .element = Type::vec2,
            .single_precision = true};
}

property::Method add_vertex(Hosting& hosting) {
    property::Method method{
        .name = "add_vertex",
        .parameters = {{.name = "point",
                        .type = Type::vec2,
                        .unit = "m",
                        .doc = "A point in the coordinates of the body."}},
        .required = 1,
        .doc = "Extends the polygon to that point; a point inside changes nothing."};
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

Property turned(Hosting& hosting) {
    return within(turns, number("angle", 0, "rad", "Its angle on the body, counter-clockwise.",
                                bound<&Shape::angle, &Shape::set_angle>(hosting)));
}

Property middle(Hosting& hosting) {
    return point("center", {0.0f, 0.0f}, "Its center in the coordinates of the body.",
                 bound<&Shape::center, &Shape::set_center>(hosting));
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
    described.makes_base_rows = true;
    hosting.tree.define(std::move(described));
}

std::vector<Property> ends(Hosting& hosting, const physics::Segment& defaults) {
    return {point("from", defaults.from, "One end in the coordinates of the body.",
                  bound<&Shape::from, &Shape::set_from>(hosting)),
            point("to", defaults.to, "The other end in the coordinates of the body.",
                  bound<&Shape::to, &Shape::set_to>(hosting))};
}

void define_ellipse(Hosting& hosting) {
    const physics::Ellipse ellipse;
    define(hosting, 5, "Ellipse", "An exact ellipse, without corners.",
           {length("radius_x", ellipse.radius_x, size, "Half its width at angle 0.",
                   bound<&Shape::radius_x, &Shape::set_radius_x>(hosting)),
            length("radius_y", ellipse.radius_y, size, "Half its height at angle 0.",
                   bound<&Shape::radius_y, &Shape::set_radius_y>(hosting)),
            middle(hosting), turned(hosting), orientation_mark(hosting)});
}

void define_outlines(Hosting& hosting) {
    define(hosting, 6, "Concave",
           "A polygon that may be concave. It collides in convex pieces, but is one shape.",
           {points<physics::Concave::most_vertices>(
               hosting, "vertices", std::get<physics::Concave>(hosting.kinds[6].geometry).vertices,
               700,
               "Its corners in the coordinates of the body, clockwise or counter-clockwise. An "
               "outline that crosses or touches itself is refused, and so is a hole; at most "
               "16384.")});
    std::vector<Property> chain = {
        points<most_points>(hosting, "points",
                            std::get<physics::Chain>(hosting.kinds[7].geometry).points, 800,
                            "Its points in the coordinates of the body."),
        flag("closed", false,
             "True if the last point is connected to the first; this needs three points.",
             bound<&Shape::closed, &Shape::set_closed>(hosting))};
    for (Property& property : surfaces_of_segments(hosting)) chain.push_back(std::move(property));
    define(hosting, 7, "Chain",
           "A line of segments without seams, solid on its left: points from left to right are "
           "ground; a closed counter-clockwise chain is a container. Bodies pass through it from "
           "the other side.",
           std::move(chain));
}

}  // namespace

void define_shapes(Hosting& hosting) {
    define_shape(hosting);
    const physics::Circle circle;
    const physics::Box box;
    const Property center = middle(hosting);
    define(hosting, 0, "Circle", "A disc.",
           {length("radius", circle.radius, size, "Distance from its center to its rim.",
                   bound<&Shape::radius, &Shape::set_radius>(hosting)),
            center, orientation_mark(hosting)});
    define(hosting, 1, "Box", "A rectangle.",
           {length("width", box.width, size,
                   "Distance from its left to its right side, rounding included.",
                   bound<&Shape::width, &Shape::set_width>(hosting)),
            length("height", box.height, size, "Distance from bottom to top, rounding included.",
                   bound<&Shape::height, &Shape::set_height>(hosting)),
            center, turned(hosting),
            rounding(hosting,
                     "Radius of its corners; more than half the smaller side counts as "
                     "half.")});
    define(hosting, 2, "Segment", "A straight line without thickness and without mass.",
           ends(hosting, std::get<physics::Segment>(hosting.kinds[2].geometry)));
    const auto& capsule = std::get<physics::Segment>(hosting.kinds[3].geometry);
    std::vector<Property> rounded = ends(hosting, capsule);
    rounded.push_back(length("radius", capsule.rounding, size,
                             "Radius around the line between its ends.",
                             bound<&Shape::rounding, &Shape::set_rounding>(hosting)));
    define(hosting, 3, "Capsule", "A straight line with round ends and a thickness.",
           std::move(rounded));
    define(hosting, 4, "Polygon", "A convex polygon.",
           {points<most_points>(
                hosting, "vertices", std::get<physics::Polygon>(hosting.kinds[4].geometry).vertices,
                100,
                "Its corners in the coordinates of the body, counter-clockwise. The convex hull "
                "of the written points becomes the shape."),
            rounding(hosting, "Radius that is added on all sides.")},
           {add_vertex(hosting)});
    define_ellipse(hosting);
    define_outlines(hosting);
}

}  // namespace fettle::physics_module
