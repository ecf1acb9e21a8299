#include <optional>

#include "catch.h"
#include "fixture.h"

namespace watchers_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {
struct Fixture {
    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");
    Handle ball = tree.create(*module.type, world, "ball");
    std::vector<std::string> log;

    ChangeHandler note(const std::string& who) {
        return [this, who](const Change& c) {
            log.push_back(who + " " + tree.path(c.instance, *c.property) + " " +
                          tree.text(c.old_value) + ">" + tree.text(c.new_value));
        };
    }
};
using Log = std::vector<std::string>;
}  // namespace

TEST_CASE_METHOD(Fixture,
                 "changes are delivered at the barrier combined and in order of registration") {
    tree.watch(ball, "mass", note("a"));
    tree.watch(*module.type, module.type->property("mass"), note("b"));
    tree.watch_pattern("world.*.mass", note("c"));
    tree.watch(ball, note("d"));
    tree.set(ball, "mass", 2);
    tree.set(ball, "mass", 3);
    CHECK(log.empty());
    tree.barrier();
    CHECK(log == Log{"a world.ball.mass 1>3", "b world.ball.mass 1>3", "c world.ball.mass 1>3",
                     "d world.ball.mass 1>3"});
    tree.barrier();
    CHECK(log.size() == 4);
}

TEST_CASE_METHOD(Fixture, "a value that returns to its old value is not a change") {
    tree.watch(ball, "mass", note("a"));
    tree.set(ball, "mass", 2);
    tree.set(ball, "mass", 1);
    tree.barrier();
    CHECK(log.empty());
}

TEST_CASE_METHOD(Fixture, "changes contain their cause and step") {
    std::optional<Change> seen;
    tree.watch(ball, "mass", [&](const Change& c) { seen = c; });
    tree.set_step(30);
    tree.stepped();
    std::function<std::string()> locate = [] { return std::string("main.lua:30"); };
    {
        Tree::CauseScope scope(tree, Writer::script, &locate);
        tree.set(ball, "mass", 2);
    }
    tree.barrier();
    REQUIRE(seen);
    CHECK(seen->cause.writer == Writer::script);
    CHECK(seen->cause.text() == "main.lua:30, step 30");
}

TEST_CASE_METHOD(Fixture,
                 "a watcher of one instance does not make writes of other instances slower") {
    tree.watch(tree.create(tree.object_class(), tree.root(), "settings"), note("a"));
    int reads = 0;
    std::function<std::string()> locate = [&] {
        ++reads;
        return std::string("main.lua:30");
    };
    Tree::CauseScope scope(tree, Writer::script, &locate);
    for (int i = 2; i < 9; ++i) tree.set(ball, "mass", i);
    CHECK(reads == 0);
}

TEST_CASE_METHOD(Fixture, "changes by the simulation are found at the barrier after the step") {
    tree.watch(ball, "velocity", note("a"));
    module.ball(ball).velocity[0] = 5;
    tree.barrier();
    CHECK(log.empty());  // no step was made
    tree.set_step(1);
    tree.stepped();
    tree.barrier();
    CHECK(log == Log{"a world.ball.velocity vec(0, 0)>vec(5, 0)"});
    tree.set_step(2);
    tree.stepped();
    tree.barrier();
    CHECK(log.size() == 1);
}

TEST_CASE_METHOD(Fixture, "an edit of a simulated property is reported once") {
    tree.watch(ball, "velocity", note("a"));
    tree.set(ball, "velocity", Vec2(1, 0));
    tree.set_step(1);
    tree.stepped();
    tree.barrier();
    CHECK(log == Log{"a world.ball.velocity vec(0, 0)>vec(1, 0)"});
}

