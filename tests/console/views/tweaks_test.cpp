// The list of tweaks, used with a mouse.

#include <imgui_internal.h>

#include <fstream>
#include <iterator>
#include <vector>

#include <fettle/property/storage/scene.h>

#include <look/theme.h>

#include "catch.h"
#include "rig.h"
#include "temporary_folder.h"

namespace tweaks_test {

using namespace fettle;
using console::Rect;
using console::test::Rig;
using property::Value;
namespace fs = std::filesystem;

namespace {

struct Place {
    TemporaryFolder folder{};
    fs::path game() const { return folder.path / "main.lua"; }
};

struct TweakedRig : Place, Rig {
    TweakedRig() : Place(), Rig({}, Place::game()) {
        key("grave");
        edit("world.ball.mass", 5.0);
        edit("world.ball.angle", 0.5);
        property::set(tree, "console.tweaks", true);
        draw(3);
    }
    void edit(const char* path, double value) {
        const property::Tree::CauseScope cause(tree, property::Writer::console);
        const auto [instance, name] = std::pair(property::get(tree, "world.ball").reference(),
                                                std::string(path).substr(sizeof "world.ball"));
        tree.set_or_add(instance, name, value);
    }
    void press(int row, const char* label) {
        const Rect at = state().views.tweak_list.button(row, label);
        REQUIRE_FALSE(at.empty());
        click(at.middle().x, at.middle().y);
        draw(3);
    }
};

}  // namespace

TEST_CASE("a click in the list of tweaks keeps or drops the tweak") {
    TweakedRig rig;
    REQUIRE(rig.tweaks->list().size() == 2);
    CHECK(rig.state().views.tweak_list.open_count() == 2);
    rig.save("tweaks");
    CHECK(rig.surface.faults() == 0);
    rig.press(1, "drop");
    // A click runs a command, so a recording contains it.
    CHECK(rig.commands.back() == "drop_tweaks(\"world.ball.angle\")");
    CHECK(rig.logged("dropped 1 tweak"));
    REQUIRE(rig.tweaks->list().size() == 1);
    CHECK(rig.tweaks->list()[0].path == "world.ball.mass");
    rig.press(0, "keep");
    CHECK(rig.logged("kept 1 tweak in main.tweaks.json"));
    CHECK(rig.tweaks->list()[0].kept);
    CHECK(rig.state().views.tweak_list.button(0, "keep").empty());
    CHECK(rig.state().views.tweak_list.open_count() == 0);
    // The name of the file is wider than the buttons, and not cut.
    const Rect file_name = rig.state().views.tweak_list.button(0, "kept");
    CHECK(file_name.high.x - file_name.low.x > 150);
    CHECK(rig.value("world.ball.angle") == Value(0.5));
    std::ifstream file(rig.folder.path / "main.tweaks.json");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    CHECK(text.find("\"world.ball.mass\": 5") != std::string::npos);
}

TEST_CASE("the menu of one of several instances of a scene file keeps for all of them") {
    TweakedRig rig;
    std::ofstream(rig.folder.path / "lamp.json")
        << R"({"fettle_scene": 1, "class": "Body", "name": "lamp"})";
    const property::Handle world = rig.tree.child(rig.tree.root(), "world");
    for (int i = 0; i < 2; ++i) {
        std::vector<property::SceneInstance> instances;
        property::load_scene(rig.tree, rig.folder.path / "lamp.json", world, {}, nullptr,
                             &instances);
        rig.tweaks->scene_loaded(rig.folder.path / "lamp.json", instances);
    }
    const auto entry_for = [&](const char* path) {
        rig.state().context_menu.open(path);
        rig.draw(3);
        REQUIRE_FALSE(rig.state().context_menu.entry("Keep").empty());
        return rig.state().context_menu.entry("Keep for all");
    };
    CHECK(entry_for("world.ball").empty());
    const Rect entry = entry_for("world.lamp_1.mass");
    REQUIRE_FALSE(entry.empty());
    rig.click(entry.middle().x, entry.middle().y);
    rig.draw(3);
    CHECK(rig.commands.back() == "keep_for_all(\"world.lamp_1.mass\")");
}

TEST_CASE("the list of tweaks does not cut a path where there is room") {
    TweakedRig rig;
    rig.edit("world.ball.linear_damping_of_a_very_long_name_indeed", 5);
    rig.draw(60);  // the list is read anew a few times in a second
    REQUIRE(rig.tweaks->list().size() == 3);
    const Rect path = rig.state().views.tweak_list.button(2, "path");
    CHECK(path.high.x - path.low.x >= console::text_width(rig.tweaks->list()[2].path));
    CHECK_FALSE(rig.state().views.tweak_list.button(2, "drop").empty());
    // Where there is none, the change keeps a part of it.
    console::test::RasterSurface narrow(400, 700);
    for (int i = 0; i < 3; ++i) rig.console.draw(narrow, 1.0 / 60);
    const Rect less = rig.state().views.tweak_list.button(2, "path");
    const Rect keep = rig.state().views.tweak_list.button(2, "keep");
    CHECK(keep.low.x - less.high.x > 40);
}

TEST_CASE("a row of the list of tweaks stays in its place when the one above it is kept") {
    TweakedRig rig;
    const float before = rig.state().views.tweak_list.button(1, "keep").low.y;
    rig.press(0, "keep");
    CHECK(rig.state().views.tweak_list.button(1, "keep").low.y == before);
}

TEST_CASE("rows of the list of tweaks stay under the mouse until it leaves the list") {
    TweakedRig rig;
    const auto& list = rig.state().views.tweak_list;
    const float first = list.button(0, "keep").low.y, second = list.button(1, "keep").low.y;
    rig.press(0, "drop");
    REQUIRE(rig.tweaks->list().size() == 1);
    CHECK(list.button(0, "keep").empty());
    CHECK(list.button(1, "keep").low.y == second);
    CHECK(rig.state().views.tweak_list.open_count() == 1);
    // A tweak that comes meanwhile is below the others.
    rig.edit("world.ball.mass", 6);
    rig.draw(40);
    CHECK(list.button(0, "keep").low.y == first);
    CHECK(list.button(1, "keep").low.y == second);
    rig.press(0, "drop");
    rig.move(640, 790);
    rig.draw(3);
    CHECK(list.button(0, "keep").low.y == first);
    CHECK(list.button(1, "keep").empty());
}

TEST_CASE("the text of an empty list of tweaks is wrapped") {
    const Place place;
    Rig rig({}, place.game());
    rig.key("grave");
    property::set(rig.tree, "console.tweaks", true);
    console::test::RasterSurface narrow(400, 700);
    for (int i = 0; i < 3; ++i) rig.console.draw(narrow, 1.0 / 60);
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
        INFO(window->Name);
        CHECK(window->ContentSize.x <= window->Size.x);
    }
}

