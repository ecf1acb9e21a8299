// Two runs side by side.

#include <algorithm>

#include "catch.h"
#include "rig.h"

#include <fettle/property/picture.h>

#include <look/theme.h>

namespace compare_test {

using namespace fettle;
using console::test::Rig;
using property::Value;
using property::Vec2;

namespace {

/// A game at step 100 in which `world.ball` moves to the right by its mass in each step.
struct CompareRig : Rig {
    std::int64_t now = 100;
    bool fails = false;

    CompareRig() {
        auto& options = state().options;
        options.review = [this](std::int64_t from, std::int64_t, const auto& visit) {
            run(from, visit);
        };
        options.repeat_with = [this](std::int64_t from, const auto& change, const auto& visit) {
            const Value before = value("world.ball.mass");
            change();
            run(from, visit);
            property::set(tree, "world.ball.mass", before);
            if (fails) throw std::runtime_error("no branch");
        };
        place(now);
        property::set(tree, "world.ball.mass", Value(1.0));
        key("grave");
        draw(2);
    }
    void place(std::int64_t step) {
        tree.set_step(static_cast<std::uint64_t>(step));
        const double mass = value("world.ball.mass").number();
        property::set(tree, "world.ball.position",
                      Value(Vec2(0.01 * mass * static_cast<double>(step), -4)));
    }
    void run(std::int64_t from, const std::function<void(std::int64_t)>& visit) {
        for (std::int64_t step = from; step <= now; ++step) {
            place(step);
            visit(step);
        }
    }
    console::Comparison& runs() { return state().comparison; }
};

/// The same, with a magenta picture of 2 m × 1 m at the place of `world.card`.
struct PictureRig : CompareRig {
    property::Picture image{2, 1, {255, 0, 255, 255, 255, 0, 255, 255}};

    PictureRig() {
        property::ClassDescriptor card{.name = "Card"};
        card.properties = {{.name = "position", .type = property::Type::vec2}};
        card.lifecycle.context = this;
        card.lifecycle.draw = [](void* rig, const property::Tree& all, property::Handle self,
                                 property::Row, property::Painter& painter, double) {
            const Vec2 at = all.get(self, "position").vec2();
            painter.picture(static_cast<PictureRig*>(rig)->image, {0, 0, 2, 1}, at - Vec2(1, 0.5),
                            at + Vec2(1, 0.5), {}, true);
        };
        tree.create(tree.define(std::move(card)), tree.child(tree.root(), "world"), "card");
    }
    std::size_t magenta() {
        return static_cast<std::size_t>(std::ranges::count_if(
            surface.pixels(), [](const auto& p) { return p[0] > 200 && p[1] < 50 && p[2] > 200; }));
    }
};

}  // namespace

TEST_CASE_METHOD(PictureRig, "both runs show the pictures of the game") {
    draw(2);
    const std::size_t before = surface.textures();
    CHECK(magenta() == 0);
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    draw(3);
    save("compare_pictures");
    CHECK(magenta() > 100);
    CHECK(surface.textures() == before + 1);
    CHECK(surface.faults() == 0);
    runs().end();
    draw(200);
    CHECK(magenta() == 0);
    CHECK(surface.textures() == before);
}

TEST_CASE_METHOD(CompareRig, "what the pictures of both runs lack has an outline") {
    property::ClassDescriptor hidden{.name = "Hidden"};
    hidden.properties = {{.name = "position", .type = property::Type::vec2}};
    hidden.lifecycle.draw = [](void*, const property::Tree& all, property::Handle self,
                               property::Row, property::Painter& painter, double) {
        if (painter.shows(property::Overlay::shapes))
            painter.circle(all.get(self, "position").vec2(), 2, {});
    };
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    draw(3);
    const std::size_t before = surface.triangle_count();
    runs().end();
    tree.create(tree.define(std::move(hidden)), tree.child(tree.root(), "world"), "hidden");
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    draw(3);
    save("compare_hidden");
    CHECK(surface.triangle_count() > before + 80);  // a dot has fewer than 40 on each side
}

namespace {

/// The same, with a disc at the place of `world.lamp` whose color depends on the mass of the ball:
/// green while it is 1.
struct LampRig : CompareRig {
    property::Handle lamp;

