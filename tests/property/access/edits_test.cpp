#include <limits>

#include "catch.h"
#include "fixture.h"

#include <fettle/property/spelling.h>

namespace edits_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {
struct Fixture {
    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");
    Handle ball = tree.create(*module.type, world, "ball");
};
}  // namespace

TEST_CASE_METHOD(Fixture,
                 "properties have their defaults before a callback can read the instance") {
    CHECK(tree.get(ball, "mass") == Value(1.0));
    CHECK(tree.get(ball, "kind") == Value("dynamic"));
    CHECK(tree.get(ball, "radius") == Value(0.5));
    bool seen = false;
    tree.watch_created(*module.type, [&](const Existence& e) {
        seen = true;
        CHECK(tree.get(e.instance, "radius") == Value(0.5));
    });
    tree.create(*module.type, world);
    tree.barrier();
    CHECK(seen);
}

TEST_CASE_METHOD(Fixture, "an edit writes the module's own memory and survives its reallocation") {
    tree.set(ball, "mass", 2.5);
    CHECK(module.ball(ball).mass == 2.5f);
    for (int i = 0; i < 1000; ++i) tree.create(*module.type, world);
    CHECK(tree.get(ball, "mass") == Value(2.5));
    module.ball(ball).mass = 4;
    CHECK(tree.get(ball, "mass") == Value(4.0));
}

TEST_CASE_METHOD(Fixture, "a float property is widened exactly and printed with few digits") {
    tree.set(ball, "mass", 0.1);
    CHECK(tree.get(ball, "mass").number() == static_cast<double>(0.1f));
    CHECK(tree.text(tree.get(ball, "mass"), tree.property(ball, "mass").precision()) == "0.1");
    CHECK(number_text(0.1) == "0.1");
    CHECK(number_text(static_cast<double>(0.1f)) == "0.10000000149011612");
}

TEST_CASE_METHOD(Fixture, "an integer becomes a number exactly or is refused") {
    tree.set(ball, "mass", 3);
    CHECK(tree.get(ball, "mass") == Value(3.0));
    tree.set(ball, "radius", 7);
    CHECK(tree.get(ball, "radius") == Value(7.0));
    tree.set_or_add(ball, "score", std::int64_t{9007199254740993});
    CHECK(tree.get(ball, "score") == Value(std::int64_t{9007199254740993}));
    CHECK_THAT(message_of([&] { tree.set(ball, "mass", std::int64_t{16777217}); }),
               contains("16777217"));
    CHECK_THAT(message_of([&] { tree.set(ball, "charge", std::int64_t{9007199254740993}); }),
               contains("world.ball.charge") && contains("9007199254740993"));
}

TEST_CASE_METHOD(Fixture, "minus two is stored as minus two") {
    tree.set_or_add(ball, "lives", -2);
    CHECK(tree.get(ball, "lives") == Value(-2));
    tree.set(ball, "charge", -2);
    CHECK(tree.get(ball, "charge") == Value(-2.0));
}

TEST_CASE_METHOD(Fixture, "no property accepts NaN and only some accept infinity") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const char* name : {"mass", "charge", "radius"})
        CHECK_THAT(message_of([&] { tree.set(ball, name, nan); }), contains("nan"));
    CHECK_THROWS_AS(tree.set(ball, "velocity", Vec2(0, nan)), Error);
    CHECK_THROWS_AS(tree.set_or_add(ball, "x", nan), Error);
    CHECK_THROWS_AS(tree.set_or_add(ball, "x", List{Value(1), Value(nan)}), Error);
    CHECK_THAT(message_of([&] { tree.set(ball, "mass", inf); }),
               contains("infinity is not allowed"));
    tree.set(ball, "charge", inf);  // the descriptor asks for clamping
    CHECK(tree.get(ball, "charge") == Value(10.0));
    tree.set_or_add(ball, "limit", inf);
    CHECK(tree.get(ball, "limit") == Value(inf));
    CHECK_THROWS_AS(tree.set(ball, "velocity", Vec2(inf, 0)), Error);
    CHECK_THROWS_AS(tree.set(ball, "mass", 1e300), Error);
}

