// Several selected instances: in the inspector, in the game, and by keys.

#include <inspector/multi_selection.h>
#include "catch.h"
#include "rig.h"

#include <look/imgui_compat.h>

namespace selection_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Value;
using property::Vec2;

namespace {

/// A rig with the console open, and pixels of places in the game.
struct SelectionRig : Rig {
    SelectionRig() {
        world = tree.child(tree.root(), "world");
        ball = tree.child(world, "ball");
        crate = tree.child(world, "crate");
        floor = tree.child(world, "floor");
        key("grave");
        draw();
    }
    ImVec2 pixel(Vec2 place) {
        const Vec2 at = state().options.to_pixels(place);
        return ImVec2(static_cast<float>(at.x), static_cast<float>(at.y));
    }
    void click_at(std::string_view path) {
        const ImVec2 at = pixel(value(std::string(path) + ".position").vec2());
        click(at.x, at.y);
        draw();
    }
    void with_key(std::string_view held, const std::function<void()>& action) {
        press(held);
        action();
        release(held);
    }
    std::vector<Handle> selection() { return state().inspector.selection(); }
    void select_all() {
        state().inspector.select({ball, crate, floor});
        draw(3);
    }
    Handle world, ball, crate, floor;
};

}  // namespace

TEST_CASE("a click with control adds to the selection and takes away from it") {
    SelectionRig rig;
    rig.click_at("world.ball");
    CHECK(rig.selection() == std::vector{rig.ball});
    rig.with_key("left_control", [&] { rig.click_at("world.crate"); });
    CHECK(rig.selection() == std::vector{rig.ball, rig.crate});
    CHECK(rig.console.selected() == rig.crate);
    rig.with_key("left_control", [&] { rig.click_at("world.crate"); });
    CHECK(rig.selection() == std::vector{rig.ball});
    rig.with_key("left_control", [&] { rig.click_at("world.crate"); });
    rig.click_at("world.ball");
    CHECK(rig.selection() == std::vector{rig.ball});
}

TEST_CASE("a click with control on the only selected instance leaves nothing selected") {
    SelectionRig rig;
    rig.click_at("world.ball");
    REQUIRE(rig.console.selected() == rig.ball);
    rig.with_key("left_control", [&] { rig.click_at("world.ball"); });
    CHECK_FALSE(rig.console.selected());
    CHECK(rig.logged("nothing is selected"));
    rig.draw(3);
    rig.click_at("world.crate");
    CHECK(rig.selection() == std::vector{rig.crate});
    rig.console.select(std::vector<Handle>{});
    rig.draw(3);
    CHECK_FALSE(rig.console.selected());
    CHECK(rig.selection().empty());
}

TEST_CASE("a click on one of the selected instances selects it alone") {
    SelectionRig rig;
    rig.select_all();
    rig.click_at("world.crate");
    CHECK(rig.selection() == std::vector{rig.crate});
}

TEST_CASE("instances that are deleted are selected no more") {
    SelectionRig rig;
    rig.select_all();
    rig.tree.destroy(rig.crate);
    rig.draw();
    const console::Selection& selection = rig.state().inspector.selected_instances();
    CHECK(selection.others() == std::vector{rig.ball});
    CHECK(selection.count() == 2);
    CHECK(!selection.contains(rig.crate));
    CHECK(selection.contains(rig.ball));
}

TEST_CASE("an instance below another selected one is left out in any order of selecting") {
    SelectionRig rig;
    const Handle ring = rig.tree.create(rig.tree.class_of(rig.ball), rig.ball, "ring");
    CHECK(console::topmost(rig.tree, {ring, rig.ball, rig.crate}) ==
          std::vector{rig.ball, rig.crate});
    CHECK(console::topmost(rig.tree, {rig.ball, rig.ball, ring}) == std::vector{rig.ball});
}

