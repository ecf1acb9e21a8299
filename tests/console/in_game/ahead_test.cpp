// Ghosts of later poses, the row of overlays, the times of frames.

#include <algorithm>

#include "catch.h"
#include "rig.h"

namespace ahead_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

const std::vector<property::Field> ghost_fields = {
    {"body", Type::reference, "", ""},
    {.name = "points", .type = Type::list, .element = Type::vec2},
    {"angle", Type::number, "", ""}};

/// A game with an instance that predicts the way of `world.ball`: its position, and a point to the
/// right for each second.
struct AheadRig : Rig {
    app::FrameLog log;
    int predictions = 0;

    AheadRig() {
        property::Method ghosts;
        ghosts.name = "ghosts";
        ghosts.parameters = {{"seconds", Type::number}};
        ghosts.required = 1;
        ghosts.returns = ghost_fields;
        ghosts.many = true;
        ghosts.effect = property::Effect::nothing;
        ghosts.context = this;
        ghosts.call = [](void* self, property::Tree& of, Handle, property::Row,
                         std::span<const Value> arguments) -> property::Result {
            auto& rig = *static_cast<AheadRig*>(self);
            ++rig.predictions;
            const Vec2 from = rig.value("world.ball.position").vec2();
            property::List points;
            for (int i = 0; i <= static_cast<int>(arguments[0].number()); ++i)
                points.emplace_back(Vec2(from.x + 2 * i, from.y));
            const Handle ball = of.child(of.child(of.root(), "world"), "ball");
            return std::vector<property::Record>{
                {&ghost_fields, {ball, Value(std::move(points)), 0.0}}};
        };
        property::ClassDescriptor seer;
        seer.name = "Seer";
        seer.methods = {ghosts};
        tree.create(tree.define(std::move(seer)), tree.root(), "seer");
        property::ClassDescriptor show;
        show.name = "Show";
        show.snapshots = property::Snapshots::never;
        for (const char* name : {"contacts", "onion_skins", "timings"})
            show.properties.push_back({.name = name,
                                       .type = Type::boolean,
                                       .default_value = Value(false),
                                       .doc = "An overlay.",
                                       .transient = true});
        property::ClassDescriptor view;
        view.name = "View";
        const Handle of = tree.create(tree.define(std::move(view)), tree.root(), "view");
        tree.create(tree.define(std::move(show)), of, "show");
        state().options.frames = &log;
        key("grave");
        draw(2);
    }
    void pause(bool paused) {
        const property::Tree::CauseScope cause(tree, property::Writer::module);
        property::set(tree, "time.paused", Value(paused));
        console.between_frames();
    }
    void edit(const char* path, const Value& to, property::Writer writer) {
        {
            const property::Tree::CauseScope cause(tree, writer);
            property::set(tree, path, to);
        }
        draw();
    }
    const auto& ghosts() { return state().ghosts.ghosts(); }
    /// Number of pixels with the color of ghosts and later poses near a point of the world.
    int faint(const Vec2& world, int reach = 2) {
        const Vec2 p = state().options.to_pixels(world);
        int count = 0;
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const auto& pixel =
                    surface.pixels().at(static_cast<std::size_t>(std::lround(p.y) + y) * 1280 +
                                        static_cast<std::size_t>(std::lround(p.x) + x));
                count += pixel[1] > pixel[0] + 20;
            }
        return count;
    }
};

}  // namespace

// --- Ghosts

TEST_CASE_METHOD(AheadRig, "an edit of a paused game shows what will move") {
    edit("world.ball.mass", 2.0, property::Writer::inspector);
    CHECK(predictions == 0);  // the game runs
    pause(true);
    draw(3);
    CHECK(predictions == 0);  // nothing was edited
    edit("world.ball.mass", 3.0, property::Writer::inspector);
    REQUIRE(ghosts().size() == 1);
    CHECK(ghosts()[0].points.size() == 3);  // console.ghost_time is 2
    CHECK(predictions == 1);
    draw(3);
    CHECK(predictions == 1);  // once for each edit
    CHECK(faint({1, -4}) > 0);
    CHECK(faint({3, -4}) > 0);
    CHECK(faint({5, -4}) == 0);
    save("ghosts");
    edit("world.ball.position", Vec2(0, -6), property::Writer::console);
    CHECK(predictions == 2);
    CHECK(faint({1, -4}) == 0);
    CHECK(faint({1, -6}) > 0);
}

