// The outline of the selected instance.

#include <catch.h>

#include <cmath>
#include <stdexcept>

#include <fettle/property/drawing.h>
#include <fettle/property/picture.h>

#include "rig.h"

#include <look/pen.h>

namespace outline_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Value;
using property::Vec2;

namespace {

/// Draws a disc with radius 1 m that moved from (0, -2) to (4, -2) in the last step, an ellipse
/// below it, and a line; none of them is under a window of the console.
void draw_ghost(void*, const property::Tree&, Handle, property::Row, property::Painter& painter,
                double alpha) {
    painter.circle(Vec2(4 * alpha, -2), 1, {});
    painter.ellipse(Vec2(4 * alpha, -5), Vec2(2, 0.5), 0, {});
    painter.polygon(std::array{Vec2(4 * alpha - 1, -7.5), Vec2(4 * alpha + 1, -7.5)}, 0.5, {});
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
    /// Number of pixels with the color of the selection within `reach` pixels of a point of the
    /// world.
    int lit(const Vec2& world, int reach) {
        const Vec2 p = state().options.to_pixels(world);
        const auto& pixels = surface.pixels();
        int count = 0;
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const auto at = static_cast<std::size_t>(std::lround(p.y) + y) * 1280 +
                                static_cast<std::size_t>(std::lround(p.x) + x);
                const auto& pixel = pixels.at(at);
                if (pixel[0] > 180 && pixel[2] < 120) ++count;
            }
        return count;
    }
    bool lined(const Vec2& world) { return lit(world, 1) > 0; }
};

}  // namespace

TEST_CASE_METHOD(Haunted, "an instance has an outline while the mouse is over its path or row") {
    state().choose_all({});
    draw(3);
    CHECK_FALSE(lined({5, -2}));
    SECTION("a path in the log") {
        state().log.output("ghost.position");
        draw(2);
        const ImVec2 end = state().views.log_view.text_end();
        for (float y = 8; y < 60; y += 4)
            for (float x = 8; x < 60 && state().views.log_view.pointed_link().empty(); x += 4) {
                move(x, end.y - y);
                draw();
            }
        REQUIRE(state().views.log_view.pointed_link() == "ghost.position");
    }
    SECTION("the row that the arrow keys have reached") {
        key("ctrl+f");
        draw(3);
        type("ghost");
        draw(3);
        key("down");
    }
    draw(2);
    CHECK(lined({5, -2}));
}

TEST_CASE_METHOD(Haunted, "the outline of the selected instance is where the instance is drawn") {
    const double alpha = GENERATE(0.0, 0.5, 1.0);
    state().settings.set("inspector_width", property::Value(300));  // it covers none of them
    {
        const property::Drawing drawing(alpha);
        draw(3);
        save("selected_ghost");
    }
    const double x = 4 * alpha;
    for (const Vec2& rim : {Vec2(x + 1, -2), Vec2(x - 1, -2), Vec2(x, -1), Vec2(x, -3)})
        CHECK(lined(rim));
    CHECK(lined({x + 2, -5}));
    CHECK(lined({x, -4.5}));
    // A line with a rounding: the outline is half a meter from its ends and sides.
    CHECK(lined({x + 1.5, -7.5}));
    CHECK(lined({x, -8}));
    CHECK_FALSE(lined({x + 2, -2}));
    // The outline has the same width at the ends of the line as elsewhere.
    CHECK(std::abs(lit({x + 1, -2}, 8) - lit({x - 1, -2}, 8)) < 6);
    CHECK(std::abs(lit({x + 2, -5}, 8) - lit({x - 2, -5}, 8)) < 6);
}

TEST_CASE_METHOD(
    Haunted, "when a function of the host throws only its own part of the console is not drawn") {
    state().options.to_pixels = [](const Vec2&) -> Vec2 {
        throw std::runtime_error("no view yet");
    };
    draw(3);
    CHECK(logged("console: no view yet"));
    CHECK(log_text().find("no view yet") == log_text().rfind("no view yet"));
    // The panel and its prompt are there and work.
    type("world.ball.mass = 4");
    key("enter");
    CHECK(value("world.ball.mass") == property::Value(4.0));
    draw();
    CHECK_FALSE(state().views.prompt_view.rect().empty());
    CHECK_FALSE(state().screen.inspector_rect.empty());
    CHECK(surface.faults() == 0);
}

TEST_CASE("an instance that is hidden from the player also has an outline") {
    Haunted rig;
    property::ClassDescriptor hidden{.name = "Hidden"};
    hidden.properties = {{.name = "position", .type = property::Type::vec2}};
    hidden.lifecycle.draw = [](void*, const property::Tree&, Handle, property::Row,
                               property::Painter& painter, double) {
        if (painter.shows(property::Overlay::shapes)) painter.circle(Vec2(-4, -2), 1, {});
    };
    rig.console.select(rig.tree.create(rig.tree.define(hidden), rig.tree.root(), "hidden"));
    rig.draw();
    CHECK(rig.lined(Vec2(-3, -2)));
    CHECK(rig.lined(Vec2(-4, -1)));
    CHECK_FALSE(rig.lined(Vec2(-4, -2)));
}

