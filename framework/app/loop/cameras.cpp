#include <loop/cameras.h>

#include <algorithm>
#include <array>
#include <string>

#include <fettle/property/drawing.h>
#include <fettle/property/pose.h>

#include <loop/view_motion.h>

namespace fettle::app {

using property::accessor;
using property::Handle;
using property::Method;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

/// The lower and the upper corner of a box; equal ones for a list that is none.
std::array<Vec2, 2> corners_of(const Value& corners) {
    const property::List& list = corners.list();
    if (list.size() != 2) return {Vec2(0, 0), Vec2(0, 0)};
    const Vec2 a = list[0].vec2(), b = list[1].vec2();
    return {a.min(b), a.max(b)};
}

}  // namespace

std::vector<Property> Cameras::properties() {
    std::vector<Property> made{
        {.name = "viewport",
         .type = Type::list,
         .default_value = property::List{Value(Vec2(0, 0)), Value(Vec2(1, 1))},
         .range = {0, 1},
         .doc = "The part of the picture that it fills: the upper left and the lower right corner, "
                "as parts of width and height from the top left. Without two different corners, "
                "it shows nothing.",
         .element = Type::vec2},
        {.name = "center",
         .type = Type::vec2,
         .unit = "m",
         .range = {-1e9, 1e9},
         .doc = "The point of the world in its middle."},
        {.name = "height",
         .type = Type::number,
         .default_value = 20.0,
         .unit = "m",
         .range = view_heights,
         .doc = "How much of the world is seen from the bottom of its viewport to its top."},
        {.name = "zoom",
         .type = Type::number,
         .default_value = 40.0,
         .unit = "px/m",
         .range = {1e-3, 1e6},
         .doc = "Pixels a meter. Setting it changes the height, which has a range of its own.",
         .binding = accessor(
             *this, [](Cameras& c, property::Row row) { return c.zoom(row); },
             [](Cameras& c, property::Row row, const Value& zoom) {
                 c.set_zoom(row, zoom.number());
             }),
         .transient = true,
         .simulated = true,  // changes with the size of the window
         .derives_from = {"height", "viewport"}},
        {.name = "angle",
         .type = Type::number,
         .unit = "rad",
         .range = {-1e6, 1e6},
         .doc = "The turn of the viewer, counter-clockwise: the picture turns the other way."},
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
    for (Property& property : following_properties()) made.push_back(std::move(property));
    return made;
}

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
                                 .doc = "From the top left corner of the picture, y down."};
    property::ClassDescriptor described{
        .name = "Camera",
        .doc =
            "Another picture of the world in a part of the screen, for a split screen or a small "
            "map. It shows what the view shows, from another place, without layers on the "
            "screen: these are drawn over all cameras.",
        .properties = properties(),
        .methods = {
            method("to_world", pixels, world, "The point of the world that it shows at a pixel.",
                   [](void* context, property::Tree&, Handle self, property::Row,
                      std::span<const Value> given) -> property::Result {
                       const auto& cameras = *static_cast<Cameras*>(context);
                       const CameraPicture p = cameras.seen(self);
                       return Value(p.view.to_world(given[0].vec2() - p.lower));
                   }),
            method("to_screen", world, pixels, "Where it shows a point of the world.",
                   [](void* context, property::Tree&, Handle self, property::Row,
                      std::span<const Value> given) -> property::Result {
                       const auto& cameras = *static_cast<Cameras*>(context);
                       const CameraPicture p = cameras.seen(self);
                       return Value(Vec2(p.lower + p.view.to_screen(given[0].vec2())));
                   })}};
    described.methods.push_back(shake_method());
    described.lifecycle.context = this;
    described.lifecycle.create = [](void* context, property::Tree&, Handle self) {
        auto& c = *static_cast<Cameras*>(context);
        c.all_.push_back(self);
        auto free = std::ranges::find(c.rows_, Handle{}, &Row::self);
        if (free == c.rows_.end()) free = c.rows_.insert(free, Row{});
        free->self = self;
        return static_cast<property::Row>(free - c.rows_.begin());
    };
    described.lifecycle.destroy = [](void* context, property::Tree&, Handle self,
                                     property::Row row) {
        auto& c = *static_cast<Cameras*>(context);
        std::erase(c.all_, self);
        c.rows_[row] = {};
    };
    const property::Class& made = tree.define(std::move(described));
    const auto of = [&](const char* name) { return made.property(name); };
    of_ = {of("viewport"),     of("center"),     of("height"),
           of("angle"),        of("follow"),     of("follow_damping"),
           of("dead_zone"),    of("limits"),     of("shake_amount"),
           of("shake_length"), of("shake_left"), of("background"),
           of("visible"),      of("z")};
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

