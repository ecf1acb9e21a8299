// What one command, one script and one game may create.

#include <fettle/property/path.h>

#include "stage.h"

namespace growth_test {

using stage::Stage;
using stage::starts_with;

namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr bool slowly = true;  // the large cases would take minutes
#else
constexpr bool slowly = false;
#endif

fettle::script::Options small_memory() {
    fettle::script::Options options;
    options.console_memory = std::size_t{2} << 20;
    return options;
}

}  // namespace

TEST_CASE(
    "a command that creates instances without end is stopped with a list of what it created") {
    const std::string attack = GENERATE(
        as<std::string>{}, "while true do world:add(Body {}) end",
        "while true do pcall(function() world:add(Body {}) end) end",
        "local b = Object { Object {}, Object {} } while true do b = Object { b:clone(), b } end",
        "local b = Object {} while true do for i = 1, 50 do b:add(Object {}) end b = b:clone() end",
        "while true do world:watch('scale', print) end",
        "while true do watch('world.*.mass', print) end",
        "while true do world:on('deleted', print) end", "while true do after(1, print) end",
        "while true do every(1, print) end",
        "local n = 0 while true do n = n + 1 world['k' .. n] = n end",
        "local n = 0 while true do n = n + 1 world['k' .. n] = Object {} end",
        "local n = 0 while true do n = n + 1 class('K' .. n, Object) {} end",
        "local l = {} while true do local o = Object {} l[#l + 1] = o o.f = formula(print) end",
        "local n = 0 while true do n = n + 1 local o = Object {} o.t = ('x'):rep(1000) .. n "
        "world:add(o) end",
        "local t = {} for i = 1, 1000 do t[i] = i end while true do local o = Object {} o.t = t "
        "world:add(o) end",
        "while true do local c = coroutine.create(function() world:add(Body {}) end) "
        "coroutine.resume(c) end");
    Stage s(small_memory());
    CAPTURE(attack);
    const std::size_t before = s.tree->size();
    const auto e = s.runtime->evaluate(attack);
    CHECK_FALSE(e.ok);
    REQUIRE(e.error);
    CHECK_THAT(e.error->message,
               starts_with("console:1: stopped: it needs more memory than a command may use, 2 MB; "
                           "it made "));
    // None of the created instances is left.
    CHECK(s.tree->size() == before);
    CHECK(s.console("1 + 1") == "2");
}

TEST_CASE("created and deleted instances do not count") {
    Stage s(small_memory());
    const std::string many = std::to_string(slowly ? 10000 : 50000);
    // The history has room for 10 000 of them.
    const std::string lost = slowly ? "" : "|this edit took too much memory to be undone";
    CHECK(s.console("for i = 1, " + many +
                    " do local o = Object { t = ('x'):rep(200) } o:delete() end "
                    "return 1") == "1" + lost);
    CHECK(s.console("for i = 1, " + many + " do world:watch('scale', print):stop() end return 2") ==
          "2");
    CHECK(s.console("for i = 1, " + many + " do after(1, print):stop() end return 3") == "3");
    CHECK(s.console("for i = 1, " + many +
                    " do world.text = ('x'):rep(200) .. i end return #world.text > "
                    "0") != "");
}

TEST_CASE("a command that writes two cells alternately stores only their first and last values") {
    Stage s(small_memory());
    s.run("world.a = 1 world.b = 1");
    CHECK_THAT(s.console("for i = 1, 50000 do world.a = i world.b = i end return 1"),
               contains("world.a: 1 → 50000"));
    s.console("undo");
    CHECK(s.get("world.a").integer() == 1);
    CHECK(s.get("world.b").integer() == 1);
}

TEST_CASE("the memory limit of a command can be set") {
    Stage s;
    std::size_t megabytes = 4;
    s.runtime->on_command_memory([&] { return megabytes << 20; }, "console.memory_limit");
    const std::string command = "for i = 1, 20000 do world:add(Object {}) end return 1";
    CHECK_THAT(s.console(command), contains("a command may use, 4 MB") &&
                                       contains(" instances, ") &&
                                       contains("console.memory_limit raises the limit"));
    megabytes = 64;
    CHECK_THAT(s.console(command), contains("1"));
}

TEST_CASE("a chunk has the memory limit of the game and not that of a command") {
    fettle::script::Options options;
    options.memory_limit = std::size_t{16} << 20;
    Stage s(options);
    CHECK_THAT(
        s.fails("\nwhile true do world:add(Object {}) end"),
        starts_with("main.lua:2: stopped: it needs more memory than a chunk may use, 16 MB"));
    CHECK_THAT(s.fails("local t = {} while true do t[#t + 1] = {} end"),
               contains("the scripts of a game may use 16 MB"));
    s.run("for i = 1, 60000000 do end");
}

TEST_CASE("snapshots held by scripts have a memory limit") {
    fettle::script::Options options;
    options.memory_limit = std::size_t{16} << 20;
    Stage s(options);
    s.run("for i = 1, 20000 do world:add(Object {}) end held = {}");
    s.step();
    std::vector<std::string> reported;
    s.tree->on_handler_error(
        [&](const fettle::property::HandlerError& error) { reported.push_back(error.message); });
    for (int i = 0; i < 30; ++i) {
        (void)s.runtime->run("held[#held + 1] = snapshot()", "main.lua");
        s.tree->barrier();
    }
    REQUIRE(!s.errors.empty());
    CHECK_THAT(s.errors.back().message, contains("of 16 MB; let go of some"));
    // A snapshot that was not stored because of the limit is refused when it is restored.
    s.errors.clear();
    s.run("held = nil collectgarbage() held = { snapshot() }");
    s.tree->barrier();
    CHECK(s.errors.empty());
}

