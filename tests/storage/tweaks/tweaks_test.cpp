// Tweaks: edits by a person are journaled, found again, kept, made again or dropped.

#include <fettle/property/storage/tweaks.h>

#include "catch.h"
#include "game_folder.h"
#include "tweak_run.h"

namespace tweaks_test {

using namespace scene_test;

namespace {

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("an edit by a person is a tweak and the next run finds it") {
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a");
        run.tree.set(a, "number", 1.0);
        CHECK_FALSE(std::filesystem::exists(folder / ".fettle"));
        run.person([&] { run.tree.set(a, "number", 2.0); });
        run.person([&] { run.tree.set_or_add(a, "lives", 3); });
        CHECK(run.lines() == Lines{"world.a.number: 1 → 2", "world.a.lives: nothing → 3"});
        CHECK(run.reported.empty());

        // The first run is still open, as after a kill.
        Run next(folder);
        CHECK(next.lines() ==
              Lines{"earlier world.a.number: 1 → 2", "earlier world.a.lives: nothing → 3"});
        CHECK(next.tweaks->open_earlier() == 2);
    }
    Run last(folder);
    CHECK(last.tweaks->open_earlier() == 2);
}

TEST_CASE("several edits of a value are one tweak and none if it gets its first value again") {
    const GameFolder folder;
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.person([&] { run.tree.set(a, "number", 2.0); });
    run.person([&] { run.tree.set(a, "number", 3.0); });
    CHECK(run.lines() == Lines{"world.a.number: 0 → 3"});
    run.person([&] { run.tree.set(a, "number", 0.0); });
    CHECK(run.lines().empty());
    run.person([&] { run.tree.set(a, "number", 4.0); });
    run.tree.undo();
    run.barrier();
    CHECK(run.lines().empty());
    CHECK(Run(folder).lines().empty());
    run.tree.redo();
    run.barrier();
    CHECK(run.lines() == Lines{"world.a.number: 0 → 4"});
    CHECK(Run(folder).lines() == Lines{"earlier world.a.number: 0 → 4"});
}

TEST_CASE("undo removes tweaks one by one from the journal too") {
    const GameFolder folder;
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.person([&] { run.tree.set(a, "number", 2.0); });
    run.person([&] { run.tree.set(a, "number", 3.0); });
    run.person([&] { run.tree.set(a, "flag", true); });
    for (const Lines& expected : {Lines{"earlier world.a.number: 0 → 3"},
                                  Lines{"earlier world.a.number: 0 → 2"}, Lines{}}) {
        run.tree.undo();
        run.barrier();
        CHECK(Run(folder).lines() == expected);
    }
}

TEST_CASE("writes by a script are tweaks only inside an edit") {
    const GameFolder folder;
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    const Tree::CauseScope scope(run.tree, Writer::script);
    run.tree.set(a, "number", 2.0);
    run.barrier();
    CHECK(run.lines().empty());
    run.tree.begin_edit("tune");
    run.tree.set(a, "number", 3.0);
    run.tree.end_edit();
    CHECK(run.lines() == Lines{"world.a.number: 2 → 3 not yet"});
    run.barrier();
    CHECK(run.lines() == Lines{"world.a.number: 2 → 3"});
    run.tree.set(a, "number", 9.0);  // a write of the game
    run.barrier();
    CHECK(run.lines() == Lines{"world.a.number: 2 → 3"});
}

TEST_CASE("a tweak outlives its instance unless a person deletes the instance") {
    const GameFolder folder;
    Run run(folder);
    Handle a = run.add("Thing", "a");
    run.person([&] { run.tree.set(a, "number", 2.0); });
    run.tree.destroy(a);  // the game restarts its level
    run.barrier();
    CHECK(run.lines() == Lines{"world.a.number: 0 → 2"});
    a = run.add("Thing", "a");
    run.person([&] { run.tree.set(a, "number", 5.0); });
    CHECK(run.lines() == Lines{"world.a.number: 0 → 5"});
    run.person([&] { run.tree.destroy(a); });
    CHECK(run.lines() == Lines{"world.a: a Thing → deleted"});
    run.tree.undo();
    run.barrier();
    CHECK(run.lines() == Lines{"world.a.number: 0 → 5"});
    CHECK(Run(folder).lines() == Lines{"earlier world.a.number: 0 → 5"});
}

TEST_CASE("created and renamed instances are tweaks") {
    const GameFolder folder;
    Run run(folder);
    Handle made;
    run.person([&] {
        made = run.tree.create(run.tree.class_named("Thing"), {}, "lamp");
        run.tree.set(made, "number", 2.0);
        run.tree.move(made, run.world, "lamp");
    });
    CHECK(run.lines() == Lines{"world.lamp: nothing → new Thing"});
    run.person([&] { run.tree.set(made, "flag", true); });
    CHECK(run.lines() == Lines{"world.lamp: nothing → new Thing"});
    run.add("Thing", "wall");
    run.person([&] { run.tree.rename(run.at("world.wall"), "fence"); });
    CHECK(run.lines().back() == "world.wall: world.wall → moved to world.fence");
    {
        Run next(folder);
        next.add("Thing", "wall");
        const Tree::CauseScope scope(next.tree, Writer::console);
        CHECK(next.tweaks->reapply("**").count == 2);
        next.barrier();
        REQUIRE(next.at("world.lamp"));
        CHECK(next.tree.get(next.at("world.lamp"), "number") == Value(2.0));
        CHECK(next.tree.get(next.at("world.lamp"), "flag") == Value(true));
        CHECK(next.at("world.fence"));
        CHECK(next.lines().size() == 2);
    }
    run.tree.undo();
    run.tree.undo();
    run.tree.undo();
    run.barrier();
    CHECK(run.lines().empty());
}

// This would take minutes if the cost were the square of the number of edits.
TEST_CASE("thousands of edits inside one new instance are one tweak with the values of all") {
    constexpr int children = 5'000;
    const GameFolder folder;
    Run run(folder);
    const Class& thing = run.tree.class_named("Thing");
    const auto name = [](int i) { return "child_" + std::to_string(i); };
    Handle top;
    const auto person = [&](const auto& edits) {
        run.person([&] {
            run.tree.begin_edit("many");
            edits();
            run.tree.end_edit();
        });
    };
    const auto child = [&](int i) { return run.tree.child(top, name(i)); };
    person([&] {
        top = run.tree.create(thing, run.world, "top");
        for (int i = 0; i < children; ++i) run.tree.create(thing, top, name(i));
    });
    person([&] {
        for (int i = 0; i < children; ++i) run.tree.set(child(i), "number", Value(i + 0.5));
    });
    person([&] {
        for (int i = 0; i < children; i += 2)
            run.tree.rename(child(i), "even_" + std::to_string(i));
    });
    person([&] {
        for (int i = 3; i < children; i += 2) run.tree.destroy(child(i));
    });
    run.tree.set(child(1), "number", 7.0);  // a script does that
    run.barrier();
    CHECK(run.lines() == Lines{"world.top: nothing → new Thing"});

    Run next(folder);
    const Tree::CauseScope scope(next.tree, Writer::console);
    CHECK(next.tweaks->reapply("**").count == 1);
    const Handle again = next.at("world.top");
    REQUIRE(again);
    CHECK(next.tree.get(next.tree.child(again, "even_4998"), "number") == Value(4998.5));
    CHECK(next.tree.get(next.tree.child(again, "child_1"), "number") == Value(1.5));
    CHECK_FALSE(next.tree.child(again, "child_3"));
    CHECK_FALSE(next.tree.child(again, "child_4"));

    for (int steps = 0; steps < 4; ++steps) run.tree.undo();
    run.barrier();
    CHECK(run.lines().empty());
}

// This takes a second; it would take minutes if each instance were compared with all earlier ones.
TEST_CASE("a command that makes tens of thousands of instances with children is settled at once") {
    constexpr int count = 40'000;
    const GameFolder folder;
    Run run(folder);
    const auto& thing = run.tree.class_named("Thing");
    run.person([&] {
        for (int i = 0; i < count; ++i) {
            const Handle made = run.tree.create(thing, run.world, "top_" + std::to_string(i));
            run.tree.create(thing, made, "child");
        }
    });
    CHECK(run.tweaks->list().size() == count);
}

// This would take minutes if all tweaks were searched for each instance.
TEST_CASE("tens of thousands of creations are undone and made again at once") {
    constexpr std::size_t count = 40'000;
    const GameFolder folder;
    Run run(folder);
    run.tree.set_history_limit(std::size_t{1} << 30);
    run.tree.begin_edit("many");
    run.person([&] {
        for (std::size_t i = 0; i < count; ++i)
            run.tree.create(run.tree.class_named("Thing"), run.world, "thing_" + std::to_string(i));
    });
    run.tree.end_edit();
    run.barrier();
    CHECK(run.tweaks->list().size() == count);
    run.tree.undo();
    run.barrier();
    CHECK(run.tweaks->list().empty());
    run.tree.redo();
    run.barrier();
    CHECK(run.tweaks->list().size() == count);
}

TEST_CASE("an undone deletion gives an instance and thousands of new children their tweaks again") {
    constexpr int children = 10'000;
    const GameFolder folder;
    Run run(folder);
    Handle top;
    run.person([&] { top = run.tree.create(run.tree.class_named("Thing"), run.world, "top"); });
    run.person([&] {
        for (int i = 0; i < children; ++i)
            run.tree.create(run.tree.class_named("Thing"), top, "child_" + std::to_string(i));
    });
    CHECK(run.lines().size() == children + 1);
    run.person([&] { run.tree.destroy(top); });
    CHECK(run.lines().empty());
    run.tree.undo();
    run.barrier();
    CHECK(run.lines().size() == children + 1);
    // The tweak of the one above does not make the children again, which have tweaks of their own.
    Run next(folder);
    const Tree::CauseScope scope(next.tree, Writer::console);
    const TweakReport again = next.tweaks->reapply("**");
    CHECK(again.count == children + 1);
    CHECK(again.problems.empty());
    CHECK(next.tree.child_count(next.at("world.top")) == children);
}

TEST_CASE("tweaks of an earlier run are made again as edits that can be undone") {
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a"), b = run.add("Thing", "b");
        run.person([&] {
            run.tree.set(a, "number", 2.0);
            run.tree.set(a, "position", Vec2(1, -INFINITY));
            run.tree.set_or_add(a, "companion", b);
        });
    }
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    {
        const Tree::CauseScope scope(run.tree, Writer::console);
        const TweakReport report = run.tweaks->reapply("world.a");
        CHECK(report.count == 2);
        REQUIRE(report.problems.size() == 1);
        CHECK(report.problems[0].find("world.a.companion: ") == 0);
    }
    CHECK(run.tree.get(a, "number") == Value(2.0));
    CHECK(run.tree.get(a, "position") == Value(Vec2(1, -INFINITY)));
    run.barrier();
    CHECK(run.tweaks->open_earlier() == 1);
    CHECK(run.lines().size() == 3);
    run.tree.undo();
    run.barrier();
    CHECK(run.tree.get(a, "number") == Value(0.0));
    CHECK(run.tweaks->open_earlier() == 3);  // all of them are open again
    CHECK(run.lines().size() == 3);
    run.tree.redo();
    run.barrier();
    CHECK(run.tweaks->open_earlier() == 1);
    CHECK(run.lines().size() == 3);
    run.tree.undo();
    run.barrier();
    run.tweaks.reset();
    Run next(folder);
    CHECK(next.tweaks->open_earlier() == 3);
}