TEST_CASE_METHOD(
    Fixture,
    "pattern and class watchers include new and moved instances and exclude deleted ones") {
    tree.watch_pattern("world.*.velocity", note("p"));
    const Handle late = tree.create(*module.type, world, "late");
    const Handle away = tree.create(*module.type, tree.root(), "away");
    module.ball(late).velocity[1] = 1;
    module.ball(away).velocity[1] = 1;
    tree.set_step(1);
    tree.stepped();
    tree.barrier();
    CHECK(log == Log{"p world.late.velocity vec(0, 0)>vec(0, 1)"});
    tree.move(away, world);
    module.ball(away).velocity[1] = 2;
    tree.destroy(late);
    tree.set_step(2);
    tree.stepped();
    tree.barrier();
    CHECK(log.size() == 2);
    CHECK(log.back() == "p world.away.velocity vec(0, 1)>vec(0, 2)");
}

TEST_CASE_METHOD(Fixture, "a watcher of a derived value is called when its source is edited") {
    tree.get(ball, "area");
    tree.watch(ball, "area", note("a"));
    tree.set(ball, "radius", 1.0);
    tree.barrier();
    CHECK(log == Log{"a world.ball.area 0.75>3"});
}

TEST_CASE_METHOD(Fixture, "writes by a handler are in the next generation of the same barrier") {
    tree.watch(ball, "mass", [&](const Change& c) {
        log.push_back("mass " + tree.text(c.new_value));
        if (c.new_value.number() < 4) tree.set(ball, "mass", c.new_value.number() + 1);
    });
    tree.set(ball, "mass", 2);
    tree.barrier();
    CHECK(log == Log{"mass 2", "mass 3", "mass 4"});
}

TEST_CASE_METHOD(Fixture, "endless handlers stop the barrier with the chain of paths and causes") {
    const Handle other = tree.create(*module.type, world, "other");
    tree.watch(ball, "mass",
               [&](const Change& c) { tree.set(other, "mass", c.new_value.number() + 1); });
    tree.watch(other, "mass",
               [&](const Change& c) { tree.set(ball, "mass", c.new_value.number() + 1); });
    tree.set(ball, "mass", 2);
    const std::string message = message_of([&] { tree.barrier(); });
    CHECK_THAT(message, contains("16 rounds") && contains("world.ball.mass by module, step 0") &&
                            contains("world.other.mass"));
    tree.barrier();  // the next barrier works
    CHECK(tree.get(ball, "mass") == Value(18.0));
}

TEST_CASE_METHOD(Fixture,
                 "a handler may remove itself and others and every other handler is called once") {
    Connection first, second, third;
    first = tree.watch(ball, "mass", [&](const Change&) {
        log.push_back("first");
        first.stop();
        third.stop();
    });
    second = tree.watch(ball, "mass", [&](const Change&) { log.push_back("second"); });
    third = tree.watch(ball, "mass", [&](const Change&) { log.push_back("third"); });
    tree.watch(ball, "mass", [&](const Change&) { log.push_back("fourth"); });
    tree.set(ball, "mass", 2);
    tree.barrier();
    CHECK(log == Log{"first", "second", "fourth"});
    CHECK_FALSE(first.active());
    CHECK(second.active());
    tree.set(ball, "mass", 3);
    tree.barrier();
    CHECK(log == Log{"first", "second", "fourth", "second", "fourth"});
}

TEST_CASE_METHOD(
    Fixture,
    "a handler may delete the instance of its change and the others still get the change") {
    tree.watch(*module.type, module.type->property("mass"), [&](const Change& c) {
        log.push_back("first");
        tree.destroy(c.instance);
    });
    tree.watch(*module.type, module.type->property("mass"), [&](const Change& c) {
        log.push_back(tree.alive(c.instance) ? "alive" : "second");
    });
    tree.watch_deleted(*module.type,
                       [&](const Existence& e) { log.push_back("deleted " + e.path); });
    tree.set(ball, "mass", 2);
    tree.barrier();
    CHECK(log == Log{"first", "second", "deleted world.ball"});
}

