#include <loop/wires.h>

#include <fettle/app/view.h>
#include <fettle/property/drawing.h>
#include <fettle/property/error.h>
#include <fettle/property/label.h>
#include <fettle/property/path.h>
#include <fettle/property/pose.h>

namespace fettle::app {

using property::Color;
using property::Handle;
using property::Tree;
using property::Vec2;

namespace {

constexpr Color ink{0.55f, 0.85f, 1.0f, 0.95f}, pale_wire{0.8f, 0.92f, 1.0f, 1};

std::optional<Vec2> place_of(const Tree& tree, Handle instance) {
    const auto place = property::place_below(tree, instance, false, property::Drawing::alpha());
    return place ? std::optional(place->origin) : std::nullopt;
}

/// The last two names of a path: "world.ball.mass" is long beside an arrow.
std::string short_path(const std::string& path) {
    const std::size_t last = path.rfind('.');
    if (last == std::string::npos || last == 0) return path;
    const std::size_t before = path.rfind('.', last - 1);
    return before == std::string::npos ? path : path.substr(before + 1);
}

/// No wire is drawn from a deleted instance, or from a cell that is not a property.
std::optional<Handle> instance_at(const Tree& tree, const std::string& path) {
    try {
        return property::resolve(tree, path).instance;
    } catch (const property::Error&) {
        return std::nullopt;
    }
}

void add(const Tree& tree, Handle instance, const property::Property& property,
         std::vector<Wire>& all) {
    // A formula of an instance without a place is beside the middle of the world.
    const Vec2 to = place_of(tree, instance).value_or(Vec2(0, 0));
    const std::string written = short_path(tree.path(instance, property));
    const property::Explanation why = tree.why(instance, property);
    for (const property::Explanation& source : why.from) {
        const auto read = instance_at(tree, source.path);
        const auto from = read ? place_of(tree, *read) : std::nullopt;
        all.push_back({from, to, short_path(source.path) + " → " + written});
    }
    if (why.from.empty()) all.push_back({std::nullopt, to, written + " is a formula"});
}

void draw_arrow(property::Painter& painter, const Vec2& from, const Vec2& to, double pixel) {
    const Vec2 way = to - from;
    const double length = way.length();
    if (length < pixel) return;
    // A curve: two formulas between the same instances do not cover each other.
    const Vec2 bend = from + 0.5 * way + 0.12 * Vec2(-way.y, way.x);
    const auto at = [&](double t) {
        return Vec2((1 - t) * (1 - t) * from + 2 * t * (1 - t) * bend + t * t * to);
    };
    constexpr int pieces = 24;
    for (int i = 0; i < pieces; ++i)
        painter.line(at(static_cast<double>(i) / pieces), at(static_cast<double>(i + 1) / pieces),
                     ink, 2);
    const Vec2 end = (at(1) - at(0.9)).normalized();
    const Vec2 back = -std::min(12 * pixel, 0.3 * length) * end;
    const Vec2 side(-0.5 * back.y, 0.5 * back.x);
    painter.line(to, to + back + side, ink, 2);
    painter.line(to, to + back - side, ink, 2);
    painter.point(from, ink, 7);
}

}  // namespace

std::vector<Wire> wires(const Tree& tree, std::size_t most) {
    std::vector<Wire> all;
    std::size_t left = std::min(most, tree.formula_count());
    // The walk ends early: a formula is found long before the last of many instances.
    const auto visit = [&](const auto& self, Handle instance) -> void {
        const auto look = [&](const property::Property& each) {
            if (left == 0 || each.read_only || tree.formula(instance, each) == nullptr) return;
            --left;
            add(tree, instance, each, all);
        };
        for (const property::Property* each : tree.class_of(instance).properties()) look(*each);
        for (const property::Property* each : tree.ad_hoc(instance)) look(*each);
        for (Handle child = tree.first_child(instance); child && left > 0;
             child = tree.next_sibling(child))
            self(self, child);
    };
    if (left > 0) visit(visit, tree.root());
    return all;
}

void draw_wires(property::Painter& painter, const Tree& tree) {
    const double pixel = 1 / painter.pixels_per_unit(), label = painter.label_scale() * pixel;
    double below = 0;  // labels of formulas at the same place are one below the other
    std::optional<Vec2> last;
    for (const Wire& wire : wires(tree)) {
        below = last && (*last - wire.to).length() < pixel ? below + 18 * label : 0;
        last = wire.to;
        const bool itself = wire.from && (*wire.from - wire.to).length() < pixel;
        const bool drawn = wire.from && !itself;
        if (drawn) draw_arrow(painter, *wire.from, wire.to, pixel);
        const Vec2 middle = drawn ? Vec2(0.5 * (*wire.from + wire.to)) : wire.to;
        const Vec2 way = drawn ? Vec2(wire.to - *wire.from) : Vec2(0, 0);
        const Vec2 at = middle + 0.06 * Vec2(-way.y, way.x) + Vec2(0, 22 * label + below);
        property::draw_label(painter, at, wire.label, 15 * label, pale_wire);
    }
}

}  // namespace fettle::app
