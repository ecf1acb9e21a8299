// The store of a game, from its scripts and over several runs.

#include <catch.h>

#include <csignal>

#include "program.h"
#include "running_program.h"

namespace store_run_test {

using namespace program_test;

namespace {

/// A run of a game of which only this chunk matters.
Outcome run(const Folder& folder, const std::string& chunk, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"--eval", chunk});
    Outcome outcome = run_script(folder, "", 5, more);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 0);
    return outcome;
}

}  // namespace

TEST_CASE("a value in the store is there in the next run") {
    const Folder folder;
    run(folder,
        "store.best = 100 store.name = 'Ada' store.home = vec(1, 2) store.paint = color('red') "
        "store.levels = { true, false, deep = { 1, 2, { 'x' } } } store.levels[2] = true");
    CHECK(run(folder,
              "print(store.best, store.name, store.home, store.paint == color('red'), "
              "store.levels[1], store.levels[2], store.levels.deep[3][1], #store.levels.deep, "
              "store.none, store:has('best'), store:has('none'))")
              .out == "100\tAda\tvec(1, 2)\ttrue\ttrue\ttrue\tx\t3\tnil\ttrue\tfalse\n");
}

TEST_CASE("pairs visits the store in order and table functions change its lists") {
    const Folder folder;
    const std::string out = run(folder, R"(
        store.list = {}
        for i = 1, 3 do table.insert(store.list, i * i) end
        table.remove(store.list, 1)
        store.b = 1 store.a = 2 store[5] = 3
        for k, v in pairs(store) do print(k, v) end
        for i, v in ipairs(store.list) do print(i, v) end
        print(store, table.concat(store.list, "+"))
        for k in pairs(store) do store[k] = nil end
        print(store)
    )")
                                .out;
    CHECK(out ==
          "5\t3\na\t2\nb\t1\nlist\t{4, 9}\n1\t4\n2\t9\n{[5] = 3, a = 2, b = 1, list = {4, "
          "9}}\t4+9\n{}\n");
}

TEST_CASE("a component of a vec or a color in the store can be assigned") {
    const Folder folder;
    const Outcome outcome = run(folder, R"(
        store.at = vec(1, 2) store.levels = { { at = vec(3, 4), paint = color('red') } }
        store.at.x = 7 store.levels[1].at.y = 8 store.levels[1].paint.g = 1
        print(store.at, store.levels[1].at, store.levels[1].paint)
        for _, level in ipairs(store.levels) do level.at.x = 0 end
        for name, value in pairs(store) do if name == "at" then value.y = 0 end end -- a note
        local kept, copy = store.at, vec(store.at)
        store.at.x = 5 copy.x = 9
        kept.y = 6
        print(store.at, store.levels[1].at, kept, copy)
        store.at = 1
        print(pcall(function() kept.x = 2 end))
    )");
    CHECK(outcome.out ==
          "vec(7, 2)\tvec(3, 8)\tcolor(\"#ffff00\")\n"
          "vec(5, 6)\tvec(0, 8)\tvec(5, 6)\tvec(9, 0)\n"
          "false\teval:12: store.at: is not a vec any more\n");
    CHECK_THAT(outcome.err, contains("so value.y = ... writes store.at; vec(value) is a copy"));
}

