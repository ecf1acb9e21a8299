// Hostile console commands: none may crash, run without end or leave the sandbox.
//
// attack                                      defense (without it, a test here fails)
// a loop; a loop around pcall                 Budget::hook, raised again at every instruction
// an xpcall handler that loops                protected.cpp: no handler while a script is stopped
// coroutines with counters of their own       Budget::enter: the hook, and 500 instructions each
// __gc, where no hook runs                    base_functions.cpp: setmetatable refuses __gc
// __close that loops while a script is ended  coroutines of a stopped script are not closed
// patterns that go back and forth             text/patterns.cpp charges each step
// rep, concat, move, insert, unpack, format   string_and_date_functions.cpp, table_functions.cpp:
//                                             charged or refused before they begin
// deep nesting in the parser and in gsub      limits of Lua, and of C calls in patterns
// __tostring, __name, __index, errors that    errors.cpp calls them in protected mode, and only
// are objects                                 while the budget lasts
// out of memory, caught in a loop             Budget::memory_refused stops the script
// bytecode, string.dump, debug, package, io   sandbox.cpp copies allowed names only; load is "t"
// metatables of texts, instances, values      __metatable hides them; setmetatable takes tables
// rawset and rawget on instances              Lua: instances are not tables
// collectgarbage("stop")                      base_functions.cpp allows collect, step, count
// wrong self, stale handles                   guarded methods check the tag and the handle
// .. and links in paths                       GameFiles; see sandboxed_game_test.cpp

#include "stage.h"

