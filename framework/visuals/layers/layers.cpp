#include <layers/layers.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <properties/properties.h>

namespace fettle::visuals {

using property::Handle;
using property::Property;
using property::Transform;
using property::Type;
using property::Vec2;

namespace {

constexpr std::array<const char*, 9> anchors{"top_left",    "top",    "top_right",
                                             "left",        "center", "right",
                                             "bottom_left", "bottom", "bottom_right"};

/// The place of an anchor as a part of the screen, y down.
Vec2 anchor_at(const std::string& name) {
    const auto found = std::find(anchors.begin(), anchors.end(), name);
    const auto n = static_cast<int>(found - anchors.begin());
    const int column = n % 3, row = n / 3;
    return {0.5 * column, 0.5 * row};
}

constexpr double most_copies = 10'000;  // of a layer in a picture: the tree makes no more passes

/// The copies of a repeated layer that may be visible along one axis: number `first` and the
/// following ones, each moved by `period` times its number.
struct Copies {
    double first = 0, period = 0, count = 1;

    /// The layer's content is taken to be no longer than one period on either side of its origin.
    Copies(double wanted_period, double lower, double upper) {
        if (!(wanted_period > 0) || !(lower <= upper)) return;
        period = wanted_period;
        first = std::floor(lower / period) - 1;
        count = std::ceil(upper / period) + 1 - first + 1;
    }
    /// Only those in the middle of the screen are left.
    void limit(double most) {
        if (count <= most) return;
        first += std::floor(0.5 * (count - most));
        count = most;
    }
};

std::vector<Property> layer_properties() {
    return {
        {.name = "space",
         .type = Type::text,
         .default_value = "world",
         .doc =
             "world: in meters, y up. screen: in pixels from `anchor`, y down, whatever the view "
             "shows.",
         .enumerators = {"world", "screen"}},
        {.name = "anchor",
         .type = Type::text,
         .default_value = "top_left",
         .doc = "The point of the screen from which positions are counted, if `space` is screen.",
         .enumerators = {anchors.begin(), anchors.end()}},
        {.name = "scale",
         .type = Type::number,
         .default_value = 1.0,
         .range = {1e-3, 1e3},
         .doc =
             "Enlarges everything below it, positions included, from the anchor on the screen or "
             "from the origin of the world."},
        {.name = "parallax",
         .type = Type::vec2,
         .default_value = Vec2(1, 1),
         .range = {-1e3, 1e3},
         .doc = "How fast it moves past when the view moves: 1 as the world, 0.5 half as fast, as "
                "if it were far away, 0 not at all. For `space` world."},
        {.name = "repeat_x",
         .type = Type::number,
         .unit = "m",
         .range = {0, 1e9},
         .doc = "Distance after which its content repeats to the left and right; 0: never. Pixels "
                "on the screen."},
        {.name = "repeat_y",
         .type = Type::number,
         .unit = "m",
         .range = {0, 1e9},
         .doc = "Distance after which its content repeats up and down; 0: never. Pixels on the "
                "screen."},
        {.name = "opacity",
         .type = Type::number,
         .default_value = 1.0,
         .range = {0, 1},
         .doc = "Multiplies the opacity of everything below it."},
        blend_property(),
        visible_property(),
    };
}

}  // namespace

void Layers::define(property::Tree& tree) {
    property::ClassDescriptor described{
        .name = "Layer",
        .doc =
            "Instances below it are drawn together: far away, repeated, translucent, or on the "
            "screen. It does not change where bodies are.",
        .properties = layer_properties()};
    described.lifecycle.context = this;
    described.lifecycle.begin_below = [](void* context, const property::Tree& in, Handle self,
                                         property::Row, property::Painter& painter, int pass) {
        return static_cast<Layers*>(context)->begin(in, self, painter, pass);
    };
    described.lifecycle.end_below = [](void* context, const property::Tree&, Handle, property::Row,
                                       property::Painter& painter) {
        static_cast<Layers*>(context)->end(painter);
    };
    const property::Class& made = tree.define(std::move(described));
    const auto of = [&](const char* name) { return made.property(name); };
    of_ = {of("space"),    of("anchor"),  of("scale"), of("parallax"), of("repeat_x"),
           of("repeat_y"), of("opacity"), of("blend"), of("visible")};
}

bool Layers::begin(const property::Tree& tree, Handle self, property::Painter& painter, int pass) {
    const Reader read(tree, self);
    const double opacity = read.number(of_.opacity);
    if (!read.flag(of_.visible) || opacity <= 0) return false;
    const property::Seen seen = painter.seen();
    const bool screen = read.value(of_.space).text() == "screen";
    Vec2 origin(0, 0), lower = seen.lower, upper = seen.upper;
    if (screen) {
        origin = anchor_at(read.value(of_.anchor).text()).times(seen.screen);
        lower = Vec2(0, 0);
        upper = seen.screen;
    } else {
        origin = (Vec2(1, 1) - read.vec2(of_.parallax)).times(seen.center);
    }
    const double scale = read.number(of_.scale);
    lower = (lower - origin) / scale;
    upper = (upper - origin) / scale;
    Copies across(read.number(of_.repeat_x), lower.x, upper.x);
    Copies up(read.number(of_.repeat_y), lower.y, upper.y);
    across.limit(std::floor(std::max(most_copies / up.count, std::sqrt(most_copies))));
    up.limit(std::floor(most_copies / across.count));
    if (pass >= across.count * up.count) return false;
    const double row = std::floor(pass / across.count);
    const Vec2 copy(across.period * (across.first + pass - row * across.count),
                    up.period * (up.first + row));
    if (screen) painter.begin_screen();
    painter.push(Transform::moved(origin + scale * copy) * Transform::scaled(Vec2(scale, scale)));
    if (opacity < 1) painter.fade(static_cast<float>(opacity));
    const property::Blend blend = blend_of(read.value(of_.blend));
    if (blend != property::Blend::normal) painter.blend(blend);
    on_screen_.push_back(screen);
    return true;
}

void Layers::end(property::Painter& painter) {
    const bool screen = on_screen_.back();
    on_screen_.pop_back();
    painter.pop();
    if (screen) painter.end_screen();
}

}  // namespace fettle::visuals
