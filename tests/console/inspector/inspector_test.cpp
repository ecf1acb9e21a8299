// The inspector, used with a mouse.

#include <bit>
#include <cstdint>
#include <limits>

#include <editing/bit_field.h>
#include <inspector/instance_tree.h>
#include "catch.h"
#include "rig.h"

namespace inspector_test {

using namespace fettle;
using console::bits_text;
using console::test::Rig;
using property::Handle;
using property::List;
using property::Value;
using property::Vec2;

namespace {

/// A rig with `world.ball` selected in the inspector.
struct BallRig : Rig {
    BallRig() {
        ball = tree.child(tree.child(tree.root(), "world"), "ball");
        key("grave");
        draw();
        console.select(ball);
        draw(3);
    }
    void drag_by(std::string_view property, float pixels, float share_x = 0.5f) {
        ImVec2 at = widget(property, share_x);
        drag(at.x, at.y, at.x + pixels, at.y);
        draw();
    }
    void replace_text(std::string_view property, std::string_view text, float share_x = 0.5f) {
        ImVec2 at = widget(property, share_x);
        click(at.x, at.y);
        draw(2);
        key("ctrl+a");
        type(text);
        key("enter");
        draw(2);
    }
    bool warns() { return state().inspector.editor().problems() > 0; }
    Handle ball;
};

}  // namespace

TEST_CASE("dragging a number edits the property") {
    BallRig rig;
    rig.drag_by("angle", 50);
    double angle = rig.value("world.ball.angle").number();
    CHECK(angle == Approx(0.5).margin(0.03));
    rig.drag_by("angle", -50);
    CHECK(rig.value("world.ball.angle").number() == Approx(0).margin(0.06));
    CHECK(rig.commands.empty());
}

TEST_CASE("a drag is recorded as an edit by the inspector") {
    BallRig rig;
    std::vector<property::Writer> writers;
    auto connection = rig.tree.watch(rig.ball, "mass", [&](const property::Change& change) {
        writers.push_back(change.cause.writer);
    });
    rig.drag_by("mass", 40);
    REQUIRE_FALSE(writers.empty());
    CHECK(writers.back() == property::Writer::inspector);
    connection.stop();
}

TEST_CASE("a drag is one step of undo") {
    BallRig rig;
    rig.drag_by("angle", 50);
    rig.drag_by("mass", 40);
    const double angle = rig.value("world.ball.angle").number();
    REQUIRE(rig.tree.history().size() == 2);
    CHECK(rig.tree.history()[0].edits == 1);
    CHECK(rig.tree.undo().name == "edit world.ball.mass");
    CHECK(rig.value("world.ball.angle").number() == angle);
    rig.tree.undo();
    CHECK(rig.value("world.ball.angle").number() == 0);
    CHECK_FALSE(rig.tree.undo().done);
}

TEST_CASE("a drag stays within the range of the property") {
    BallRig rig;
    rig.drag_by("friction", 600);
    CHECK(rig.value("world.ball.friction") == Value(1.0));
    rig.drag_by("friction", -1000);
    CHECK(rig.value("world.ball.friction") == Value(0.0));
    CHECK_FALSE(rig.warns());
    rig.drag_by("lives", 500);
    CHECK(rig.value("world.ball.lives") == Value(9));
}

TEST_CASE("a drag with shift is slower and with control even slower") {
    BallRig rig;
    auto travelled = [&](const char* modifier) {
        rig.tree.set(rig.ball, "angle", Value(0.0));
        app::InputEvent down = console::test::key_event(modifier, true);
        rig.console.handle(down);
        rig.drag_by("angle", 80);
        rig.release(modifier);
        return rig.value("world.ball.angle").number();
    };
    double plain = travelled("f9"), shift = travelled("left_shift"),
           fine = travelled("left_control");
    CHECK(plain > 0.7);
    // From the first pixel on, also before it is known that the mouse is dragged.
    CHECK(shift == Approx(plain / 10).epsilon(0.1));
    CHECK(fine == Approx(plain / 100).epsilon(0.1));
    CHECK(travelled("left_alt") == plain);  // window managers take it
}

TEST_CASE("a wide range does not make a drag fast") {
    BallRig rig;
    REQUIRE(rig.tree.property(rig.ball, "position").range.max > 1e6);
    rig.drag_by("position", 50, 0.25f);
    CHECK(rig.value("world.ball.position").vec2().x == Approx(0.5).margin(0.1));
}

TEST_CASE("a vector has a field for each component") {
    BallRig rig;
    rig.drag_by("position", 30, 0.25f);
    Vec2 position = rig.value("world.ball.position").vec2();
    CHECK(position.x == Approx(0.3).margin(0.05));
    CHECK(position.y == -4);
    rig.drag_by("position", 30, 0.75f);
    CHECK(rig.value("world.ball.position").vec2().y > -4);
}

TEST_CASE("a number field that is clicked can be typed into") {
    BallRig rig;
    rig.replace_text("mass", "2.5");
    CHECK(rig.value("world.ball.mass") == Value(2.5));
    rig.replace_text("mass", "7 kg");
    CHECK(rig.value("world.ball.mass") == Value(7.0));
    rig.replace_text("mass", "inf");
    CHECK(rig.value("world.ball.mass") == Value(std::numeric_limits<double>::infinity()));
    CHECK(rig.input().empty());  // the prompt got no text
    CHECK(rig.console.is_open());
}

TEST_CASE("an expression typed into a number field is calculated") {
    BallRig rig;
    rig.tree.set(rig.ball, "angle", Value(1.25));
    rig.replace_text("mass", "world.ball.angle");
    CHECK(rig.value("world.ball.mass") == Value(1.25));
}

TEST_CASE("a refused edit shows the reason and changes nothing") {
    BallRig rig;
    rig.replace_text("mass", "-3");
    CHECK(rig.value("world.ball.mass") == Value(1.0));
    CHECK(rig.state().inspector.editor().problem(rig.tree.property(rig.ball, "mass")).find("0") !=
          std::string::npos);
    rig.replace_text("mass", "nan");
    CHECK(rig.value("world.ball.mass") == Value(1.0));
    CHECK(rig.warns());
    rig.replace_text("mass", "world.bal.mass");
    const std::string problem =
        rig.state().inspector.editor().problem(rig.tree.property(rig.ball, "mass"));
    CHECK(problem.starts_with("\"world.bal.mass\" is not a number: "));
    INFO(problem);
    CHECK(problem.find("did you mean") != std::string::npos);
    rig.replace_text("mass", "3");
    CHECK(rig.value("world.ball.mass") == Value(3.0));
    CHECK_FALSE(rig.warns());
}

TEST_CASE("a refused number keeps the focus until it is mended or given up") {
    BallRig rig;
    const auto mass = [&] {
        return rig.state().inspector.editor().problem(rig.tree.property(rig.ball, "mass"));
    };
    for (const char* refused : {"-3", "nonsense"}) {
        INFO(refused);
        rig.replace_text("mass", refused);
        REQUIRE_FALSE(mass().empty());
        rig.draw(4);
        // The field still has the keyboard, with the text selected.
        rig.key("ctrl+a");
        rig.type("4");
        rig.key("enter");
        rig.draw(4);
        CHECK(rig.value("world.ball.mass") == Value(4.0));
        CHECK(mass().empty());
        CHECK(rig.input().empty());
        rig.type("x");
        CHECK(rig.input() == "x");
        rig.key("escape");

        rig.replace_text("mass", refused);
        rig.draw(4);
        rig.key("escape");
        rig.draw(4);
        CHECK(rig.value("world.ball.mass") == Value(4.0));
        CHECK(mass().empty());
        CHECK(rig.console.is_open());
        rig.type("y");
        CHECK(rig.input() == "y");
        rig.key("escape");
    }
}

TEST_CASE("a click beside a value that the simulation writes changes nothing") {
    BallRig rig;
    rig.tree.set(rig.ball, "speed", Value(-2.9e-11));
    ImVec2 at = rig.widget("speed", 1.0f);
    rig.click(at.x + 16, at.y);
    rig.draw();
    CHECK(rig.value("world.ball.speed") == Value(-2.9e-11));
}

TEST_CASE("Escape cancels the edit of a field and keeps the console open") {
    BallRig rig;
    ImVec2 at = rig.widget("mass");
    rig.click(at.x, at.y);
    rig.draw(2);
    rig.type("99");
    rig.key("escape");
    rig.draw(2);
    CHECK(rig.value("world.ball.mass") == Value(1.0));
    CHECK(rig.console.is_open());
    rig.type("x");
    CHECK(rig.input() == "x");
}

TEST_CASE("a check box writes a boolean") {
    BallRig rig;
    ImVec2 at = rig.widget("awake", 0.03f);
    rig.click(at.x + 6, at.y);
    rig.draw();
    CHECK(rig.value("world.ball.awake") == Value(false));
}

TEST_CASE("a typed text is written when the field loses the focus") {
    BallRig rig;
    rig.replace_text("label", "hello");
    CHECK(rig.value("world.ball.label") == Value("hello"));
    ImVec2 at = rig.widget("label");
    rig.click(at.x, at.y);
    rig.draw(2);
    rig.key("end");
    rig.type("!");
    rig.draw();
    ImVec2 other = rig.widget("angle");
    rig.move(other.x, other.y);
    rig.button(true, other.x, other.y);
    rig.draw();
    rig.button(false, other.x, other.y);
    rig.draw();
    CHECK(rig.value("world.ball.label") == Value("hello!"));
}

TEST_CASE("an enumerator is chosen from its list") {
    BallRig rig;
    ImVec2 at = rig.widget("type");
    rig.click(at.x, at.y);
    rig.draw(2);
    REQUIRE(rig.state().screen.popup_open);
    rig.click(at.x, at.y + 24);  // the first entry of the list below the field
    rig.draw(2);
    CHECK(rig.value("world.ball.type") == Value("static"));
    CHECK_FALSE(rig.state().screen.popup_open);
}

TEST_CASE("bits are words in their field and boxes in its list") {
    CHECK(bits_text(0) == "none");
    CHECK(bits_text(-1) == "all");
    CHECK(bits_text(1) == "bit 0");
    CHECK(bits_text(0b111101) == "bits 0, 2 to 5");
    CHECK(bits_text(0b110) == "bits 1, 2");
    CHECK(bits_text(~std::int64_t{8}) == "all but bit 3");
    CHECK(bits_text(std::numeric_limits<std::int64_t>::min()) == "bit 63");
    BallRig rig;
    const ImVec2 at = rig.widget("mask");
    const auto bits = [&] {
        return static_cast<std::uint64_t>(rig.value("world.ball.mask").integer());
    };
    rig.click(at.x, at.y);
    rig.draw(2);
    REQUIRE(rig.state().screen.popup_open);
    rig.click(at.x, at.y + 26);  // a box of the first row
    rig.draw(2);
    CHECK(std::popcount(bits()) == 63);
    CHECK((~bits() & 0xff) != 0);
    CHECK(rig.state().screen.popup_open);  // several may be changed
    rig.click(at.x, at.y + 26);
    rig.draw(2);
    CHECK(rig.value("world.ball.mask") == Value(-1));
    rig.key("escape");
    CHECK_FALSE(rig.state().screen.popup_open);
    CHECK(rig.console.is_open());
}

TEST_CASE("Escape closes an open list and keeps the console open") {
    BallRig rig;
    ImVec2 at = rig.widget("type");
    rig.click(at.x, at.y);
    rig.draw(2);
    REQUIRE(rig.state().screen.popup_open);
    rig.key("escape");
    rig.draw(2);
    CHECK_FALSE(rig.state().screen.popup_open);
    CHECK(rig.console.is_open());
    CHECK(rig.value("world.ball.type") == Value("dynamic"));
}

TEST_CASE("a reference is chosen from the instances of the required class") {
    BallRig rig;
    ImVec2 at = rig.widget("target", 1.0f);
    rig.click(at.x - 8, at.y);
    rig.draw(2);
    REQUIRE(rig.state().screen.popup_open);
    rig.type("crat");
    rig.draw();
    rig.key("enter");
    rig.draw(2);
    CHECK(rig.value("world.ball.target") ==
          Value(rig.tree.child(rig.tree.parent(rig.ball), "crate")));
    CHECK(rig.input().empty());
}

TEST_CASE("the reset mark sets a property back to its default") {
    BallRig rig;
    rig.tree.set(rig.ball, "mass", Value(8.0));
    ImVec2 at = rig.widget("mass", 1.0f);
    rig.click(at.x + 16, at.y);
    rig.draw();
    CHECK(rig.value("world.ball.mass") == Value(1.0));
}

TEST_CASE("a read-only property cannot be dragged") {
    BallRig rig;
    rig.drag_by("energy", 100);
    CHECK(rig.value("world.ball.energy") == Value(12.5));
    CHECK_FALSE(rig.warns());
}

TEST_CASE("a reference is shown as a link") {
    BallRig rig;
    Handle crate = rig.tree.child(rig.tree.parent(rig.ball), "crate");
    rig.tree.set(rig.ball, "target", Value(crate));
    ImVec2 at = rig.widget("target", 0.1f);
    rig.click(at.x, at.y);
    rig.draw();
    CHECK(rig.console.selected() == crate);
}

TEST_CASE("elements of a list are edited and added and removed") {
    BallRig rig;
    ImVec2 head = rig.widget("vertices", 0.2f);
    rig.click(head.x, head.y);
    rig.draw(2);
    auto& editor = rig.state().inspector.editor();
    const property::Property& vertices = rig.tree.property(rig.ball, "vertices");
    rig.state().inspector.select(rig.ball, "vertices");
    rig.draw(3);
    console::Rect rect = editor.widget_rect(vertices);
    REQUIRE(rect.high.y - rect.low.y > 80);
    float row = (rect.high.y - rect.low.y) / 5;
    // Drags the x of the second vertex.
    float x = rect.low.x + 50, y = rect.low.y + row * 2.4f;
    rig.drag(x, y, x + 40, y);
    rig.draw();
    List list = rig.value("world.ball.vertices").list();
    CHECK(list[1].vec2().x > 1.2);
    CHECK(list[1].vec2().y == 0);
    // Clicks the last line, which adds a vertex.
    rig.click(rect.low.x + 15, rect.high.y - 8);
    rig.draw(2);
    list = rig.value("world.ball.vertices").list();
    REQUIRE(list.size() == 4);
    // A polygon would drop a vertex that it has already, or that lies on one of its sides.
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 from = list[i].vec2(), side = list[(i + 1) % 3].vec2() - from;
        CHECK(std::abs(side.cross(list[3].vec2() - from)) > 0.01);
    }
    // Clicks the last column, which removes a vertex.
    rig.click(rect.high.x - 10, rect.low.y + row * 1.45f);
    rig.draw(2);
    list = rig.value("world.ball.vertices").list();
    REQUIRE(list.size() == 3);
    CHECK(list[0].vec2().x > 1.2);
}

