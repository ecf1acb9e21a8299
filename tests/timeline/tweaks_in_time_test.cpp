// The list of tweaks at every moment: the edits by persons that hold there, in the branch that the
// game is on, and those of values that have no other edit there.

#include <algorithm>

#include "catch.h"
#include "tweaked.h"

namespace tweaks_in_time_test {

using namespace tweaked;

TEST_CASE("the list has the edit that holds and an edit of a later moment can still be kept") {
    Tweaked game;
    game.run(9);
    game.edit("world.a.gravity_scale", 2);
    game.run(10);
    game.edit("world.a.gravity_scale", 3);
    game.run(10);
    const Lines later{"world.a.gravity_scale: 1 → 3"};
    CHECK(game.list() == later);
    game.time().go_to(15);
    CHECK(game.list() == Lines{"world.a.gravity_scale: 1 → 2"});
    game.time().go_to(25);
    CHECK(game.list() == later);
    CHECK(game.tweaks.list()[0].step == 20);
    game.time().go_to(5);
    CHECK(game.list() == later);
    CHECK(game.get("world.a.gravity_scale") == Value(1.0));
    CHECK(game.tweaks.keep("**").count == 1);
    CHECK(game.kept_file().find("\"world.a.gravity_scale\": 3") != std::string::npos);
}

TEST_CASE("each branch lists its own edits and those of values that only another branch edits") {
    Tweaked game;
    game.run(9);
    game.edit("world.a.gravity_scale", 2);
    game.run(10);
    game.time().go_to(5);
    game.edit("world.b.gravity_scale", 0.5);
    game.run(10);
    game.edit("world.a.gravity_scale", 4);
    game.run(1);
    const Lines second{"world.a.gravity_scale: 1 → 4", "world.b.gravity_scale: 1 → 0.5"};
    CHECK(game.list() == second);
    game.time().switch_to("1");
    const Lines first{"world.a.gravity_scale: 1 → 2", "world.b.gravity_scale: 1 → 0.5"};
    CHECK(game.list() == first);
    game.time().switch_to("2");
    CHECK(game.list() == second);
}

TEST_CASE("an instance that was made again twice and kept is listed once") {
    Tweaked game;
    game.run(4);
    game.person([&] { game.make("lamp"); });
    game.run(5);
    game.time().go_to(2);
    CHECK(game.tweaks.reapply("**").count == 1);
    game.barrier();
    game.person([&] { game.tree.undo(); });
    CHECK(game.list() == Lines{"world.lamp: nothing → new Body"});
    CHECK(game.tweaks.reapply("**").count == 1);
    game.barrier();
    CHECK(game.tweaks.keep("**").count == 1);
    game.run(3);
    CHECK(game.list() == Lines{"world.lamp: nothing → new Body, kept"});
}

TEST_CASE("edits of an instance that is made later stay listed") {
    Tweaked game;
    game.run(4);
    game.tree.create(*game.tree.find_class("Body"), game.at("world"), "late");  // by the game
    game.run(5);
    game.edit("world.late.gravity_scale", 2);
    game.run(5);
    const Lines all{"world.late.gravity_scale: 1 → 2"};
    for (const std::int64_t step : {2, 12, 7, 2, 15}) {
        game.time().go_to(step);
        CHECK(game.list() == all);
    }
    game.time().go_to(2);
    CHECK(game.tweaks.keep("**").count == 1);
    CHECK(game.kept_file().find("\"world.late.gravity_scale\": 2") != std::string::npos);
}

TEST_CASE("a drag that has not ended is listed after looking at the past") {
    Tweaked game;
    game.run(4);
    game.tree.begin_edit("drag");
    for (int i = 1; i <= 9; ++i) {
        game.edit("world.a.gravity_scale", i + 1);
        game.run(1);
    }
    game.time().go_to(9);
    CHECK(game.list() == Lines{"world.a.gravity_scale: 1 → 5"});
    game.tree.end_edit();
}

TEST_CASE("what was dropped stays dropped after going back and returning") {
    Tweaked game;
    game.edit("world.a.gravity_scale", 2);
    game.run(5);
    game.edit("world.a.gravity_scale", 3);
    game.run(5);
    CHECK(game.tweaks.drop("**").count == 1);
    game.time().go_to(4);
    CHECK(game.list().empty());
    game.time().go_to(11);
    CHECK(game.list().empty());
    game.time().go_to(4);
    game.edit("world.a.gravity_scale", 4);
    CHECK(game.list() == Lines{"world.a.gravity_scale: 1 → 4"});
}

TEST_CASE("a tweak from before the kept one starts from the value in the file") {
    Tweaked game;
    game.edit("world.a.gravity_scale", 2);
    game.run(5);
    game.edit("world.a.gravity_scale", 3);
    game.run(5);
    CHECK(game.tweaks.keep("**").count == 1);
    CHECK(game.list() == Lines{"world.a.gravity_scale: 1 → 3, kept"});
    game.time().go_to(4);
    CHECK(game.list() == Lines{"world.a.gravity_scale: 3 → 2"});
    game.time().go_to(1);
    CHECK(game.list() == Lines{"world.a.gravity_scale: 3 → 2"});
    game.time().go_to(11);
    CHECK(game.list() == Lines{"world.a.gravity_scale: 1 → 3, kept"});
    CHECK(game.tweaks.drop("**").count == 0);
    game.time().go_to(1);
    game.edit("world.a.gravity_scale", 3);  // the file has it
    CHECK(game.list().empty());
    game.edit("world.a.gravity_scale", 1);
    CHECK(game.list() == Lines{"world.a.gravity_scale: 3 → 1"});
    CHECK(game.tweaks.keep("**").count == 1);
    CHECK(game.kept_file().find("\"world.a.gravity_scale\": null") != std::string::npos);
}

TEST_CASE("instances that are made and deleted and renamed later can still be kept") {
    Tweaked game;
    game.run(4);
    game.person([&] { game.make("lamp"); });
    game.run(5);
    game.edit("world.lamp.gravity_scale", 2);
    game.person([&] { game.tree.destroy(game.at("world.wall")); });
    game.run(5);
    game.person([&] { game.tree.rename(game.at("world.c"), "last"); });
    game.run(5);
    const Lines all{"world.lamp: nothing → new Body", "world.wall: a Body → deleted",
                    "world.c: world.c → moved to world.last"};
    CHECK(game.list() == all);
    const auto sorted = [](Lines lines) {
        std::sort(lines.begin(), lines.end());
        return lines;
    };
    for (const std::int64_t step : {12, 7, 2, 20, 3, 12, 2}) {
        game.time().go_to(step);
        CHECK(sorted(game.list()) == sorted(all));
        // What does not hold at this step is listed as an edit of an earlier run is.
        std::int64_t earlier = 0;
        for (const Tweak& each : game.tweaks.list()) earlier += each.earlier ? 1 : 0;
        CHECK(earlier == (step < 5 ? 3 : step < 10 ? 2 : step < 15 ? 1 : 0));
    }
    CHECK(game.tweaks.keep("world.lamp").count == 1);
    CHECK(game.tweaks.keep("world.wall").count == 1);
    // As at the moment of the edit.
    const Lines problems = game.tweaks.keep("**").problems;
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].starts_with("world.c: a name or parent that a script gives cannot be kept"));
    // The file has what was kept, at every moment.
    CHECK(sorted(game.list()) == sorted({all[0] + ", kept", all[1] + ", kept", all[2]}));
    for (const Tweak& each : game.tweaks.list())
        if (each.kept) CHECK(each.kept_in == "main.tweaks.json");
    const std::string file = game.kept_file();
    INFO(file);
    CHECK(file.find("\"world.lamp\": {") != std::string::npos);
    CHECK(file.find("\"gravity_scale\": 2") != std::string::npos);
    CHECK(file.find("\"world.wall\"") != std::string::npos);
    // Back where they hold, they are kept there.
    game.time().go_to(20);
    CHECK(sorted(game.list()) == sorted({all[0] + ", kept", all[1] + ", kept", all[2]}));
    CHECK(game.warnings.empty());
}