TEST_CASE_METHOD(Fixture,
                 "a refused edit reports path and value and range and unit and changes nothing") {
    tree.set(ball, "mass", 5);
    const std::string message = message_of([&] { tree.set(ball, "mass", -1); });
    CHECK_THAT(message,
               contains("world.ball.mass") && contains("from 0 to 1e6 kg") && contains("got -1"));
    CHECK(tree.get(ball, "mass") == Value(5.0));
    CHECK_THAT(message_of([&] { tree.set(ball, "mass", "heavy"); }),
               contains("got text \"heavy\""));
    CHECK_THAT(
        message_of([&] { tree.set(ball, "kind", "statik"); }),
        contains("\"dynamic\", \"static\", \"kinematic\"") && contains("did you mean \"static\"?"));
    CHECK_THAT(message_of([&] { tree.set(ball, "radius", 13); }),
               contains("world.ball.radius: thirteen"));
    CHECK_THAT(message_of([&] { tree.set(ball, "area", 1); }),
               contains("world.ball.area is read-only"));
}

TEST_CASE_METHOD(Fixture, "an unknown name is an error with the nearest spelling") {
    CHECK_THAT(
        message_of([&] { tree.get(ball, "masss"); }),
        contains("world.ball has no property \"masss\"") && contains("did you mean \"mass\"?"));
    CHECK_THAT(message_of([&] { set(tree, "world.bal.mass", 1); }),
               contains("did you mean \"ball\"?"));
    CHECK_THAT(message_of([&] { tree.call(ball, "grwo", {1.0}); }),
               contains("did you mean \"grow\"?"));
}

TEST_CASE("a name of one letter is similar to the last word of a name and to no other letter") {
    const std::vector<std::string> names = {"z", "body_a", "body_b", "out_bounce"};
    CHECK(suggestion("a", names) == " (did you mean \"body_a\"?)");
    CHECK(suggestion("q", names).empty());
    CHECK(suggestion("bounce", names) == " (did you mean \"out_bounce\"?)");
    CHECK(suggestion("Z", names) == " (did you mean \"z\"?)");
}

TEST_CASE_METHOD(Fixture,
                 "writing an unknown name adds a property unless it is similar to a declared one") {
    tree.set_or_add(ball, "lives", 3);
    CHECK(tree.get(ball, "lives") == Value(3));
    CHECK_THAT(message_of([&] { tree.set_or_add(ball, "velosity", 1); }),
               contains("did you mean \"velocity\"?"));
    CHECK_THAT(message_of([&] { tree.set_or_add(ball, "Mass", 1); }),
               contains("did you mean \"mass\"?"));
    CHECK_THAT(message_of([&] { tree.set_or_add(ball, "amss", 1); }),
               contains("did you mean \"mass\"?"));
    tree.set_or_add(ball, "max", 1);  // two letters differ
    CHECK(tree.ad_hoc(ball).size() == 2);
    tree.set(ball, "lives", Value());
    CHECK(tree.find(ball, "lives") == nullptr);
    CHECK_THAT(message_of([&] { tree.set_or_add(ball, "grow", 1); }), contains("is a method"));
    CHECK_THAT(message_of([&] { tree.set_or_add(world, "ball", 1); }), contains("is a child"));
}

TEST_CASE_METHOD(Fixture, "assigning nil restores the default") {
    tree.set(ball, "mass", 9);
    CHECK(tree.overridden(ball, tree.property(ball, "mass")));
    tree.set(ball, "mass", Value());
    CHECK(tree.get(ball, "mass") == Value(1.0));
    CHECK_FALSE(tree.overridden(ball, tree.property(ball, "mass")));
}

TEST_CASE_METHOD(Fixture, "an edit wakes the ball and ten edits cause one rebuild") {
    module.ball(ball).awake = false;
    tree.set(ball, "mass", 2);
    CHECK(module.ball(ball).awake);
    module.ball(ball).awake = false;
    tree.set(ball, "mass", 2);  // equal: nothing happens
    CHECK_FALSE(module.ball(ball).awake);
    tree.get(ball, "area");
    const int before = module.ball(ball).rebuilds;
    for (int i = 1; i <= 10; ++i) tree.set(ball, "radius", 1.0 + i);
    CHECK(module.ball(ball).rebuilds == before);
    CHECK(tree.get(ball, "area") == Value(363.0));
    CHECK(tree.get(ball, "area") == Value(363.0));
    CHECK(module.ball(ball).rebuilds == before + 1);
}

