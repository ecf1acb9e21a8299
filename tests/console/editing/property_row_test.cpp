// Rows of the inspector: their order, marks that reset a value, texts of several lines.

#include <cmath>
#include <set>
#include <string>

#include "catch.h"
#include "rig.h"

namespace property_row_test {

using namespace fettle;
using console::test::Rig;
using property::Handle;
using property::Value;

namespace {

Handle in_world(const Rig& rig, const char* name) {
    return rig.tree.child(rig.tree.child(rig.tree.root(), "world"), name);
}

}  // namespace

TEST_CASE("the properties of a class stay together where a derived class has other defaults") {
    property::Tree tree;
    property::ClassDescriptor base;
    base.name = "Base";
    for (const char* name : {"first", "second", "third"})
        base.properties.push_back(
            {.name = name, .type = property::Type::number, .default_value = Value(1.0)});
    tree.define(std::move(base));
    property::ClassDescriptor derived;
    derived.name = "Derived";
    derived.base = "Base";
    derived.properties.push_back(
        {.name = "second", .type = property::Type::number, .default_value = Value(2.0)});
    const Handle one = tree.create(tree.define(std::move(derived)), tree.root(), "one");
    std::string titles;
    const property::Class* owner = nullptr;
    for (const property::Property* each : console::grouped_by_class(tree.properties(one))) {
        if (each->owner != owner) titles += each->owner->name() + " ";
        owner = each->owner;
    }
    CHECK(titles == "Object Base Derived ");
}

TEST_CASE("the properties of the game's own classes come first") {
    property::Tree tree;
    const auto define = [&](const char* name, const char* base) {
        property::ClassDescriptor made;
        made.name = name;
        made.base = base;
        made.properties.push_back({.name = std::string("of_") + name,
                                   .type = property::Type::number,
                                   .default_value = Value(1.0)});
        return &tree.define(std::move(made));
    };
    define("Solid", "Object");
    const property::Class* const enemy = define("Enemy", "Solid");
    const property::Class* const boss = define("Boss", "Enemy");
    const Handle one = tree.create(*boss, tree.root(), "one");
    tree.set_or_add(one, "mark", Value(1));
    std::string titles;
    const property::Class* owner = nullptr;
    for (const property::Property* each : console::grouped_by_class(
             tree.properties(one),
             [&](const property::Class& of) { return &of == enemy || &of == boss; })) {
        const bool added = each->binding.kind == property::BindingKind::ad_hoc;
        if (!added && each->owner != owner) titles += each->owner->name() + " ";
        if (added) titles += each->name;
        owner = added ? nullptr : each->owner;
    }
    CHECK(titles == "Boss Enemy Object Solid mark");
}

TEST_CASE("the values of all rows begin at one column or below their names") {
    for (const double scale : {1.0, 1.5, 2.0})
        for (const double width : {230.0, 280.0, 330.0, 380.0, 450.0}) {
            INFO("scale " << scale << ", width " << width);
            Rig rig;
            rig.key("grave");
            rig.state().settings.set("scale", Value(scale));
            rig.state().settings.set("inspector_width", Value(width));
            console::test::RasterSurface window(1900, 2600);
            const Handle ball = in_world(rig, "ball");
            rig.console.select(ball);
            for (int i = 0; i < 4; ++i) rig.console.draw(window, 1.0 / 60);
            std::set<int> columns;
            for (const property::Property* each : rig.tree.properties(ball)) {
                const console::Rect at = rig.state().inspector.editor().widget_rect(*each);
                if (!at.empty()) columns.insert(static_cast<int>(std::round(at.low.x)));
            }
            CHECK(!columns.empty());
            CHECK(columns.size() <= 2);
        }
}

TEST_CASE("numbers in names of added properties count as numbers in the inspector") {
    property::Tree tree;
    const Handle one = tree.create(tree.object_class(), tree.root(), "one");
    for (const char* name : {"gap_10", "gap_2", "gap_1"}) tree.set_or_add(one, name, Value(1));
    std::string names;
    for (const property::Property* each : console::grouped_by_class(tree.properties(one)))
        if (each->name.starts_with("gap")) names += each->name + " ";
    CHECK(names == "gap_1 gap_2 gap_10 ");
}

TEST_CASE("a value that a step wrote has no reset mark even if its module reports it as set") {
    Rig rig;
    rig.key("grave");
    bool awake = false;
    property::Property property{.name = "roused",
                                .type = property::Type::boolean,
                                .default_value = true,
                                .simulated = true};
    property::Binding& binding = property.binding;
    binding.kind = property::BindingKind::accessor;
    binding.context = &awake;
    binding.get = [](void* it, property::Row) { return Value(*static_cast<bool*>(it)); };
    binding.set = [](void* it, property::Row, const Value& value) {
        *static_cast<bool*>(it) = value.boolean();
    };
    binding.reset = [](void* it, property::Row) { *static_cast<bool*>(it) = true; };
    binding.overridden = [](void* it, property::Row) { return !*static_cast<bool*>(it); };
    const Handle sleeper = rig.tree.create(
        rig.tree.define({.name = "Sleeper", .properties = {property}}), rig.tree.root(), "sleeper");
    rig.console.select(sleeper);
    rig.draw(3);
    const auto click_mark = [&] {
        const console::Rect row =
            rig.state().inspector.editor().widget_rect(rig.tree.property(sleeper, "roused"));
        const console::Rect gutter =
            rig.state().inspector.editor().gutter_rect(rig.tree.property(sleeper, "roused"));
        REQUIRE_FALSE(gutter.empty());
        rig.click(gutter.low.x - ImGui::GetFrameHeight() / 2, row.middle().y);
        rig.draw(2);
    };
    click_mark();
    CHECK_FALSE(awake);
    awake = true;
    {
        const property::Tree::CauseScope cause(rig.tree, property::Writer::console);
        rig.tree.set(sleeper, "roused", Value(false));
    }
    rig.draw(2);
    click_mark();
    CHECK(awake);
}

TEST_CASE("a text of several lines is edited in one line and keeps its line ends") {
    Rig rig;
    const Handle ball = rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball");
    rig.key("grave");
    rig.console.select(ball);
    rig.tree.set(ball, "label", Value("one\ntwo ↵"));
    rig.draw(3);
    const auto append = [&](const char* text) {
        const ImVec2 at = rig.widget("label");
        rig.click(at.x, at.y);
        rig.draw(3);
        rig.key("end");
        rig.type(text);
        rig.key("enter");
        rig.draw(3);
    };
    append("!");
    CHECK(rig.value("world.ball.label").text() ==
          "one\ntwo ↵");  // a line end in it could not be told from this sign
    rig.tree.set(ball, "label", Value("one\ntwo"));
    rig.draw(3);
    append(" and more");
    CHECK(rig.value("world.ball.label").text() == "one\ntwo and more");
}

TEST_CASE("the column of names is as wide as the names of an instance need") {
    Rig rig;
    const auto scale = GENERATE(1.0, 2.0);
    property::set(rig.tree, "console.scale", Value(scale));
    rig.key("grave");
    rig.console.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.draw(3);
    rig.widget("position");
    const Handle ball = rig.console.selected();
    const auto room_of = [&](const char* name) {
        const console::Rect value =
            rig.state().inspector.editor().widget_rect(rig.tree.property(ball, name));
        return value.low.x - rig.state().screen.inspector_rect.low.x;
    };
    if (scale == 1.0) CHECK(room_of("position") > ImGui::CalcTextSize("position").x);
    const auto lines_of_position = [&] {
        const console::Rect fields =
            rig.state().inspector.editor().widget_rect(rig.tree.property(ball, "position"));
        return (fields.high.y - fields.low.y) / ImGui::GetFrameHeight();
    };
    const float before = lines_of_position();
    // A name that would leave its value no room is cut, and no vector needs another line for it.
    const char* const longest = "the_longest_of_all_names_of_properties_in_this_game";
    rig.tree.set_or_add(ball, longest, Value(1));
    rig.draw(3);
    rig.widget("position");
    CHECK(lines_of_position() == before);
    const ImVec2 value = rig.widget(longest);
    CHECK(value.x > 0);
    CHECK(room_of(longest) < ImGui::CalcTextSize(longest).x);
}

TEST_CASE("every field has room for four digits and for each enumerator") {
    struct Window {
        unsigned width, height;
        double scale;
    };
    const auto [width, height, scale] =
        GENERATE(Window{400, 600, 1.0}, Window{1280, 800, 1.0}, Window{1280, 800, 2.0},
                 Window{1920, 1080, 2.0}, Window{3840, 2160, 4.0});
    INFO(width << " x " << height << ", scale " << scale);
    Rig rig;
    rig.surface = console::test::RasterSurface(width, height);
    property::set(rig.tree, "console.scale", Value(scale));
    rig.key("grave");
    rig.console.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.draw(3);
    const auto room_of = [&](const char* name) {
        rig.widget(name);
        const console::Rect widget = rig.state().inspector.editor().widget_rect(
            rig.tree.property(rig.console.selected(), name));
        return widget.high.x - widget.low.x;
    };
    const float pad = 2 * ImGui::GetStyle().FramePadding.x;
    const auto needs = [&](const char* text) { return ImGui::CalcTextSize(text).x + pad; };
    CHECK(room_of("friction") >= needs("-0.001235"));
    CHECK(room_of("angle") >= needs("-0.001235 rad"));
    CHECK(room_of("type") >= needs("kinematic") + ImGui::GetFrameHeight());
    CHECK(room_of("color") >= needs("#e9ecef80") + ImGui::GetFrameHeight());
    rig.widget("position");
    const console::Rect fields = rig.state().inspector.editor().widget_rect(
        rig.tree.property(rig.console.selected(), "position"));
    const bool stacked = fields.high.y - fields.low.y > 1.5f * ImGui::GetFrameHeight();
    CHECK((fields.high.x - fields.low.x) / (stacked ? 1 : 2) >= needs("x-0.001235"));
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("an edit that is too large to be undone says so when it is made") {
    Rig rig;
    rig.key("grave");
    rig.console.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.draw(3);
    rig.tree.set_history_limit(1);
    const ImVec2 at = rig.widget("angle");
    rig.drag(at.x, at.y, at.x + 50, at.y);
    rig.draw(3);
    const std::string log = rig.log_text();
    INFO(log);
    CHECK(rig.logged("this edit took too much memory to be undone"));
    CHECK(log.find("too much memory") == log.rfind("too much memory"));
}

}  // namespace property_row_test
