#include "catch.h"
#include "fixture.h"

#include <fettle/property/earlier_writer.h>
#include <fettle/property/edits.h>
#include <fettle/property/snapshot.h>

namespace history_test {

using namespace fettle::property;
using namespace fettle::property::testing;
namespace {
struct Fixture {
    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");
    Handle ball = tree.create(*module.type, world, "ball");

    template <class F>
    void as(Writer writer, F f) {
        const Tree::CauseScope scope(tree, writer);
        f();
    }
    template <class F>
    void console(F f) {
        as(Writer::console, f);
    }
    double mass() { return tree.get(ball, "mass").number(); }
    std::vector<std::string> child_names() {
        std::vector<std::string> names;
        for (const Handle c : tree.children(world)) names.push_back(tree.name(c));
        return names;
    }
};
using Names = std::vector<std::string>;
}  // namespace

TEST_CASE_METHOD(Fixture, "an edit by a person is undone and redone") {
    console([&] { tree.set(ball, "mass", 5); });
    console([&] { tree.set(ball, "mass", 7); });
    CHECK(tree.undo().done);
    CHECK(mass() == 5);
    CHECK(tree.undo().name == "world.ball.mass: 1 → 5");
    CHECK(mass() == 1);
    CHECK_FALSE(tree.overridden(ball, tree.property(ball, "mass")));
    CHECK_FALSE(tree.undo().done);
    tree.redo();
    tree.redo();
    CHECK(mass() == 7);
    CHECK_FALSE(tree.redo().done);
}

TEST_CASE_METHOD(Fixture,
                 "a setting that no snapshot has is not an edit and leaves redo as it is") {
    const auto flag = [](const char* name, bool transient) {
        Property property{.name = name, .type = Type::boolean, .default_value = false};
        property.transient = transient;
        return property;
    };
    const Class& marks = tree.define({.name = "Marks",
                                      .snapshots = Snapshots::never,
                                      .properties = {flag("names", true), flag("kept", false)}});
    const Handle shown = tree.create(marks, tree.root(), "marks");
    console([&] { tree.set(ball, "mass", 5); });
    tree.undo();
    console([&] {
        tree.set(shown, "names", true);
        tree.set_formula(shown, tree.property(shown, "names"),
                         {[](const Tree&) { return Value(true); }, "true"});
        tree.reset(shown, tree.property(shown, "names"));
    });
    REQUIRE(tree.history().size() == 1);
    CHECK(tree.redo().done);
    CHECK(mass() == 5);
    console([&] {
        tree.begin_edit("both");
        tree.set(ball, "mass", 6);
        tree.set(shown, "names", true);
        tree.end_edit();
    });
    CHECK(tree.undo().changes.size() == 1);
    CHECK(mass() == 5);
    CHECK(tree.get(shown, "names") == Value(true));
    // A value that others than snapshots keep is an edit: the keys of an action, for example.
    console([&] { tree.set(shown, "kept", true); });
    CHECK(tree.undo().name == "marks.kept: false → true");
}

TEST_CASE_METHOD(Fixture, "the cause of a step of undo is that of its first write") {
    tree.begin_edit("a drag");
    tree.set_step(7);
    as(Writer::inspector, [&] { tree.set(ball, "mass", 5); });
    tree.end_edit();
    REQUIRE(tree.history().size() == 1);
    CHECK(tree.history().front().cause.text() == "inspector, step 7");
}

TEST_CASE_METHOD(Fixture, "writes by callbacks belong to the game and are not edits") {
    as(Writer::script, [&] { tree.set(ball, "mass", 5); });
    tree.set(ball, "mass", 6);
    CHECK(tree.history().empty());
    CHECK_FALSE(tree.undo().done);
    tree.begin_edit("tune");
    as(Writer::script, [&] {
        tree.set(ball, "mass", 7);
        tree.set(ball, "radius", 2.0);
    });
    tree.end_edit();
    REQUIRE(tree.history().size() == 1);
    CHECK(tree.history()[0].name == "tune");
    CHECK(tree.history()[0].edits == 2);
    tree.undo();
    CHECK(mass() == 6);
    CHECK(tree.get(ball, "radius") == Value(0.5));
}

TEST_CASE_METHOD(Fixture, "a drag is one step of undo with any number of intermediate values") {
    console([&] {
        tree.begin_edit("drag");
        for (int i = 2; i < 100; ++i) tree.set(ball, "mass", i);
        tree.end_edit();
    });
    REQUIRE(tree.history().size() == 1);
    CHECK(tree.history()[0].edits == 1);
    tree.undo();
    CHECK(mass() == 1);
    tree.redo();
    CHECK(mass() == 99);
}

TEST_CASE_METHOD(Fixture, "writes of the game during a drag are not a part of it") {
    tree.begin_edit("drag", false);
    as(Writer::inspector, [&] { tree.set(ball, "mass", 2); });
    as(Writer::script, [&] { tree.set(ball, "radius", 3.0); });
    as(Writer::inspector, [&] { tree.set(ball, "mass", 4); });
    tree.end_edit();
    REQUIRE(tree.history().size() == 1);
    tree.undo();
    CHECK(mass() == 1);
    CHECK(tree.get(ball, "radius") == Value(3.0));
}

TEST_CASE_METHOD(Fixture, "a new edit removes the undone edits") {
    console([&] { tree.set(ball, "mass", 5); });
    tree.undo();
    console([&] { tree.set(ball, "mass", 6); });
    CHECK_FALSE(tree.redo().done);
    CHECK(mass() == 6);
}

TEST_CASE_METHOD(Fixture, "undo and redo are reported to watchers as edits") {
    std::vector<std::string> log;
    console([&] { tree.set(ball, "mass", 5); });
    tree.barrier();
    tree.watch(ball, "mass", [&](const Change& c) {
        log.push_back(tree.text(c.old_value) + ">" + tree.text(c.new_value) + " " + c.cause.text());
    });
    tree.set_step(9);
    tree.undo();
    tree.barrier();
    CHECK(log == Names{"5>1 undo, step 9"});
}

TEST_CASE_METHOD(Fixture,
                 "undo restores a deleted instance with handle and children and values and place") {
    const Handle after = tree.create(*module.type, world, "after");
    const Handle part = tree.create(*module.type, ball, "part");
    tree.set(part, "radius", 3.0);
    tree.set(ball, "velocity", Vec2(1, 2));
    tree.set_or_add(ball, "lives", 3);
    tree.set_or_add(after, "friend", part);
    tree.set_formula(part, "mass",
                     {[&](const Tree& t) { return t.get(after, "mass"); }, "after.mass"});
    tree.watch(ball, "mass", [](const Change&) {});
    console([&] { tree.destroy(ball); });
    // The slot is reserved; a new instance gets another.
    const Handle other = tree.create(*module.type, world, "other");
    CHECK(other.index != ball.index);
    CHECK(other.index != part.index);
    CHECK_FALSE(tree.alive(part));
    const UndoResult result = tree.undo();
    REQUIRE(result.notes.size() == 1);
    CHECK_THAT(result.notes[0], contains("watchers of world.ball ended"));
    CHECK(tree.alive(ball));
    CHECK(tree.path(part) == "world.ball.part");
    CHECK(tree.get(part, "radius") == Value(3.0));
    CHECK(tree.get(ball, "velocity") == Value(Vec2(1, 2)));
    CHECK(tree.get(ball, "lives") == Value(3));
    CHECK(tree.get(after, "friend") == Value(part));
    CHECK(tree.text(tree.get(after, "friend")) == "world.ball.part");
    CHECK(child_names() == Names{"ball", "after", "other"});
    tree.set(after, "mass", 4);
    CHECK(tree.get(part, "mass") == Value(4.0));
    tree.redo();
    CHECK_FALSE(tree.alive(ball));
    CHECK(child_names() == Names{"after", "other"});
    tree.undo();
    CHECK(tree.get(part, "radius") == Value(3.0));
}

TEST_CASE_METHOD(
    Fixture, "undo deletes a created instance and redo restores it with its values at that time") {
    Handle made;
    console([&] { made = tree.create(*module.type, world, "made"); });
    as(Writer::script, [&] { tree.set(made, "mass", 8); });
    tree.undo();
    CHECK_FALSE(tree.alive(made));
    tree.redo();
    CHECK(tree.alive(made));
    CHECK(tree.get(made, "mass") == Value(8.0));
}

TEST_CASE_METHOD(Fixture, "undo of a move and a renaming restores the place") {
    for (const char* name : {"a", "b", "c"}) tree.create(*module.type, world, name);
    const Handle b = tree.child(world, "b");
    console([&] {
        tree.begin_edit("about");
        tree.rename(b, "w");
        tree.move(b, ball);
        tree.end_edit();
    });
    CHECK(tree.path(b) == "world.ball.w");
    tree.undo();
    CHECK(child_names() == Names{"ball", "a", "b", "c"});
    tree.redo();
    CHECK(tree.path(b) == "world.ball.w");
}

TEST_CASE_METHOD(Fixture, "definitions of formulas and ad-hoc properties are undone") {
    console([&] { tree.set_or_add(ball, "lives", 3); });
    console([&] { tree.set_formula(ball, "mass", {[](const Tree&) { return Value(9.0); }, "9"}); });
    CHECK(mass() == 9);
    console([&] { tree.set(ball, "mass", 2); });
    tree.undo();
    CHECK(mass() == 9);
    REQUIRE(tree.formula(ball, tree.property(ball, "mass")) != nullptr);
    CHECK(tree.formula(ball, tree.property(ball, "mass"))->source == "9");
    tree.undo();
    CHECK(tree.formula(ball, tree.property(ball, "mass")) == nullptr);
    CHECK(mass() == 1);
    tree.undo();
    CHECK(tree.find(ball, "lives") == nullptr);
    tree.redo();
    CHECK(tree.get(ball, "lives") == Value(3));
}

TEST_CASE_METHOD(Fixture, "a refused value leaves the formula that it would have replaced") {
    tree.set_formula(ball, "radius", {[](const Tree&) { return Value(2.0); }});
    CHECK_THROWS_AS(tree.set(ball, "radius", 13.0), Error);
    CHECK(tree.formula(ball, tree.property(ball, "radius")) != nullptr);
}

TEST_CASE_METHOD(Fixture, "undo reports the changes that it could not undo") {
    console([&] { tree.set(ball, "mass", 5); });
    tree.destroy(ball);  // done by the game
    const UndoResult result = tree.undo();
    CHECK(result.done);
    REQUIRE(result.notes.size() == 1);
    CHECK_THAT(result.notes[0], contains("deleted since"));
    tree.begin_edit("open");
    tree.set_or_add(world, "score", 1);
    CHECK_THROWS_AS(tree.undo(), Error);
    tree.end_edit();
}

TEST_CASE_METHOD(Fixture, "the history drops its oldest edits when it grows too large") {
    tree.set_history_limit(20000);
    console([&] {
        for (int i = 0; i < 1000; ++i)
            tree.set_or_add(ball, "text", std::string(100, 'a') + std::to_string(i));
    });
    CHECK(tree.history().size() < 200);
    CHECK(tree.history().size() > 5);
    while (tree.undo().done) {
    }
    CHECK(tree.get(ball, "text").text().size() > 100);
    // Slots of deleted instances are released when their deletions are dropped from the history.
    tree.set_history_limit(2000);
    for (int i = 0; i < 2000; ++i) {
        const Handle brief = tree.create(*module.type, world, "brief");
        console([&] { tree.destroy(brief); });
    }
    CHECK(tree.create(*module.type, world, "last").index < 100);
}

TEST_CASE_METHOD(Fixture, "the history is listed from the latest edit") {
    for (int i = 1; i <= 4; ++i) console([&] { tree.set(ball, "mass", 1 + i); });
    tree.undo();
    tree.undo();
    std::string listed;
    for (const HistoryEntry& entry : tree.history())
        listed += entry.name.substr(entry.name.rfind(' ') + 1) + (entry.undone ? "-" : "+");
    CHECK(listed == "5-4-3+2+");
}

TEST_CASE_METHOD(Fixture, "a copy of a long history is cheap and does not change") {
    for (int i = 0; i < 2000; ++i) console([&] { tree.set(ball, "mass", 1 + i % 7); });
    const Snapshot snapshot = tree.snapshot();
    for (int i = 0; i < 50; ++i) tree.undo();
    console([&] { tree.set(ball, "mass", 3); });
    const auto size = [&] { return tree.history().size(); };
    CHECK(size() < 1990);
    tree.restore(snapshot);
    const std::size_t then = size();
    CHECK(then > 1990);
    while (tree.undo().done) {
    }
    CHECK(mass() == 1);
    tree.restore(snapshot);
    CHECK(size() == then);
}

TEST_CASE_METHOD(Fixture,
                 "an edit larger than the limit of the history is listed but cannot be undone") {
    tree.set_history_limit(10000);
    console([&] { tree.set(ball, "mass", 2); });
    CHECK(edits_without_undo(tree) == 0);
    const std::string text(20000, 'x');
    tree.begin_edit("large");
    tree.set_or_add(ball, "text", text);
    tree.set(ball, "mass", 3);
    const Handle brief = tree.create(*module.type, world, "brief");
    tree.destroy(brief);
    tree.end_edit();
    CHECK(tree.history_bytes() < 10000);
    REQUIRE(tree.history().size() == 2);
    CHECK(tree.history()[0].too_large);
    CHECK(edits_without_undo(tree) == 1);
    const UndoResult result = tree.undo();
    CHECK(result.name == "large");
    REQUIRE(result.notes.size() == 1);
    CHECK_THAT(result.notes[0], contains("more memory"));
    CHECK(mass() == 3);
    tree.undo();
    CHECK(mass() == 1);
    CHECK(tree.create(*module.type, world, "next").index == brief.index);
}

TEST_CASE_METHOD(Fixture, "the last writer is known by kind and step and for edits by place") {
    const Property& p = tree.property(ball, "mass");
    CHECK_FALSE(tree.last_writer(ball, p).known);
    tree.set_step(3);
    as(Writer::script, [&] { tree.set(ball, "mass", 2); });
    CHECK(tree.last_writer(ball, p).cause.text() == "script, step 3");
    tree.set_step(4);
    std::function<std::string()> locate = [] { return std::string("console:1"); };
    {
        const Tree::CauseScope scope(tree, Writer::console, &locate);
        tree.set(ball, "mass", 3);
    }
    CHECK(tree.last_writer(ball, p).cause.text() == "console:1, step 4");
    tree.set_step(5);
    as(Writer::script, [&] { tree.set(ball, "mass", 4); });
    CHECK(tree.last_writer(ball, p).cause.text() == "script, step 5");
    const Property& v = tree.property(ball, "velocity");
    CHECK(tree.last_writer(ball, v).cause.writer == Writer::simulation);
    as(Writer::script, [&] { tree.set(ball, "velocity", Vec2(1, 2)); });
    CHECK(last_writer_text(tree, ball, v) == "script, step 5");
    tree.set_step(9);
    CHECK(last_writer_text(tree, ball, v) == "script, step 5; later steps may have changed it");
    tree.destroy(ball);
    const Handle next = tree.create(*module.type, world, "ball");
    REQUIRE(next.index == ball.index);
    CHECK_FALSE(tree.last_writer(next, p).known);
}

TEST_CASE_METHOD(
    Fixture,
    "the writer of a value that a step has changed since a person wrote it is the simulation") {
    const Property& velocity = tree.property(ball, "velocity");
    tree.set_step(4);
    console([&] { tree.set(ball, velocity, Vec2(5, 0)); });
    CHECK(tree.last_writer(ball, velocity).cause.text() == "console, step 4");
    tree.set_step(6);
    CHECK(tree.last_writer(ball, velocity).cause.text() == "console, step 4");
    module.ball(ball).velocity[1] = -1;
    CHECK(tree.last_writer(ball, velocity).cause.text() == "simulation, step 6");
    tree.set_step(5);  // the step that follows the write
    CHECK(tree.last_writer(ball, velocity).cause.text() == "console, step 4");
    tree.set_step(6);
    console([&] { tree.set(ball, velocity, Vec2(2, 0)); });
    CHECK(tree.last_writer(ball, velocity).cause.text() == "console, step 6");
}

TEST_CASE_METHOD(Fixture, "the last writer of each of many plain writes is known") {
    const Property& mass = tree.property(ball, "mass");
    const Handle other = tree.create(*module.type, world, "other");
    tree.set_step(7);
    as(Writer::script, [&] {
        for (int i = 1; i <= 2000; ++i) {
            REQUIRE(tree.write(i % 2 == 0 ? ball : other, mass, i));
            if (i == 1) CHECK_FALSE(tree.last_writer(ball, mass).known);
        }
        CHECK(tree.last_writer(other, mass).cause.text() == "script, step 7");
        REQUIRE(tree.write(ball, mass, 0.5));
    });
    tree.set_step(8);
    CHECK(tree.last_writer(ball, mass).cause.text() == "script, step 7");
    as(Writer::module, [&] { REQUIRE(tree.write(ball, mass, 1.5)); });
    as(Writer::script, [&] { CHECK(tree.last_writer(ball, mass).cause.writer == Writer::module); });
}

TEST_CASE_METHOD(Fixture, "undo removes a formula of a property that never had a value") {
    console([&] {
        tree.set_formula(ball, "mass", {[&](const Tree& t) { return t.get(ball, "mass"); }});
    });
    CHECK_FALSE(tree.problem(ball, tree.property(ball, "mass")).empty());
    tree.undo();
    CHECK(tree.formula_count() == 0);
    CHECK(mass() == 1);
}

TEST_CASE_METHOD(Fixture, "a formula that makes its property is one step of undo") {
    const auto fails = [](const Tree&) -> Value { throw std::runtime_error("no"); };
    console([&] { tree.set_formula(ball, "score", {fails}); });
    tree.barrier();
    console([&] { tree.set_formula(ball, "score", {[](const Tree&) { return Value(3); }}); });
    tree.undo();  // removes the formula again; the property never had a value
    REQUIRE(tree.find(ball, "score") != nullptr);
    CHECK_FALSE(tree.problem(ball, tree.property(ball, "score")).empty());
    tree.undo();
    CHECK(tree.find(ball, "score") == nullptr);
    CHECK(tree.formula_count() == 0);
    tree.redo();
    tree.redo();
    CHECK(tree.get(ball, "score") == Value(3));
}

TEST_CASE_METHOD(Fixture, "repeated creation and deletion by undo and redo frees one slot") {
    Handle other;
    console([&] { other = tree.create(*module.type, world, "other"); });
    console([&] { tree.destroy(other); });
    tree.undo();
    tree.undo();
    console([&] { tree.set(ball, "mass", 2); });  // drops the undone edit
    const Handle first = tree.create(*module.type, world, "first");
    const Handle second = tree.create(*module.type, world, "second");
    CHECK(first.index != second.index);
    CHECK(child_names() == Names{"ball", "first", "second"});
}

TEST_CASE_METHOD(Fixture,
                 "a formula that follows a handle recovers when undo restores the instance") {
    const Handle source = tree.create(*module.type, world, "source");
    tree.set_formula(ball, "mass", {[&](const Tree& t) { return t.get(source, "radius"); }});
    console([&] { tree.destroy(source); });
    tree.barrier();
    CHECK_THAT(tree.problem(ball, tree.property(ball, "mass")), contains("was deleted"));
    tree.undo();
    CHECK(mass() == 0.5);
}

TEST_CASE_METHOD(Fixture, "no child is given the name of a property") {
    const Class& object = tree.object_class();
    tree.set_or_add(world, "object_1", 3);
    tree.set_or_add(world, "object_3", "mine");
    CHECK(tree.name(tree.create(object, world)) == "object_2");
    const Handle moved = tree.create(object);
    tree.move(moved, world);
    CHECK(tree.name(moved) == "object_4");
    const Handle again = tree.create(object, world);
    tree.move(again, {});
    tree.set_or_add(world, "object_5", 1);
    tree.move(again, world);
    CHECK(tree.name(again) == "object_6");
    // Nor is an instance that undo restores.
    console([&] { tree.destroy(again); });
    tree.set_or_add(world, "object_6", true);
    tree.undo();
    CHECK(tree.alive(again));
    CHECK(tree.name(again) == "object_7");
    const auto saved = Snapshot::from_bytes(tree.snapshot().to_bytes());
    CHECK_NOTHROW(tree.check(saved));
}

TEST_CASE_METHOD(Fixture, "undo of a deletion restores references to the instance") {
    const Handle other = tree.create(*module.type, world, "other");
    const Handle third = tree.create(*module.type, world, "third");
    console([&] { tree.set_or_add(other, "target", ball); });
    console([&] { tree.set_or_add(other, "all", Value(List{ball, third})); });
    console([&] { tree.destroy(ball); });
    console([&] { tree.destroy(other); });
    tree.undo();  // restores `other`, but not the instance that it refers to
    CHECK(tree.alive(other));
    SECTION("also after other edits") {
        console([&] { tree.rename(third, "fourth"); });
        tree.undo();
        tree.undo();
        CHECK(tree.get(other, "target").reference() == ball);
        CHECK(tree.text(tree.get(other, "all")) == "{world.ball, world.third}");
    }
    SECTION("but not a reference that was written since") {
        tree.set_or_add(other, "target", third);
        tree.undo();
        CHECK(tree.get(other, "target").reference() == third);
        CHECK(tree.text(tree.get(other, "all")) == "{world.ball, world.third}");
    }
}

}  // namespace history_test