CameraPicture Cameras::picture(Handle camera, const Vec2& screen, double alpha) const {
    const auto value = [&](const Property* of) { return tree_.peek(camera, *of); };
    CameraPicture made;
    const auto corners = corners_of(value(of_.viewport));
    made.lower = corners[0].times(screen);
    made.upper = corners[1].times(screen);
    View& view = made.view;
    view.screen = (made.upper - made.lower).max({1, 1});
    view.center = value(of_.center).vec2();
    view.height = value(of_.height).as_double();
    view.angle = value(of_.angle).as_double();
    view.follow = value(of_.follow).reference();
    view.follow_damping = value(of_.follow_damping).as_double();
    view.dead_zone = value(of_.dead_zone).vec2();
    if (const auto box = corners_of(value(of_.limits)); box[0] != box[1])
        view.limits = {box[0], box[1]};
    view.shake_amount = value(of_.shake_amount).as_double();
    view.shake_length = value(of_.shake_length).as_double();
    view.shake_left = value(of_.shake_left).as_double();
    view.step_length = view_.step_length;
    if (const auto row = std::ranges::find(rows_, camera, &Row::self); row != rows_.end())
        view.track = row->track;
    // Also before the first step, and where a body has been put elsewhere.
    if (view.follows_without_delay(tree_) && view.limits.empty())
        if (const auto place = property::place_below(tree_, view.follow, false, alpha))
            view.center = place->origin;
    return made;
}

CameraPicture Cameras::drawn(Handle camera, const Vec2& screen, double alpha) const {
    CameraPicture made = picture(camera, screen, alpha);
    made.view = made.view.drawn(tree_, alpha);
    return made;
}

CameraPicture Cameras::seen(Handle camera) const {
    const Vec2 screen = view_.picture();
    return property::Drawing::underway() ? drawn(camera, screen, property::Drawing::alpha())
                                         : picture(camera, screen, 1);
}

double Cameras::zoom(property::Row row) const {
    return picture(rows_[row].self, view_.picture(), 1).view.zoom();
}

void Cameras::set_zoom(property::Row row, double zoom) {
    const Handle camera = rows_[row].self;
    const double height = picture(camera, view_.picture(), 1).view.screen.y / zoom;
    require_view_height(height);
    tree_.set(camera, "height", Value(height));
}

void Cameras::each(const std::function<void(Row&)>& visit) {
    // By index: a function that a write calls may make cameras.
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (const Handle camera = rows_[i].self;
            camera && tree_.alive(camera) && tree_.is_below(camera, tree_.root()))
            visit(rows_[i]);
}

property::Placement Cameras::placement(Handle camera) const {
    return {.position = tree_.peek(camera, *of_.center).vec2(),
            .angle = tree_.peek(camera, *of_.angle).as_double(),
            .scale = tree_.peek(camera, *of_.height).as_double()};
}

void Cameras::note_step_begins() {
    each([this](Row& row) {
        row.track.step_begins(placement(row.self), tree_.peek(row.self, *of_.visible).boolean());
    });
}

void Cameras::note_step_ended() {
    each([this](Row& row) { row.track.step_ended(placement(row.self)); });
}

void Cameras::advance(double dt) {
    each([&](Row& row) { advance(row, dt); });
}

void Cameras::advance(Row& row, double dt) {
    static std::function<std::string()> where = [] { return std::string("the camera"); };
    const property::Tree::CauseScope cause(tree_, property::Writer::module, &where);
    const Handle camera = row.self;
    View view = picture(camera, view_.picture(), 1).view;
    const Vec2 before = view.center = tree_.peek(camera, *of_.center).vec2();
    const double shaking = view.shake_left;
    view.advance(tree_, dt);
    const bool moved = before != view.center;
    if (moved && !tree_.formula(camera, *of_.center))
        tree_.set(camera, "center", Value(view.center));
    if (view.shake_left != shaking) tree_.set(camera, "shake_left", Value(view.shake_left));
}

void Cameras::draw(property::Painter& painter, const View& view, double alpha,
                   const std::function<void(property::Painter&)>& game) {
    const std::vector<Handle> cameras = shown();
    if (cameras.empty()) return game(painter);
    {
        CameraPainter world(painter, CameraPainter::Part::world);
        game(world);
    }
    for (const Handle camera : cameras) {
        if (!tree_.alive(camera)) continue;  // a function that draws has deleted it
        const CameraPicture shown = drawn(camera, view.picture(), alpha);
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
