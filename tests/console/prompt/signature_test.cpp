// The signature of the call that is being typed.

#include <prompt/signature_help.h>
#include "catch.h"
#include "rig.h"

#include <imgui_internal.h>

namespace signature_test {

using namespace fettle;
using console::open_call;
using console::parameter_of;

namespace {

std::string call_at_end(std::string_view text) {
    const auto call = open_call(text, text.size());
    return call ? std::string(call->callee) + " " + std::to_string(call->argument) : "none";
}

std::string parameter(std::string_view signature, std::size_t index) {
    const auto range = parameter_of(signature, index);
    return std::string(signature.substr(range.begin, range.end - range.begin));
}

}  // namespace

TEST_CASE("the open call at the cursor is found") {
    CHECK(call_at_end("world:raycast(") == "world:raycast 0");
    CHECK(call_at_end("world:raycast(vec(0, 1), ") == "world:raycast 1");
    CHECK(call_at_end("world:raycast(vec(0, ") == "vec 1");
    CHECK(call_at_end("f({1, 2, 3}, ") == "f 1");
    CHECK(call_at_end("f({1, 2, ") == "f 0");
    CHECK(call_at_end("f(\"a, (b\", 'c,', ") == "f 2");
    CHECK(call_at_end("f(a[1") == "f 0");
    for (const char* const text :
         {"", "f", "f(1)", "f(1) ", "(1 + ", "f(\")\")", "a = b, c", ")))"})
        CHECK(call_at_end(text) == "none");
    CHECK(open_call("f(1, 2)", 3)->argument == 0);
}

TEST_CASE("a constructor is an open call whose keys are found") {
    const auto at_end = [](std::string_view text) {
        const auto call = open_call(text, text.size());
        return call ? std::string(call->callee) + " " + std::string(call->key) : "none";
    };
    CHECK(at_end("Body{") == "Body ");
    CHECK(at_end("Body {") == "Body ");
    CHECK(at_end("world.ball = Body { mass = 2, position = ") == "Body position");
    CHECK(at_end("Body({ mass = 2, friction = ") == "Body friction");
    CHECK(at_end("Body { mass = 2, Box { width = ") == "Box width");
    CHECK(at_end("Body { mass = 2, Box { width = 3 }, ") == "Body ");
    CHECK(at_end("Polygon { vertices = { vec(1, 2), ") == "Polygon vertices");
    CHECK(at_end("Body { mass = vec(1, ") == "vec ");
    CHECK(at_end("Body { mass == ") == "Body ");
    for (const char* const text : {"return {", "a = {", "return {1, ", "Body { mass = 2 }"})
        CHECK(at_end(text) == "none");
}

TEST_CASE("the properties in the text of a constructor are found") {
    const std::string_view text = "Body { type, position, angle, … }";
    const auto found = [&](std::string_view name) {
        const auto range = console::property_in(text, name);
        return std::string(text.substr(range.begin, range.end - range.begin));
    };
    for (const char* const name : {"type", "position", "angle"}) CHECK(found(name) == name);
    for (const char* const name : {"posit", "mass", "Body", "", "…x"}) CHECK(found(name).empty());
}

TEST_CASE("the parameters of a signature are found") {
    const std::string_view text = "f(a: number, b?: fun(x: number, y: text), ...: any): text";
    CHECK(parameter(text, 0) == "a: number");
    CHECK(parameter(text, 1) == "b?: fun(x: number, y: text)");
    CHECK(parameter(text, 2) == "...: any");
    CHECK(parameter(text, 7) == "...: any");
    CHECK(parameter("apply_force(force [, point])", 0) == "force");
    CHECK(parameter("apply_force(force [, point])", 1) == "point");
    CHECK(parameter("raycast(from, to [, mask] [, group])", 2) == "mask");
    CHECK(parameter("f(points: vec[] [, closed])", 0) == "points: vec[]");
    CHECK(parameter("f(a)", 1).empty());
    CHECK(parameter("f()", 0).empty());
    CHECK(parameter("number", 0).empty());
}

TEST_CASE("a constructor shows its class with the first sentence and the main properties") {
    property::Tree tree;
    property::ClassDescriptor shape;
    shape.name = "Shape";
    shape.properties = {{.name = "density", .default_value = 1.0}};
    tree.define(shape);
    property::ClassDescriptor box;
    box.name = "Box";
    box.base = "Shape";
    box.doc = "A box around `position`. More is said later.";
    box.properties = {{.name = "width", .default_value = 1.0},
                      {.name = "area", .default_value = 1.0, .read_only = true}};
    tree.define(box);
    script::Runtime runtime(tree, {});
    console::Console lua(tree, runtime);
    lua.open();
    console::test::RasterSurface window(1280, 720);
    for (const char* const text : {"Box(", "Box{", "x = Box { "}) {
        CAPTURE(text);
        lua.state().prompt.edit().assign(text);
        const auto shown = lua.state().prompt.signature();
        REQUIRE(shown);
        CHECK(shown->text == "Box { width, density }");
        CHECK(shown->doc == "A box around position.");
        for (int i = 0; i < 2; ++i) lua.draw(window, 1.0 / 60);
        CHECK_FALSE(lua.state().views.prompt_view.signature_rect().empty());
    }
    lua.state().prompt.edit().assign("Box { width = 2, density = ");
    const auto shown = lua.state().prompt.signature();
    REQUIRE(shown);
    CHECK(shown->text.substr(shown->parameter.begin,
                             shown->parameter.end - shown->parameter.begin) == "density");
}

TEST_CASE("a long signature has several lines in a narrow window") {
    console::test::Rig rig;
    script::Runtime runtime(rig.tree, {});
    console::Console lua(rig.tree, runtime);
    lua.open();
    lua.state().prompt.edit().insert("ab(");
    REQUIRE(lua.state().prompt.signature());
    const auto height = [&](unsigned width) {
        console::test::RasterSurface window(width, 600);
        for (int i = 0; i < 3; ++i) lua.draw(window, 1.0 / 60);
        const console::Rect rect = lua.state().views.prompt_view.signature_rect();
        CHECK(rect.high.x <= static_cast<float>(width));
        const ImGuiWindow* const shown = ImGui::FindWindowByName("##signature");
        CHECK(shown->ContentSize.x <= shown->WorkRect.GetWidth() + 1);
        return rect.high.y - rect.low.y;
    };
    INFO(lua.state().prompt.signature()->text);
    CHECK(height(180) > height(1280) + 10);
}

TEST_CASE("the signature is shown while arguments are typed") {
    console::test::Rig rig;
    script::Runtime runtime(rig.tree, {});
    console::Console lua(rig.tree, runtime);
    lua.open();
    const auto type = [&](std::string_view text) {
        for (const char each : text) {
            app::InputEvent event;
            event.kind = app::EventKind::text;
            event.character = static_cast<char32_t>(each);
            lua.handle(event);
        }
        lua.draw(rig.surface, 1.0 / 60);
        lua.draw(rig.surface, 1.0 / 60);
    };
    type("rewind");
    CHECK(lua.state().views.prompt_view.signature_rect().empty());
    type("(");
    CHECK_FALSE(lua.state().views.prompt_view.signature_rect().empty());
    const auto shown = lua.state().prompt.signature();
    REQUIRE(shown);
    CHECK(shown->text.starts_with("rewind(seconds"));
    CHECK(shown->text.substr(shown->parameter.begin,
                             shown->parameter.end - shown->parameter.begin) == "seconds");
    type("2)");
    CHECK(lua.state().views.prompt_view.signature_rect().empty());
    CHECK(rig.surface.faults() == 0);
}

}  // namespace signature_test
