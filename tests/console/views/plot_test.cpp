// How a plot is drawn.

#include <imgui_internal.h>
#include <set>

#include "catch.h"
#include "observing_rig.h"

namespace plot_test {

using namespace fettle;
using console::test::ObservingRig;

TEST_CASE("the time below a plot has from two to five labels") {
    for (double seconds = 0.05; seconds < 200; seconds *= 1.01) {
        CAPTURE(seconds);
        const double labels = seconds / console::seconds_between_labels(seconds);
        CHECK(labels >= 2);
        CHECK(labels < 6);
    }
}

TEST_CASE("the labels of values beside a plot do not touch") {
    for (const float tall : {20.0f, 45.0f, 60.0f, 200.0f, 1000.0f})
        for (double span = 0.01; span < 1e4; span *= 1.37) {
            CAPTURE(tall, span);
            const double apart = console::value_between_labels(span, tall, 18);
            if (apart < span) CHECK(apart / span * static_cast<double>(tall) > 18);
        }
    CHECK(console::value_between_labels(8, 1000, 18) == Approx(2));
}

TEST_CASE("a long error leaves room for the name in the legend and is whole in the tooltip") {
    ObservingRig rig;
    rig.step(10);
    rig.run(
        "plot world.crate.mass, error(('a long reason '):rep(20)) + world.ball.mass * "
        "world.crate.mass + world.crate.position.x - world.ball.position.x");
    rig.step(2);
    REQUIRE(rig.plots().size() == 2);
    REQUIRE(rig.plots()[1].problem().size() > 200);
    rig.show();
    const auto& legend = rig.lua.state().views.plot_view.legend();
    REQUIRE(legend.size() == 2);
    const console::Rect line = legend[1].rect;
    CHECK(legend[1].name > 0.4f * (line.high.x - line.low.x));
    CHECK(legend[1].name < 0.6f * (line.high.x - line.low.x));
    const auto tooltip = [&] {
        const ImGuiWindow* const window = ImGui::FindWindowByName("##Tooltip_00");
        return window != nullptr && window->Active ? window->Size.x * window->Size.y : 0.0f;
    };
    app::InputEvent event;
    event.kind = app::EventKind::mouse_moved;
    event.x = legend[0].rect.middle().x;
    event.y = legend[0].rect.middle().y;
    rig.lua.handle(event);
    rig.show();
    const float of_mass = tooltip();
    CHECK(of_mass > 0);
    event.y = line.middle().y;
    rig.lua.handle(event);
    rig.show();
    CHECK(tooltip() > 4 * of_mass);
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("the legend has the value of a condition at the mouse") {
    ObservingRig rig;
    rig.step(100);
    rig.run("plot world.ball.position.x > 70");
    rig.show();
    const auto& view = rig.lua.state().views.plot_view;
    CHECK(view.legend().at(0).value == "true");
    app::InputEvent event;
    event.kind = app::EventKind::mouse_moved;
    event.x = view.area().middle().x;
    event.y = view.area().middle().y;
    rig.lua.handle(event);
    rig.show();
    CHECK(view.legend().at(0).value == "false");
}

TEST_CASE("a value has fewer digits where its name needs the room") {
    ObservingRig rig;
    rig.show();
    rig.lua.state().ui.activate();
    const property::Value value(property::Vec2(3.14159, 2.71828));
    const auto text = [&](float room) {
        return console::observed_text_in(rig.tree, value, "m", 5, room, 1000).text;
    };
    const std::string whole = text(1000);
    CHECK(whole == console::observed_text(rig.tree, value, "m", 5).text);
    const float three = console::observed_text(rig.tree, value, "m", 5, 3).place();
    CHECK(text(three) == console::observed_text(rig.tree, value, "m", 5, 3).text);
    CHECK(text(three) != whole);
    CHECK(text(5) == whole);  // the name is shortened anyway
}

TEST_CASE("a curve is interrupted where there is no value") {
    ObservingRig rig;
    rig.step(100);
    rig.run(
        "plot(function() local x = world.ball.position.x "
        "return (x < 40 or x > 60) and x or 'none' end)");
    rig.step();
    rig.show();
    const console::Rect area = rig.lua.state().views.plot_view.area();
    const auto curve_at = [&](float share) {
        const auto wide = static_cast<std::size_t>(rig.surface.width());
        const auto x = static_cast<std::size_t>(area.low.x + share * (area.high.x - area.low.x));
        int bright = 0;
        for (auto y = static_cast<std::size_t>(area.low.y);
             y < static_cast<std::size_t>(area.high.y); ++y) {
            const auto& pixel = rig.surface.pixels()[y * wide + x];
            if (std::max({pixel[0], pixel[1], pixel[2]}) > 150) ++bright;
        }
        return bright;
    };
    CHECK(curve_at(0.25f) > 0);
    CHECK(curve_at(0.5f) == 0);
    CHECK(curve_at(0.75f) > 0);
}

TEST_CASE("the legend of a plot does not move while values change and has no blanks in them") {
    ObservingRig rig;
    rig.run("plot world.ball.position, world.crate.mass");
    std::set<float> names;
    for (const double x : {0.0, -0.5, 12.3456, -1.23456, 0.00012, 100.0}) {
        property::set(rig.tree, "world.ball.position", property::Value(property::Vec2(x, -x)));
        rig.step(1);
        rig.show();
        const auto& line = rig.lua.state().views.plot_view.legend().at(0);
        CHECK(line.value.find("( ") == std::string::npos);
        CHECK(line.value.find("  ") == std::string::npos);
        names.insert(line.name);
    }
    CHECK(names.size() == 1);
}

bool are_apart(const console::Rect& a, const console::Rect& b) {
    return a.high.x <= b.low.x || b.high.x <= a.low.x || a.high.y <= b.low.y || b.high.y <= a.low.y;
}

TEST_CASE("the upper edge of a plot is dragged to another height, which is kept") {
    ObservingRig rig;
    rig.step(10);
    rig.run("plot world.ball.position.x");
    rig.show();
    auto& state = rig.lua.state();
    const auto height = [&] {
        const console::Rect rect = state.views.plot_view.rect();
        return rect.high.y - rect.low.y;
    };
    const float before = height();
    const ImVec2 edge = state.screen.plot_edge.middle();
    REQUIRE(edge.y > 0);
    const auto event = [&](app::EventKind kind, float y) {
        app::InputEvent made;
        made.kind = kind;
        made.x = edge.x;
        made.y = y;
        if (kind != app::EventKind::mouse_moved) made.name = "left";
        CHECK(rig.lua.handle(made));
        rig.show();
    };
    event(app::EventKind::mouse_moved, edge.y);
    event(app::EventKind::mouse_pressed, edge.y);
    for (float y = edge.y; y >= edge.y - 60; y -= 10) event(app::EventKind::mouse_moved, y);
    event(app::EventKind::mouse_released, edge.y - 60);
    CHECK(std::abs(height() - before - 60) < 10);
    CHECK(state.settings.number("plot_height") > 0);
    // It never covers the panel.
    state.settings.set("plot_height", property::Value(4000));
    rig.show();
    CHECK(state.views.plot_view.rect().low.y >= state.screen.panel_rect.high.y);
}

TEST_CASE("beside a plot and a watch list there is room for the inspector") {
    struct Case {
        unsigned width, height;
        double scale;
    };
    const auto [width, height, scale] =
        GENERATE(Case{1280, 800, 2.0}, Case{1280, 800, 1.0}, Case{640, 700, 1.0},
                 Case{400, 700, 1.0}, Case{400, 900, 1.0}, Case{3840, 2160, 4.0});
    INFO(width << " x " << height << ", scale " << scale);
    ObservingRig rig;
    rig.lua.state().settings.set("scale", property::Value(scale));
    rig.step(10);
    rig.run("plot world.ball.position");
    rig.run("pin world.ball.position");
    rig.lua.state().choose(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    console::test::RasterSurface window(width, height);
    for (int i = 0; i < 4; ++i) rig.lua.draw(window, 1.0 / 60);
    const auto& state = rig.lua.state();
    const console::Rect inspector = state.screen.inspector_rect;
    const float em = static_cast<float>(15 * scale);
    REQUIRE_FALSE(inspector.empty());
    CHECK(inspector.high.x - inspector.low.x >= 14.9f * em);
    CHECK(inspector.high.y - inspector.low.y >= 12 * em);
    CHECK(inspector.high.y <= static_cast<float>(height));
    for (const console::Rect& other :
         {state.screen.panel_rect, state.views.plot_view.rect(), state.views.watch_list.rect(),
          state.views.time_bar.rect()}) {
        if (other.empty()) continue;
        CHECK(are_apart(other, inspector));
    }
}

TEST_CASE("in a low window no view at the lower edge covers the prompt") {
    const unsigned height = GENERATE(60u, 120u, 180u, 240u, 300u, 400u, 500u);
    const bool overlays = GENERATE(false, true);
    INFO("400 x " << height << ", overlays " << overlays);
    ObservingRig rig;
    rig.lua.state().settings.set("overlays", property::Value(overlays));
    rig.step(10);
    rig.run("plot world.ball.position");
    rig.run("pin world.ball.position");
    rig.lua.state().choose(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    console::test::RasterSurface window(400, height);
    for (int i = 0; i < 4; ++i) rig.lua.draw(window, 1.0 / 60);
    const auto& state = rig.lua.state();
    std::vector<console::Rect> shown{state.screen.panel_rect};
    for (const console::Rect& each :
         {state.screen.inspector_rect, state.views.plot_view.rect(), state.views.watch_list.rect()})
        if (!each.empty()) shown.push_back(each);
    for (std::size_t i = 0; i < shown.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            CHECK((shown[i].high.y <= shown[k].low.y || shown[k].high.y <= shown[i].low.y));
    CHECK(state.views.plot_view.rect().empty() == (height < 300));
}

TEST_CASE("the console leaves room for the legend of writers beside what it observes") {
    struct Case {
        unsigned width, height;
        double scale;
    };
    const auto [width, height, scale] =
        GENERATE(Case{1280, 800, 2.0}, Case{1280, 800, 1.0}, Case{640, 700, 1.0},
                 Case{400, 700, 1.0}, Case{400, 700, 2.0}, Case{3840, 2160, 4.0});
    const bool selected = GENERATE(false, true);
    INFO(width << " x " << height << ", scale " << scale << ", selected " << selected);
    ObservingRig rig;
    property::ClassDescriptor show;
    show.name = "Show";
    show.properties = {
        {.name = "blame", .type = property::Type::boolean, .default_value = property::Value(true)}};
    property::ClassDescriptor view;
    view.name = "View";
    property::Tree& tree = rig.tree;
    const property::Handle of = tree.create(tree.define(std::move(view)), tree.root(), "view");
    tree.create(tree.define(std::move(show)), of, "show");
    rig.lua.state().settings.set("scale", property::Value(scale));
    rig.step(10);
    rig.run("pin world.ball.position");
    if (selected) rig.lua.state().choose(tree.child(tree.child(tree.root(), "world"), "ball"));
    console::test::RasterSurface window(width, height);
    for (int i = 0; i < 4; ++i) rig.lua.draw(window, 1.0 / 60);
    const auto& state = rig.lua.state();
    const app::ClipRectangle whole{0, 0, window.width(), window.height()};
    const app::ClipRectangle room = rig.lua.free_area(whole);
    CHECK(room.width >= 200);
    CHECK(room.height >= 72);
    for (const console::Rect& other :
         {state.screen.panel_rect, state.screen.inspector_rect, state.views.watch_list.rect(),
          state.views.time_bar.rect()}) {
        if (other.empty()) continue;
        CHECK(are_apart(other, {ImVec2(room.left, room.top),
                                ImVec2(room.left + room.width, room.top + room.height)}));
    }
    rig.lua.open(false);
    CHECK(rig.lua.free_area(whole).height == whole.height);
}

TEST_CASE("the labels of a plot of tiny values differ") {
    for (const double most : {1e-6, 3e-6, 9e-6}) {
        const auto [low, high] = console::shown_range(0.2e-6, most);
        const double apart = console::value_between_labels(high - low, 100, 18);
        INFO(most);
        CHECK(apart >= 1e-6);
        CHECK((low < 0.2e-6 && high > most));
    }
    const auto [low, high] = console::shown_range(0, 0);
    CHECK((low < -0.5 && high > 0.5));
}

TEST_CASE("a plot of how long frames take begins with the present ones") {
    ObservingRig rig;
    rig.step(100);
    rig.run("plot time.timings.modules * 1000, world.ball.position.x");
    REQUIRE(rig.plots().size() == 2);
    CHECK(rig.plots()[0].samples().size() <= 1);
    CHECK(rig.plots()[1].samples().front().step == 0);
}

}  // namespace plot_test
