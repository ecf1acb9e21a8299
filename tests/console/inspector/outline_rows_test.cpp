// The rows of the tree of the game in the inspector.

#include <cmath>
#include <string>
#include <string_view>

#include "catch.h"
#include "rig.h"

#include <look/imgui_compat.h>
#include <look/theme.h>

namespace outline_rows_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;

TEST_CASE("the selected row stays visible while the outline becomes lower and no row is cut") {
    Rig rig;
    rig.key("grave");
    const Handle world = rig.tree.child(rig.tree.root(), "world");
    Handle last;
    for (int i = 0; i < 60; ++i)
        last = rig.tree.create(rig.tree.class_named("Body"), world, "b" + std::to_string(i));
    rig.console.select(last);
    for (const float height : {800.0f, 500.0f, 400.0f, 330.0f}) {
        console::test::RasterSurface other(1280, static_cast<unsigned>(height));
        for (int frame = 0; frame < 4; ++frame) rig.console.draw(other, 1.0 / 60);
        const ImGuiWindow* outline = nullptr;
        for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows)
            if (std::string_view(each->Name).find("/outline_") != std::string_view::npos)
                outline = each;
        REQUIRE(outline != nullptr);
        const float row = ImGui::GetFrameHeight();
        const auto index = static_cast<float>(rig.state().inspector.outline().row_of(last));
        CHECK(std::fmod(outline->Size.y, row) == Approx(0).margin(0.01));
        CHECK(std::fmod(outline->Scroll.y, row) == Approx(0).margin(0.01));
        CHECK(index * row >= outline->Scroll.y);
        CHECK((index + 1) * row <= outline->Scroll.y + outline->Size.y + 0.01f);
    }
}

TEST_CASE("a selection moves neither the inspector nor the rows of the tree") {
    const auto width = GENERATE(1280u, 400u);
    console::test::RasterSurface window(width, 800);
    Rig rig;
    rig.key("grave");
    const auto draw = [&] {
        for (int frame = 0; frame < 4; ++frame) rig.console.draw(window, 1.0 / 60);
        return rig.state().screen.inspector_rect;
    };
    const auto height_of_tree = [] {
        for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows)
            if (std::string_view(each->Name).find("/outline_") != std::string_view::npos)
                return each->Size.y;
        return 0.0f;
    };
    const console::Rect before = draw();
    const float tree_before = height_of_tree();
    rig.console.select(rig.tree.child(rig.tree.root(), "world"));
    const console::Rect after = draw();
    CHECK(tree_before > 0);
    CHECK(height_of_tree() == tree_before);
    CHECK(after.low.y == before.low.y);
    // In a narrow window more of the game is visible without a selection.
    if (width == 1280) CHECK(after.high.y == before.high.y);
    CHECK(after.low.x == before.low.x);
}

TEST_CASE("the rows of a search show the ends of paths that are too long for them") {
    const auto picture = [](char last) {
        Rig rig;
        const Handle world = rig.tree.child(rig.tree.root(), "world");
        rig.tree.create(rig.tree.class_named("Body"), world, "rock" + std::string(80, 'x') + last);
        rig.key("grave");
        rig.draw(3);
        rig.key("ctrl+f");
        rig.draw(3);
        rig.type("rock");
        rig.draw(20);
        return rig.surface.pixels();
    };
    CHECK((picture('1') == picture('1')));
    CHECK((picture('1') != picture('2')));
}

TEST_CASE("a name with a line end is drawn in its own row") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    rig.state().ui.activate();
    CHECK(console::shortened("a\nx", 500) == "a↵x");
}

TEST_CASE("the row of the selected instance is shown after it got another parent") {
    Rig rig;
    rig.key("grave");
    const Handle world = rig.tree.child(rig.tree.root(), "world");
    const Handle ball = rig.tree.child(world, "ball"), crate = rig.tree.child(world, "crate");
    rig.console.select(ball);
    rig.draw(3);
    const auto row = [&] { return rig.state().inspector.outline().row_of(ball); };
    REQUIRE(row() > 0);
    SECTION("below a folded one") {
        rig.tree.move(ball, crate);
    }
    SECTION("with an instance above it") {
        rig.tree.move(ball, crate);
        rig.draw(3);
        rig.tree.move(crate, rig.tree.child(world, "floor"));
    }
    rig.draw(3);
    REQUIRE(row() > 0);
    const auto& shown = rig.state().inspector.outline();
    CHECK(shown.row_of(ball) == shown.row_of(crate) + 1);
}

TEST_CASE("a motion before the press on the line below the tree does not move the line") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    const auto height_of_tree = [] {
        for (const ImGuiWindow* each : ImGui::GetCurrentContext()->Windows)
            if (std::string_view(each->Name).find("/outline_") != std::string_view::npos)
                return each->Size.y;
        return 0.0f;
    };
    const float before = height_of_tree();
    const console::Rect inspector = rig.state().screen.inspector_rect;
    const float line = inspector.low.y + 0.36f * (inspector.high.y - inspector.low.y) + 26;
    rig.move(inspector.middle().x, inspector.high.y - 20);
    rig.draw(2);
    for (float y = line - 16; y < line + 16; y += 4) {
        rig.move(inspector.middle().x, inspector.high.y - 20);
        rig.draw();
        rig.click(inspector.middle().x, y);
        rig.draw(2);
    }
    CHECK(height_of_tree() == before);
}

}  // namespace outline_rows_test
