// The pen, and the order in which scripts draw.

#include <array>

#include <fettle/property/media.h>
#include <fettle/property/painter.h>

#include "stage.h"

namespace pen_test {

using stage::Stage;

namespace {

struct Recorder : fettle::property::Painter {
    std::string log;
    std::vector<double> heights;  // of texts
    void circle(const stage::Vec2& c, double r, const fettle::property::Paint& p) override {
        log += "circle " + std::to_string(int(c.x)) + " " + std::to_string(int(r)) + " " +
               fettle::property::color_text(p.fill) + ";";
    }
    void ellipse(const stage::Vec2&, const stage::Vec2&, double,
                 const fettle::property::Paint&) override {
        log += "ellipse;";
    }
    void polygon(std::span<const stage::Vec2> v, double, const fettle::property::Paint&) override {
        log += "polygon " + std::to_string(v.size()) + ";";
    }
    void line(const stage::Vec2&, const stage::Vec2&, stage::Color, float) override {
        log += "line;";
    }
    void point(const stage::Vec2&, stage::Color, float) override { log += "point;"; }
    void text(const stage::Vec2&, std::string_view t, double height, stage::Color,
              fettle::property::TextAlign) override {
        heights.push_back(height);
        log += "text " + std::string(t) + ";";
    }
    void part_of(std::uint64_t) override {}
    bool shows(fettle::property::Overlay) const override { return false; }
    bool sees(const stage::Vec2&, const stage::Vec2&) const override { return true; }
    void begin_screen() override { log += "screen{"; }
    void end_screen() override { log += "}"; }
};

/// An image of one frame, which a tool has cut out of 8 x 4 pixels.
struct CutImage : fettle::property::Media {
    using User = fettle::property::FileUser;
    fettle::property::Picture whole;
    const fettle::property::Picture& picture(const User&, const std::string&) override {
        return whole;
    }
    fettle::property::PictureFrame frame(const User&, const std::string&,
                                         const fettle::property::ImageFrame&) override {
        return {.area = {10, 20, 2, 1}, .offset = {1, 0}, .size = {8, 4}};
    }
    void load_font(const User&, const std::string&) override {}
    bool smooth() const override { return true; }
    std::vector<double> wraps;
    std::vector<float> outlines;  // opacity
    stage::Vec2 text_size(std::string_view, const fettle::property::TextStyle& style) override {
        wraps.push_back(style.wrap);
        return {0, 0};
    }
    std::vector<double> carets(std::string_view, const fettle::property::TextStyle&) override {
        return {0};
    }
    bool right_to_left(std::string_view) override { return false; }
    void text(fettle::property::Painter&, const stage::Vec2&, std::string_view,
              const fettle::property::TextStyle& style) override {
        wraps.push_back(style.wrap);
        outlines.push_back(style.outline.a);
    }
};

/// Remembers the boxes of pictures.
struct Boxes : Recorder {
    std::vector<std::array<stage::Vec2, 2>> all;
    void begin_screen() override { push_screen(); }
    void end_screen() override { pop(); }
    void picture(const fettle::property::Picture&, const fettle::property::PictureArea&,
                 const stage::Vec2& lower, const stage::Vec2& upper, stage::Color, bool) override {
        all.push_back({transform()(lower), transform()(upper)});
    }
};

}  // namespace

TEST_CASE("the pen draws a frame that a tool has cut where it is in the uncut frame") {
    CutImage image;
    fettle::script::Options options = stage::unhurried();
    options.media = &image;
    Stage s(options);
    s.run(R"lua(
function draw(pen)
    pen.image("walk.json", vec(10, 0), 8)
    pen.image({ "walk.json", frame = 1 }, vec(0, 0), 4, 4)
    pen.screen(function() pen.image("walk.json", vec(0, 0)) end)
end
)lua");
    Boxes boxes;
    REQUIRE(s.runtime->draw(boxes));
    using stage::Vec2;
    REQUIRE(boxes.all.size() == 3);
    CHECK(boxes.all[0] == std::array{Vec2(7, 1), Vec2(9, 2)});        // y up
    CHECK(boxes.all[1] == std::array{Vec2(-1.5, 1), Vec2(-0.5, 2)});  // distorted as it is asked
    CHECK(boxes.all[2] == std::array{Vec2(-3, -2), Vec2(-1, -1)});    // pixels, y down
    s.run("function draw(pen) pen.image({ 'walk.json', fraem = 1 }, vec(0, 0)) end");
    CHECK_FALSE(s.runtime->draw(boxes));
    CHECK_THAT(s.errors.back().message,
               contains("a frame has no \"fraem\" (did you mean \"frame\"?)"));
}

TEST_CASE("a text of the pen may have a greatest width of its lines") {
    CutImage fonts;
    fettle::script::Options options = stage::unhurried();
    options.media = &fonts;
    Stage s(options);
    Recorder recorder;
    s.run(R"lua(
function draw(pen)
    pen.text(vec(0, 0), "a b", 1, "white", "left", nil, 3)
    pen.text(vec(0, 0), "a b")
    pen.text_size("a b", 1, "sans", 4)
    pen.text_size("a b")
end
)lua");
    REQUIRE(s.runtime->draw(recorder));
    CHECK(fonts.wraps == std::vector<double>{3, 0, 4, 0});
    for (const char* call : {"pen.text(vec(0, 0), 'a', 1, 'white', 'left', 'sans', -1)",
                             "pen.text_size('a', 1, 'sans', 'wide')"}) {
        INFO(call);
        s.run("function draw(pen) " + std::string(call) + " end");
        CHECK_FALSE(s.runtime->draw(recorder));
        CHECK_THAT(s.errors.back().message, contains("pen.text"));
    }
}

TEST_CASE("a text of the pen may have an outline") {
    CutImage fonts;
    fettle::script::Options options = stage::unhurried();
    options.media = &fonts;
    Stage s(options);
    Recorder recorder;
    s.run(R"lua(
function draw(pen)
    pen.text(vec(0, 0), "a", 1, "white", "left", nil, nil, "black")
    pen.text(vec(0, 0), "a", 1, "white", "left", nil, nil, false)
    pen.text(vec(0, 0), "a")
end
)lua");
    REQUIRE(s.runtime->draw(recorder));
    CHECK(fonts.outlines == std::vector<float>{1, 0, 0});
    s.run("function draw(pen) pen.text(vec(0, 0), 'a', 1, 'white', 'left', nil, nil, 'blak') end");
    CHECK_FALSE(s.runtime->draw(recorder));
    CHECK_THAT(s.errors.back().message, contains("did you mean \"black\""));
}

TEST_CASE("draw gets a pen that can be used only during the call") {
    Stage s;
    s.run(R"lua(
Ball = class("Ball", Body) {}
function Ball:draw(pen) pen.point(self.position) end
world.b = Ball {}
function draw(pen)
    kept = pen
    pen.circle(vec(1, 0), 2, "red")
    pen.box(vec(0, 0), 1, 2, nil, "white", 2, deg(45))
    pen:polygon({ vec(0, 0), vec(1, 0), vec(0, 1) }, color(1, 0, 0))
    pen.line(vec(0, 0), vec(1, 1), "white", 3)
    pen.text(vec(0, 0), 42, 1, "white")
    pen.screen(function(pen) pen.text("hi", vec(0, 0)) end)
end
)lua");
    Recorder recorder;
    CHECK(s.runtime->draw(recorder));
    CHECK(recorder.log ==
          "point;circle 1 2 #ff0000;polygon 4;polygon 3;line;text 42;screen{text hi;}");
    CHECK_THAT(s.fails("kept.circle(vec(0, 0), 1)"), contains("only while draw"));
    s.run("function draw(pen) pen.screen(function() pen.circl() end) end");
    recorder.log.clear();
    CHECK_FALSE(s.runtime->draw(recorder));
    CHECK_THAT(s.errors.back().message, contains("did you mean \"circle\""));
    CHECK_THAT(recorder.log, Catch::Matchers::EndsWith("screen{}"));
    s.run("function draw(pen) pen.circle(vec(0/0, 0), 1) end");
    CHECK_FALSE(s.runtime->draw(recorder));
}

TEST_CASE("a pen reports arguments that it cannot draw") {
    Stage s;
    Recorder recorder;
    const auto [call, reported] = GENERATE(table<std::string, std::string>({
        {"pen.circle(vec(0, 0), 1, 'golden')",
         "pen.circle: \"golden\" is not a color (did you mean \"gold\"?)"},
        {"pen.circle(0, 0, 5)", "pen.circle: needs a vec"},
        {"pen.line(0, 0, 5, 5)", "pen.line: needs a vec"},
        {"pen.point(0, 5)", "pen.point: needs a vec"},
        {"pen.rect(vec(0, 0), 1, 1)", "pen has no rect (did you mean \"box\"?)"},
        {"pen.circle(vec(0, 0), -1)", "pen.circle: -1 is not a radius, which is 0 or more"},
        {"pen.box(vec(0, 0), 1, -2)", "pen.box: -2 is not a height, which is 0 or more"},
        {"pen.box(vec(0, 0), -1, 2)", "pen.box: -1 is not a width, which is 0 or more"},
        {"pen.text(vec(0, 0), 'x', -2)", "pen.text: -2 is not a height, which is 0 or more"},
        {"pen.line(vec(0, 0), vec(1, 0), 'red', -1)",
         "pen.line: -1 is not a width in pixels, which is 0 or more"},
        {"pen.circle(vec(0, 0), 1, nil, 'red', -1)",
         "pen.circle: -1 is not a width in pixels, which is 0 or more"},
    }));
    s.run("function draw(pen) " + call + " end");
    CHECK_FALSE(s.runtime->draw(recorder));
    CHECK_THAT(s.errors.back().message, contains(reported));
    CHECK(recorder.log == "");
}

TEST_CASE("a text without a height is readable in the world and on the screen") {
    Stage s;
    s.run(
        "function draw(pen) "
        "pen.text(vec(0, 0), 'a') pen.screen(function() pen.text(vec(0, 0), 'b') end) "
        "pen.text(vec(0, 0), 'c') end");
    Recorder recorder;
    CHECK(s.runtime->draw(recorder));
    CHECK(recorder.heights == std::vector<double>{0.5, 16, 0.5});
    // The state of the pen is restored however the function ends.
    s.run(
        "function draw(pen) pcall(pen.screen, function() error('x') end) "
        "pen.text(vec(0, 0), 'a') end");
    recorder.heights.clear();
    CHECK(s.runtime->draw(recorder));
    CHECK(recorder.heights == std::vector<double>{0.5});
}

TEST_CASE("instances of scripts are drawn in the order of z between both global functions") {
    Stage s;
    s.run(R"lua(
Mark = class("Mark", Object) {}
function Mark:draw(pen) pen.text(vec(0, 0), self.name) end
world.a = Mark { z = 1 }
world.b = Mark {}
world.group = Object { z = 2, c = Mark { z = -3 } }
function draw_behind(pen) pen.text(vec(0, 0), "behind") end
function draw(pen) pen.text(vec(0, 0), "over") end
)lua");
    Recorder recorder;
    CHECK(s.runtime->draw(recorder));
    CHECK(recorder.log == "text behind;text c;text b;text a;text over;");
}

TEST_CASE("states that a pen pushes end with the function") {
    Stage s;
    s.run(R"lua(
Mark = class("Mark", Object) {}
function Mark:draw(pen) pen.push(vec(5, 0)) pen.circle(vec(1, 0), 1) pen.push() error("stop") end
world.a = Mark {}
function draw(pen)
    pen.push(vec(1, 0), 0, 2)
    pen.fade(0.5)
    pen.blend("add")
    pen.clip(vec(0, 0), vec(1, 1))
    pen.pop()
    print(pcall(pen.pop))
    pen.screen(function() pen.push(vec(1, 1)) end)
    pen.push()
end
)lua");
    Recorder recorder;
    CHECK_FALSE(s.runtime->draw(recorder));
    CHECK(recorder.pushed() == 0);
    CHECK(recorder.transform().is_identity());
    for (const char* call :
         {"pen.pop()", "pen.push('x')", "pen.push(vec(0, 0), 1/0)", "pen.fade('x')",
          "pen.blend('glow')", "pen.clip(vec(0, 0))", "pen.image(7, vec(0, 0))",
          "pen.image({ 'a.png', columns = 0 }, vec(0, 0))", "pen.image({}, vec(0, 0))",
          "pen.linear(vec(0, 0), vec(1, 0))", "pen.linear(vec(0, 0), vec(1, 0), { 'red' })",
          "pen.radial(vec(0, 0), -1, { 'red', 'blue' })", "pen.radial(vec(0, 0), 1, { 'red', {} })",
          "pen.image('a.png', vec(0, 0))", "pen.text_size('a')",
          "for i = 1, 2000 do pen.push() end"}) {
        INFO(call);
        s.run("function draw(pen) " + std::string(call) + " end");
        CHECK_FALSE(s.runtime->draw(recorder));
        CHECK_THAT(s.errors.back().message, contains("pen."));
        CHECK(recorder.pushed() == 0);
    }
}

TEST_CASE("a runtime knows whether its scripts draw by themselves") {
    Stage s;
    CHECK_FALSE(s.runtime->draws());
    s.run("Lamp = class(\"Lamp\", Body) {}");
    CHECK_FALSE(s.runtime->draws());
    s.run("function Lamp:draw(pen) end");
    CHECK(s.runtime->draws());
    Stage other;
    other.run("function draw_behind(pen) end");
    CHECK(other.runtime->draws());
}

}  // namespace pen_test
