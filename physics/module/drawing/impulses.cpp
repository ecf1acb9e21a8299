// Impulses of contacts, drawn to scale.

#include <cmath>
#include <string>

#include <bindings/conversion.h>
#include <drawing/marks.h>

namespace fettle::physics_module {
namespace {

using property::Color;
using property::Painter;
using property::Vec2;

constexpr Color ink{0.35f, 0.95f, 0.5f, 1};

/// The largest of 1, 2 and 5 times a power of ten that is not above `value`.
double round_number(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double factor : {5.0, 2.0})
        if (factor * power <= value * (1 + 1e-9)) return factor * power;
    return power;
}

/// The impulse of the weight of the heaviest body that moves, N s in a step; without gravity as if
/// it were 10 m/s².
double weight_impulse(physics::World& world, double dt) {
    double mass = 0;
    for (const physics::Body& body : world.bodies())
        if (body.type() == physics::BodyType::dynamic_body && std::isfinite(body.mass()))
            mass = std::max(mass, static_cast<double>(body.mass()));
    const double gravity = static_cast<double>(world.gravity().length());
    return mass * (gravity > 0 ? gravity : 10) * dt;
}

void draw_arrow(const Vec2& from, const Vec2& arrow, double pixel, Painter& painter) {
    const Vec2 to = from + arrow;
    painter.line(from, to, ink, 2);
    const double length = arrow.length();
    const double head = std::min(7 * pixel, 0.4 * length);
    const Vec2 back = -head / length * arrow, side(-0.5 * back.y, 0.5 * back.x);
    painter.line(to, to + back + side, ink, 2);
    painter.line(to, to + back - side, ink, 2);
}

/// Draws the scale of the impulses at the lower edge of the picture.
void draw_scale(double meters_each, double pixel, Painter& painter) {
    const double shown = round_number(120 * pixel / meters_each);
    const std::string text = property::number_text(shown) + " N s in a step";
    const double y = painter.seen().screen.y - 84, x = 0.4 * painter.seen().screen.x;
    const double wide = shown * meters_each / pixel;
    painter.begin_screen();
    painter.line({x, y}, {x + wide, y}, ink, 2);
    for (const double end : {x, x + wide}) painter.line({end, y - 4}, {end, y + 4}, ink, 2);
    painter.text({x + wide + 8, y}, text, 15 * painter.label_scale(), ink,
                 property::TextAlign::left);
    painter.end_screen();
}

}  // namespace

void draw_impulses(physics::World& world, double dt, Painter& painter) {
    const double reference = weight_impulse(world, dt);
    if (!(reference > 0)) return;
    const property::Seen seen = painter.seen();
    const double height = seen.upper.y > seen.lower.y ? seen.upper.y - seen.lower.y : 20;
    const double pixel = 1 / painter.pixels_per_unit();
    const double meters_each = round_number(height / 12 / reference);
    // The library stores the impulses of a sub-step.
    const double substeps = std::max(1, world.last_substeps());
    for (const physics::Contact& contact : world.contacts()) {
        const bool onto_b = world.is_valid(contact.body_b) &&
                            world.body(contact.body_b).type() == physics::BodyType::dynamic_body;
        const double side = onto_b ? 1 : -1;
        const Vec2 normal = widen(contact.normal), tangent(normal.y, -normal.x);
        for (int k = 0; k < contact.point_count; ++k) {
            const physics::ContactPoint& point = contact.points[static_cast<std::size_t>(k)];
            const Vec2 arrow = side * meters_each * substeps *
                               (static_cast<double>(point.normal_impulse) * normal +
                                static_cast<double>(point.tangent_impulse) * tangent);
            const Vec2 at = widen(point.point), end = at + arrow;
            if (arrow.length() > pixel && painter.sees(at.min(end), at.max(end)))
                draw_arrow(at, arrow, pixel, painter);
        }
    }
    draw_scale(meters_each, pixel, painter);
}

}  // namespace fettle::physics_module