TEST_CASE("a tweak that was made again and undone can be dropped") {
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a");
        run.person([&] { run.tree.set(a, "number", 2.0); });
    }
    {
        Run run(folder);
        run.add("Thing", "a");
        const Tree::CauseScope scope(run.tree, Writer::console);
        CHECK(run.tweaks->reapply("**").count == 1);
        run.barrier();
        run.tree.undo();
        run.barrier();
        CHECK(run.tweaks->drop("**").count == 1);
        run.barrier();
        CHECK(run.lines().empty());
    }
    CHECK(Run(folder).lines().empty());
}

TEST_CASE("dropped tweaks are removed and their values stay") {
    const GameFolder folder;
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.person([&] {
        run.tree.set(a, "number", 2.0);
        run.tree.set(a, "flag", true);
    });
    CHECK(run.tweaks->drop("world.*.number").count == 1);
    CHECK(run.lines() == Lines{"world.a.flag: false → true"});
    CHECK(run.tree.get(a, "number") == Value(2.0));
    Run next(folder);
    CHECK(next.lines() == Lines{"earlier world.a.flag: false → true"});
    CHECK(next.tweaks->drop("**").count == 1);
    CHECK(Run(folder).lines().empty());
}

TEST_CASE("a formula defined by a person is a tweak") {
    const GameFolder folder;
    const auto compiler = [](const std::string& source) {
        return Formula{
            [](const Tree& tree) {
                return Value(
                    2 *
                    tree.get(tree.child(tree.child(tree.root(), "world"), "b"), "number").number());
            },
            source};
    };
    {
        Run run(folder);
        run.tree.set(run.add("Thing", "b"), "number", 3.0);
        const Handle a = run.add("Thing", "a");
        run.person([&] { run.tree.set_formula(a, "number", compiler("twice b")); });
        CHECK(run.lines() == Lines{"world.a.number: 0 → is twice b"});
        run.person([&] { run.tree.set_formula(a, "number", compiler("twice b")); });
    }
    Run run(folder);
    run.tree.compile_formulas_with(compiler);
    const Handle a = run.add("Thing", "a");
    run.tree.set(run.add("Thing", "b"), "number", 4.0);
    {
        const Tree::CauseScope scope(run.tree, Writer::console);
        CHECK(run.tweaks->reapply("world.a.number").problems.empty());
    }
    CHECK(run.tree.get(a, "number") == Value(8.0));
    run.barrier();
    CHECK(run.tweaks->keep("world.a").count == 1);
    CHECK(folder.text("main.tweaks.json") ==
          "{\n  \"fettle_tweaks\": 1,\n  \"values\": {\n    \"world.a.number\": {\"is\": \"twice "
          "b\", \"value\": 8}\n  }\n}\n");
}

}  // namespace tweaks_test
