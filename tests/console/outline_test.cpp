// The line round what is selected.

#include <catch.h>

#include <cmath>

#include <fettle/property/drawing.h>

#include "rig.h"

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Vec2;

namespace {

/// Draws a disc of a metre's radius that has come from (0, 0) to (4, 0) in the last step, beside
/// it what the section adds.
void draw_ghost(void*, const property::Tree&, Handle, property::Row, property::Painter& painter,
                double alpha) {
    painter.circle(Vec2(4 * alpha, 0), 1, {});
    painter.ellipse(Vec2(4 * alpha, 3), Vec2(2, 0.5), 0, {});
    painter.polygon(std::array{Vec2(4 * alpha - 1, -3), Vec2(4 * alpha + 1, -3)}, 0.5, {});
}

struct Haunted : Rig {
    Handle ghost;

    Haunted() {
        property::ClassDescriptor descriptor;
        descriptor.name = "Ghost";
        descriptor.properties = {{.name = "position", .type = property::Type::vec2}};
        descriptor.lifecycle.draw = draw_ghost;
        ghost = tree.create(tree.define(descriptor), tree.root(), "ghost");
        key("grave");
        console.select(ghost);
    }
    /// Whether there is a line at a point of the world, in the color of what is selected.
    bool lined(const Vec2& world) {
        const Vec2 p = state().options.to_pixels(world);
        const auto& pixels = surface.pixels();
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const auto at = static_cast<std::size_t>(std::lround(p.y()) + y) * 1280 +
                                static_cast<std::size_t>(std::lround(p.x()) + x);
                const auto& pixel = pixels.at(at);
                if (pixel[0] > 180 && pixel[2] < 120) return true;
            }
        return false;
    }
};

}  // namespace

TEST_CASE_METHOD(Haunted, "the line round what is selected is where the picture shows it") {
    const double alpha = GENERATE(0.0, 0.5, 1.0);
    {
        const property::Drawing drawing(alpha);
        draw(3);
    }
    save("selected_ghost");
    const double x = 4 * alpha;
    for (const Vec2& rim : {Vec2(x + 1, 0), Vec2(x - 1, 0), Vec2(x, 1), Vec2(x, -1)})
        CHECK(lined(rim));
    CHECK(lined({x + 2, 3}));
    CHECK(lined({x, 3.5}));
    // A line with a rounding: half a metre off its ends and sides.
    CHECK(lined({x + 1.5, -3}));
    CHECK(lined({x, -3.5}));
    CHECK_FALSE(lined({x + 2, 0}));
}
