// What modules in shared objects draw.

#include <catch.h>

#include <string>
#include <utility>
#include <vector>

#include <fettle/property/painter.h>

#include "weather.h"

namespace drawing_test {

using namespace fettle;
using property::Color;
using property::Paint;
using property::Vec2;

namespace {

/// Notes texts with their heights.
struct Texts : property::Painter {
    double scale = 1;
    std::vector<std::pair<std::string, double>> noted{};

    double pixels_per_unit() const override { return 40; }
    double label_scale() const override { return scale; }
    void circle(const Vec2&, double, const Paint&) override {}
    void ellipse(const Vec2&, const Vec2&, double, const Paint&) override {}
    void polygon(std::span<const Vec2>, double, const Paint&) override {}
    void line(const Vec2&, const Vec2&, Color, float) override {}
    void point(const Vec2&, Color, float) override {}
    void text(const Vec2&, std::string_view text, double height, Color,
              property::TextAlign) override {
        noted.emplace_back(text, height);
    }
    void part_of(std::uint64_t) override {}
    bool shows(property::Overlay overlay) const override {
        return overlay == property::Overlay::names;
    }
    bool sees(const Vec2&, const Vec2&) const override { return true; }
    void begin_screen() override {}
    void end_screen() override {}
};

}  // namespace

#ifdef FETTLE_PHYSICS_PLUGIN
TEST_CASE("names that a loaded physics module draws are as large as the texts of the console") {
    module::Plugins plugins;
    property::Tree tree;
    plugins.open(FETTLE_PHYSICS_PLUGIN).attach(tree);
    const property::Handle world = tree.child(tree.root(), "world");
    tree.create(tree.class_named("Circle"), tree.create(tree.class_named("Body"), world, "ball"));
    tree.barrier();
    const auto height = [&](double scale) {
        Texts texts;
        texts.scale = scale;
        tree.draw(tree.root(), texts, 1.0);
        double highest = 0;
        for (const auto& [text, its] : texts.noted)
            if (text == "ball") highest = std::max(highest, its);
        return highest;
    };
    REQUIRE(height(1) > 0);
    CHECK(height(2) == Approx(2 * height(1)));
}
#endif

}  // namespace drawing_test
