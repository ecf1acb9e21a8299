// The rows of the tree of the game in the inspector.

#include <cmath>
#include <string>
#include <string_view>

#include "catch.h"
#include "rig.h"

#include <look/imgui_compat.h>

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

}  // namespace outline_rows_test