TEST_CASE("in a narrow window the list of tweaks leaves the times to tooltips") {
    TweakedRig rig;
    CHECK(rig.state().views.tweak_list.shows_times());
    console::test::RasterSurface narrow(400, 700);
    for (int i = 0; i < 3; ++i) rig.console.draw(narrow, 1.0 / 60);
    CHECK_FALSE(rig.state().views.tweak_list.shows_times());
    CHECK_FALSE(rig.state().views.tweak_list.button(1, "drop").empty());
}

TEST_CASE("in a window of 400 px the buttons have room at scale 2") {
    TweakedRig rig;
    rig.state().settings.set("scale", Value(2.0));
    console::test::RasterSurface narrow(400, 400), wide(1280, 800);
    for (int i = 0; i < 3; ++i) rig.console.draw(narrow, 1.0 / 60);
    const Rect drop = rig.state().views.tweak_list.button(-1, "drop all");
    REQUIRE_FALSE(drop.empty());
    CHECK(drop.high.x < 400);
    CHECK(rig.state().views.tweak_list.button(0, "drop").high.x < 400);
    const float small = drop.high.y - drop.low.y;
    for (int i = 0; i < 3; ++i) rig.console.draw(wide, 1.0 / 60);
    const Rect large = rig.state().views.tweak_list.button(-1, "drop all");
    CHECK(large.high.y - large.low.y > 1.5f * small);
}

TEST_CASE("a command of a menu or a key shows its output in place of the list of tweaks") {
    TweakedRig rig;
    rig.state().run("world.ball.mass");
    CHECK(rig.value("console.tweaks") == Value(false));
    CHECK(rig.logged("world.ball.mass: 5"));
}

TEST_CASE("the name of the file of a plot is shown in place of the list of tweaks") {
    TweakedRig rig;
    rig.state().observing.exports().push_back("csv");
    rig.console.between_frames();
    CHECK(rig.value("console.tweaks") == Value(false));
    CHECK(rig.logged("nothing is plotted"));
}

TEST_CASE("a command shows its output in place of the list of tweaks") {
    TweakedRig rig;
    rig.type("world.ball.mass");
    CHECK(rig.value("console.tweaks") == Value(true));
    rig.key("enter");
    CHECK(rig.value("console.tweaks") == Value(false));
    CHECK(rig.logged("world.ball.mass: 5"));
}

TEST_CASE("tweaks of an earlier run are applied again from the list as one edit") {
    const Place place;
    {
        Rig first({}, place.game());
        const property::Tree::CauseScope cause(first.tree, property::Writer::console);
        property::set(first.tree, "world.ball.mass", 5.0);
        property::set(first.tree, "world.ball.angle", 0.5);
        first.tweaks->barrier();
    }
    Rig rig({}, place.game());
    rig.key("grave");
    property::set(rig.tree, "console.tweaks", true);
    rig.draw(3);
    const double before = rig.value("world.ball.mass").number();
    CHECK(before != 5);
    const Rect at = rig.state().views.tweak_list.button(-1, "make all again");
    REQUIRE_FALSE(at.empty());
    rig.click(at.middle().x, at.middle().y);
    rig.draw(3);
    CHECK(rig.value("world.ball.mass") == Value(5.0));
    CHECK(rig.tweaks->open_earlier() == 0);
    CHECK(rig.tweaks->list().size() == 2);
    rig.tree.undo();
    rig.draw();
    CHECK(rig.value("world.ball.mass").number() == before);
    CHECK(rig.tweaks->open_earlier() == 2);  // after undo they are open again
    CHECK(rig.tweaks->list().size() == 2);
}

TEST_CASE("a console without a journal shows no list of tweaks") {
    Rig rig;
    rig.key("grave");
    property::set(rig.tree, "console.tweaks", true);
    rig.draw(3);
    CHECK_FALSE(rig.state().views.tweak_list.available());
    CHECK(rig.state().views.log_view.line_height() > 0);
}

}  // namespace tweaks_test