TEST_CASE("a constructor takes very many children without names") {
    Stage s;
    const std::string count = std::to_string(slowly ? 10000 : 200000);
    s.run("local t = { object_4 = Object {} } for i = 1, " + count + " do t[i] = Object {} end " +
          "world.many = Object(t)");
    CHECK(s.console("world.many:children()[4].name") == "\"object_3\"");
    CHECK(s.console("world.many:children()[5].name") == "\"object_5\"");
    CHECK(s.console("#world.many:children()") == std::to_string(std::stoi(count) + 1));
}

TEST_CASE("the depth of a tree is limited to a thousand levels") {
    Stage s;
    const std::string reported = s.fails(R"lua(
local deep = world
while true do deep = deep:add(Object {}) end
)lua");
    CHECK_THAT(reported, contains("too deep; a tree has 1000 levels at most"));
    CHECK(reported.size() < 300);
    // By adding a parent, and by moving.
    CHECK_THAT(s.fails("local top = Object {} while true do top = Object { top } end"),
               contains("1000 levels at most"));
    s.run(R"lua(
local a, b = Object {}, Object {}
world.a, world.b = a, b
local deep = a
for i = 1, 900 do deep = deep:add(Object {}) end
local other = b
for i = 1, 900 do other = other:add(Object {}) end
assert(not pcall(function() b:move(deep) end))
assert(b.parent == world)
assert(#tostring(deep) > 900)
local copy = a:clone()
a:delete()
copy:delete()
)lua");
    s.step();
}

TEST_CASE("an undo that would exceed the depth is refused") {
    Stage s;
    s.run(R"lua(
world.p = Object {}
local deep = world.p:add(Object {}, "top")
for i = 1, 600 do deep = deep:add(Object {}) end
world.q = Object {}
bottom = world.q
for i = 1, 600 do bottom = bottom:add(Object {}) end
)lua");
    s.console("world.p.top = nil");
    s.run("world.p:move(bottom)");
    CHECK_THAT(s.console("undo"),
               contains("cannot be brought back: its former parent is too deep in the tree now"));
}

TEST_CASE("the number of classes and of names of ad-hoc properties is limited") {
    Stage s;
    CHECK_THAT(s.fails("for i = 1, 20000 do class('K' .. i, Object) {} end"),
               contains("K") && contains("there are 10000 classes already"));
    Stage names;
    CHECK_THAT(names.fails("local o = Object {} for i = 1, 200000 do o['n' .. i] = 1 o['n' .. i] = "
                           "nil end"),
               contains("different names were added already; keep what is counted in a list"));
    CHECK(names.prints("local o = Object { n17 = 3 } print(o.n17)") == "3");
}

TEST_CASE("classes that derive from each other have the memory limit of the game") {
    // Each class copies what is known of the properties of its base.
    const std::string attack =
        GENERATE(as<std::string>{},
                 "local base = Object for i = 1, 5000 do base = class('K' .. i, base) { ['p' .. i] "
                 "= 1 } end",
                 "for i = 1, 200 do class('K' .. i, Object) { doc = { ('d'):rep(1e6) .. i } } end");
    CAPTURE(attack);
    auto options = stage::unhurried();
    options.memory_limit = options.limits.memory = std::size_t{64} << 20;
    Stage s(options);
    CHECK_THAT(s.fails(attack),
               contains("memory") && contains("a chunk may use") && contains("64 MB"));
}

TEST_CASE("what each call of a script of a trusted game adds to the tree is limited") {
    auto options = stage::unhurried();
    options.limits.tree = std::size_t{8} << 20;
    options.limits.tree_setting = "the host";
    Stage s(options);
    s.run("function fill() while true do pcall(function() world:add(Object {}) end) end end");
    s.run("function few() for i = 1, 10 do world:add(Object {}) end end");
    s.errors.clear();
    CHECK_FALSE(s.runtime->call("fill", {}));
    REQUIRE(s.errors.size() == 1);
    CHECK_THAT(s.errors[0].message,
               contains("stopped: it needs more memory than the scripts of a game may add to it, 8 "
                        "MB; ") &&
                   contains("instances and what belongs to them have 8 MB (the host raises the "
                            "limit)"));
    // Small additions and a console command have some room, and the next big one is stopped again.
    CHECK(s.runtime->call("few", {}));
    CHECK(s.runtime->evaluate("for i = 1, 10 do world:add(Object {}) end").ok);
    CHECK_FALSE(s.runtime->call("fill", {}));
}

TEST_CASE("the number of restores that wait for one barrier is limited") {
    Stage s;
    s.run("kept = snapshot()");
    s.tree->barrier();
    CHECK_THAT(s.fails("for i = 1, 1e9 do restore(kept) end"),
               contains("restore: 100 restores and rewinds wait for the next barrier already"));
    s.tree->barrier();
    s.run("restore(kept)");
    s.tree->barrier();
}

TEST_CASE("the order of pairs does not depend on addresses") {
    // The keys are created in another order than the instances, with garbage between them.
    const char* game = R"(
local all, seen = {}, {}
for i = 1, 40 do all[i] = Object {} world:add(all[i]) end
for i = 40, 1, -1 do seen[all[(i * 7) % 40 + 1]] = {} local waste = { i, tostring(i) } end
local order = {}
for instance in pairs(seen) do order[#order + 1] = instance.name end
world.order = table.concat(order, " ")
)";
    std::string first;
    for (int run = 0; run < 3; ++run) {
        Stage stage;
        stage.run(game);
        const std::string order =
            stage.tree->get(stage.tree->child(stage.tree->root(), "world"), "order").text();
        if (run == 0) first = order;
        CHECK(order == first);
        CHECK(order.find(' ') != std::string::npos);
    }
}

}  // namespace growth_test
