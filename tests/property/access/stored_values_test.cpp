#include <stdexcept>

#include <fettle/property/stored_values.h>

#include "catch.h"
#include "fixture.h"

namespace stored_values_test {

// Many values of one instance: they must be those that `Tree::peek` gives.

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {
struct Fixture {
    Tree tree;
    BallModule module{tree};
    const Class& lamp = tree.define(
        {.name = "Lamp",
         .properties = {{.name = "power", .type = Type::number, .default_value = 2.0},
                        {.name = "arms", .type = Type::integer, .default_value = 3},
                        {.name = "place", .type = Type::vec2},
                        {.name = "lit", .type = Type::boolean, .default_value = true},
                        {.name = "light", .type = Type::color, .default_value = Color{1, 0, 0, 1}},
                        {.name = "label", .type = Type::text, .default_value = "lamp"},
                        {.name = "size", .type = Type::vec2, .nullable = true},
                        {.name = "wear", .type = Type::number, .sparse = true}}});
    const Class& big = tree.define({.name = "BigLamp", .base = "Lamp"});
    const Property& of(const char* name) const { return *lamp.property(name); }
};
}  // namespace

TEST_CASE_METHOD(Fixture, "values of one instance are read without a search for each of them") {
    for (const Class* each : {&lamp, &big}) {
        tree.create(*each, tree.root(), "other");
        const Handle self = tree.create(*each, tree.root(), "self");
        tree.set(self, "place", Vec2(1, 2));
        tree.set(self, "label", "red");
        tree.set(self, "wear", 0.5);
        const StoredValues values(tree, self);
        CHECK(values.number(of("power")) == 2);
        CHECK(values.number(of("wear")) == 0.5);
        CHECK(values.integer(of("arms")) == 3);
        tree.set(self, "arms", 5);
        CHECK(values.integer(of("arms")) == 5);
        CHECK(values.vec2(of("place")) == Vec2(1, 2));
        CHECK(values.boolean(of("lit")));
        CHECK(values.color(of("light")) == Color{1, 0, 0, 1});
        CHECK(values.value(of("label")).text() == "red");
        CHECK(values.value(of("size")).is_nil());
        tree.set(self, "size", Vec2(3, 4));
        tree.set(self, "lit", false);
        CHECK(values.value(of("size")).vec2() == Vec2(3, 4));
        CHECK_FALSE(values.boolean(of("lit")));
        tree.destroy(self);
        tree.destroy(tree.child(tree.root(), "other"));
    }
}

TEST_CASE_METHOD(Fixture, "the values of a module and of failing formulas are read too") {
    const Handle ball = tree.create(*module.type, tree.root(), "ball");
    CHECK(StoredValues(tree, ball).number(*module.type->property("mass")) ==
          tree.peek(ball, *module.type->property("mass")).number());
    const Handle self = tree.create(lamp, tree.root(), "lamp");
    tree.set_formula(self, "power",
                     {[](const Tree& t) { return t.get(t.child(t.root(), "ball"), "mass"); }});
    tree.set(ball, "mass", 7);
    CHECK(tree.get(self, "power").number() == 7);
    tree.destroy(ball);
    CHECK_THROWS(tree.get(self, "power"));
    CHECK(StoredValues(tree, self).number(of("power")) == 7);
}

TEST_CASE_METHOD(Fixture, "a wrong read of one instance's values is an error") {
    const Handle self = tree.create(lamp, tree.root(), "lamp");
    const StoredValues values(tree, self);
    CHECK_THROWS_AS(values.value(of("power")), std::logic_error);
    CHECK_THROWS_AS(values.vec2(of("power")), Error);
    CHECK_THROWS_AS(values.number(of("label")), Error);
    tree.destroy(self);
    CHECK_THROWS_AS(StoredValues(tree, self), Error);
}

}  // namespace stored_values_test