TEST_CASE("ad-hoc properties are shown and edited and removed") {
    BallRig rig;
    rig.tree.set_or_add(rig.ball, "score", Value(10.0));
    rig.drag_by("score", 50);
    CHECK(rig.value("world.ball.score").number() > 10);
    rig.tree.set_or_add(rig.ball, "nickname", Value("bob"));
    rig.replace_text("nickname", "alice");
    CHECK(rig.value("world.ball.nickname") == Value("alice"));
    ImVec2 at = rig.widget("score", 1.0f);
    rig.click(at.x + 16, at.y);
    rig.draw(2);
    CHECK(rig.tree.find(rig.ball, "score") == nullptr);
}

TEST_CASE("a formula in error is shown with its error and an edit replaces it") {
    BallRig rig;
    bool works = true;
    rig.tree.set_formula(rig.ball, "angle",
                         {[&](const property::Tree& tree) {
                              if (!works) throw std::runtime_error("out of order");
                              return tree.get(rig.ball, "mass");
                          },
                          "ball.mass"});
    rig.tree.barrier();
    rig.draw(2);
    CHECK(rig.value("world.ball.angle") == Value(1.0));
    works = false;
    rig.tree.set(rig.ball, "mass", Value(2.0));
    auto before = rig.surface.pixels();
    rig.draw(3);
    CHECK(rig.surface.faults() == 0);
    CHECK(rig.surface.pixels() != before);
    rig.replace_text("angle", "0.5");
    CHECK(rig.value("world.ball.angle") == Value(0.5));
    CHECK(rig.tree.formula(rig.ball, rig.tree.property(rig.ball, "angle")) == nullptr);
}

