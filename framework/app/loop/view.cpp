#include <fettle/app/view.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include <fettle/property/drawing.h>

#include <loop/view_motion.h>

namespace fettle::app {

using property::accessor;
using property::Native;
using property::Overlay;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

bool Show::overlay(Overlay overlay) const {
    switch (overlay) {
        case Overlay::aabbs:
            return aabbs;
        case Overlay::contacts:
            return contacts;
        case Overlay::joints:
            return joints;
        case Overlay::centers:
            return centers;
        case Overlay::velocities:
            return velocities;
        case Overlay::names:
            return names;
        case Overlay::islands:
            return islands;
        case Overlay::impulses:
            return impulses;
        case Overlay::limits:
            return limits;
        case Overlay::shapes:
            return shapes;
    }
    return false;
}

double View::zoom() const {
    if (fit == Fit::expand) return screen.y / height;
    const double largest = screen.over(design).smallest();
    const double scale = fit == Fit::letterbox ? largest : std::max(1.0, std::floor(largest));
    return scale * design.y / height;
}

double View::width() const {
    return fit == Fit::expand ? screen.x / zoom() : height * design.x / design.y;
}

Vec2 View::picture() const {
    return fit == Fit::expand ? screen : (zoom() * Vec2(width(), height)).min(screen);
}

Vec2 View::corner() const {
    if (fit == Fit::expand) return {0, 0};
    const Vec2 corner = 0.5 * (screen - picture());
    return {std::floor(corner.x), std::floor(corner.y)};
}

Vec2 View::reach() const {
    const Vec2 half(0.5 * width(), 0.5 * height);
    if (angle == 0) return half;
    const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
    return {c * half.x + s * half.y, s * half.x + c * half.y};
}

Vec2 View::to_screen(const Vec2& world) const {
    return to_window(world) - corner();
}

Vec2 View::to_window(const Vec2& world) const {
    Vec2 offset = (world - center) * zoom();
    if (angle != 0) offset = property::Transform::turned(-angle).direction(offset);
    return {0.5 * screen.x + offset.x, 0.5 * screen.y - offset.y};
}

Vec2 View::to_world(const Vec2& pixels) const {
    const Vec2 offset = pixels + corner() - 0.5 * screen;
    Vec2 world = Vec2(offset.x, -offset.y) / zoom();
    if (angle != 0) world = property::Transform::turned(angle).direction(world);
    return center + world;
}

property::Transform View::world_to_window() const {
    const double z = zoom(), c = std::cos(angle), s = std::sin(angle);
    property::Transform made{Vec2(z * c, z * s), Vec2(z * s, -z * c), Vec2(0, 0)};
    made.origin = 0.5 * screen - made.direction(center);
    return made;
}

namespace {

Property derived(Property property, std::vector<std::string> sources) {
    property.read_only = true;
    property.transient = true;
    property.derives_from = std::move(sources);
    return property;
}

std::vector<Property> place_properties(View& view) {
    return {
        {.name = "center",
         .type = Type::vec2,
         .unit = "m",
         .range = {-1e9, 1e9},
         .doc = "The point of the world in the middle of the screen.",
         .binding = column(view, Native::vec2d, 0, [](View& v) { return v.center.data(); }),
         .simulated = true},
        {.name = "height",
         .type = Type::number,
         .default_value = 20.0,
         .unit = "m",
         .range = view_heights,
         .doc = "How much of the world is seen from the bottom of the screen to its top.",
         .binding = column(view, Native::f64, 0, [](View& v) { return &v.height; })},
        {.name = "angle",
         .type = Type::number,
         .unit = "rad",
         .range = {-1e6, 1e6},
         .doc = "The turn of the viewer, counter-clockwise: the picture turns the other way.",
         .binding = column(view, Native::f64, 0, [](View& v) { return &v.angle; })},
        derived({.name = "width",
                 .type = Type::number,
                 .unit = "m",
                 .doc = "How much of the world is seen from side to side.",
                 .binding = accessor(view, [](View& v, property::Row) { return v.width(); })},
                {"height", "screen", "fit", "design"}),
        // Computed from `height` and the size of the window. Resizing changes it without a write,
        // so it is simulated.
        {.name = "zoom",
         .type = Type::number,
         .default_value = 40.0,
         .unit = "px/m",
         .range = {1e-3, 1e6},
         .doc = "Pixels a meter. Setting it changes the height, which has a range of its own.",
         .binding = accessor(
             view, [](View& v, property::Row) { return v.zoom(); },
             [](View& v, property::Row, const Value& zoom) {
                 const double height = v.fit == Fit::expand ? v.screen.y / zoom.number()
                                                            : v.height * v.zoom() / zoom.number();
                 require_view_height(height);
                 v.height = height;
             }),
         .transient = true,
         .simulated = true,
         .derives_from = {"height", "screen", "fit", "design"}},
        derived({.name = "lower",
                 .type = Type::vec2,
                 .unit = "m",
                 .doc = "The smallest x and y of the world that are seen: the bottom left corner "
                        "unless the view is turned.",
                 .binding = accessor(view, [](View& v, property::Row) { return v.lower(); })},
                {"center", "height", "angle", "screen", "fit", "design"}),
        derived({.name = "upper",
                 .type = Type::vec2,
                 .unit = "m",
                 .doc = "The largest x and y of the world that are seen: the top right corner "
                        "unless the view is turned.",
                 .binding = accessor(view, [](View& v, property::Row) { return v.upper(); })},
                {"center", "height", "angle", "screen", "fit", "design"}),
    };
}

/// The properties for following an instance, with their places in the view.
std::vector<Property> bound_following_properties(View& view) {
    std::vector<Property> made = following_properties();
    const auto put = [&made](std::string_view name, const property::Binding& binding) {
        std::ranges::find(made, name, &Property::name)->binding = binding;
    };
    put("follow",
        accessor(
            view, [](View& v, property::Row) { return Value(v.follow); },
            [](View& v, property::Row, const Value& value) { v.follow = value.reference(); }));
    put("follow_damping", column(view, Native::f64, 0, [](View& v) { return &v.follow_damping; }));
    put("dead_zone", column(view, Native::vec2d, 0, [](View& v) { return v.dead_zone.data(); }));
    put("limits",
        accessor(
            view,
            [](View& v, property::Row) {
                return Value(property::List(v.limits.begin(), v.limits.end()));
            },
            [](View& v, property::Row, const Value& value) {
                const property::List& corners = value.list();
                if (!corners.empty() &&
                    (corners.size() != 2 || corners[0].vec2().x > corners[1].vec2().x ||
                     corners[0].vec2().y > corners[1].vec2().y))
                    throw std::invalid_argument(
                        "expected the lower and the upper corner of a box, or an empty list");
                v.limits.clear();
                for (const Value& corner : corners) v.limits.push_back(corner.vec2());
            }));
    put("shake_amount", column(view, Native::f64, 0, [](View& v) { return &v.shake_amount; }));
    put("shake_length", column(view, Native::f64, 0, [](View& v) { return &v.shake_length; }));
    put("shake_left", column(view, Native::f64, 0, [](View& v) { return &v.shake_left; }));
    std::ranges::find(made, "shake_left", &Property::name)->simulated = true;
    return made;
}

std::vector<Property> picture_properties(View& view) {
    return {
        {.name = "fit",
         .type = Type::text,
         .default_value = "expand",
         .doc = "How the picture fits into the window. expand: all of the window is used. "
                "letterbox: what is seen has the proportions of `design`, with black bars beside "
                "it. pixel: so that each pixel of `design` is a whole number of pixels.",
         .binding = column(view, Native::enumeration, 0,
                           [](View& v) { return reinterpret_cast<std::uint8_t*>(&v.fit); }),
         .enumerators = {"expand", "letterbox", "pixel"}},
        {.name = "design",
         .type = Type::vec2,
         .default_value = view.design,
         .unit = "px",
         .range = {1, 16384},
         .doc =
             "The size of the picture for which the game is made, for `fit` letterbox and pixel.",
         .binding = column(view, Native::vec2d, 0, [](View& v) { return v.design.data(); })},
        {.name = "effect",
         .type = Type::text,
         .doc = "A fragment shader in GLSL, a file in the game's folder (.frag, .glsl), through "
                "which the picture with its menus is drawn; empty: none. Its uniforms are the "
                "properties of `view.uniforms`.",
         .binding = accessor(
             view, [](View& v, property::Row) { return Value(v.effect); },
             [](View& v, property::Row, const Value& value) { v.effect = value.text(); })},
        {.name = "background",
         .type = Type::color,
         .default_value = view.background,
         .range = {0, 1},
         .doc = "The color behind everything.",
         .binding = column(view, Native::color, 0, [](View& v) { return &v.background; })},
        {.name = "screen",
         .type = Type::vec2,
         .default_value = view.screen,
         .unit = "px",
         .doc = "Size of the picture on the screen: of the window, without the bars of `fit`. In a "
                "headless run, the size that a window would have.",
         .binding = accessor(view, [](View& v, property::Row) { return Value(v.picture()); }),
         .read_only = true,
         .transient = true,
         .simulated = true},
    };
}

template <class Base>
Property overlay(Show& show, const char* name, const char* doc, Base base) {
    return {.name = name,
            .type = Type::boolean,
            .default_value = false,
            .doc = doc,
            .binding = column(show, Native::boolean, 0, base),
            .transient = true};  // no edit of the game: no file and no list of tweaks holds it
}

std::vector<Property> overlays(Show& show) {
    return {
        overlay(show, "aabbs", "Axis-aligned bounding boxes of shapes.",
                [](Show& s) { return &s.aabbs; }),
        overlay(show, "contacts", "Contact points, their normals and impulses.",
                [](Show& s) { return &s.contacts; }),
        overlay(show, "joints", "Joints and their anchors.", [](Show& s) { return &s.joints; }),
        overlay(show, "centers", "Centers of mass.", [](Show& s) { return &s.centers; }),
        overlay(show, "velocities", "Velocities of bodies, as lines.",
                [](Show& s) { return &s.velocities; }),
        overlay(show, "names", "Names of bodies. Where names would overlap, only one is drawn.",
                [](Show& s) { return &s.names; }),
        overlay(show, "islands",
                "Islands: bodies that sleep and wake together, each island in a color of its own.",
                [](Show& s) { return &s.islands; }),
        overlay(show, "impulses",
                "Impulses of contacts in the last step, as arrows with one scale for all.",
                [](Show& s) { return &s.impulses; }),
        overlay(show, "limits", "Limits of joints: the angles and ways that they allow.",
                [](Show& s) { return &s.limits; }),
        overlay(show, "shapes",
                "Outlines of all shapes, also of those that are not visible because the game draws "
                "something else.",
                [](Show& s) { return &s.shapes; }),
        overlay(show, "blame",
                "What wrote last: each instance has the color of the line of a script, the "
                "console, the inspector or the physics that wrote it.",
                [](Show& s) { return &s.blame; }),
        overlay(show, "wires", "Formulas: arrows from what a formula reads to what it writes.",
                [](Show& s) { return &s.wires; }),
        overlay(show, "onion_skins",
                "Earlier poses of the selected instance while the console is open, and later ones "
                "after going back.",
                [](Show& s) { return &s.onion_skins; }),
        overlay(show, "grid", "A grid of meters.", [](Show& s) { return &s.grid; }),
        overlay(show, "timings", "Frames a second, and where a frame's time goes.",
                [](Show& s) { return &s.timings; }),
    };
}

/// In `draw`, points are converted as they are seen, as `drawn_position` of a body is.
View view_of(const void* context, const property::Tree& tree) {
    const View& view = *static_cast<const View*>(context);
    return property::Drawing::underway() ? view.drawn(tree, property::Drawing::alpha()) : view;
}

std::vector<property::Method> conversions(View& view) {
    return {
        {.name = "to_screen",
         .parameters = {{.name = "point", .type = Type::vec2, .unit = "m", .doc = "In the world."}},
         .required = 1,
         .returns = {{.name = "pixels",
                      .type = Type::vec2,
                      .unit = "px",
                      .doc = "From the top left corner, y down."}},
         .doc = "Where a point of the world is on the screen, from the top left corner, y down.",
         .context = &view,
         .call = [](void* context, property::Tree& tree, property::Handle, property::Row,
                    std::span<const Value> arguments) -> property::Result {
             return Value(view_of(context, tree).to_screen(arguments[0].vec2()));
         },
         .effect = property::Effect::nothing},
        {.name = "to_world",
         .parameters = {{.name = "pixels",
                         .type = Type::vec2,
                         .unit = "px",
                         .doc = "From the top left corner, y down."}},
         .required = 1,
         .returns = {{.name = "point", .type = Type::vec2, .unit = "m", .doc = "In the world."}},
         .doc = "The point of the world that is seen at a point of the screen.",
         .context = &view,
         .call = [](void* context, property::Tree& tree, property::Handle, property::Row,
                    std::span<const Value> arguments) -> property::Result {
             return Value(view_of(context, tree).to_world(arguments[0].vec2()));
         },
         .effect = property::Effect::nothing},
    };
}

}  // namespace

property::Handle define_view(property::Tree& tree, View& view) {
    std::vector<Property> properties = place_properties(view);
    for (Property& property : bound_following_properties(view))
        properties.push_back(std::move(property));
    for (Property& property : picture_properties(view)) properties.push_back(std::move(property));
    std::vector<property::Method> methods = conversions(view);
    methods.push_back(shake_method());
    const property::Class& view_class =
        tree.define({.name = "View",
                     .doc = "Which part of the world is seen, and what lies over it.",
                     .creatable = false,
                     .properties = std::move(properties),
                     .methods = std::move(methods)});
    const property::Class& show_class =
        tree.define({.name = "Show",
                     .doc = "What is shown over the picture, for looking into a game.",
                     .creatable = false,
                     .snapshots = property::Snapshots::never,
                     .properties = overlays(view.show)});
    const property::Handle instance = tree.create(view_class, tree.root(), "view");
    tree.create(show_class, instance, "show");
    define_window(tree, instance, view);
    return instance;
}

}  // namespace fettle::app
