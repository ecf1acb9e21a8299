// How a plot is drawn.

#include <imgui_internal.h>

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

TEST_CASE("a long error leaves room for the name in the legend, and the tooltip has it whole") {
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

}  // namespace plot_test
