// Snapshots restored in a game with other classes: values that fit are kept, and the others are
// reported.

#include "catch.h"
#include "snapshot_rig.h"

#include <fettle/property/snapshot_remarks.h>
#include <fettle/property/write_log.h>

namespace changed_classes_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

/// Another version of a game: one class with these properties, derived from `base`.
struct Version {
    Tree tree;
    BallModule module{tree};
    explicit Version(std::vector<Property> properties, std::string base = "Object") {
        ClassDescriptor d;
        d.name = "Thing";
        d.base = std::move(base);
        d.properties = std::move(properties);
        tree.define(std::move(d));
    }
    Handle make(std::string_view name, Handle parent = {}) {
        return tree.create(tree.class_named("Thing"), parent ? parent : tree.root(), name);
    }
    /// Restores as from a file of another version.
    void load(const Version& other) { tree.restore(through_bytes(other.tree.snapshot())); }
};

Property of_type(std::string name, Value value) {
    return {.name = std::move(name), .type = value.type(), .default_value = std::move(value)};
}

}  // namespace

TEST_CASE("a saved value is converted if the type of its property has changed") {
    Version old({of_type("whole", 1), of_type("real", 1.5), of_type("broken", 1.5),
                 of_type("word", "x"), of_type("same", "x")});
    const Handle a = old.make("a"), b = old.make("b"), gone = old.make("gone");
    old.tree.destroy(gone);
    old.tree.set(a, "whole", 7);
    old.tree.set(a, "real", 4.0);
    old.tree.set(a, "broken", 4.5);
    old.tree.set(b, "broken", 8.0);
    old.tree.set(a, "word", "seven");
    old.tree.set(a, "same", "y");
    old.tree.set_or_add(a, "own", 3);
    old.tree.set_or_add(b, "own", "three");
    Version now({of_type("whole", 0.5), of_type("real", 2), of_type("broken", 2),
                 of_type("word", List{Value(1)}), of_type("same", "x"), of_type("own", 0.25)});
    now.load(old);
    CHECK(now.tree.get(a, "whole") == Value(7.0));
    CHECK(now.tree.get(b, "whole") == Value(1.0));
    CHECK(now.tree.get(a, "real") == Value(4));
    CHECK(now.tree.get(b, "real") == Value(2));  // 1.5 is not an integer
    CHECK(now.tree.get(a, "broken") == Value(2));
    CHECK(now.tree.get(b, "broken") == Value(8));
    CHECK(now.tree.get(a, "word") == Value(List{Value(1)}));
    CHECK(now.tree.get(a, "same") == Value("y"));
    CHECK(now.tree.get(a, "own") == Value(3.0));
    CHECK(now.tree.get(b, "own") == Value(0.25));
    std::string all;
    for (const std::string& remark : restore_remarks(now.tree)) all += remark + "\n";
    CAPTURE(all);
    CHECK(restore_remarks(now.tree).size() == 4);
    CHECK_THAT(all, contains("Thing.real: the saved value 1.5 cannot be"));
    CHECK_THAT(all, contains("Thing.broken: the saved value 4.5 cannot be"));
    CHECK_THAT(all, contains("Thing.word: the saved value \"seven\" and 1 more cannot be"));
    CHECK_THAT(all, contains("Thing.own: the saved value \"three\" cannot be"));
    now.load(now);
    CHECK(restore_remarks(now.tree).empty());
}

TEST_CASE("saved values of a property that is gone are reported") {
    Version old({of_type("healt", 10), of_type("same", "x")});
    const Handle a = old.make("a");
    old.make("b");
    old.tree.set(a, "healt", 33);
    Version now({of_type("health", 10), of_type("same", "x")});
    now.load(old);
    CHECK(now.tree.get(a, "health") == Value(10));
    REQUIRE(restore_remarks(now.tree).size() == 1);
    CHECK(restore_remarks(now.tree)[0] ==
          "Thing.healt: the class no longer has this property (did you mean \"health\"?); the "
          "saved value 33 and 1 more are not restored");
}

TEST_CASE("a property keeps its default if it refuses the saved value") {
    const auto version = [](Range range, std::vector<std::string> enumerators, bool clamp,
                            std::string owner) {
        return std::vector<Property>{
            {.name = "lives", .type = Type::integer, .default_value = 3, .range = range},
            {.name = "speed", .default_value = 3, .range = range, .clamp = clamp},
            {.name = "mood",
             .type = Type::text,
             .default_value = enumerators.front(),
             .enumerators = enumerators},
            {.name = "owner", .type = Type::reference, .reference_class = owner},
            {.name = "friends",
             .type = Type::list,
             .element = Type::reference,
             .reference_class = owner}};
    };
    Version old(version({}, {"glad", "sad"}, false, ""));
    const Handle a = old.make("a"), b = old.make("b");
    const Handle ball = old.tree.create(old.tree.class_named("Ball"), old.tree.root(), "ball");
    old.tree.set(a, "lives", 12);
    old.tree.set(a, "speed", 12);
    old.tree.set(a, "mood", "glad");
    old.tree.set(b, "mood", "sad");
    old.tree.set(a, "owner", b);
    old.tree.set(b, "owner", ball);
    old.tree.set(a, "friends", List{Value(b), Value(ball)});
    old.tree.set(b, "friends", List{Value(ball)});
    Version now(version({.min = 0, .max = 10}, {"sad", "angry"}, true, "Ball"));
    now.load(old);
    CHECK(now.tree.get(a, "lives") == Value(3));
    CHECK(now.tree.get(b, "lives") == Value(3));
    CHECK(now.tree.get(a, "speed") == Value(10.0));  // as a write would set it
    CHECK(now.tree.get(a, "mood") == Value("sad"));
    CHECK(now.tree.get(b, "mood") == Value("sad"));
    CHECK(now.tree.get(a, "owner") == Value(Handle{}));
    CHECK(now.tree.get(b, "owner") == Value(ball));
    CHECK(now.tree.get(a, "friends") == Value(List{}));
    CHECK(now.tree.get(b, "friends") == Value(List{Value(ball)}));
    std::string all;
    for (const std::string& remark : restore_remarks(now.tree)) all += remark + "\n";
    CAPTURE(all);
    CHECK(restore_remarks(now.tree).size() == 4);
    CHECK_THAT(all, contains("Thing.lives: the saved value 12 cannot be an integer from 0 to 10"));
    CHECK_THAT(all, contains("Thing.mood: the saved value \"glad\" cannot be"));
    CHECK_THAT(all, contains("Thing.owner: ") && contains("cannot be a Ball or nil"));
    CHECK_THAT(all, contains("Thing.friends: "));
}

