#pragma once
// A game with widgets and without a window, and a painter that records the boxes and the letters
// that it is asked to draw.

#include <catch.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/app/loop.h>
#include <fettle/app/services.h>
#include <fettle/interface/interface.h>
#include <fettle/property/error.h>
#include <fettle/property/path.h>
#include <fettle/script/runtime.h>
#include <fettle/visuals/visuals.h>

namespace fettle::interface::test {

using namespace fettle::property;
using app::EventKind;

class Paper : public Painter {
  public:
    void circle(const Vec2& center, double, const Paint&) override { note(center); }
    void ellipse(const Vec2& center, const Vec2&, double, const Paint&) override { note(center); }
    void polygon(std::span<const Vec2> v, double, const Paint& paint) override {
        for (const Vec2& each : v) note(each);
        polygons.push_back(paint);
    }
    void line(const Vec2& a, const Vec2& b, Color, float) override { note(a), note(b); }
    void point(const Vec2& at, Color, float) override { note(at); }
    void text(const Vec2& at, std::string_view, double, Color, TextAlign) override { note(at); }
    void picture(const property::Picture& picture, const PictureArea&, const Vec2& lower,
                 const Vec2&, Color, bool) override {
        note(lower);
        ++pictures_drawn;
        pictures.push_back({&picture, transform()(lower)});
    }
    void part_of(std::uint64_t) override {}
    bool shows(Overlay) const override { return false; }
    bool sees(const Vec2&, const Vec2&) const override { return true; }
    void begin_screen() override { push_screen(); }
    void end_screen() override { pop(); }
    double pixels_per_unit() const override { return transform().scale(); }

    int drawn = 0, pictures_drawn = 0;
    bool finite = true;
    std::vector<Paint> polygons{};  // boxes, and rings around widgets
    struct Placed {
        const property::Picture* picture;
        Vec2 lower;
        bool operator==(const Placed&) const = default;
    };
    std::vector<Placed> pictures{};  // letters are pictures, too

  private:
    void note(const Vec2& at) {
        ++drawn;
        finite = finite && transform()(at).is_finite();
    }
};

struct Screen {
    visuals::Visuals visuals{nullptr};
    Interface interface { visuals.media() };
    Tree tree;
    app::Services services{tree};
    script::Runtime runtime{tree, {}};
    app::Loop loop{tree, runtime, services};
    std::vector<std::string> printed, problems, errors;

    explicit Screen(std::string_view script = {}) {
        visuals.attach(tree);
        interface.attach(tree);
        services.input.set_foreground(&interface);
        services.view.screen = {1280, 720};
        loop.add({.name = "interface",
                  .step = [this](double dt) { interface.step(dt); },
                  .report = [this] { interface.report(tree); },
                  .hash = [this] { return interface.hash(); }});
        interface.on_problem([this](const std::string& line) { problems.push_back(line); });
        runtime.on_print([this](std::string_view text) { printed.emplace_back(text); });
        runtime.on_error(
            [this](const script::ScriptError& error) { errors.push_back(error.message); });
        if (!script.empty()) run(script);
        turn();
    }
    void run(std::string_view script) {
        INFO(script);
        const bool ok = runtime.run(script, "test");
        INFO((errors.empty() ? std::string() : errors.back()));
        CHECK(ok);
    }
    void turn(int count = 1) {
        for (int i = 0; i < count; ++i) loop.turn();
    }
    Value get(std::string_view path) const { return property::get(tree, path); }
    void set(std::string_view path, const Value& value) { property::set(tree, path, value); }
    Handle at(std::string_view path) const { return resolve(tree, path).instance; }
    /// Text printed since the last call; lines are joined by blanks.
    std::string new_output() {
        std::string all;
        for (const std::string& line : printed) all += (all.empty() ? "" : " ") + line;
        printed.clear();
        return all;
    }
    void tap(const std::string& key) {
        set("input.keys." + key, true);
        turn();
        set("input.keys." + key, false);
        turn();
    }
    void point(const Vec2& pixels) { set("input.mouse.screen", pixels); }
    Vec2 middle(const std::string& path) const {
        return get(path + ".screen_position").vec2() + 0.5 * get(path + ".screen_size").vec2();
    }
    void click(const std::string& path) { click(middle(path)); }
    void click(const Vec2& pixels) {
        point(pixels);
        set("input.mouse.left", true);
        turn();
        set("input.mouse.left", false);
        turn();
    }
    void type(std::u32string_view text) {
        for (const char32_t c : text) {
            app::InputEvent event;
            event.kind = EventKind::text;
            event.character = c;
            loop.handle(event);
        }
        turn();
    }
    Paper draw() {
        Paper paper;
        interface.draw(paper);
        CHECK(paper.pushed() == 0);
        CHECK(paper.finite);
        return paper;
    }
    std::string focus() const {
        const Handle now = get("interface.focus").reference();
        return tree.alive(now) ? tree.path(now) : "";
    }
};

}  // namespace fettle::interface::test
