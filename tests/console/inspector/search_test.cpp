// The search of the inspector.

#include <algorithm>
#include <string>

#include <inspector/instance_tree.h>
#include <look/imgui_compat.h>
#include "catch.h"
#include "rig.h"

namespace search_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Value;

TEST_CASE("the outline is searched by a condition") {
    Rig rig;
    console::InstanceTree outline(rig.tree);
    rig.tree.set(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "crate"), "mass",
                 Value(9.0));
    const auto found = [&](const std::string& text) {
        outline.search(text);
        std::string names;
        for (const auto& row : outline.rows(0))
            names += (names.empty() ? "" : " ") + rig.tree.name(row.instance);
        return names;
    };
    CHECK(found("mass > 5") == "crate");
    CHECK(found("Body and position.x >= 3") == "crate floor");
    CHECK(outline.problem().empty());
    CHECK(found("mass > 50").empty());
    CHECK(outline.problem().empty());
    CHECK(found("mass >").empty());
    CHECK(outline.problem().ends_with("expected a property or a value, got the end"));
    CHECK(found("masss > 5").empty());
    CHECK(outline.problem() == "nothing has \"masss\" (did you mean \"mass\"?)");
    // By name again: with the letters of a name, and with a path.
    CHECK(found("world.cr") == "crate");
    CHECK(found("flr") == "floor");
    CHECK(outline.problem().empty());
}

TEST_CASE("a search for a class finds instances of the classes that derive from it") {
    Rig rig;
    property::ClassDescriptor descriptor;
    descriptor.name = "Coin";
    descriptor.base = "Body";
    const Handle world = rig.tree.child(rig.tree.root(), "world");
    const Handle coin = rig.tree.create(rig.tree.define(descriptor), world, "penny");
    console::InstanceTree outline(rig.tree);
    const auto finds = [&](const char* text) {
        outline.search(text);
        const auto& rows = outline.rows(0);
        return std::ranges::any_of(rows, [&](const auto& row) { return row.instance == coin; });
    };
    CHECK(finds("Body"));
    CHECK(finds("body"));
    CHECK(finds("oin"));
    CHECK_FALSE(finds("bod"));
    CHECK_FALSE(finds("Object"));
}

TEST_CASE("when a search is cleared the tree shows the selected instance again") {
    Rig rig;
    const Handle world = rig.tree.child(rig.tree.root(), "world");
    Handle last;
    for (int i = 0; i < 300; ++i)
        last = rig.tree.create(rig.tree.class_named("Body"), world, "b" + std::to_string(i));
    rig.key("grave");
    rig.draw(3);
    const ImVec2 field(rig.state().screen.inspector_rect.low.x + 60,
                       rig.state().screen.inspector_rect.low.y + 18);
    rig.click(field.x, field.y);
    rig.type("b299");
    rig.draw(3);
    rig.click(field.x, field.y + 25);  // the only row
    rig.draw(3);
    REQUIRE(rig.console.selected() == last);
    rig.click(field.x, field.y);
    rig.key("ctrl+a");
    rig.key("delete");
    rig.draw(5);
    float scrolled = 0;
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
        if (std::string(window->Name).find("/outline") != std::string::npos)
            scrolled = window->Scroll.y;
    CHECK(scrolled > 1000);
}

TEST_CASE("a search in a large game takes several frames and follows its changes") {
    Rig rig;
    const Handle world = rig.tree.child(rig.tree.root(), "world");
    std::vector<Handle> many;
    for (int i = 0; i < 5000; ++i)
        many.push_back(rig.tree.create(rig.tree.class_named("Body"), world));
    rig.tree.set(many.back(), "mass", Value(9.0));
    console::InstanceTree outline(rig.tree);
    outline.search("mass > 5");
    CHECK(outline.rows(0).empty());
    CHECK(outline.searching());
    int frames = 1;
    for (; outline.searching() && frames < 100; ++frames) outline.rows(0);
    CHECK(frames > 2);
    REQUIRE(outline.rows(0).size() == 1);
    CHECK(outline.rows(0)[0].instance == many.back());
    // Later it is searched again; meanwhile the old result stays.
    rig.tree.set(many.front(), "mass", Value(9.0));
    CHECK(outline.rows(2).size() == 1);
    while (outline.searching()) outline.rows(2);
    CHECK(outline.rows(2).size() == 2);
    // The instance that the search would visit next is deleted.
    CHECK(outline.rows(4).size() == 2);
    CHECK(outline.searching());
    rig.tree.destroy(world);
    for (int i = 0; i < 100 && outline.searching(); ++i) outline.rows(4);
    CHECK(outline.rows(4).empty());
}

}  // namespace search_test