TEST_CASE_METHOD(AheadRig, "ghosts end when the game goes on or goes to another step") {
    pause(true);
    draw();
    edit("world.ball.mass", 3.0, property::Writer::inspector);
    REQUIRE_FALSE(ghosts().empty());
    SECTION("the game goes on") {
        pause(false);
        draw();
        CHECK(ghosts().empty());
    }
    SECTION("the console closes") {
        key("grave");
        draw();
        CHECK(ghosts().empty());
    }
    SECTION("they are switched off") {
        edit("console.ghosts", false, property::Writer::console);
        console.between_frames();
        CHECK(ghosts().empty());
        edit("world.ball.mass", 4.0, property::Writer::inspector);
        CHECK(ghosts().empty());
    }
    SECTION("a snapshot is restored") {
        tree.restore(tree.snapshot());
        draw();
        CHECK(ghosts().empty());
    }
}

TEST_CASE_METHOD(AheadRig, "only edits of persons show ghosts") {
    pause(true);
    draw();
    edit("world.ball.mass", 3.0, property::Writer::script);
    edit("world.ball.position", Vec2(1, -4), property::Writer::simulation);
    edit("view.show.contacts", true, property::Writer::console);  // no part of the game
    CHECK(predictions == 0);
    edit("world.ball.mass", 4.0, property::Writer::console);
    CHECK(predictions == 1);
    tree.undo();
    draw();
    CHECK(predictions == 2);
}

TEST_CASE_METHOD(AheadRig, "drags in the inspector show ghosts before the button is released") {
    pause(true);
    console.select(tree.child(tree.child(tree.root(), "world"), "ball"));
    const ImVec2 at = widget("mass");
    move(at.x, at.y);
    button(true, at.x, at.y);
    for (int i = 1; i <= 5; ++i) {
        move(at.x + 4.0f * static_cast<float>(i), at.y);
        draw();
    }
    draw();
    CHECK(predictions > 1);
    CHECK_FALSE(ghosts().empty());
    button(false, at.x + 20, at.y);
    draw();
    CHECK_FALSE(ghosts().empty());
}

// --- The row of overlays

TEST_CASE_METHOD(AheadRig, "a button of the row of overlays switches its property") {
    edit("console.overlays", true, property::Writer::console);
    draw(2);
    save("overlays");
    const auto& bar = state().views.overlay_bar;
    REQUIRE_FALSE(bar.button("contacts").empty());
    REQUIRE_FALSE(bar.button("onion_skins").empty());
    const ImVec2 at = bar.button("contacts").middle();
    const std::size_t edits = tree.history().size();
    click(at.x, at.y);
    draw(2);
    CHECK(value("view.show.contacts") == Value(true));
    CHECK(bar.lit() == 1);
    CHECK(tree.history().size() == edits);
    click(at.x, at.y);
    draw(2);
    CHECK(value("view.show.contacts") == Value(false));
}

TEST_CASE_METHOD(AheadRig, "the buttons of overlays stay inside of a narrow panel") {
    edit("console.overlays", true, property::Writer::console);
    edit("console.inspector_width", 800.0, property::Writer::console);
    draw(3);
    const auto& bar = state().views.overlay_bar;
    for (const char* name : {"contacts", "onion_skins", "timings"}) {
        CHECK_FALSE(bar.button(name).empty());
        CHECK(bar.button(name).high.x <= state().screen.panel_rect.high.x);
    }
}