    LampRig() {
        property::ClassDescriptor kind{.name = "Lamp"};
        kind.properties = {{.name = "position", .type = property::Type::vec2}};
        kind.lifecycle.draw = [](void*, const property::Tree& all, property::Handle self,
                                 property::Row, property::Painter& painter, double) {
            const Value mass = property::get(all, "world.ball.mass");
            const property::Color fill =
                mass == Value(1.0) ? property::Color{0, 1, 0, 1} : property::Color{1, 0, 0, 1};
            painter.circle(all.get(self, "position").vec2(), 2, {.fill = fill, .border = fill});
        };
        lamp = tree.create(tree.define(std::move(kind)), tree.child(tree.root(), "world"), "lamp");
    }
    struct Lit {
        std::size_t green = 0, red = 0;
    };
    /// The pixels of these colors in the left or the right half of the window.
    Lit lit(bool right) {
        Lit found;
        const auto wide = static_cast<std::size_t>(surface.width());
        for (std::size_t i = 0; i < surface.pixels().size(); ++i) {
            if ((i % wide >= wide / 2) != right) continue;
            const auto& p = surface.pixels()[i];
            found.green += p[1] > 250 && p[0] < 5 && p[2] < 5;
            found.red += p[0] > 250 && p[1] < 5 && p[2] < 5;
        }
        return found;
    }
};

}  // namespace

TEST_CASE_METHOD(LampRig, "both runs show the colors and shapes of their own moments") {
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    CHECK(value("world.ball.mass") == Value(1.0));
    draw(3);
    save("compare_looks");
    CHECK(lit(false).green > 500);
    CHECK(lit(false).red == 0);
    CHECK(lit(true).red > 500);
    CHECK(lit(true).green == 0);
    CHECK(logged("world.ball by 2.00 m; 1 looks different"));
    // A lamp that is not there any more was there then.
    tree.destroy(lamp);
    draw(3);
    CHECK(lit(true).red > 500);
    CHECK(lit(false).green > 500);
}

TEST_CASE_METHOD(LampRig, "drawings that are the same at many moments are kept once") {
    runs().request_change("world.crate.mass", Value(3.0), 1);
    console.between_frames();
    const auto& a = *runs().a().back().items;
    const auto& b = *runs().b().front().items;
    REQUIRE(a.size() == b.size());
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i].drawing == b[i].drawing);
    CHECK(runs().a().back().items == runs().a().front().items);
}

TEST_CASE_METHOD(LampRig, "figures beyond the limit look as the last ones that are kept") {
    const std::size_t before = console::DrawnPast::most_figures;
    console::DrawnPast::most_figures = 1;
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    console::DrawnPast::most_figures = before;
    CHECK(runs().shown());
    draw(3);
    CHECK(surface.faults() == 0);
}

TEST_CASE_METHOD(CompareRig, "both runs show the part of the world that was seen then") {
    state().options.to_world = [this](float x, float y) {
        return Vec2((x - 640) / 40 + static_cast<double>(tree.step()), (400 - y) / 40);
    };
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    CHECK(runs().a().front().seen.center.x == Approx(40));
    CHECK(runs().a().back().seen.center.x == Approx(100));
    CHECK(runs().b().front().seen.center.x == Approx(40));
}

TEST_CASE_METHOD(PictureRig, "a picture that the game replaces is shown as it was") {
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    image.replace(2, 1, {0, 0, 0, 255, 0, 0, 0, 255});
    draw(3);
    CHECK(magenta() > 100);
    // A frame in which the comparison ends still draws what it has begun.
    const ImVec2 close = state().views.compare_view.close_button().middle();
    click(close.x, close.y);
    draw(2);
    CHECK_FALSE(runs().shown());
    CHECK(surface.faults() + magenta() == 0);
}