TEST_CASE("the values shown follow the game") {
    BallRig rig;
    rig.draw(2);
    auto before = rig.surface.pixels();
    rig.tree.set(rig.ball, "angle", Value(1.5));
    rig.draw();
    CHECK(rig.surface.pixels() != before);
}

TEST_CASE("the selected instance may be deleted at any time") {
    BallRig rig;
    rig.tree.destroy(rig.ball);
    rig.draw(3);
    CHECK_FALSE(rig.console.selected());
    CHECK(rig.surface.faults() == 0);
    rig.tree.destroy(rig.tree.child(rig.tree.root(), "world"));
    rig.draw(3);
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("the outline unfolds down to the selected instance") {
    Rig rig;
    Handle world = rig.tree.child(rig.tree.root(), "world");
    Handle deep = world;
    for (int i = 0; i < 5; ++i)
        deep = rig.tree.create(rig.tree.class_named("Body"), deep, "level" + std::to_string(i));
    console::InstanceTree outline(rig.tree);
    outline.rows(0);
    CHECK(outline.row_of(deep) == -1);
    outline.reveal(deep);
    outline.rows(0);
    CHECK(outline.row_of(deep) > 0);
    outline.fold(world, false);
    outline.rows(0);
    CHECK(outline.row_of(deep) == -1);
}

TEST_CASE("the outline is searched by name and class") {
    Rig rig;
    console::InstanceTree outline(rig.tree);
    outline.search("CRAT");
    REQUIRE(outline.rows(0).size() == 1);
    CHECK(rig.tree.name(outline.rows(0)[0].instance) == "crate");
    outline.search("body");
    CHECK(outline.rows(0).size() == 3);
    outline.search("no such thing");
    CHECK(outline.rows(0).empty());
    outline.search("");
    CHECK(outline.rows(0).size() == 7);
}

TEST_CASE("a hundred thousand instances are shown without reading all of them") {
    BallRig rig;
    Handle world = rig.tree.parent(rig.ball);
    const property::Class& object = rig.tree.object_class();
    for (int i = 0; i < 100'000; ++i) rig.tree.create(object, world, "thing_" + std::to_string(i));
    rig.draw(30);  // until after the refresh
    std::size_t first = rig.surface.triangle_count();
    CHECK(first < 20'000);
    Handle last = rig.tree.child(world, "thing_99999");
    rig.console.select(last);
    rig.draw(3);
    CHECK(rig.console.selected() == last);
    CHECK(rig.surface.triangle_count() < 20'000);
}

}  // namespace inspector_test