TEST_CASE_METHOD(AheadRig, "overlays are icons where words need more than two rows") {
    edit("console.overlays", true, property::Writer::console);
    draw(3);
    const auto& bar = state().views.overlay_bar;
    const auto wide = [&](const char* name) {
        return bar.button(name).high.x - bar.button(name).low.x;
    };
    CHECK(wide("onion_skins") > wide("timings") + 10);
    edit("console.font_size", 40.0, property::Writer::console);
    console::test::RasterSurface small(400, 700);
    for (int i = 0; i < 3; ++i) console.draw(small, 1.0 / 60);
    CHECK(wide("onion_skins") == Approx(wide("timings")));
    CHECK(wide("timings") >= 16);
}

TEST_CASE_METHOD(AheadRig,
                 "a low panel grows by the row of overlays so that the prompt stays visible") {
    edit("console.height", 0.15, property::Writer::console);
    edit("console.scale", 2.0, property::Writer::console);
    edit("console.overlays", true, property::Writer::console);
    edit("console.inspector_width", 800.0, property::Writer::console);
    draw(3);
    const auto& bar = state().views.overlay_bar;
    const console::Rect prompt = state().views.prompt_view.rect();
    CHECK(prompt.low.y > bar.button("timings").high.y);
    CHECK(prompt.high.y <= state().screen.panel_rect.high.y);
}

TEST_CASE_METHOD(AheadRig, "in a low window the row of overlays leaves the log its last lines") {
    property::set(tree, "view.show.timings", Value(true));
    edit("console.overlays", true, property::Writer::console);
    edit("console.height", GENERATE(0.15, 0.45), property::Writer::console);
    console::test::RasterSurface small(400, 300);
    for (int i = 0; i < 3; ++i) console.draw(small, 1.0 / 60);
    const auto& bar = state().views.overlay_bar;
    const auto& lines = state().views.log_view;
    CHECK(lines.text_end().y - lines.line_height() >= bar.button("timings").high.y);
    CHECK(lines.text_end().y <= state().views.prompt_view.rect().low.y);
}

// --- Small windows

TEST_CASE_METHOD(AheadRig, "a selection does not move the views at the lower edge") {
    property::set(tree, "view.show.timings", Value(true));
    draw(3);
    const float frames = state().views.frame_view.rect().high.x;
    CHECK(frames > 0);
    state().choose(tree.child(tree.child(tree.root(), "world"), "ball"));
    draw(3);
    CHECK(state().views.frame_view.rect().high.x == frames);
}

TEST_CASE_METHOD(AheadRig, "in a narrow window without a selection the game is visible") {
    console::test::RasterSurface small(400, 700);
    for (int i = 0; i < 3; ++i) console.draw(small, 1.0 / 60);
    REQUIRE_FALSE(state().screen.inspector_rect.empty());
    CHECK(state().screen.inspector_rect.high.y < 600);
}

TEST_CASE_METHOD(AheadRig, "candidates are inside of the window at each height of the console") {
    const auto height = GENERATE(0.15, 0.45, 0.7, 1.0);
    const auto scale = GENERATE(1.0, 2.0);
    edit("console.height", height, property::Writer::console);
    edit("console.scale", scale, property::Writer::console);
    type("world.ball.");
    key("tab");
    draw(3);
    INFO(height << " " << scale);
    REQUIRE(state().prompt.menu().open());
    const console::Rect list = state().views.prompt_view.menu_rect(),
                        prompt = state().views.prompt_view.rect();
    CHECK(list.low.y >= 0);
    CHECK(list.high.y <= static_cast<float>(surface.height()));
    CHECK(list.high.y - list.low.y > 60);
    CHECK((list.low.y >= prompt.high.y || list.high.y <= prompt.low.y));
}