namespace sandbox_test {

using stage::Stage;

namespace {

fettle::script::Options small_budget(std::uint64_t instructions = 3'000'000,
                                     std::size_t megabytes = 24) {
    fettle::script::Options options;
    options.console_budget = instructions;
    options.console_memory = megabytes << 20;
    options.memory_limit = std::size_t{96} << 20;
    return options;
}

}  // namespace

TEST_CASE("an endless command is stopped with its place") {
    const std::string attack = GENERATE(
        as<std::string>{}, "while true do end", "while true do pcall(error) end",
        "while true do pcall(function() while true do end end) end",
        "local function f() pcall(f) while true do end end f()",
        "xpcall(function() while true do end end, function() while true do end end)",
        "xpcall(error, function() while true do end end)",
        "while true do xpcall(error, function(e) return e end) end",
        "repeat until coroutine.wrap(function() while true do end end)()",
        "while true do coroutine.wrap(function() for i = 1, 900 do end end)() end",
        "local function f() while true do coroutine.wrap(f)() end end f()",
        "local function f() while true do coroutine.resume(coroutine.create(f)) end end f()",
        "local co = coroutine.create(function() while true do end end) "
        "while true do coroutine.resume(co) end",
        "local co = coroutine.wrap(function() local x <close> = setmetatable({}, "
        "{ __close = function() while true do end end }) while true do end end) pcall(co) "
        "while true do end",
        "local x <close> = setmetatable({}, { __close = function() while true do end end }) "
        "while true do end",
        "local x <close> = setmetatable({}, { __close = function() while true do end end })",
        "goto top ::top:: goto top", "for i = 1, math.huge do end",
        "setmetatable({}, { __index = function(t, k) return t[k] end }).x = nil "
        "local t = setmetatable({}, { __index = function(t, k) return t[k .. 'x'] end }) return "
        "t.x",
        "return tostring(setmetatable({}, { __tostring = function() while true do end end }))",
        "print(setmetatable({}, { __tostring = function() while true do end end }))",
        "load(function() while true do end end)", "load(function() return ' ' end)",
        "string.gsub(('x'):rep(1e6), '.', function() while true do end end)",
        "table.sort({3, 2, 1, 4, 5}, function() while true do end end)",
        "world:find('World', 3) while true do end",
        "for _ in pairs(setmetatable({}, { __pairs = function() while true do end end })) do end",
        "while true do collectgarbage() end", "return (('a'):rep(100)):find(('.-'):rep(50) .. 'b')",
        "return (('a'):rep(30000)):match('.-.-.-.-b')",
        "return (('a'):rep(30000)):gsub('a*a*a*a*b', '')",
        "for x in (('a'):rep(30000)):gmatch('a-a-a-a-b') do end",
        "return (('('):rep(1e6)):find('%b()')", "return (('a'):rep(1e6)):find('(.-)%1b')",
        "return (('a'):rep(1e6)):find('[' .. ('b'):rep(1e5) .. ']')",
        "return (('a'):rep(1e6)):find('%f[' .. ('b'):rep(1e5) .. ']')",
        "while true do local s = ('x'):rep(1e6) end",
        "while true do pcall(string.rep, 'x', 1e10) end",
        "for i = 1, 1e9 do world.gravity = vec(0, i) end",
        "for i = 1, 1e9 do world.gravity.x = i end",
        "while true do pcall(function() world.x = {} world.y = nil end) end",
        "local t = setmetatable({}, { __len = function() return 1e15 end }) table.insert(t, 1, 2) "
        "while true do end");
    Stage s(small_budget(1'000'000));
    CAPTURE(attack);
    const auto e = s.runtime->evaluate(attack);
    CHECK_FALSE(e.ok);
    REQUIRE(e.error);
    CHECK_THAT(e.error->message,
               contains("console:1: ") || contains("stopped") || contains("C stack overflow"));
    // The console still works.
    CHECK(s.console("1 + 1") == "2");
    CHECK(s.prints("local n = 0 for i = 1, 1000000 do n = n + 1 end print(n)") == "1000000");
}

TEST_CASE("a plain search takes linear time") {
    Stage s;
    CHECK(s.prints("local text, word = ('a'):rep(1e6), ('a'):rep(5e5) "
                   "print(text:find(word .. 'b', 1, true), text:find(word .. 'b'), "
                   "text:find(word, 3, true))") == "nil\tnil\t3\t500002");
    CHECK(s.prints("print(('abc'):find('', 2, true), ('abc'):find('', 4, true), "
                   "('abc'):find('c', -1, true), ('a\\0b'):find('\\0b', 1, true), "
                   "('abc'):find('abcd', 1, true))") == "2\t4\t3\t2\tnil");
}

TEST_CASE("a command that needs too much memory is stopped") {
    const std::string attack = GENERATE(
        as<std::string>{}, "return ('x'):rep(1e10)", "local t = {} for i = 1, 1e9 do t[i] = {} end",
        "local t = {} while true do pcall(function() for i = 1, 1e9 do t[#t + 1] = i .. 'x' end "
        "end) end",
        "local s = 'x' while true do s = s .. s end",
        "return table.concat(setmetatable({}, { __index = rawlen, __len = function() return 1e9 "
        "end }))",
        "return table.concat(setmetatable({}, { __index = function() return 'x' end }), '', 1, "
        "1e9)",
        "table.move({}, 1, 1e9, 2)", "return table.unpack({}, 1, 1e9)",
        "return table.pack(table.unpack({}, 1, 1e6))", "return ('%99.99f'):rep(1e6):format(1)",
        "return ('x'):rep(1e6):gsub('x', ('y'):rep(1e6))",
        "local s = ('x'):rep(5e5) local t = {} for i = 1, 100 do t[i] = s .. i end",
        "local function f(n) return f(n + 1) + 1 end return f(1)",
        "local function f(...) return f(1, ...) end return f()",
        "local t = {} t.t = t for i = 1, 1e8 do t[i] = coroutine.create(print) end",
        "load(('('):rep(1e5))", "return ('x'):rep(-1), (''):rep(1e18), ('x'):rep(1e18)",
        "return string.pack(('i16'):rep(1e6), 1)",
        "world.list = {} for i = 1, 1e9 do world.list[i] = i end");
    Stage s(small_budget(3'000'000, 3));
    CAPTURE(attack);
    s.runtime->evaluate(attack);
    CHECK(s.runtime->memory() < (std::size_t{64} << 20));
    CHECK(s.console("1 + 1") == "2");
    CHECK(s.prints("local t = {} for i = 1, 1000 do t[i] = {} end print(#t)") == "1000");
}

TEST_CASE("memory of a command is freed after it") {
    Stage s(small_budget());
    s.run("function fill() local t = {} for i = 1, 300000 do t[i] = { i } end end");
    CHECK_THAT(s.console("local t = {} for i = 1, 1e8 do t[i] = { i } end"),
               contains("more memory than a command may use"));
    CHECK(s.console("#('x'):rep(1e7)") == "10000000");
}

TEST_CASE("repeating and sorting give what Lua's own functions give") {
    Stage s;
    CHECK(
        s.prints("print(('ab'):rep(3), ('ab'):rep(3, '-'), ('ab'):rep(1, '-'), #('ab'):rep(0))") ==
        "ababab\tab-ab-ab\tab\t0");
    CHECK(s.prints("print((''):rep(3, '-'), #('xyz'):rep(10001, '--'), ('x'):rep(-1) == '')") ==
          "--\t50003\ttrue");
    CHECK(s.prints("print(pcall(string.rep, 'xy', math.maxinteger))") ==
          "false\tmain.lua:1: resulting string too large");
    // In a command, whose time is limited: of long texts, and by a function that is not a script's.
    CHECK(s.console("t = { 'b', ('a'):rep(5000), 'c' } table.sort(t) return #t[1], t[2], t[3]") ==
          "5000  \"b\"  \"c\"");
    CHECK(s.console("table.sort(t, function(a, b) return a > b end) return t[1]") == "\"c\"");
    CHECK(s.console("n = { 3, 1, 2 } table.sort(n, math.ult) return n") == "{1, 2, 3}");
}

TEST_CASE("dangerous functions are not available") {
    Stage s;
    for (const char* name :
         {"debug", "io", "package", "dofile", "loadfile", "loadstring", "newproxy", "getfenv"}) {
        CAPTURE(name);
        CHECK_THAT(s.fails(std::string("return ") + name), contains("no such name"));
    }
    s.run(R"lua(
assert(rawget(os, "execute") == nil and rawget(os, "exit") == nil and rawget(os, "remove") == nil)
assert(rawget(os, "getenv") == nil and rawget(os, "setlocale") == nil and rawget(os, "tmpname") == nil)
assert(rawget(string, "dump") == nil)
assert(os.time() and os.clock() and os.date())
assert(getmetatable("") == "text")
assert(not pcall(setmetatable, _G, {}))
assert(getmetatable(world) == "instance" and getmetatable(vec(0, 0)) == "vec")
assert(getmetatable(Body) == "class" and getmetatable(_G) == "globals")
assert(not pcall(setmetatable, world, {}))
assert(not pcall(rawset, world, "x", 1) and not pcall(rawget, world, "x"))
assert(not pcall(rawlen, world) and rawequal(world, world))
assert(load("\27Lua") == nil)
local f, message = load("return 1", "x", "b")
assert(f == nil and message == "attempt to load a text chunk (mode is 'b')", message)
assert(load("return 1", "x", "bt")() == 1)
assert(load("return world", "x", "t", { world = 3 })() == 3)
assert(not pcall(setmetatable, {}, { __gc = print }))
assert(not pcall(collectgarbage, "stop") and not pcall(collectgarbage, "generational"))
assert(not pcall(string.format, "%p", {}))
assert(string.format("%s %5.2f %d %%", {}, 1.5, 3) == "{}  1.50 3 %")
assert(not tostring(print):find("0x") and not tostring({}):find("0x"))
assert(not pcall(function() return ("").x.y end))
)lua");
    // Methods with a wrong self.
    for (const char* call :
         {"world.add(3, Body {})", "world.delete('x')", "world.has()", "world.on({}, 'x', print)",
          "world.raycast(vec(1, 1), vec(0, 0), vec(1, 1))", "world.children(Body)",
          "vec(1, 2).length(3)", "vec(1, 2).length()", "world.add(Body, Body {})",
          "world.watch(Circle, 'radius', 3)", "world:add(world)", "world.clone(color('red'))",
          "(after(1, print)).stop(world)", "world:all().set({}, 'mass', 1)"}) {
        CAPTURE(call);
        s.fails(call);
    }
}

// Each attack fails with the reason beside it. If a defense is missing, the reason is another one.
TEST_CASE("an escape is refused with its reason") {
    const auto [attack, reason] = GENERATE(table<std::string, std::string>({
        {"local _ENV = { load = load } return load('return debug.getinfo')()", "no such name"},
        {"return load('return io', 'x', 't', setmetatable({}, { __index = _G }))()", "no such "},
        {"local e = setmetatable({}, { __index = function(_, k) return _G[k] end }) "
         "return load('return package', 'x', 't', e)()",
         "no such name"},
        {"assert(load(string.char(27) .. 'LuaT'))", "binary chunk"},
        {"assert(load((function() local n = 0 return function() n = n + 1 "
         "return n == 1 and '\\27Lua' or nil end end)()))",
         "binary chunk"},
        {"return ('').dump(print)", "a text has no dump"},
        {"getmetatable('').__index = {}", "index a string value"},
        {"getmetatable(vec(1, 1)).__add = print", "index a string value"},
        {"setmetatable('', {})", "needs a table, not a text"},
        {"setmetatable(_G, { __index = print })", "protected metatable"},
        {"setmetatable(world, {})", "needs a table"},
        {"rawset(world, 'gravity', 1)", "table expected, got instance"},
        {"rawget(vec(1, 2), 'x')", "table expected, got vec"},
        {"next(world)", "table expected, got instance"},
        {"table.concat({ world })", "invalid value"},
        {"coroutine.close(coroutine.running())", "cannot close a running coroutine"},
        {"coroutine.yield()", "from outside a coroutine"},
        {"os.exit()", "field 'exit'"},
        {"os.getenv('HOME')", "field 'getenv'"},
        {"os.rename('a', 'b')", "field 'rename'"},
        {"collectgarbage('setpause', 1)", "is not available"},
        {"setmetatable({}, { __gc = true })", "finalizers"},
        {"local m = {} setmetatable({}, m) m.__gc = print setmetatable({}, m)", "finalizers"},
        {"string.format('%q', world)", "no literal form"},
        {"return string.unpack('s4', '\\255\\255\\255\\127')", "data string too short"},
        {"utf8.char(1e10)", "out of range"},
        {"table.move({}, 1, math.maxinteger, 2)", "too many elements"},
        {"assert(load(('do '):rep(1e5)))", "overflow"},
        {"assert(load('return ' .. ('function() return '):rep(1e4)))", "overflow"},
        {"assert(load('local ' .. ('a,'):rep(300) .. 'a'))", "too many local variables"},
        {"local function f(n) return (('x'):gsub('x', function() return f(n + 1) end)) end f(1)",
         "overflow"},
        {"local function f(n) return coroutine.wrap(function() return f(n + 1) end)() end f(1)",
         ":1: C stack overflow"},
        {"local function f(n) return coroutine.wrap(function() return f(n + 1) end)() end "
         "return (('x'):gsub('x', function() return f(1) end))",
         ":1: C stack overflow"},
        {"game:delete()", "cannot be deleted"},
        {"world:delete()", "cannot be deleted"},
        {"game:add(game)", "has its place already"},
        {"local b = world:add(Body {}) b.parent = b", "below itself"},
        {"class('Body', Body) {}", "a class of the framework"},
        {"local b = world:add(Body {}) b:delete() return b.position", "was deleted"},
        {"local b = world:add(Body {}) local p = b.position b:delete() p.x = 1", "was deleted"},
        {"local b = world:add(Body {}) b:delete() b:delete()", "was deleted"},
        {"rewind(0/0)", "finite"},
        {"after(-1, print)", "not negative"},
        {"every(math.huge, print)", "finite"},
        {"every(1e-9, print)", "shorter than"},
        {"tween(world, 'nope', 1, 1)", "no property"},
        {"restore(1)", "what snapshot() returned"},
        {"quit('x')", "a status is a whole number from 0 to 255, not \"x\""},
        {"quit({})", "a status is a whole number from 0 to 255, not {}"},
    }));
    CAPTURE(attack);
    Stage s(small_budget());
    CHECK_THAT(s.fails(attack), contains(reason));
    CHECK(s.console("1 + 1") == "2");
}

TEST_CASE("errors of any type are reported") {
    Stage s;
    CHECK_THAT(s.fails("error({ code = 3 })"), contains("{code = 3}"));
    CHECK_THAT(s.fails("error(nil)"), contains("nil"));
    CHECK_THAT(s.fails("error(world)"), contains("world"));
    CHECK_THAT(
        s.fails("error(setmetatable({}, { __tostring = function() while true do end end }))"),
        contains("table"));
    CHECK_THAT(s.fails("error('plain', 0)"), contains("plain"));
    CHECK_THAT(s.fails("local t = setmetatable({}, { __name = ('x'):rep(1e6) }) return t + 1"),
               contains("arithmetic"));
    CHECK_THAT(s.fails("local function f() return f() + 1 end f()"), contains("stack overflow"));
    CHECK_THAT(s.fails("string.rep()"), contains("main.lua:1"));
    CHECK_THAT(s.fails("return #nil"), contains("main.lua:1"));
    CHECK_THAT(s.fails("this is not Lua"), contains("main.lua:1: syntax error"));
}

TEST_CASE("protected calls in scripts work as in Lua") {
    Stage s;
    s.run(R"lua(
local ok, e = pcall(error, "x"); assert(not ok and e == "x")
assert(select("#", pcall(function() return 1, nil, 3 end)) == 4)
local ok, e = xpcall(function(a, b) return a + b end, print, 1, 2); assert(ok and e == 3)
local ok, e = xpcall(function() error("y", 0) end, function(m) return m .. "!" end)
assert(not ok and e == "y!")
local co = coroutine.wrap(function()
    local ok, v = xpcall(function() return coroutine.yield(1) end, print)
    return ok, v
end)
assert(co() == 1)
local ok, v = co(5)
assert(ok and v == 5)
local ok, e = pcall(function() world.nope.x = 1 end)
assert(not ok and e:find("nope"))
)lua");
}

TEST_CASE("patterns match as in Lua") {
    Stage s;
    s.run(R"lua(
assert(("hello world"):find("wor") == 7)
assert(select(2, ("hello"):find("l+")) == 4)
assert(("key = value"):match("^(%w+)%s*=%s*(%w+)$") == "key")
assert(("x"):find("") == 1 and (""):find("") == 1 and ("abc"):find("b", -2) == 2)
assert(("a.b"):find(".", 1, true) == 2 and ("abc"):find("d") == nil)
assert(("2024-01-02"):gsub("(%d+)-(%d+)-(%d+)", "%3.%2.%1") == "02.01.2024")
assert(("hello"):gsub("", "-") == "-h-e-l-l-o-")
assert(("abc"):gsub("%w", "%0%0") == "aabbcc")
assert(select(2, ("abc abc"):gsub("abc", { abc = "x" })) == 2)
assert(("abc"):gsub("b", function() return nil end) == "abc")
assert(("THE (quick) fox"):find("%((%a+)%)") == 5)
assert(("f(a(b)c)d"):match("%b()") == "(a(b)c)")
assert(("THE (quick) fox"):gsub("%f[%a]%a+", "x") == "x (x) x")
assert(("aXb"):match("()X()") == 2)
assert(("[test]"):match("[%[%]]") == "[" and ("a-b"):match("[a%-]+") == "a-")
assert(("abcd"):match("[^a-c]") == "d" and ("]"):match("[]]") == "]")
assert(("aa"):match("(a)%1") == "a" and ("ab"):match("(a)%1") == nil)
assert(("  trim  "):match("^%s*(.-)%s*$") == "trim")
assert(("x=1,y=2"):gsub("(%w+)=(%w+)", "%2=%1") == "1=x,2=y")
local t = {} for k, v in ("a=1, b=2"):gmatch("(%w+)=(%w+)") do t[#t + 1] = k .. v end
assert(table.concat(t, " ") == "a1 b2")
local n = 0 for w in ("one two  three"):gmatch("%a+") do n = n + 1 end assert(n == 3)
local n = 0 for _ in ("abc"):gmatch("") do n = n + 1 end assert(n == 4)
assert(("abc"):gsub("^a", "x") == "xbc" and ("aaa"):gsub("^a", "x") == "xaa")
assert(("abc"):gsub("c$", "x") == "abx" and ("a$c"):find("$", 1, true) == 2)
assert(("a\0b"):find("\0") == 2 and ("a\0b"):match("%z?") ~= nil)
assert(("abc"):gsub("b", "%%") == "a%c")
for _, bad in ipairs { "[a", "(a", "a)", "%b", "%f", "(()", "%1" } do
    assert(not pcall(string.match, "aaaa", bad), bad)
end
assert(not pcall(string.find, "a", "%") and not pcall(string.match, "a", "a)"))
assert(not pcall(string.gsub, "a", "a", "%2"))
assert(not pcall(string.gsub, "a", "a", function() return {} end))
)lua");
}

}  // namespace sandbox_test