TEST_CASE_METHOD(PictureRig, "the pictures of both runs are drawn on a surface that changes") {
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    draw(3);
    console::test::RasterSurface other(1280, 800);
    for (int frame = 0; frame < 2; ++frame) console.draw(other, 1.0 / 60);
    CHECK(other.faults() == 0);
    CHECK(other.textures() == 2);  // that of the fonts, and the picture
}

TEST_CASE_METHOD(
    CompareRig,
    "a comparison contains the past as it was and as it would have been after a change") {
    runs().request_change("world.ball.mass", Value(3.0), 1);
    CHECK_FALSE(runs().shown());
    console.between_frames();
    REQUIRE(runs().shown());
    REQUIRE(runs().a().size() == 61);
    REQUIRE(runs().b().size() == 61);
    CHECK(runs().a().front().step == 40);
    const auto ball = tree.child(tree.child(tree.root(), "world"), "ball");
    CHECK(runs().a().back().find(ball)->position.x == Approx(1));
    CHECK(runs().b().back().find(ball)->position.x == Approx(3));
    CHECK(
        logged("ab world.ball.mass = 3 since step 40: 1 of 3 end elsewhere, world.ball by "
               "2.00 m"));
    CHECK(value("world.ball.mass") == Value(1.0));
}

TEST_CASE_METHOD(CompareRig,
                 "a comparison reports that it does not show what draw functions of scripts draw") {
    bool scripts_draw = false;
    runs().scripts_draw = [&] { return scripts_draw; };
    const auto triangles = [&] {
        draw(2);
        surface.clear();
        draw();
        return surface.triangle_count();
    };
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    CHECK_FALSE(runs().lacks_drawing());
    const std::size_t before = triangles();
    scripts_draw = true;
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    CHECK(runs().lacks_drawing());
    CHECK(triangles() > before + 40);  // two for each letter
}

TEST_CASE_METHOD(CompareRig, "neither run of a comparison contains instances in screen layers") {
    property::ClassDescriptor layer{.name = "Sheet"};
    layer.properties = {{.name = "space",
                         .type = property::Type::text,
                         .default_value = "screen",
                         .enumerators = {"world", "screen"}}};
    const auto sheet = tree.create(tree.define(std::move(layer)), tree.root(), "sheet");
    const auto world = tree.child(tree.root(), "world");
    const auto score = tree.create(tree.class_of(tree.child(world, "ball")), sheet, "score");
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    REQUIRE(runs().shown());
    CHECK(runs().a().back().find(score) == nullptr);
    property::set(tree, "sheet.space", Value("world"));
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    CHECK(runs().a().back().find(score) != nullptr);
}

TEST_CASE_METHOD(CompareRig, "both runs are shown side by side and played in a loop") {
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    draw(2);
    save("compare");
    const auto& view = state().views.compare_view;
    REQUIRE_FALSE(view.rect().empty());
    CHECK(view.shown() == 60);  // the end first
    // Nothing of the game is visible between the windows.
    surface.clear();
    draw();
    const auto pixel = [&](float x, float y) {
        return surface
            .pixels()[static_cast<std::size_t>(y) * static_cast<std::size_t>(surface.width()) +
                      static_cast<std::size_t>(x)];
    };
    CHECK(pixel(3, 400) == console::test::pixel_of(console::palette::well));
    CHECK(pixel(640, view.rect().low.y - 4) == console::test::pixel_of(console::palette::well));
    draw(80);
    CHECK(view.shown() < 60);
    const console::Rect track = view.track();
    const float middle = track.middle().x;
    move(middle, track.middle().y);
    button(true, middle, track.middle().y);
    draw(3);
    CHECK(view.shown() == 30);
    button(false, middle, track.middle().y);
    draw();
    const ImVec2 close = view.close_button().middle();
    click(close.x, close.y);
    draw(2);
    CHECK(view.rect().empty());
    CHECK_FALSE(runs().shown());
}