TEST_CASE("an instance that is made later is made again at this moment or dropped") {
    Tweaked game;
    game.run(4);
    game.person([&] { game.make("lamp"); });
    game.person([&] { game.make("shade"); });
    game.run(5);
    game.time().go_to(2);
    CHECK(game.list().size() == 2);
    CHECK(game.tweaks.reapply("world.lamp").count == 1);
    CHECK(game.at("world.lamp"));
    CHECK(game.tweaks.drop("world.shade").count == 1);
    CHECK(game.list() == Lines{"world.lamp: nothing → new Body"});
    game.run(3);
    CHECK(game.tweaks.keep("**").count == 1);
    CHECK(game.kept_file().find("world.lamp") != std::string::npos);
    CHECK(game.kept_file().find("shade") == std::string::npos);
    game.time().switch_to("1");
    CHECK(game.at("world.shade"));
    CHECK(game.warnings.empty());
}

TEST_CASE("an edit of an instance takes its later deletion out of the list") {
    const bool adds = GENERATE(false, true);
    Tweaked game;
    game.run(4);
    game.person([&] { game.tree.destroy(game.at("world.wall")); });
    game.run(5);
    game.time().go_to(2);
    CHECK(game.list() == Lines{"world.wall: a Body → deleted"});
    if (adds)
        game.person([&] {
            game.tree.create(*game.tree.find_class("Circle"), game.at("world.wall"), "knob");
        });
    else
        game.edit("world.wall.gravity_scale", 2);
    CHECK(game.list() == Lines{adds ? "world.wall.knob: nothing → new Circle"
                                    : "world.wall.gravity_scale: 1 → 2"});
    CHECK(game.tweaks.keep("**").problems == Lines{});
    CHECK(game.kept_file().find("deleted") == std::string::npos);
}

TEST_CASE("the end of an instance whose tweak was dropped is no tweak") {
    Tweaked game;
    game.run(4);
    game.person([&] { game.make("lamp"); });
    CHECK(game.tweaks.drop("**").count == 1);
    game.run(2);
    game.person([&] { game.tree.destroy(game.at("world.lamp")); });
    CHECK(game.list().empty());
    game.run(2);
    game.time().go_to(3);
    CHECK(game.list().empty());
}

