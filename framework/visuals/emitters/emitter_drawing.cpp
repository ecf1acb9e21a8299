#include <algorithm>
#include <array>

#include <emitters/emitters.h>
#include <fettle/property/pose.h>
#include <properties/properties.h>

namespace fettle::visuals {

using property::Color;
using property::Transform;
using property::Value;
using property::Vec2;

namespace {

/// Values over the life of a particle, in equal parts; between two they are mixed.
constexpr std::size_t parts = 64;

Color mixed(Color a, Color b, float t) {
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b),
            a.a + t * (b.a - a.a)};
}
double mixed(double a, double b, float t) {
    return a + static_cast<double>(t) * (b - a);
}

template <class T, class Read>
std::array<T, parts + 1> curve(const Value& list, T otherwise, Read read) {
    std::array<T, parts + 1> all;
    all.fill(otherwise);
    const property::List& points = list.list();
    if (points.empty()) return all;
    for (std::size_t i = 0; i <= parts; ++i) {
        const double at = static_cast<double>(i) / parts * static_cast<double>(points.size() - 1);
        const auto before = static_cast<std::size_t>(at);
        const std::size_t after = std::min(before + 1, points.size() - 1);
        all[i] = mixed(read(points[before]), read(points[after]),
                       static_cast<float>(at - static_cast<double>(before)));
    }
    return all;
}

}  // namespace

/// Null without an image.
const Sheet* Emitters::sheet_of(Row& row) {
    const Value name = Reader(*tree_, row.state.self).value(of_.image);
    if (!(name == row.image)) {
        row.image = name;
        const auto user = [this, &row] { return tree_->path(row.state.self, *of_.image); };
        row.sheet = name.text().empty() ? nullptr : images_.get(user, name.text());
    }
    return row.sheet.get();
}

void Emitters::draw(Row& row, property::Painter& painter, double alpha) {
    const property::Handle self = row.state.self;
    const Reader read(*tree_, self);
    if (row.particles.empty() || !read.flag(of_.visible)) return;
    const auto sizes =
        curve<double>(read.value(of_.size), 0.1, [](const Value& v) { return v.as_double(); });
    const auto colors =
        curve<Color>(read.value(of_.color), Color{}, [](const Value& v) { return v.color(); });
    const Sheet* const sheet = sheet_of(row);
    const property::Picture& picture = sheet != nullptr ? sheet->picture : dot_;
    property::PictureArea area{0, 0, static_cast<double>(picture.width()),
                               static_cast<double>(picture.height())};
    if (sheet != nullptr && !sheet->frames.empty()) area = sheet->frames.front().area;
    const double slim = area.height > 0 ? area.width / area.height : 1;
    const double rotation = read.number(of_.rotation);
    const bool smooth = read.flag(of_.smooth);
    const bool local = read.value(of_.space).text() == "local";
    painter.push(
        local
            ? property::place_below(*tree_, self, painter.on_screen(), alpha).value_or(Transform())
            : Transform());
    const property::Blend blend = blend_of(read.in_place(of_.blend));
    if (blend != property::Blend::normal) painter.blend(blend);
    // The picture shows a time between the last two steps: the particles are moved back to it.
    const auto back = static_cast<float>((alpha - 1) * row.state.last_dt);
    for (const Particle& p : row.particles) {
        const float age = p.age + back;
        if (age < 0.0f) continue;  // it begins after the time of the picture
        const auto part = static_cast<std::size_t>(
            std::min(static_cast<float>(parts), age / p.lifetime * static_cast<float>(parts)));
        const double half = 0.5 * sizes[part] * static_cast<double>(p.size);
        if (half <= 0 || colors[part].a <= 0) continue;
        const Vec2 center(static_cast<double>(p.x + p.velocity_x * back),
                          static_cast<double>(p.y + p.velocity_y * back));
        const Vec2 reach(half * slim, half);
        if (rotation == 0) {
            painter.picture(picture, area, center - reach, center + reach, colors[part], smooth);
            continue;
        }
        // Half of the particles turn to the left, the others to the right.
        const double turn = static_cast<double>(p.angle) +
                            (p.angle < 0 ? -rotation : rotation) * static_cast<double>(age);
        painter.push(Transform::placed(center, turn));
        painter.picture(picture, area, -reach, reach, colors[part], smooth);
        painter.pop();
    }
    painter.pop();
}

}  // namespace fettle::visuals
