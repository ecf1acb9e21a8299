// Islands: bodies that are connected by contacts and joints.

#include <cmath>
#include <numeric>
#include <vector>

#include <drawing/forms.h>
#include <drawing/marks.h>

namespace fettle::physics_module {
namespace {

using property::Color;
using property::Painter;
using property::Vec2;

/// Sets of bodies by slot, joined one connection at a time.
class Islands {
  public:
    explicit Islands(physics::World& world) : above_(physics::HostAccess::body_slots(world)) {
        std::iota(above_.begin(), above_.end(), 0u);
        const auto moves = [&](physics::BodyId id) {
            return world.is_valid(id) && world.body(id).type() == physics::BodyType::dynamic_body;
        };
        for (const physics::Contact& contact : world.contacts())
            if (moves(contact.body_a) && moves(contact.body_b))
                join(contact.body_a.index, contact.body_b.index);
        for (const physics::Joint& joint : world.joints()) {
            const physics::Body a = joint.body_a(), b = joint.body_b();
            if (a && b && !joint.dormant() && joint.enabled() && !joint.broken() && moves(a.id()) &&
                moves(b.id()))
                join(a.index(), b.index());
        }
    }
    /// The same number for all bodies of an island.
    std::uint32_t of(std::uint32_t body) {
        while (above_[body] != body) body = above_[body] = above_[above_[body]];
        return body;
    }

  private:
    /// The smaller slot is the number, so that an island keeps its color while it grows.
    void join(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t x = of(a), y = of(b);
        above_[std::max(x, y)] = std::min(x, y);
    }
    std::vector<std::uint32_t> above_;
};

/// Colors of consecutive numbers are far apart.
Color color_of(std::uint32_t number, float opacity) {
    const double hue = std::fmod(number * 0.618033988749895, 1.0) * 6;
    const auto channel = [&](double shift) {
        const double k = std::fmod(hue + shift, 6);
        return static_cast<float>(1 - 0.75 * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
    };
    return {channel(5), channel(3), channel(1), opacity};
}

}  // namespace

void draw_islands(HostedWorld& in, Painter& painter, double alpha) {
    physics::World& world = in.world;
    Islands islands(world);
    for (const physics::Body& body : world.bodies()) {
        if (body.type() != physics::BodyType::dynamic_body) continue;
        const Frame frame(in, body.index(), alpha);
        const std::uint32_t island = islands.of(body.index());
        const bool awake = body.awake();
        const property::Paint paint{.fill = color_of(island, awake ? 0.7f : 0.35f),
                                    .border = color_of(island, awake ? 1.0f : 0.6f)};
        for (const physics::Shape& shape : body.shapes()) {
            const auto [lower, upper] = extent_of(shape, frame);
            if (painter.sees(lower, upper)) draw_form(shape, frame, paint, painter);
        }
        const Vec2 at = frame.point(body.center());
        if (!awake && painter.sees(at, at))
            painter.text(at, "z", 0.4 * painter.label_scale(), {1, 1, 1, 0.8f});
    }
}

}  // namespace fettle::physics_module