TEST_CASE("a box drawn with shift selects the instances in it") {
    SelectionRig rig;
    const ImVec2 from = rig.pixel(Vec2(-1, -3)), to = rig.pixel(Vec2(4, -5));
    rig.with_key("left_shift", [&] { rig.drag(from.x, from.y, to.x, to.y); });
    CHECK(rig.selection() == std::vector{rig.ball, rig.crate});
    CHECK(rig.logged("2 selected, it = world.crate"));
    // An empty box leaves the selection as it is.
    const ImVec2 empty = rig.pixel(Vec2(-9, -8));
    rig.with_key("left_shift", [&] { rig.drag(empty.x, empty.y, empty.x + 20, empty.y + 20); });
    CHECK(rig.selection().size() == 2);
}

TEST_CASE("an edit goes to all that are selected as one step of undo") {
    SelectionRig rig;
    rig.tree.set(rig.crate, "mass", Value(5.0));
    rig.select_all();
    const ImVec2 at = rig.widget("mass");
    rig.click(at.x, at.y);
    rig.draw(2);
    rig.key("ctrl+a");
    rig.type("7");
    rig.key("enter");
    rig.draw(2);
    for (const char* const path : {"world.ball.mass", "world.crate.mass", "world.floor.mass"})
        CHECK(rig.value(path).number() == 7);
    CHECK(rig.tree.undo().name == "edit mass of 3 selected instances");
    CHECK(rig.value("world.ball.mass").number() == 1);
    CHECK(rig.value("world.crate.mass").number() == 5);
    CHECK(rig.value("world.floor.mass").number() == 1);
    const ImVec2 angle = rig.widget("angle");
    rig.drag(angle.x, angle.y, angle.x + 50, angle.y);
    rig.draw();
    CHECK(rig.value("world.crate.angle").number() > 0.2);
    CHECK(rig.value("world.crate.angle").number() == rig.value("world.floor.angle").number());
    CHECK(rig.tree.undo().name == "edit angle of 3 selected instances");
    CHECK(rig.value("world.ball.angle").number() == 0);
    CHECK(rig.value("world.crate.angle").number() == 0);
}

TEST_CASE("an edit of a component of a vector sets only this component of the others") {
    SelectionRig rig;
    rig.tree.set(rig.crate, "position", Value(Vec2(3, 8)));
    rig.select_all();
    const ImVec2 x = rig.widget("position", 0.25f);
    rig.click(x.x, x.y);
    rig.draw(2);
    rig.key("ctrl+a");
    rig.type("2");
    rig.key("enter");
    rig.draw(2);
    CHECK(rig.value("world.ball.position").vec2() == Vec2(2, -4));
    CHECK(rig.value("world.crate.position").vec2() == Vec2(2, 8));
    CHECK(rig.value("world.floor.position").vec2() == Vec2(2, -4));
}

TEST_CASE("different values are shown as mixed") {
    property::Tree tree;
    console::test::make_game(tree);
    const Handle world = tree.child(tree.root(), "world");
    const Handle ball = tree.child(world, "ball"), crate = tree.child(world, "crate");
    const property::Property& mass = tree.property(ball, "mass");
    console::MixedValues mixed;
    CHECK(mixed.text(tree, mass, Value(1.0)).empty());
    mixed.compare_with({crate}, 1);
    CHECK(mixed.text(tree, mass, tree.get(ball, mass)).empty());
    tree.set(crate, "mass", Value(5.0));
    CHECK(mixed.text(tree, mass, tree.get(ball, mass)) == "mixed: 1 to 5 kg");
    const property::Property& position = tree.property(ball, "position");
    tree.set(ball, position, Value(Vec2(1, -4)));
    tree.set(crate, "position", Value(Vec2(5, -4)));
    CHECK(mixed.text(tree, position, tree.get(ball, position)) == "mixed: x 1 to 5, y -4 m");
    tree.set(crate, "position", Value(Vec2(1, 8)));
    CHECK(mixed.text(tree, position, tree.get(ball, position)) == "mixed: x 1, y -4 to 8 m");
    tree.set(crate, "position", Value(Vec2(1 + 1e-9, 7e-6)));
    CHECK(mixed.text(tree, position, tree.get(ball, position)) == "mixed: x about 1, y -4 to 0 m");
    const property::Property& label = tree.property(ball, "label");
    tree.set(crate, "label", Value("x"));
    CHECK(mixed.text(tree, label, tree.get(ball, label)) == "mixed");
    // A world has no mass, so no other instance is compared.
    mixed.compare_with({world}, 2);
    CHECK(mixed.text(tree, mass, tree.get(ball, mass)).empty());
}