TEST_CASE_METHOD(CompareRig, "the pictures of two runs have room beside plots") {
    struct Size {
        unsigned width, height;
    };
    const auto [width, height] = GENERATE(Size{1280, 800}, Size{1920, 1080}, Size{400, 900});
    const std::size_t plots = GENERATE(0u, 1u, 3u);
    const bool selected = GENERATE(false, true);
    INFO(width << " x " << height << ", " << plots << " plots, selected " << selected);
    for (std::size_t i = 0; i < plots; ++i)
        state().observing.plots().emplace_back(
            script::Observed{.text = "world.ball.mass", .path = "", .unit = "kg", .value = [] {
                                 return Value(1.0);
                             }});
    if (selected) state().choose(tree.child(tree.child(tree.root(), "world"), "ball"));
    console::test::RasterSurface window(width, height);
    for (int i = 0; i < 3; ++i) console.draw(window, 1.0 / 60);
    const float before = state().screen.panel_rect.high.y;
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    for (int i = 0; i < 4; ++i) console.draw(window, 1.0 / 60);
    const console::Rect both = state().views.compare_view.rect();
    const float wanted = console::CompareView::height(
        both.high.x - both.low.x, static_cast<float>(width) / static_cast<float>(height));
    const float least = std::min(0.3f * static_cast<float>(height), wanted);
    CHECK(both.high.y - both.low.y >= least);
    std::vector<console::Rect> shown{both, state().screen.panel_rect, state().screen.inspector_rect,
                                     state().views.plot_view.rect(), state().views.time_bar.rect()};
    const auto apart = [](const console::Rect& a, const console::Rect& b) {
        return a.high.x <= b.low.x || b.high.x <= a.low.x || a.high.y <= b.low.y ||
               b.high.y <= a.low.y;
    };
    std::erase_if(shown, [](const console::Rect& each) { return each.empty(); });
    for (std::size_t i = 0; i < shown.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) CHECK(apart(shown[i], shown[k]));
    // The selection does not change the layout.
    state().choose(selected ? property::Handle{}
                            : tree.child(tree.child(tree.root(), "world"), "ball"));
    for (int i = 0; i < 3; ++i) console.draw(window, 1.0 / 60);
    const console::Rect later = state().views.compare_view.rect();
    CHECK(later.low.x == both.low.x);
    CHECK(later.high.x == both.high.x);
    CHECK(later.low.y == both.low.y);
    CHECK(later.high.y == both.high.y);
    const console::Rect curves = state().views.plot_view.area();
    if (plots > 0) CHECK(curves.high.y - curves.low.y >= 60);
    // The inspector is not beside what is below both runs.
    if (plots > 0) CHECK(state().views.plot_view.rect().high.x == both.high.x);
    runs().end();
    for (int i = 0; i < 3; ++i) console.draw(window, 1.0 / 60);
    CHECK(state().screen.panel_rect.high.y == before);
}

TEST_CASE_METHOD(CompareRig, "values that cannot be compared are refused") {
    std::string told;
    runs().on_result = [&](const std::string& line) { told = line; };
    CHECK_THROWS(runs().request_change("world.ball.mas", Value(3.0), 1));
    CHECK_THROWS(runs().request_change("world.ball", Value(3.0), 1));
    CHECK_THROWS(runs().request_change("world.ball.energy", Value(3.0), 1));
    CHECK_THROWS(runs().request_change("world.ball.mass", Value(3.0), 0));
    CHECK_THROWS(runs().request_change("world.ball.mass", Value(3.0), 1e9));
    runs().request_change("world.ball.mass", Value("heavy"), 1);
    console.between_frames();
    CHECK_FALSE(runs().shown());
    CHECK(logged("ab: "));
    CHECK(told.starts_with("✗ ab: "));
    fails = true;
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    CHECK_FALSE(runs().shown());
    CHECK(logged("ab: no branch"));
}

