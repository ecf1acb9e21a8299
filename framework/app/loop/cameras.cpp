#include <loop/cameras.h>

#include <algorithm>
#include <array>

#include <fettle/property/pose.h>

namespace fettle::app {

using property::Handle;
using property::Method;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

std::vector<Property> camera_properties() {
    return {
        {.name = "viewport",
         .type = Type::list,
         .default_value = property::List{Value(Vec2(0, 0)), Value(Vec2(1, 1))},
         .range = {0, 1},
         .doc = "The part of the window that it fills: the upper left and the lower right corner, "
                "as parts of width and height from the top left. Without two different corners, "
                "it shows nothing.",
         .element = Type::vec2},
        {.name = "center",
         .type = Type::vec2,
         .unit = "m",
         .range = {-1e9, 1e9},
         .doc = "The point of the world in its middle, unless it follows something."},
        {.name = "height",
         .type = Type::number,
         .default_value = 20.0,
         .unit = "m",
         .range = {1e-3, 1e6},
         .doc = "How much of the world is seen from the bottom of its viewport to its top."},
        {.name = "angle",
         .type = Type::number,
         .unit = "rad",
         .range = {-1e6, 1e6},
         .doc = "The turn of the viewer, counter-clockwise: the picture turns the other way."},
        {.name = "follow",
         .type = Type::reference,
         .doc = "The instance in its middle; nil: `center`."},
        {.name = "background",
         .type = Type::color,
         .range = {0, 1},
         .doc = "The color behind everything; nil: that of the view.",
         .nullable = true},
        {.name = "visible",
         .type = Type::boolean,
         .default_value = true,
         .doc = "Whether its picture is drawn."},
    };
}

/// The corners of a viewport; equal ones for a list that is none.
std::array<Vec2, 2> corners_of(const Value& viewport) {
    const property::List& list = viewport.list();
    if (list.size() != 2) return {Vec2(0, 0), Vec2(0, 0)};
    const Vec2 a = list[0].vec2(), b = list[1].vec2();
    return {a.min(b), a.max(b)};
}

}  // namespace

Cameras::Cameras(property::Tree& tree, const View& view) : tree_(tree), view_(view) {
    define(tree);
}

void Cameras::define(property::Tree& tree) {
    const auto method = [this](const char* name, property::Field from, property::Field to,
                               const char* doc, auto call) {
        Method made{.name = name,
                    .parameters = {std::move(from)},
                    .required = 1,
                    .returns = {std::move(to)},
                    .doc = doc,
                    .context = this};
        made.call = call;
        made.effect = property::Effect::nothing;
        return made;
    };
    const property::Field world{
        .name = "point", .type = Type::vec2, .unit = "m", .doc = "In the world."};
    const property::Field pixels{.name = "pixels",
                                 .type = Type::vec2,
                                 .unit = "px",
                                 .doc = "From the top left corner of the window, y down."};
    property::ClassDescriptor described{
        .name = "Camera",
        .doc =
            "Another picture of the world in a part of the window, for a split screen or a small "
            "map. It shows what the view shows, from another place, without layers on the "
            "screen: these are drawn over all cameras.",
        .properties = camera_properties(),
        .methods = {
            method("to_world", pixels, world, "The point of the world that it shows at a pixel.",
                   [](void* context, property::Tree&, Handle self, property::Row,
                      std::span<const Value> given) -> property::Result {
                       const auto& cameras = *static_cast<Cameras*>(context);
                       const CameraPicture p = cameras.picture(self, cameras.view_, 1);
                       return Value(p.view.to_world(given[0].vec2() - p.lower));
                   }),
            method("to_screen", world, pixels, "Where it shows a point of the world.",
                   [](void* context, property::Tree&, Handle self, property::Row,
                      std::span<const Value> given) -> property::Result {
                       const auto& cameras = *static_cast<Cameras*>(context);
                       const CameraPicture p = cameras.picture(self, cameras.view_, 1);
                       return Value(Vec2(p.lower + p.view.to_screen(given[0].vec2())));
                   })}};
    described.lifecycle.context = this;
    described.lifecycle.create = [](void* context, property::Tree&, Handle self) {
        static_cast<Cameras*>(context)->all_.push_back(self);
        return property::Row{0};
    };
    described.lifecycle.destroy = [](void* context, property::Tree&, Handle self, property::Row) {
        std::erase(static_cast<Cameras*>(context)->all_, self);
    };
    const property::Class& made = tree.define(std::move(described));
    const auto of = [&](const char* name) { return made.property(name); };
    of_ = {of("viewport"), of("center"),     of("height"),  of("angle"),
           of("follow"),   of("background"), of("visible"), of("z")};
}

std::vector<Handle> Cameras::shown() const {
    std::vector<Handle> found;
    for (const Handle camera : all_)
        if (tree_.alive(camera) && tree_.is_below(camera, tree_.root()) &&
            tree_.peek(camera, *of_.visible).boolean())
            found.push_back(camera);
    std::ranges::stable_sort(
        found, {}, [this](Handle camera) { return tree_.peek(camera, *of_.z).as_double(); });
    return found;
}

CameraPicture Cameras::picture(Handle camera, const View& view, double alpha) const {
    CameraPicture made;
    const auto corners = corners_of(tree_.peek(camera, *of_.viewport));
    made.lower = corners[0].times(view.screen);
    made.upper = corners[1].times(view.screen);
    made.view.screen = (made.upper - made.lower).max({1, 1});
    made.view.center = tree_.peek(camera, *of_.center).vec2();
    made.view.height = tree_.peek(camera, *of_.height).as_double();
    made.view.angle = tree_.peek(camera, *of_.angle).as_double();
    const Handle followed = tree_.peek(camera, *of_.follow).reference();
    if (followed && tree_.alive(followed))
        if (const auto place = property::place_below(tree_, followed, false, alpha))
            made.view.center = place->origin;
    return made;
}

void Cameras::draw(property::Painter& painter, const View& view, double alpha,
                   const std::function<void(property::Painter&)>& game) const {
    const std::vector<Handle> cameras = shown();
    if (cameras.empty()) return game(painter);
    {
        CameraPainter world(painter, CameraPainter::Part::world);
        game(world);
    }
    for (const Handle camera : cameras) {
        if (!tree_.alive(camera)) continue;  // a function that draws has deleted it
        const CameraPicture shown = picture(camera, view, alpha);
        if ((shown.upper - shown.lower).smallest() < 1) continue;
        const Value color = tree_.peek(camera, *of_.background);
        property::Paint paint{.border = {0, 0, 0, 0}};
        paint.fill = color.is_nil() ? view.background : color.color();
        const std::array<Vec2, 4> box{shown.lower, Vec2(shown.upper.x, shown.lower.y), shown.upper,
                                      Vec2(shown.lower.x, shown.upper.y)};
        painter.begin_screen();
        painter.polygon(box, 0, paint);
        painter.end_screen();
        CameraPainter seen(painter, view, shown);
        game(seen);
    }
    CameraPainter screen(painter, CameraPainter::Part::screen);
    game(screen);
}

}  // namespace fettle::app