TEST_CASE_METHOD(
    Fixture,
    "a deletion is reported once with the last values and ends the watchers of the instance") {
    tree.set(ball, "mass", 8);
    int deleted = 0;
    tree.watch(ball, "mass", note("cell"));
    const Connection gone = tree.watch_deleted(ball, [&](const Existence& e) {
        ++deleted;
        CHECK(e.path == "world.ball");
        CHECK_FALSE(tree.alive(e.instance));
        for (const auto& [property, value] : e.last_values)
            if (property->name == "mass") CHECK(value == Value(8.0));
    });
    tree.on(ball, *module.type->event("deleted"),
            [&](const Occurrence& o) { log.push_back("event " + o.record.get("path").text()); });
    tree.destroy(ball);
    // The slot is reused before the barrier: the new instance has none of the old watchers.
    const Handle next = tree.create(*module.type, world, "next");
    REQUIRE(next.index == ball.index);
    tree.set(next, "mass", 3);
    tree.barrier();
    CHECK(deleted == 1);
    CHECK(log == Log{"event world.ball"});
    CHECK(tree.watcher_count() == 0);
    CHECK_FALSE(gone.active());
}

TEST_CASE_METHOD(Fixture,
                 "instances and watchers created by a handler are notified only of later changes") {
    tree.watch(ball, "mass", [&](const Change&) {
        const Handle made = tree.create(*module.type, world, "made");
        tree.watch(ball, "mass", note("late"));
        tree.watch(made, "mass", note("made"));
        tree.set(made, "mass", 7);
    });
    tree.set(ball, "mass", 2);
    tree.barrier();
    CHECK(log == Log{"made world.made.mass 1>7"});
}

TEST_CASE_METHOD(Fixture, "a handler that throws is reported by name and the others are called") {
    std::vector<HandlerError> errors;
    tree.on_handler_error([&](const HandlerError& e) { errors.push_back(e); });
    tree.watch(ball, "mass", [](const Change&) { throw std::runtime_error("boom"); },
               {.label = "main.lua:12"});
    tree.watch(ball, "mass", note("b"));
    tree.set(ball, "mass", 2);
    tree.barrier();
    CHECK(log.size() == 1);
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].path == "world.ball.mass");
    CHECK(errors[0].where == "main.lua:12");
    CHECK(errors[0].message == "boom");
}

TEST_CASE_METHOD(Fixture, "a new watcher gets the current value if requested") {
    tree.watch(ball, "mass", note("a"), {.initial = true});
    tree.watch_pattern("**.radius", note("p"), {.initial = true});
    tree.set(ball, "mass", 2);
    tree.barrier();
    CHECK(log ==
          Log{"a world.ball.mass nil>2", "p world.ball.radius nil>0.5", "a world.ball.mass 1>2"});
}

TEST_CASE_METHOD(Fixture, "the first old value of a new watcher is that of its beginning") {
    tree.watch(ball, "mass", note("a"));
    tree.set(ball, "mass", 2);
    tree.watch(world, note("other"));  // of another instance, so it divides no change
    tree.set(ball, "mass", 3);
    tree.watch(ball, "mass", note("b"));
    tree.set(ball, "mass", 4);
    tree.set(ball, "mass", 5);
    tree.barrier();
    CHECK(log == Log{"a world.ball.mass 1>3", "a world.ball.mass 3>5", "b world.ball.mass 3>5"});
    tree.watch(ball, "radius", note("c"));
    log.clear();
    tree.set(ball, "radius", 2);
    tree.watch(ball, "radius", note("d"));
    tree.barrier();
    CHECK(log == Log{"c world.ball.radius 0.5>2"});
}

TEST_CASE_METHOD(Fixture, "ad-hoc properties are watched like declared ones") {
    tree.watch_pattern("world.ball.*", note("p"));
    tree.set_or_add(ball, "lives", 3);
    tree.barrier();
    tree.set(ball, "lives", 2);
    tree.barrier();
    tree.remove_ad_hoc(ball, "lives");
    tree.barrier();
    CHECK(log ==
          Log{"p world.ball.lives nil>3", "p world.ball.lives 3>2", "p world.ball.lives 2>nil"});
}