TEST_CASE("rows stay where they are while mixed values become longer and shorter") {
    SelectionRig rig;
    rig.state().inspector.select({rig.ball, rig.crate});
    const auto row_below = [&](double angle) {
        rig.tree.set(rig.crate, "angle", Value(angle));
        rig.draw(3);
        return rig.widget("mass").y;
    };
    const float short_values = row_below(2);
    CHECK(row_below(-0.00012345678) == short_values);
    CHECK(row_below(-123456789.125) == short_values);
}

TEST_CASE("of many selected instances all are compared in a few frames") {
    property::Tree tree;
    console::test::make_game(tree);
    const Handle world = tree.child(tree.root(), "world");
    std::vector<Handle> many;
    for (int i = 0; i < 20'000; ++i) many.push_back(tree.create(tree.class_named("Body"), world));
    tree.set(many.back(), "mass", Value(9.0));
    const property::Property& mass = tree.property(many.front(), "mass");
    console::MixedValues mixed;
    mixed.compare_with(many, 1);
    int frames = 0;
    while (mixed.text(tree, mass, Value(1.0)).empty() && frames < 500) ++frames;
    CHECK(frames > 0);
    CHECK(frames < 25);
    CHECK(mixed.text(tree, mass, Value(1.0)) == "mixed: 1 to 9 kg");
}

TEST_CASE("arrows move the selection after a click into the game") {
    SelectionRig rig;
    rig.click_at("world.ball");
    const Vec2 before = rig.value("world.ball.position").vec2();
    const double pixel =
        (rig.state().options.to_world(1, 0) - rig.state().options.to_world(0, 0)).x;
    rig.key("right");
    rig.key("shift+up");
    const Vec2 after = rig.value("world.ball.position").vec2();
    CHECK(after.x == Approx(before.x + pixel));
    CHECK(after.y == Approx(before.y + 10 * pixel));
    rig.tree.undo();
    CHECK(rig.value("world.ball.position").vec2().y == Approx(before.y));
    // Typed letters go to the prompt again.
    rig.type("world");
    rig.key("left");
    rig.type("x");
    CHECK(rig.input() == "worlxd");
    CHECK(rig.value("world.ball.position").vec2().x == Approx(before.x + pixel));
}

TEST_CASE("one command deletes or clones all selected instances") {
    SelectionRig rig;
    CHECK(console::delete_command(rig.tree, {rig.ball, rig.crate}) ==
          "world.ball:delete(); world.crate:delete()");
    // An instance below another selected one goes with it.
    CHECK(console::delete_command(rig.tree, {rig.ball, rig.world}) == "world:delete()");
    CHECK(console::clone_command(rig.tree, {rig.ball}) == "world:add(world.ball:clone())");
    const std::vector<Handle> many(1000, rig.ball);
    CHECK(console::delete_command(rig.tree, many) == "world.ball:delete()");
    std::vector<Handle> bodies;
    for (int i = 0; i < 201; ++i)
        bodies.push_back(rig.tree.create(rig.tree.class_named("Body"), rig.world));
    CHECK(console::delete_command(rig.tree, bodies).empty());
    rig.state().inspector.select(bodies);
    rig.state().inspector.delete_selection();
    CHECK(rig.logged("delete: at most 200 instances at once"));
    rig.click_at("world.ball");
    rig.key("delete");
    CHECK(rig.commands.back() == "world.ball:delete()");
}

TEST_CASE("positions are aligned to their mean") {
    SelectionRig rig;
    console::align(rig.tree, {rig.ball, rig.crate, rig.floor, rig.world}, 0);
    CHECK(rig.value("world.ball.position").vec2() == Vec2(3, -4));
    CHECK(rig.value("world.floor.position").vec2() == Vec2(3, -4));
    rig.tree.undo();
    CHECK(rig.value("world.ball.position").vec2() == Vec2(0, -4));
    CHECK(rig.value("world.floor.position").vec2() == Vec2(6, -4));
    CHECK(console::all_of_class(rig.tree, rig.tree.class_of(rig.ball)).size() == 3);
}

TEST_CASE("the button that deletes all selected leaves no error") {
    SelectionRig rig;
    rig.console.select(std::vector{rig.ball, rig.crate});
    rig.draw(3);
    bool deleted = false;
    rig.state().inspector.run = [&](const std::string&) {
        deleted = true;
        rig.tree.destroy(rig.ball);
        rig.tree.destroy(rig.crate);
    };
    const console::Rect& all = rig.state().screen.inspector_rect;
    // Clicks from below upwards until one hits the button; between the buttons nothing happens.
    for (float y = (all.low.y + all.high.y) / 2; y > all.low.y + 60 && !deleted; y -= 8)
        rig.click(all.low.x + 45, y);
    REQUIRE(deleted);
    rig.draw(3);
    CHECK_FALSE(rig.logged("console:"));
    CHECK_FALSE(rig.logged("was deleted"));
}

TEST_CASE("deleted instances leave the selection") {
    SelectionRig rig;
    rig.select_all();
    rig.tree.destroy(rig.crate);
    rig.draw(2);
    CHECK(rig.selection() == std::vector{rig.ball, rig.floor});
    rig.tree.destroy(rig.floor);
    rig.tree.destroy(rig.ball);
    rig.draw(2);
    CHECK(rig.selection().empty());
}

TEST_CASE("a frame checks a limited number of the selected instances and a few frames check all") {
    using console::Selection;
    property::Tree tree;
    console::test::make_game(tree);
    const Handle world = tree.child(tree.root(), "world");
    std::vector<Handle> many;
    for (std::size_t i = 0; i < 4 * Selection::checked_in_a_frame; ++i)
        many.push_back(tree.create(tree.class_named("Body"), world));
    Selection selection(tree);
    selection.select(many);
    REQUIRE(selection.of_one_class());
    for (std::size_t i = 0; i + 1 < many.size(); i += 2) tree.destroy(many[i]);
    selection.drop_deleted();
    CHECK(selection.others().size() == many.size() - 1 - Selection::checked_in_a_frame / 2);
    for (int frame = 0; frame < 5; ++frame) {
        tree.destroy(tree.create(tree.class_named("Body"), world));
        selection.drop_deleted();
    }
    CHECK(selection.others().size() == many.size() / 2 - 1);
    CHECK(selection.of_one_class());
    CHECK_FALSE(selection.contains(many[0]));
    CHECK(selection.contains(many[1]));
    CHECK(selection.last() == many.back());
}

TEST_CASE("the buttons for several instances stay in a narrow inspector with large text") {
    SelectionRig rig;
    property::set(rig.tree, "console.scale", Value(2.0));
    rig.select_all();
    const bool of_one_class = GENERATE(true, false);
    if (!of_one_class) rig.state().inspector.select({rig.ball, rig.world});
    rig.draw(3);
    const ImGuiWindow* const inspector = ImGui::FindWindowByName("##inspector");
    REQUIRE(inspector != nullptr);
    CHECK(inspector->ContentSize.x <= inspector->WorkRect.GetWidth());
}

}  // namespace selection_test