TEST_CASE("assigning a table copies it and reading gives the table in the store") {
    const Folder folder;
    CHECK(run(folder, R"(
        local mine = { 1 }
        store.t = mine
        mine[1] = 2
        local theirs = store.t
        theirs[2] = 5
        print(store.t[1], store.t[2], theirs == store.t)
        store.u = store.t
        store.u[1] = 9
        print(store.t[1], store.u[1])
        store.t = nil
        print(theirs[1], #theirs, theirs)
        print(pcall(function() theirs[1] = 7 end))
    )")
              .out ==
          "1\t5\ttrue\n1\t9\n1\t2\t{1, 5}\n"
          "false\teval:13: this table is no longer in the store: it was replaced or removed\n");
}

TEST_CASE("a table of the store that is put where it is stays the same table") {
    const Folder folder;
    CHECK(run(folder, R"(
        store.scores = { 3, 2, 1 }
        local scores = store.scores
        store.scores = scores
        scores[1], store.scores = 9, scores
        scores[4] = 0
        print(store.scores[1], #store.scores, scores == store.scores)
        store.scores = { 5 }
        print(pcall(function() scores[1] = 7 end))
    )")
              .out ==
          "9\t4\ttrue\n"
          "false\teval:9: this table is no longer in the store: it was replaced or removed\n");
}

TEST_CASE("a list in the store is the value of a property or an argument as other lists are") {
    const Folder folder;
    const Outcome outcome = run(folder, R"(
        store.points = { vec(1, 2), vec(3, 4) } store.rows = { { "a", 1 }, { "b", 2 } }
        state("points", store.points)
        state("rows", {})
        rows = store.rows
        table.insert(points, store.points[1])
        points[1].x = 9 rows[2][1] = "c"
        world.line = Line { points = store.points }
        print(points, rows, world.line.points[2])
        print(store.points, store.rows)
        rows = { store.rows[2], { "d", 3 } }
        print(rows)
        for _, bad in ipairs { { x = 1 }, { [1] = 1, [3] = 3 }, { { name = "a" } } } do
            store.bad = bad
            print(select(2, pcall(function() rows = store.bad end)))
        end
        print(select(2, pcall(function() rows = store end)))
        print(rows)
    )");
    INFO(outcome.out << outcome.err);
    CHECK(
        outcome.out ==
        "{vec(9, 2), vec(3, 4), vec(1, 2)}\t{{\"a\", 1}, {\"c\", 2}}\tvec(3, 4)\n"
        "{vec(1, 2), vec(3, 4)}\t{{\"a\", 1}, {\"b\", 2}}\n"
        "{{\"b\", 2}, {\"d\", 3}}\n"
        "eval:15: game.rows: a table with named keys (x) is not a value; a vector is vec(x, y), "
        "a color color(r, g, b), a list has elements 1, 2, 3 ..., and Object { } takes names\n"
        "eval:15: game.rows: the table has gaps; a list has elements 1, 2, 3 ...\n"
        "eval:15: game.rows: a table with named keys (name) is not a value; a vector is vec(x, "
        "y), a color color(r, g, b), a list has elements 1, 2, 3 ..., and Object { } takes names\n"
        "eval:17: game.rows: the whole store is not a value of a property\n"
        "{{\"b\", 2}, {\"d\", 3}}\n");
}

TEST_CASE("tables in the store are sorted and moved and exchanged as other tables are") {
    const Folder folder;
    CHECK(run(folder, R"(
        store.best = {}
        for i, points in ipairs { 5, 9, 7, 1, 8, 3 } do
            store.best[i] = { points = points, at = { i, { i } } }
        end
        local function show()
            local all = {}
            for _, each in ipairs(store.best) do all[#all + 1] = each.points .. ":" .. each.at[2][1] end
            print(table.concat(all, " "))
        end
        table.sort(store.best, function(a, b) return a.points > b.points end)
        show()
        table.insert(store.best, 2, { points = 8.5, at = { 0, { 0 } } })
        local first = table.remove(store.best, 1)
        print(first.points, first.at[2][1])
        show()
        local best = store.best
        best[1], best[3] = best[3], best[1]
        show()
        table.move(best, 4, 6, 1)
        best[6] = first
        show()
    )")
              .out ==
          "9:2 8:5 7:3 5:1 3:6 1:4\n9\t2\n8.5:0 8:5 7:3 5:1 3:6 1:4\n"
          "7:3 8:5 8.5:0 5:1 3:6 1:4\n5:1 3:6 1:4 5:1 3:6 9:2\n");
}

TEST_CASE("a value that cannot be in the store is refused with its path") {
    const Folder folder;
    const std::string out = run(folder, R"(
        local function try(f) local ok, why = pcall(f) print(why) end
        try(function() store.f = print end)
        try(function() store.t = { a = { b = function() end } } end)
        try(function() store.w = world end)
        try(function() store.c = Body end)
        try(function() store.clear = 1 end)
        try(function() store[1.5] = 1 end)
        try(function() store[{}] = 1 end)
        try(function() local t = {} t.t = t store.t = t end)
        try(function() local t = {} t.u = { t } store.t = t end)
        try(function() local t = {} for _ = 1, 120 do t = { t } end store.t = t end)
        try(function() store.s = store end)
        try(function() game.o = Object {} game.o.n = formula(function() return store.a end) end)
        print(store:has("f"), store:has("t"), game.o:problem("n"))
    )")
                                .out;
    INFO(out);
    CHECK(contains(out, "eval:3: store.f: a function cannot be in the store; it holds texts"));
    CHECK(contains(out, "store.t.a.b: a function cannot be in the store"));
    CHECK(contains(out, "store.w: a World cannot be in the store, because it ends with the run"));
    CHECK(contains(out, "store.c: "));
    CHECK(contains(out, "store.clear: this is a function of the store"));
    CHECK(contains(out, "a key in the store is a text or a whole number, not 1.5"));
    CHECK(contains(out, "a key in the store is a text or a whole number, not a table"));
    CHECK(contains(out, "store.t.t: this is store.t again; a table that contains itself"));
    CHECK(contains(out, "store.t.u[1]: this is store.t again"));
    CHECK(contains(out, "nested at most 100 deep"));
    CHECK(contains(out, "false\tfalse\t"));
    CHECK(contains(out, "the store cannot be read in a formula"));
}

TEST_CASE("the console echoes what it changes in the store") {
    const Folder folder;
    const std::string out =
        run(folder, "store.best = 7",
            {"--console", "1:store.best = 8", "--console", "2:store.best", "--console",
             "3:store.t = {x = 1}", "--console", "4:store", "--console", "5:store:clear()"})
            .out;
    INFO(out);
    CHECK(contains(out, "store.best: 7 → 8"));
    CHECK(contains(out, "  8\n"));
    CHECK(contains(out, "store.t: nil → {x = 1}"));
    CHECK(contains(out, "{best = 8, t = {x = 1}}"));
    CHECK(contains(out, "store: cleared"));
    CHECK(run(folder, "print(store)").out == "{}\n");
}

TEST_CASE("going back in time and saved games leave the store as it is") {
    const Folder folder;
    const std::string out =
        run(folder,
            "store.deaths = 0 game.o = Object {} game.o.n = 0 save_game('a') "
            "function step() game.o.n = game.o.n + 1 store.deaths = store.deaths + 1 end",
            {"--at", "3:rewind(1)", "--at", "4:load_game('a')", "--at",
             "5:print(game.o.n, store.deaths)"})
            .out;
    CHECK(out.ends_with("\t4\n"));
    CHECK_FALSE(out == "4\t4\n");
}

TEST_CASE("a replay reads the store of the recorded start and does not write") {
    const Folder folder;
    run(folder, "store.runs = 1");
    const std::string recording = (folder / "a.recording").string();
    folder.write("main.lua", "");
    run(folder, "game.o = Object {} game.o.n = store.runs store.runs = store.runs + 1",
        {"--record", recording, "--at", "3:game.o.m = store.runs"});
    run(folder, "store.runs = 50");
    const Outcome replay = fettle(folder, {"run", "--replay", recording, "--headless"});
    INFO(replay.err);
    CHECK(replay.status == 0);
    CHECK(contains(replay.out, "5 steps, each as it was recorded"));
    CHECK(run(folder, "print(store.runs)").out == "50\n");
}

TEST_CASE("a run that is killed leaves the whole store of a moment") {
    const Folder folder;
    const std::string stored = "user data/fettle/games/org.example.killed/store.json";
    folder.write("game.json", R"({"id": "org.example.killed"})");
    const std::string endless = folder.write("endless.lua", R"(
        local n = 0
        store.list = { 1, 2, 3 }
        function step()
            n = n + 1
            store.n = n
            store.list[2] = n
        end
    )");
    for (int i = 0; i < 4; ++i) {
        std::filesystem::remove(folder / stored);
        RunningProgram program(folder, {"run", endless, "--headless", "--steps", "1000000000"});
        REQUIRE(program.makes(stored));
        program.send(SIGKILL);
        program.end();
        CHECK(run(folder, "print(store.n == store.list[2], store.n > 0)").out == "true\ttrue\n");
    }
}

TEST_CASE("a table that names another one thousands of times is refused before it is copied") {
    const Folder folder;
    const std::string out = run(folder, R"(
        store.big = {}
        for i = 1, 10 do store.big[i] = string.rep("x", 1000000) end
        local many = {}
        for i = 1, 100000 do many[i] = store.big end
        print(pcall(function() store.many = many end))
        print(store.many)
    )")
                                .out;
    CHECK(contains(out, "store.many: the store would have more than 16 MiB"));
    CHECK(contains(out, "nil\n"));
}

TEST_CASE("in a formula the store is neither read nor written and the error says so") {
    const Folder folder;
    const std::string out = run(folder, R"(
        local list = store.list
        store.list = { 1 }
        list = store.list
        local function try(f)
            world.x = formula(f)
            print((select(2, pcall(function() return world.x end))))
        end
        try(function() return #list end)
        try(function() list[1] = 2 return 1 end)
        try(function() return tostring(list) end)
    )",
                                {"--eval", "world.x = nil"})
                                .out;
    CHECK(contains(out, "it cannot read a store"));
    CHECK(contains(out, "it cannot assign to a store"));
    CHECK(contains(out, "it cannot call tostring"));
}

}  // namespace store_run_test