namespace {

/// The same game with another branch of the past, in which the mass is 3 from step 60 on.
struct TwoBranches : CompareRig {
    static inline const std::vector<property::Field> fields = {
        {.name = "name", .type = property::Type::text},
        {.name = "fork", .type = property::Type::integer},
        {.name = "newest", .type = property::Type::integer}};

    TwoBranches() {
        property::ClassDescriptor time;
        time.name = "TimeWithBranches";
        time.properties.push_back({.name = "branch",
                                   .type = property::Type::text,
                                   .default_value = Value(std::string("light"))});
        time.methods.push_back(
            {.name = "branches",
             .returns = fields,
             .many = true,
             .call = [](void*, property::Tree&, property::Handle, property::Row,
                        std::span<const Value>) -> property::Result {
                 return std::vector<property::Record>{
                     {&fields, {Value(std::string("heavy")), Value(60), Value(90)}}};
             },
             .effect = property::Effect::nothing});
        tree.destroy(tree.child(tree.root(), "time"));
        tree.create(tree.define(std::move(time)), tree.root(), "time");
        state().options.review_branch = [this](const std::string&, std::int64_t from,
                                               const auto& visit) {
            property::set(tree, "world.ball.mass", Value(3.0));
            for (std::int64_t step = from; step <= 90; ++step) {
                place(step);
                visit(step);
            }
            property::set(tree, "world.ball.mass", Value(1.0));
            place(now);
        };
    }
};

}  // namespace

TEST_CASE_METHOD(
    TwoBranches,
    "two branches are compared from the step at which they part and their differences are listed") {
    runs().request_branch("");
    console.between_frames();
    REQUIRE(runs().shown());
    CHECK(runs().a().size() == 31);
    CHECK(runs().b().size() == 31);
    CHECK(runs().a().front().step == 60);
    CHECK(runs().original() == "branch light");
    CHECK(runs().change() == "branch heavy");
    CHECK(logged("A branch light, B branch heavy since step 60: 1 of"));
    CHECK(logged("world.ball.mass: A 1 kg, B 3 kg"));
    draw(3);
    save("two_branches");
    CHECK_FALSE(state().views.compare_view.rect().empty());
    CHECK_THROWS_WITH(runs().request_branch("heawy"),
                      "compare_branch: there is no branch \"heawy\" (did you mean \"heavy\"?)");
    now = 50;
    place(now);
    runs().request_branch("heavy");
    console.between_frames();
    CHECK(logged("before the branches part"));
    CHECK_FALSE(runs().shown());
}

TEST_CASE_METHOD(CompareRig, "a comparison needs the instance at its beginning") {
    const property::Handle crate = property::get(tree, "world.crate").reference();
    bool another = GENERATE(false, true);
    const auto repeat = state().options.repeat_with;
    // At the beginning, the crate is not there; another instance may have its path.
    state().options.repeat_with = [&](std::int64_t from, const auto& change, const auto& visit) {
        tree.rename(crate, "made_later");
        const property::Handle other =
            another ? tree.create(tree.class_of(crate), tree.parent(crate), "crate")
                    : property::Handle();
        const auto back = [&] {
            if (other) tree.destroy(other);
            tree.rename(crate, "crate");
        };
        try {
            repeat(from, change, visit);
        } catch (...) {
            back();
            throw;
        }
        back();
    };
    runs().request_change("world.crate.mass", Value(3.0), 1);
    console.between_frames();
    CHECK_FALSE(runs().shown());
    INFO(log_text());
    CHECK(
        logged("ab: world.crate.mass was not yet there at the beginning, step 40: ask for fewer "
               "seconds"));
    runs().request_change("world.ball.mass", Value(3.0), 1);
    console.between_frames();
    CHECK(runs().shown());
}

}  // namespace compare_test
