// Overlays that know the tree: who wrote, and what formulas read.

#include <catch.h>

#include <array>
#include <ctime>
#include <set>

#include <loop/tint_painter.h>
#include <loop/wires.h>
#include <loop/writer_colors.h>

#include "game.h"
#include "noting_screen.h"

namespace overlays_test {

using namespace fettle;
using app::Game;
using property::Vec2;

namespace {

std::string writer_of(const Game& game, const std::string& path) {
    for (const app::InstanceWriter& each : app::instance_writers(game.tree, app::tick))
        if (game.tree.path(each.instance) == path) return each.writer;
    return "nobody";
}

}  // namespace

TEST_CASE("blame names the last writer of an instance") {
    Game game("game.crate = Object {}\ngame.crate.position = vec(1, 2)\ngame.empty = Object {}");
    CHECK(writer_of(game, "crate") == "script");
    CHECK(writer_of(game, "empty") == "nobody");
    // The place of each write is kept while blame is shown.
    game.set("view.show.blame", true);
    game.loop.turn();
    game.runtime.run("\ncrate.position = vec(2, 2)", "main.lua");
    CHECK(writer_of(game, "crate") == "main.lua:2");
    game.set("view.show.blame", false);
    game.loop.turn();
    game.runtime.run("\ncrate.position = vec(2, 3)", "main.lua");
    CHECK(writer_of(game, "crate") == "script");
    game.runtime.evaluate("crate.position = vec(3, 4)");
    CHECK(writer_of(game, "crate") == "console");
    {
        const property::Tree::CauseScope cause(game.tree, property::Writer::inspector);
        game.set("crate.position", Vec2(5, 6));
    }
    CHECK(writer_of(game, "crate") == "inspector");
}

TEST_CASE("blame names the writers of thousands of instances in a frame") {
    Game game(
        "for i = 1, 4000 do\n  local b = Object {}\n  game['b' .. i] = b\n"
        "  b.position = vec(i, 0)\n  b.mark = i\nend");
    game.set("view.show.blame", true);
    game.loop.turn();
    timespec begin{}, end{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &begin);
    const auto all = app::instance_writers(game.tree, app::tick);
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
    REQUIRE(all.size() >= 4000);
    CHECK(all.front().writer == "script");
    const double seconds = static_cast<double>(end.tv_sec - begin.tv_sec) +
                           1e-9 * static_cast<double>(end.tv_nsec - begin.tv_nsec);
    CHECK(seconds < 1);  // of the processor; a look at each write for each property takes minutes
}

TEST_CASE("blame says restore for writes that going back has lost") {
    Game game("game.crate = Object {}\ngame.crate.position = vec(1, 2)\ngame.crate.mark = 1");
    for (int i = 0; i < 5; ++i) game.loop.turn();
    game.runtime.evaluate("crate.position = vec(3, 4)");
    for (int i = 0; i < 5; ++i) game.loop.turn();
    CHECK(writer_of(game, "crate") == "console");
    game.runtime.evaluate("time:go_to(3)");
    game.loop.turn();
    // The script's write of the same property holds again.
    CHECK(writer_of(game, "crate") == "script");
}

TEST_CASE("blame names the writer of a child as the writer of its parent") {
    Game game;
    game.set("view.show.blame", true);
    game.loop.turn();
    game.runtime.run(
        "game.crate = Object {}\ngame.crate.position = vec(1, 2)\n"
        "game.crate.lid = Object {}\ngame.crate.lid.open = true",
        "main.lua");
    CHECK(writer_of(game, "crate") == "main.lua:4");
    CHECK(writer_of(game, "crate.lid") == "nobody");
}

TEST_CASE("blame names physics for a moved instance a second after the last other write") {
    Game game("game.crate = Object {}\ngame.crate.position = vec(1, 2)\ngame.crate.awake = true");
    CHECK(writer_of(game, "crate") == "script");
    for (int i = 0; i < 61; ++i) game.loop.turn();
    CHECK(writer_of(game, "crate") == "physics");
    game.runtime.run("crate.awake = false", "sleep");
    for (int i = 0; i < 61; ++i) game.loop.turn();
    CHECK(writer_of(game, "crate") == "script");
}

TEST_CASE("the tint of blame keeps the blend mode and the opacity of pictures") {
    struct Pictures : app::NotingPainter {
        std::vector<std::pair<property::Blend, property::Color>> all;
        void picture(const property::Picture&, const property::PictureArea&, const Vec2&,
                     const Vec2&, property::Color tint, bool) override {
            all.emplace_back(state().blend, tint);
        }
    } pictures;
    app::TintPainter tinted(pictures, {1, 0, 0, 0.75f});
    const property::Picture picture{};
    tinted.push({});
    tinted.blend(property::Blend::add);
    tinted.picture(picture, {}, Vec2(0, 0), Vec2(1, 1), {1, 1, 1, 0.25f}, true);
    tinted.pop();
    tinted.picture(picture, {}, Vec2(0, 0), Vec2(1, 1), {1, 1, 1, 1}, true);
    REQUIRE(pictures.all.size() == 2);
    CHECK(pictures.all[0].first == property::Blend::add);
    CHECK(pictures.all[0].second == property::Color{1, 0, 0, 0.25f});
    CHECK(pictures.all[1].first == property::Blend::normal);
    CHECK(pictures.all[1].second == property::Color{1, 0, 0, 1});
}

TEST_CASE("blame draws what is in a layer where the layer places it") {
    Game game;
    property::ClassDescriptor dot{.name = "Dot"};
    dot.properties = {{.name = "position", .type = property::Type::vec2}};
    dot.lifecycle.draw = [](void*, const property::Tree&, property::Handle, property::Row,
                            property::Painter& painter,
                            double) { painter.circle(Vec2(1, 0), 1, {}); };
    game.tree.define(std::move(dot));
    property::ClassDescriptor far{.name = "Far"};
    far.lifecycle.begin_below = [](void*, const property::Tree&, property::Handle, property::Row,
                                   property::Painter& painter, int pass) {
        if (pass > 1) return false;
        painter.push(property::Transform::moved({10.0 * pass, 0}));
        return true;
    };
    far.lifecycle.end_below = [](void*, const property::Tree&, property::Handle, property::Row,
                                 property::Painter& painter) { painter.pop(); };
    game.tree.define(std::move(far));
    property::ClassDescriptor plain{.name = "Plain"};
    plain.lifecycle.draw = [](void*, const property::Tree&, property::Handle, property::Row,
                              property::Painter& painter, double) {
        painter.circle(Vec2(5, 5), 1, {.fill = {0, 0, 1, 1}});
    };
    game.tree.define(std::move(plain));
    game.runtime.run(
        "game.far = Far {}\ngame.far.dot = Dot { position = vec(0, 0) }\ngame.plain = Plain {}",
        "main.lua");
    struct Circles : app::NotingPainter {
        std::vector<Vec2> centers;
        void circle(const Vec2& center, double, const property::Paint& paint) override {
            centers.push_back(transform()(center));
            if (center == Vec2(5, 5))
                CHECK(paint.fill == property::Color{0, 0, 1, 1});
            else
                CHECK(paint.fill.a == 0.75f);
        }
    } circles;
    app::WriterColors(game.tree, app::tick).draw(circles, 1);
    CHECK(circles.centers == std::vector{Vec2(1, 0), Vec2(11, 0), Vec2(5, 5)});
}

TEST_CASE("the legend of writers is in the part of the screen that layers leave free") {
    struct Covering : app::Layer {
        app::ClipRectangle free{0, 0, 0, 0};
        float size = 0;
        float text_size() const override { return size; }
        bool handle(const app::InputEvent&) override { return false; }
        void draw(app::Surface&, double) override {}
        app::ClipRectangle free_area(const app::ClipRectangle&) const override { return free; }
    } layer;
    Game game;
    game.set("view.show.blame", true);
    game.loop.turn();
    for (int line = 1; line <= 14; ++line) {
        const std::string name = "b" + std::to_string(line);
        game.runtime.run(std::string(static_cast<std::size_t>(line - 1), '\n') + "game." + name +
                             " = Object {} " + name + ".position = vec(1, 2)",
                         "a_folder_with_a_long_name/main.lua");
    }
    const auto drawn = [&] {
        app::NotingScreen screen;
        game.loop.draw(screen, 0);
        return screen.noted_surface;
    };
    const app::NotingSurface whole = drawn();
    CHECK(whole.lines.size() == 11);
    CHECK(whole.line_with("others   4") > 740);
    CHECK(whole.low <= 800);
    game.loop.add(layer);
    layer.free = {40, 300, 260, 100};
    const app::NotingSurface part = drawn();
    CHECK(part.lines.size() == 3);
    CHECK(part.line_with("…") > 300);
    CHECK(part.line_with("main.lua:") > 300);
    CHECK(part.line_with("others   12") > 300);
    CHECK(part.top >= 300);
    CHECK(part.low <= 400);
    CHECK(part.right <= 300);
    layer.free = {40, 300, 260, 40};
    CHECK(drawn().lines.empty());
    // Its texts are as high as those of the layer.
    layer.free = {0, 0, 1280, 800};
    const auto pitch = [&] {
        const app::NotingSurface screen = drawn();
        return screen.lines[1].second - screen.lines[0].second;
    };
    const float usual = pitch();
    layer.size = 30;
    CHECK(pitch() == 2 * usual);
}

TEST_CASE("the texts of overlays grow with those of the console") {
    struct Large : app::Layer {
        float text_size() const override { return 30; }
        bool handle(const app::InputEvent&) override { return false; }
        void draw(app::Surface&, double) override {}
    } layer;
    Game game;
    game.set("view.show.timings", true);
    game.loop.turn();
    const auto drawn = [&] {
        app::NotingScreen screen;
        game.loop.draw(screen, 0);
        const auto& lines = screen.noted_surface.lines;
        return std::pair(screen.noted.view.label_scale, lines[2].second - lines[1].second);
    };
    const auto [scale, pitch] = drawn();
    CHECK(scale == 1);
    game.loop.add(layer);
    CHECK(drawn() == std::pair(2.0, 2 * pitch));
}

TEST_CASE("the timings of the game are not drawn under a layer that shows them") {
    struct Covering : app::Layer {
        bool handle(const app::InputEvent&) override { return false; }
        void draw(app::Surface&, double) override {}
        app::ClipRectangle free_area(const app::ClipRectangle& whole) const override {
            return {whole.left, 100, whole.width, whole.height - 100};
        }
    } layer;
    Game game;
    game.set("view.show.timings", true);
    game.loop.turn();
    const auto lines = [&] {
        app::NotingScreen screen;
        game.loop.draw(screen, 0);
        return screen.noted_surface.lines.size();
    };
    CHECK(lines() > 0);
    game.loop.add(layer);
    CHECK(lines() == 0);
}

TEST_CASE("two writers in the legend of blame never have one color") {
    Game game("game.old = Object {}\ngame.old.position = vec(1, 2)\ngame.old.awake = true");
    game.set("view.show.blame", true);
    for (int i = 0; i < 70; ++i) game.loop.turn();
    for (int line = 1; line <= 14; ++line) {
        const std::string name = "b" + std::to_string(line);
        game.runtime.run(std::string(static_cast<std::size_t>(line - 1), '\n') + "game." + name +
                             " = Object {} " + name + ".position = vec(1, 2)",
                         "main.lua");
    }
    app::NotingSurface screen;
    app::WriterColors(game.tree, app::tick).draw_legend(screen, {0, 0, 1280, 800});
    CHECK(screen.line_with("physics   1") > 0);
    CHECK(screen.line_with("others   4") > 0);
    std::set<std::array<int, 3>> colors;
    for (const app::SurfaceColor& c : screen.fills) colors.insert({c.r, c.g, c.b});
    CHECK(screen.fills.size() == screen.lines.size() + 1);  // one is the background
    CHECK(colors.size() == screen.fills.size());
}

TEST_CASE("a wire leads from what a formula reads to what it writes") {
    Game game(
        "game.a = Object {}\ngame.a.position = vec(1, 0)\n"
        "game.b = Object {}\ngame.b.position = vec(4, 0)\ngame.b.size = 1");
    CHECK(app::wires(game.tree).empty());
    REQUIRE_FALSE(game.runtime.evaluate("b.size is a.position.x * 2 + time.step").error);
    const auto wires = app::wires(game.tree);
    REQUIRE(wires.size() == 2);
    for (const app::Wire& wire : wires) CHECK(wire.to == Vec2(4, 0));
    const app::Wire& placed = wires[0].from ? wires[0] : wires[1];
    const app::Wire& unplaced = wires[0].from ? wires[1] : wires[0];
    CHECK(placed.from == Vec2(1, 0));
    CHECK(placed.label == "a.position → b.size");
    CHECK_FALSE(unplaced.from);
    CHECK(unplaced.label == "time.step → b.size");
    game.set("b.size", 3);
    CHECK(app::wires(game.tree).empty());
}

TEST_CASE("the number of formulas with wires is limited") {
    Game game("game.a = Object {}\ngame.a.x = 1");
    for (const char* name : {"p", "q", "r"})
        game.runtime.evaluate(std::string("a.") + name + " is a.x + 1");
    CHECK(app::wires(game.tree).size() == 3);
    CHECK(app::wires(game.tree, 2).size() == 2);
}

}  // namespace overlays_test