TEST_CASE("a class without properties that gets some later takes their defaults") {
    Version old({});
    const Handle a = old.make("a"), b = old.make("b");
    Version now({of_type("lives", 3)});
    now.load(old);
    now.tree.set(a, "lives", 4);
    CHECK(now.tree.get(a, "lives") == Value(4));
    CHECK(now.tree.get(b, "lives") == Value(3));
    old.load(now);
    CHECK(old.tree.alive(b));
}

TEST_CASE("a snapshot of changed classes reports the change and is not called damaged") {
    const auto refusal = [](Version& now, const Version& old) {
        try {
            now.load(old);
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::rejected);
            return std::string(error.what());
        }
        return std::string();
    };
    const std::string changed = "the classes of the game have changed since";
    Version old({}, "Ball"), plain({});
    const Handle a = plain.make("a");
    plain.make("child", a);
    Version other({});
    CHECK(refusal(other, old).empty());  // the snapshot contains no instance of that class
    old.make("a");
    CHECK_THAT(
        refusal(other, old),
        contains(changed) && contains("Thing was a kind of Ball and is now a kind of Object"));
    Version with_property({of_type("child", 1)});
    CHECK_THAT(refusal(with_property, plain),
               contains(changed) &&
                   contains("a child called \"child\", which is now a property of Thing"));
}

TEST_CASE(
    "after a load the running game's formula replaces one without a text or is reported as lost") {
    Version old({of_type("x", 1.0), of_type("y", 1.0)});
    const Handle a = old.make("a"), b = old.make("b", a);
    const auto three = [](const Tree&) { return Value(3.0); };
    old.tree.set_formula(
        b, "x",
        {.function = three, .not_saved = "uses the local variable \"speed\" of main.lua:12"});
    old.tree.set_formula(b, "y", {.function = three, .source = "return 3"});
    old.tree.barrier();
    CHECK(unsaved_formulas(old.tree) ==
          std::vector<std::string>{
              "a.b.x: its formula uses the local variable \"speed\" of main.lua:12"});
    Version now({of_type("x", 1.0), of_type("y", 1.0)});
    now.tree.compile_formulas_with(
        [](std::string_view) -> Formula { throw Error(ErrorKind::formula, "who knows"); });
    const bool has_it = GENERATE(false, true);
    if (has_it) {
        const Handle mine = now.make("b", now.make("a"));
        now.tree.set_formula(mine, "x", {.function = [](const Tree&) { return Value(4.0); }});
    }
    now.load(old);
    std::vector<std::string> expected{
        "a.b.y: its formula does not compile any more: who knows; it keeps the value that it had"};
    if (!has_it)
        expected.insert(expected.begin(),
                        "a.b.x: its formula was not saved; it keeps the value that it had");
    CHECK(restore_remarks(now.tree) == expected);
    now.tree.barrier();
    CHECK(now.tree.get(b, "x") == Value(has_it ? 4.0 : 3.0));
    CHECK(now.tree.get(b, "y") == Value(3.0));
    // Within one process every formula continues.
    old.tree.restore(old.tree.snapshot());
    CHECK(restore_remarks(old.tree).empty());
    CHECK(old.tree.formula_count() == 2);
}

TEST_CASE("repeating a log gives the same next names") {
    SnapshotRig r;
    const Class& ball = r.tree.class_named("Ball");
    const Handle a = r.make("a"), b = r.make("b");
    WriteLog log(r.tree);
    const Snapshot before = r.tree.snapshot();
    const auto next = [&](const Class& of, Handle below) {
        return r.tree.path(r.tree.create(of, below));
    };
    for (int i = 0; i < 3; ++i) {
        r.tree.destroy(r.tree.create(r.thing, r.tree.root()));
        const Handle moved = r.tree.create(ball, a);
        r.tree.move(moved, b);
        r.tree.move(moved, a);
        r.tree.rename(moved, "ball_" + std::to_string(20 - i));
        r.tree.rename(moved, "named");
        r.tree.destroy(moved);
    }
    const LoggedWrites piece = log.take();
    const auto names = [&] {
        return std::vector{next(r.thing, r.tree.root()), next(ball, a), next(ball, b)};
    };
    const auto there = names();
    CHECK(there[0] == "thing_4");
    r.tree.restore(before, [&] { log.play(piece); });
    CHECK(names() == there);
}
}  // namespace changed_classes_test