namespace {

/// Draws a picture of 2 m × 1 m around its position, of which the left half is transparent.
struct Cards : Rig {
    property::Picture image{2, 1, {255, 255, 255, 0, 255, 255, 255, 255}};
    Handle card;
    int walks = 0;  // through the layer

    Cards() {
        property::ClassDescriptor descriptor;
        descriptor.name = "Card";
        descriptor.properties = {
            {.name = "position", .type = property::Type::vec2},
            {.name = "size", .type = property::Type::number, .default_value = 1.0}};
        descriptor.lifecycle.context = this;
        descriptor.lifecycle.draw = [](void* c, const property::Tree& in, Handle self,
                                       property::Row, property::Painter& painter, double) {
            const Vec2 at = property::get(in, in.path(self) + ".position").vec2();
            const double size = property::get(in, in.path(self) + ".size").number();
            painter.picture(static_cast<Cards*>(c)->image, {0, 0, 2, 1}, at - size * Vec2(1, 0.5),
                            at + size * Vec2(1, 0.5), {1, 1, 1, 1}, true);
        };
        const property::Class& made = tree.define(descriptor);
        property::ClassDescriptor shifted;
        shifted.name = "Shifted";
        shifted.lifecycle.context = this;
        shifted.lifecycle.begin_below = [](void* c, const property::Tree&, Handle, property::Row,
                                           property::Painter& painter, int pass) {
            if (pass > 0) return false;
            ++static_cast<Cards*>(c)->walks;
            painter.push(property::Transform::moved({3, 0}));
            return true;
        };
        shifted.lifecycle.end_below = [](void*, const property::Tree&, Handle, property::Row,
                                         property::Painter& painter) { painter.pop(); };
        const Handle layer = tree.create(tree.define(shifted), tree.root(), "layer");
        card = tree.create(made, layer, "card");
        tree.set(card, "position", property::Value(Vec2(0, -4)));
        key("grave");
        draw(2);
    }
    Handle clicked(const Vec2& world) {
        console.select(std::vector<Handle>{});
        const Vec2 at = state().options.to_pixels(world);
        click(static_cast<float>(at.x), static_cast<float>(at.y));
        draw(2);
        return console.selected();
    }
};

}  // namespace

TEST_CASE_METHOD(Cards, "a click selects an instance with a picture where the picture is opaque") {
    CHECK(clicked({3.5, -4}) == card);
    CHECK_FALSE(clicked({2.5, -4}));
    CHECK_FALSE(clicked({0.5, -4}));
    tree.set(card, "size", property::Value(1000.0));
    CHECK_FALSE(clicked({3.5, -4}));  // a background
}

TEST_CASE_METHOD(Cards, "the outline of a picture is where its layer places it") {
    console.select(card);
    draw(3);
    save("selected_picture");
    const auto lit = [&](const Vec2& world) {
        const Vec2 p = state().options.to_pixels(world);
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const auto& pixel =
                    surface.pixels().at(static_cast<std::size_t>(std::lround(p.y) + y) * 1280 +
                                        static_cast<std::size_t>(std::lround(p.x) + x));
                if (pixel[0] > 180 && pixel[2] < 120) return true;
            }
        return false;
    };
    for (const Vec2& side : {Vec2(2, -4), Vec2(4, -4), Vec2(3, -3.5), Vec2(3, -4.5)})
        CHECK(lit(side));
    CHECK_FALSE(lit({0, -3.5}));
    CHECK_FALSE(lit({3, -4}));
}

TEST_CASE_METHOD(
    Cards,
    "the outlines of all selected instances in a layer are found in one walk over the tree") {
    std::vector<Handle> all{card};
    for (int i = 1; i < 20; ++i) all.push_back(tree.create(tree.class_of(card), tree.parent(card)));
    console.select(all);
    draw(3);
    walks = 0;
    draw();
    CHECK(walks == 1);
}