TEST_CASE("what was kept before its moment is listed with its file at its moment") {
    Tweaked game;
    game.run(4);
    game.person([&] { game.make("lamp"); });
    game.run(5);
    game.time().go_to(2);
    CHECK(game.tweaks.keep("**").count == 1);
    game.time().go_to(8);
    REQUIRE(game.list() == Lines{"world.lamp: nothing → new Body, kept"});
    CHECK(game.tweaks.list()[0].kept_in == "main.tweaks.json");
}

TEST_CASE("what was kept at a moment that was left stays listed with its file") {
    Tweaked game;
    game.run(4);
    game.person([&] { game.make("lamp"); });
    game.run(5);
    CHECK(game.tweaks.keep("**").count == 1);
    const Lines kept{"world.lamp: nothing → new Body, kept"};
    for (const std::int64_t step : {2, 8, 3, 9}) {
        game.time().go_to(step);
        CHECK(game.list() == kept);
        CHECK(game.tweaks.list()[0].kept_in == "main.tweaks.json");
    }
    game.time().go_to(2);
    game.run(2);  // another branch
    CHECK(game.list() == kept);
    game.person([&] { game.make("lamp"); });
    CHECK(game.list() == Lines{"world.lamp: nothing → new Body"});
}

TEST_CASE("an edit of an instance that is renamed later is kept at the path of this moment") {
    Tweaked game;
    game.run(4);
    game.person([&] { game.tree.rename(game.at("world.a"), "x"); });
    game.run(5);
    game.person([&] { game.tree.rename(game.at("world.x"), "y"); });
    game.run(5);
    game.edit("world.y.gravity_scale", 3);
    game.run(5);
    const auto value = [&] {
        for (const std::string& line : game.list())
            if (line.find("gravity_scale") != std::string::npos) return line;
        return std::string();
    };
    CHECK(value() == "world.y.gravity_scale: 1 → 3");
    game.time().go_to(7);
    CHECK(value() == "world.x.gravity_scale: 1 → 3");
    game.time().go_to(17);
    CHECK(value() == "world.y.gravity_scale: 1 → 3");
    game.time().go_to(2);
    CHECK(value() == "world.a.gravity_scale: 1 → 3");
    CHECK(game.tweaks.keep("world.a.**").count == 1);
    CHECK(game.kept_file().find("\"world.a.gravity_scale\": 3") != std::string::npos);
}

TEST_CASE("an instance that is made anew takes the place of one that was left behind") {
    Tweaked game;
    game.run(4);
    game.person([&] { game.make("lamp"); });
    game.run(5);
    game.time().go_to(2);
    game.person([&] { game.make("lamp"); });
    CHECK(game.list() == Lines{"world.lamp: nothing → new Body"});
    CHECK(game.tweaks.keep("**").count == 1);
}

TEST_CASE("a deletion that was kept is listed as kept before it and can be kept again") {
    Tweaked game;
    game.run(4);
    const auto remove_wall = [&] {
        game.person([&] { game.tree.destroy(game.at("world.wall")); });
    };
    remove_wall();
    game.run(5);
    CHECK(game.tweaks.keep("**").count == 1);
    const Lines kept{"world.wall: a Body → deleted, kept"};
    CHECK(game.list() == kept);
    game.time().go_to(3);
    CHECK(game.list() == kept);
    CHECK_FALSE(game.tweaks.list()[0].earlier);
    CHECK(game.tweaks.drop("**").count == 0);
    remove_wall();  // as in the file
    CHECK(game.list() == kept);
    game.time().go_to(3);
    game.edit("world.wall.gravity_scale", 2);
    CHECK(game.list().size() == 2);  // that, and the wall that is back
    CHECK(game.list()[0] != kept[0]);
    CHECK(game.list()[1] != kept[0]);
    CHECK(game.tweaks.keep("**").problems == Lines{});
    CHECK(game.kept_file().find("\"deleted\"") == std::string::npos);
    CHECK(game.kept_file().find("\"world.wall.gravity_scale\": 2") != std::string::npos);
    CHECK(game.warnings.empty());
}

TEST_CASE("the next run finds edits that the game has left behind") {
    const TemporaryFolder folder;
    {
        property::Tree tree;
        property::Tweaks tweaks(tree, folder.path, [](const std::string&) {});
        tree.set_or_add(tree.root(), "mark", 1);
        const property::Snapshot before = tree.snapshot();
        {
            const property::Tree::CauseScope scope(tree, property::Writer::console);
            tree.set_or_add(tree.root(), "mark", 2);
        }
        tree.barrier();
        tweaks.barrier();
        CHECK(tweaks.list().size() == 1);
        tree.restore(before);
        tweaks.barrier();
    }
    property::Tree tree;
    const property::Tweaks tweaks(tree, folder.path, [](const std::string&) {});
    REQUIRE(tweaks.list().size() == 1);
    CHECK(tweaks.list()[0].now == "2");
}

}  // namespace tweaks_in_time_test