TEST_CASE_METHOD(Fixture, "events are delivered to handlers of the instance and of its class") {
    const Event& bounced = *module.type->event("bounced");
    CHECK_FALSE(tree.listens(ball, bounced));
    tree.emit(ball, bounced, {1.0});  // without handlers nothing is stored
    tree.on(ball, bounced,
            [&](const Occurrence& o) { log.push_back("one " + tree.text(o.record.get("speed"))); });
    tree.on(*module.type, bounced, [&](const Occurrence&) { log.push_back("class"); });
    CHECK(tree.listens(ball, bounced));
    tree.emit(ball, bounced, {2.5});
    tree.barrier();
    CHECK(log == Log{"one 2.5", "class"});
}

TEST_CASE("patterns match names at any depth") {
    Tree tree;
    const Handle a = tree.create(tree.object_class(), tree.root(), "a");
    const Handle b = tree.create(tree.object_class(), a, "ball_1");
    const Handle c = tree.create(tree.object_class(), b, "c");
    CHECK(Pattern("a.*").matches(tree, b));
    CHECK_FALSE(Pattern("a.*").matches(tree, c));
    CHECK(Pattern("a.**").matches(tree, c));
    CHECK(Pattern("**.c").matches(tree, c));
    CHECK(Pattern("a.ball_*.c").matches(tree, c));
    CHECK(Pattern("a.b*l*_1").matches(tree, b));
    CHECK_FALSE(Pattern("a.b*x").matches(tree, b));
    CHECK(Pattern("game.a").matches(tree, a));
    for (const char* bad : {"", "a.", "a..b", "a[b]", "a[\"b"})
        CHECK_THROWS_AS(Pattern(bad), Error);
}

TEST_CASE("a connection may outlive its tree") {
    Connection connection;
    {
        Tree tree;
        connection = tree.watch_pattern("**", [](const Change&) {});
        CHECK(connection.active());
    }
    CHECK_FALSE(connection.active());
    connection.stop();
}

TEST_CASE_METHOD(
    Fixture,
    "an instance made and deleted between two barriers is reported only to its own watchers") {
    tree.barrier();
    tree.watch_created(*module.type, [&](const Existence&) { log.push_back("created"); });
    tree.watch_deleted(*module.type, [&](const Existence&) { log.push_back("deleted"); });
    const Handle brief = tree.create(*module.type, world, "brief");
    tree.watch_deleted(brief, [&](const Existence& e) { log.push_back("own " + e.path); });
    tree.destroy(brief);
    tree.barrier();
    CHECK(log == Log{"own world.brief"});
    tree.destroy(ball);
    tree.barrier();
    CHECK(log == Log{"own world.brief", "deleted"});
}

TEST_CASE_METHOD(Fixture,
                 "what a handler makes is reported when it is deleted, as when it is made") {
    tree.watch_created(*module.type, [&](const Existence& e) {
        log.push_back("created");
        if (log.size() < 5) tree.destroy(e.instance);
    });
    Connection deletions = tree.watch_deleted(*module.type, [&](const Existence&) {
        log.push_back("deleted");
        if (log.size() == 2) tree.create(*module.type, world, "again");
    });
    tree.create(*module.type, world, "brief");
    tree.barrier();
    CHECK(log == Log{"created", "deleted", "created", "deleted"});
    deletions.stop();  // the fixture destroys the module before the tree
}

TEST_CASE_METHOD(Fixture,
                 "an instance that is deleted before its creation is reported is not reported") {
    Handle second = {};
    tree.watch_created(*module.type, [&](const Existence& e) {
        log.push_back("created " + e.path);
        tree.destroy(second);
    });
    Connection deletions = tree.watch_deleted(
        *module.type, [&](const Existence& e) { log.push_back("deleted " + e.path); });
    tree.create(*module.type, world, "first");
    second = tree.create(*module.type, world, "second");
    tree.barrier();
    CHECK(log == Log{"created world.first"});
    deletions.stop();
}

}  // namespace watchers_test
