// The figures of the pen: where their points are, in the world and on the screen.

#include <cmath>
#include <numbers>

#include <fettle/property/painter.h>

#include "stage.h"

namespace pen_figures_test {

using fettle::property::Paint;
using stage::Stage;
using stage::Vec2;

namespace {

/// What was drawn last of each kind.
struct Figures : fettle::property::Painter {
    std::vector<Vec2> polygon_points;
    double rounding = 0, angle = 0, radius = 0;
    Vec2 radii{0, 0};
    int polygons = 0, circles = 0, lines = 0;
    std::vector<std::uint64_t> wholes;

    void circle(const Vec2&, double r, const Paint&) override { radius = r, ++circles; }
    void ellipse(const Vec2&, const Vec2& half, double turned, const Paint&) override {
        radii = half;
        angle = turned;
    }
    void polygon(std::span<const Vec2> v, double round, const Paint&) override {
        polygon_points.assign(v.begin(), v.end());
        rounding = round;
        ++polygons;
    }
    void line(const Vec2&, const Vec2&, stage::Color, float) override { ++lines; }
    void point(const Vec2&, stage::Color, float) override {}
    void text(const Vec2&, std::string_view, double, stage::Color,
              fettle::property::TextAlign) override {}
    void part_of(std::uint64_t whole) override { wholes.push_back(whole); }
    bool shows(fettle::property::Overlay) const override { return false; }
    bool sees(const Vec2&, const Vec2&) const override { return true; }
    void begin_screen() override { push_screen(); }
    void end_screen() override { pop(); }
};

struct Drawn : Stage {
    /// What the pen draws; a failed check with the error if it draws nothing.
    Figures draw(const std::string& calls) {
        Figures figures;
        run("function draw(pen) " + calls + " end");
        const bool ok = runtime->draw(figures);
        INFO((errors.empty() ? std::string() : errors.back().message));
        CHECK(ok);
        return figures;
    }
    std::string refusal(const std::string& call) {
        Figures figures;
        run("function draw(pen) " + call + " end");
        CHECK_FALSE(runtime->draw(figures));
        return errors.back().message;
    }
};

bool near(const Vec2& a, const Vec2& b) {
    return (a - b).length() < 1e-9;
}

}  // namespace

TEST_CASE("an angle of a figure is counter-clockwise as seen in the world and on the screen") {
    Drawn s;
    const double c = std::cos(0.5), n = std::sin(0.5);
    const Figures world = s.draw("pen.box(vec(0, 0), 4, 0, nil, nil, nil, 0.5)");
    CHECK(near(world.polygon_points[1], {2 * c, 2 * n}));
    const Figures screen =
        s.draw("pen.screen(function() pen.box(vec(0, 0), 4, 0, nil, nil, nil, 0.5) end)");
    CHECK(near(screen.polygon_points[1], {2 * c, -2 * n}));
    CHECK(s.draw("pen.ellipse(vec(0, 0), 4, 2, nil, nil, nil, 0.5)").angle == 0.5);
    CHECK(s.draw("pen.screen(function() pen.ellipse(vec(0, 0), 4, 2, nil, nil, nil, 0.5) end)")
              .angle == -0.5);
    const Figures pie = s.draw("pen.screen(function() pen.pie(vec(0, 0), 2, 0, deg(90)) end)");
    CHECK(near(pie.polygon_points.front(), {2, 0}));
    CHECK(near(pie.polygon_points[pie.polygon_points.size() - 2], {0, -2}));
    CHECK(near(pie.polygon_points.back(), {0, 0}));
}

TEST_CASE("a box has round corners and is as large as without them") {
    Drawn s;
    const Figures box = s.draw("pen.box(vec(0, 0), 6, 4, 'gold', nil, nil, 0, 0.5)");
    CHECK(box.rounding == 0.5);
    CHECK(near(box.polygon_points[0], {-2.5, -1.5}));
    // No rounder than the box allows.
    const Figures pill = s.draw("pen.box(vec(0, 0), 6, 4, 'gold', nil, nil, 0, 50)");
    CHECK(pill.rounding == 2);
    CHECK(near(pill.polygon_points[0], {-1, 0}));
    CHECK(s.draw("pen.ellipse(vec(0, 0), 4, 2)").radii == Vec2(2, 1));
}

TEST_CASE("a whole pie is a circle and an empty one is nothing") {
    Drawn s;
    CHECK(s.draw("pen.pie(vec(0, 0), 2, 1, 1 + deg(360))").circles == 1);
    CHECK(s.draw("pen.pie(vec(0, 0), 2, 1, 1 - deg(800))").circles == 1);
    const Figures empty = s.draw("pen.pie(vec(0, 0), 2, 1, 1)");
    CHECK(empty.circles + empty.polygons == 0);
}

TEST_CASE("lines through several points and arcs are one figure") {
    Drawn s;
    const Figures thin = s.draw("pen.line({ vec(0, 0), vec(1, 0), vec(1, 1) })");
    CHECK(thin.lines == 2);
    CHECK(thin.wholes == std::vector<std::uint64_t>{~std::uint64_t{0}, 0});
    const Figures thick = s.draw("pen.line({ vec(0, 0), vec(1, 0), vec(1, 1) }, 'red', 6)");
    CHECK(thick.polygons == 2);
    CHECK(thick.rounding == 3);
    CHECK(s.draw("pen.line(vec(0, 0), vec(1, 1), 'red', 6)").lines == 1);
    const Figures arc = s.draw("pen.arc(vec(0, 0), 2, 0, deg(90), 'red', 6)");
    CHECK(near(arc.polygon_points.back(), {0, 2}));
    CHECK(s.draw("pen.arc(vec(0, 0), 1e9, 0, 1e9)").lines < 1000);
    // A list of a property, too.
    s.run("state('way', { vec(0, 0), vec(1, 0) })");
    CHECK(s.draw("pen.line(way, 'red')").lines == 1);
}

TEST_CASE("figures of the pen refuse what they cannot draw") {
    Drawn s;
    CHECK_THAT(s.refusal("pen.line({ vec(0, 0) })"),
               contains("pen.line: needs a list of two or more vec"));
    CHECK_THAT(s.refusal("pen.line({ vec(0, 0), 3 })"), contains("pen.line: needs a list of vec"));
    CHECK_THAT(s.refusal("pen.polygon({ vec(0, 0), vec(1, 1) })"),
               contains("pen.polygon: needs a list of three or more vec"));
    CHECK_THAT(s.refusal("pen.pie(vec(0, 0), -1, 0, 1)"), contains("-1 is not a radius"));
    CHECK_THAT(s.refusal("pen.arc(vec(0, 0), 1, 0, 0/0)"), contains("cannot be drawn"));
    CHECK_THAT(s.refusal("pen.box(vec(0, 0), 1, 1, nil, nil, nil, 0, -1)"),
               contains("-1 is not a rounding"));
    CHECK_THAT(s.refusal("pen.sector(vec(0, 0), 1)"),
               contains("pen has no sector (did you mean \"pie\"?)"));
    CHECK_THAT(s.refusal("pen.elipse(vec(0, 0), 1)"), contains("(did you mean \"ellipse\"?)"));
}

}  // namespace pen_figures_test