TEST_CASE_METHOD(Fixture, "writing a part of a value by path writes the whole value") {
    set(tree, "world.ball.velocity", Vec2(1, 2));
    set(tree, "world.ball.velocity.x", 3);
    CHECK(tree.get(ball, "velocity") == Value(Vec2(3, 2)));
    CHECK(get(tree, "game.world.ball.velocity.y") == Value(2.0));
    tree.set_or_add(ball, "points", List{Vec2(0, 0), Vec2(1, 0)});
    set(tree, "world.ball.points[2]", Vec2(5, 5));
    set(tree, "world.ball.points[3]", Vec2(6, 6));
    set(tree, "world.ball.points[3].y", 7);
    CHECK(tree.get(ball, "points") == Value(List{Vec2(0, 0), Vec2(5, 5), Vec2(6, 7)}));
    CHECK_THAT(message_of([&] { set(tree, "world.ball.points[9]", Vec2(0, 0)); }),
               contains("world.ball.points") && contains("1 to 3"));
    CHECK_THAT(message_of([&] { set(tree, "world.ball.velocity.z", 1); }),
               contains("the parts x and y"));
}

TEST_CASE_METHOD(Fixture, "a class may redeclare the default of a property that it inherits") {
    ClassDescriptor d;
    d.name = "HeavyBall";
    d.base = "Ball";
    d.properties = {{.name = "mass", .default_value = 50.0},
                    {.name = "lives", .type = Type::integer, .default_value = 3},
                    {.name = "title", .type = Type::text, .default_value = "boss"}};
    const Class& heavy = tree.define(std::move(d));
    const Handle boss = tree.create(heavy, world, "boss");
    CHECK(tree.get(boss, "mass") == Value(50.0));
    CHECK(tree.get(boss, "lives") == Value(3));
    CHECK(tree.get(boss, "title") == Value("boss"));
    CHECK(module.ball(boss).mass == 50);
    tree.set(boss, "mass", 1);
    tree.set(boss, "mass", Value());
    CHECK(tree.get(boss, "mass") == Value(50.0));
    CHECK(tree.get(ball, "mass") == Value(1.0));
    CHECK_FALSE(tree.overridden(boss, tree.property(boss, "mass")));
    tree.set(boss, "lives", 1);
    tree.destroy(boss);
    const Handle again = tree.create(heavy, world, "again");
    CHECK(tree.get(again, "lives") == Value(3));
}

TEST_CASE_METHOD(Fixture, "an invalid class descriptor is refused") {
    ClassDescriptor d;
    d.name = "Broken";
    d.properties = {{.name = "size", .default_value = -1.0, .range = {0, 1}}};
    CHECK_THAT(message_of([&] { tree.define(d); }), contains("class Broken: default of size"));
    d.properties.clear();
    d.base = "Boll";
    CHECK_THAT(message_of([&] { tree.define(d); }), contains("did you mean \"Ball\"?"));
    d.name = "Ball";
    CHECK_THROWS_AS(tree.define(d), Error);
}

TEST_CASE_METHOD(Fixture, "references accept only existing instances of their class") {
    tree.set_or_add(ball, "target", world);
    CHECK(tree.text(tree.get(ball, "target")) == "world");
    const Handle other = tree.create(*module.type, world, "other");
    tree.set(ball, "target", other);
    CHECK(get(tree, "world.ball.target.mass") == Value(1.0));
    tree.destroy(other);
    CHECK(tree.text(tree.get(ball, "target")) == "(deleted)");
    CHECK_THAT(message_of([&] { tree.set(ball, "target", other); }),
               contains("world.other was deleted at step 0"));
}

TEST_CASE("values compare by their bits") {
    CHECK_FALSE(Value(1) == Value(1.0));
    CHECK_FALSE(Value(0.0) == Value(-0.0));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(Value(nan) == Value(nan));
    CHECK(Value("a") == Value(std::string("a")));
    CHECK(Value(List{Value(1), Value("x")}) == Value(List{Value(1), Value("x")}));
}

}  // namespace edits_test