TEST_CASE_METHOD(AheadRig,
                 "in a narrow window the inspector is below the panel and covers nothing") {
    console::test::RasterSurface small(400, 700);
    edit("console.inspector", true, property::Writer::console);
    state().run("world.ball.mass");
    state().choose(tree.child(tree.child(tree.root(), "world"), "ball"));
    for (int i = 0; i < 3; ++i) console.draw(small, 1.0 / 60);
    const console::Rect panel = state().screen.panel_rect,
                        inspector = state().screen.inspector_rect;
    CHECK(panel.high.x - panel.low.x > 380);
    REQUIRE_FALSE(inspector.empty());
    CHECK(inspector.low.y >= panel.high.y);
    CHECK(inspector.high.y <= 700);
}

TEST_CASE_METHOD(AheadRig, "times of frames never cover the prompt") {
    for (int i = 1; i <= 50; ++i) log.add({.ms = {.scripts = 2}, .frame = i, .step = i});
    property::set(tree, "view.show.timings", Value(true));
    edit("console.scale", 2.0, property::Writer::console);
    edit("console.height", 1.0, property::Writer::console);
    draw(3);
    CHECK(state().screen.panel_rect.high.y <= state().views.frame_view.rect().low.y);
    CHECK(state().screen.panel_rect.high.y - state().screen.panel_rect.low.y > 150);
}

// --- Times of frames

TEST_CASE_METHOD(AheadRig, "no bars of frames are behind the label of the time for a frame") {
    for (int i = 1; i <= 300; ++i) {
        log.add({.ms = {.draw = 100}, .frame = i, .step = i});
        (void)log.complete(100);
    }
    property::set(tree, "view.show.timings", Value(true));
    draw(3);
    const console::Rect bars = state().views.frame_view.bars();
    const float line = bars.high.y - (bars.high.y - bars.low.y) / 100 * (1000.0f / 60);
    const auto pixel = [&](float x, float y) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(surface.width());
        return surface.pixels()[row + static_cast<std::size_t>(x)];
    };
    const console::test::Pixel well{0x0d, 0x0f, 0x14};
    CHECK(pixel(bars.low.x + 3, line - 5) == well);
    CHECK_FALSE(pixel(bars.middle().x, line - 5) == well);
}

TEST_CASE_METHOD(AheadRig, "the times of frames are shown and lead to the worst one") {
    for (int i = 1; i <= 200; ++i) {
        const double modules = i == 120 ? 30 : 3;
        log.add(
            {.ms = {.scripts = 2, .modules = modules, .draw = 1}, .frame = i, .step = 1000 + i});
        (void)log.complete(16.7);
    }
    CHECK(state().views.frame_view.rect().empty());
    property::set(tree, "view.show.timings", Value(true));
    draw(3);
    save("frame_times");
    const auto& view = state().views.frame_view;
    REQUIRE_FALSE(view.rect().empty());
    REQUIRE(view.shown());
    CHECK(view.shown()->frame == 200);
    CHECK(console::worst_frame(log)->step == 1120);
    std::int64_t went = 0;
    state().views.frame_view.go_to = [&](std::int64_t step) { went = step; };
    const ImVec2 worst = view.worst_button().middle();
    click(worst.x, worst.y);
    draw(2);
    CHECK(went == 1120);
    // It is shown until the game goes on.
    CHECK(view.shown()->frame == 120);
    log.add({.ms = {.scripts = 2}, .frame = 201, .step = 1121});
    (void)log.complete(16.7);
    draw(2);
    CHECK(view.shown()->frame == 201);
    // The newest frame is at the right end.
    const console::Rect bars = view.bars();
    const float each = (bars.high.x - bars.low.x) / 300;
    move(bars.high.x - 9.5f * each, bars.middle().y);
    draw(2);
    CHECK(view.shown()->frame == 192);
    click(bars.high.x - 9.5f * each, bars.middle().y);
    draw(2);
    CHECK(went == 1192);
    const ImVec2 close = view.close_button().middle();
    click(close.x, close.y);
    draw(2);
    CHECK(value("view.show.timings") == Value(false));
    CHECK(view.rect().empty());
}

}  // namespace ahead_test
