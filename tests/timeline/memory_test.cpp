// The memory of the timeline is limited by `time.rewind_memory` in any game. It is measured as the
// memory of the process, not as the timeline counts it.

#include "catch.h"

#include <fstream>

#include <malloc.h>
#include <unistd.h>

#include "playing.h"
#include "thorough.h"

namespace memory_test {

using namespace fettle;
using namespace fettle::app;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool measured = false;  // freed memory stays in quarantine
#else
constexpr bool measured = true;
#endif

namespace {

/// Resident memory of the process, MiB.
double resident() {
    malloc_trim(0);
    std::ifstream from("/proc/self/statm");
    double all = 0, pages = 0;
    from >> all >> pages;
    return pages * double(sysconf(_SC_PAGESIZE)) / 1048576;
}

/// Maximal difference of the memory of a game with a timeline of `allowed` MiB and without one,
/// MiB.
double worst_of_the_past(const std::string& script, double allowed, int steps) {
    const auto played = [&](double limit) {
        Playing game(script);
        game.loop->timeline().set_share(0.01);
        game.services.clock.rewind_limit = limit;
        game.services.clock.rewind_memory = allowed;
        double worst = 0;
        for (int i = 0; i < steps; ++i) {
            game.loop->turn();
            if (i % 100 == 99) worst = std::max(worst, resident());
        }
        CAPTURE(game.errors);
        REQUIRE(game.errors.empty());
        CHECK(game.time().memory() <= std::size_t(allowed * 1048576));
        return worst;
    };
    const double without = played(0);
    return played(3600) - without;
}

}  // namespace

TEST_CASE("an undo that the memory does not allow says which property allows it") {
    Playing game("");
    game.services.clock.rewind_memory = 1;
    game.loop->turn();
    const auto output_of = [&](const char* command) {
        std::string all;
        for (const std::string& line : game.runtime->evaluate(command).lines) all += line + "\n";
        return all;
    };
    output_of("for i = 1, 2000 do world:add(Body { position = vec(i, 0), Circle {} }) end");
    const std::string undone = output_of("undo");
    INFO(undone);
    CHECK(undone.find("more memory than the history may") != std::string::npos);
    CHECK(undone.find("larger time.rewind_memory (1 MiB now)") != std::string::npos);
    game.services.clock.rewind_memory = 128;
    game.loop->turn();
    output_of("for i = 1, 2000 do world:add(Body { position = vec(i, 0), Circle {} }) end");
    CHECK(output_of("undo").find("deleted") != std::string::npos);
}

TEST_CASE("the timeline keeps its memory limit in any game") {
    const std::pair<const char*, const char*> games[] = {
        {"an edit a step",
         "local n = 0 function step() n = n + 1 edit('e', function() world.gravity = vec(n, 1) "
         "end) end"},
        {"many edits a step",
         "local n = 0 function step() for i = 1, 300 do n = n + 1 edit('e' .. n, function() "
         "world['p' .. i % 50] = n end) end end"},
        {"undo and redo",
         "local n = 0 function step() n = n + 1 edit('e', function() world.big = string.rep('x', "
         "20000) .. n end) undo() redo() end"},
        {"large texts",
         "local n = 0 function step() n = n + 1 world.text = string.rep('x', 200000) .. n end"},
        {"large lists",
         "local n = 0 function step() n = n + 1 local l = {} for i = 1, 5000 do l[i] = n + i end "
         "world.list = l end"},
        {"an edit of a large list",
         "local n = 0 function step() n = n + 1 local l = {} for i = 1, 5000 do l[i] = n + i end "
         "edit('l', function() world.list = l end) end"},
        {"writes", R"(
            local bodies = {}
            for i = 1, 50 do bodies[i] = Body { position = vec(3 * i, 0), Circle {} } world:add(bodies[i]) end
            local n = 0
            function step() for k = 1, 3000 do n = n + 1 bodies[k % 50 + 1].velocity = vec(n % 7, 1) end end)"},
        {"watchers", R"(
            for i = 1, 200 do
                local b = Body { position = vec(3 * i, 0), Circle {} }
                world:add(b)
                b:watch("position", function(new) b.seen = new.y end)
            end)"},
        {"births and deaths", R"(
            local old
            function step()
                for i = 1, 40 do world:add(Body { position = vec(3 * i, 9), Circle {}, Box {} }) end
                for _, b in ipairs(world:children(Body)) do b:delete() end
            end)"},
        {"deaths that can be undone", R"(
            function step()
                edit('d', function()
                    for i = 1, 10 do world:add(Body { position = vec(3 * i, 9), Circle {}, Box {} }) end
                    for _, b in ipairs(world:children(Body)) do b:delete() end
                end)
            end)"},
        {"formulas", R"(
            local n = 0
            function step()
                n = n + 1
                local mine = string.rep('x', 50000) .. n
                world.f = formula(function() return #mine end)
            end)"},
        {"formulas that are edits", R"(
            local n = 0
            function step()
                n = n + 1
                local mine = {}
                for i = 1, 2000 do mine[i] = n end
                edit('f', function() world.f = formula(function() return #mine end) end)
            end)"},
        {"timers", R"(
            local n = 0
            function step()
                n = n + 1
                for i = 1, 20 do
                    local mine = string.rep('x', 5000) .. n .. i
                    after(0.05, function() world.last = #mine end)
                end
            end)"},
        {"timers of every step", "for i = 1, 500 do every(0, function() end) end"},
        {"a large state",
         "for i = 1, 1500 do world:add(Body { position = vec(i % 40, i / 40), Circle {} }) end"},
    };
    constexpr double allowed = 16;
    std::size_t number = 0;
    for (const auto& [name, script] : games) {
        if (!is_tested(number++, 3)) continue;
        INFO(name);
        const double more = worst_of_the_past(script, allowed, measured ? 700 : 150);
        INFO("MiB: " << more);
        if (measured) CHECK(more < allowed * 1.25 + 6);
    }
}

TEST_CASE("a smaller limit of memory applies from the next step") {
    Playing game(R"(
        local n = 0
        function step() n = n + 1 edit('e', function() world.text = string.rep('x', 20000) .. n end) end
    )");
    game.play(2000);
    REQUIRE(game.time().memory() + game.tree.history_bytes() > (std::size_t{30} << 20));
    const double before = resident();
    game.console("time.rewind_memory = 4");
    game.play(2);
    CHECK(game.time().memory() + game.tree.history_bytes() <= (std::size_t{4} << 20));
    if (measured) CHECK(resident() < before - 20);
    game.play(100);
    game.check(game.time().oldest());
    game.check(game.time().newest());
}

TEST_CASE("a state larger than the memory limit leaves an empty timeline without an error") {
    Playing game("world.text = string.rep('x', 3000000)");
    game.console("time.rewind_memory = 1");
    game.play(100);
    CHECK(game.time().keyframes() == 0);
    CHECK(game.get("time.oldest").integer() == 100);
    REQUIRE(game.runtime->run("rewind(1) world.text = 'short'", "test"));
    game.play(700);
    CHECK(game.time().newest() == 800);
    CHECK(game.time().oldest() < 800);
    game.check(game.time().oldest());
}

TEST_CASE("undo uses its share of the memory and names an edit that is too large") {
    Playing game("");
    game.console("time.rewind_memory = 32");
    game.play(2);
    std::vector<std::string> printed;
    game.runtime->on_print([&](std::string_view line) { printed.emplace_back(line); });
    REQUIRE(
        game.runtime->run("edit('small', function() world.a = 1 end)"
                          "edit('large', function() world.b = string.rep('x', 9000000) end)",
                          "test"));
    CHECK(game.tree.history_bytes() < (std::size_t{2} << 20));
    const auto listed = game.tree.history();
    REQUIRE(listed.size() == 3);  // the third is the console command itself
    CHECK(listed[0].name == "large");
    CHECK(listed[0].too_large);
    const std::string told =
        "this edit took too much memory to be undone; with a larger time.rewind_memory (32 MiB "
        "now), the next edit of this size can be undone";
    CHECK(printed == std::vector<std::string>{told});
    const auto typed = game.runtime->evaluate("world.c = string.rep('x', 9000000)");
    REQUIRE(typed.ok);
    CHECK(typed.lines.back() == told);
    CHECK(game.runtime->evaluate("world.d = 1").lines.size() == 1);
    game.tree.undo();
    game.tree.undo();
    const auto reported = game.tree.undo();
    REQUIRE(reported.notes.size() == 1);
    CHECK(reported.notes[0].find("more memory") != std::string::npos);
    CHECK(game.get("world.b").text().size() == 9000000);
    CHECK(game.tree.undo().notes.empty());
    CHECK_THROWS(game.get("world.a"));
    game.play(5);
    game.check(3);
}

}  // namespace memory_test