TEST_CASE("a click selects the visible widget before instances behind it") {
    Rig rig;
    // A button of 100 by 40 pixels over a body, and the part of the tree that knows where it is.
    static constexpr float left = 300, top = 500;
    property::ClassDescriptor widget;
    widget.name = "Widget";
    const auto constant = [](const char* name, Value value) {
        return property::Property{.name = name,
                                  .type = value.type(),
                                  .default_value = value,
                                  .read_only = true,
                                  .transient = true};
    };
    widget.properties = {constant("shown", Value(true)),
                         constant("screen_position", Value(Vec2(left, top))),
                         constant("screen_size", Value(Vec2(100, 40)))};
    rig.tree.define(widget);
    const Handle button =
        rig.tree.create(rig.tree.class_named("Widget"), rig.tree.root(), "button");
    property::ClassDescriptor service;
    service.name = "Interface";
    service.methods = {{.name = "widget_at",
                        .parameters = {{"point", property::Type::vec2}},
                        .required = 1,
                        .returns = {{"widget", property::Type::reference}},
                        .call = [](void*, property::Tree& tree, Handle, property::Row,
                                   std::span<const Value> arguments) -> property::Result {
                            const Vec2 at = arguments[0].vec2() - Vec2(left, top);
                            const bool inside = at.x >= 0 && at.y >= 0 && at.x < 100 && at.y < 40;
                            return inside ? Value(tree.child(tree.root(), "button")) : Value();
                        }}};
    rig.tree.create(rig.tree.define(service), rig.tree.root(), "interface");
    const Handle ball = rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball");
    property::set(rig.tree, "world.ball.position",
                  Value(rig.state().options.to_world(left + 50, top + 20)));
    rig.key("grave");
    rig.draw(2);
    rig.click(left + 50, top + 20);
    CHECK(rig.console.selected() == button);
    // It is outlined.
    rig.draw(2);
    const auto& pixel =
        rig.surface
            .pixels()[static_cast<std::size_t>(top) * 1280 + static_cast<std::size_t>(left) + 50];
    CHECK(pixel[0] > 150);
    CHECK(pixel[2] < 130);
    // Beside it a click goes to the world.
    property::set(rig.tree, "world.ball.position",
                  Value(rig.state().options.to_world(left + 200, top + 20)));
    rig.click(left + 200, top + 20);
    CHECK(rig.console.selected() == ball);
    // The right button opens the menu of the widget.
    rig.button(true, left + 50, top + 20, "right");
    rig.button(false, left + 50, top + 20, "right");
    rig.draw(3);
    CHECK(rig.console.selected() == button);
    CHECK(rig.state().screen.popup_open);
}

TEST_CASE("no outline is drawn over what covers the game") {
    Haunted rig;
    bool covered = true;
    rig.state().options.game_covered = [&] { return covered; };
    const auto triangles = [&] {
        rig.draw(3);
        rig.surface.clear();
        rig.draw();
        return rig.surface.triangle_count();
    };
    const std::size_t without = triangles();
    covered = false;
    CHECK(triangles() > without + 20);
}

TEST_CASE_METHOD(Haunted, "no outline is drawn over what another layer covers") {
    draw(3);
    REQUIRE(lined({5, -2}));
    state().options.free_of_others = [](const app::ClipRectangle& whole) {
        return app::ClipRectangle{0, 0, whole.width, 0.5f * whole.height};
    };
    draw(3);
    CHECK_FALSE(lined({5, -2}));
}

TEST_CASE("a picture of the game is drawn as its box where the console draws the game") {
    Rig rig;
    rig.key("grave");
    rig.draw();
    ImGui::NewFrame();
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const console::ToPixels same = [](Vec2 at) { return at; };
    console::Pen outline(list, same, {});
    outline.picture({}, {}, {0, 0}, {9, 9}, {1, 1, 1, 1}, false);
    CHECK_FALSE(outline.drew_anything());  // an outline of its shape is drawn
    console::Pen as_drawn(list, same, {.as_drawn = true});
    as_drawn.picture({}, {}, {0, 0}, {9, 9}, {1, 1, 1, 0}, false);
    CHECK_FALSE(as_drawn.drew_anything());
    as_drawn.picture({}, {}, {0, 0}, {9, 9}, {1, 1, 1, 1}, false);
    CHECK(as_drawn.drew_anything());
    // A letter is drawn as its pixels: here two of its four, each a quad.
    property::Picture letter(2, 2, std::vector<std::uint8_t>(16, 0));
    letter.keep_on_pixels();
    std::vector<std::uint8_t> pixels(16, 0);
    pixels[3] = pixels[15] = 255;
    letter.replace(2, 2, pixels);
    console::Pen writing(list, same, {.as_drawn = true});
    list.Flags = ImDrawListFlags_None;
    const int before = list.VtxBuffer.Size;
    writing.picture(letter, {0, 0, 2, 2}, {10, 20}, {30, 40}, {1, 0, 0, 1}, false);
    REQUIRE(list.VtxBuffer.Size - before == 8);
    CHECK(list.VtxBuffer[before].pos.x == 10);
    CHECK(list.VtxBuffer[before].pos.y == 40);  // the world's y goes up: the first row is on top
    CHECK(list.VtxBuffer[before + 4].pos.x == 20);
    CHECK(list.VtxBuffer[before + 4].pos.y == 30);
    ImGui::EndFrame();
}

}  // namespace outline_test
