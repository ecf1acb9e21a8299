// Interrupted scripts of a run that must end: they stop at any place, until they may run again.

#include "stage.h"

namespace interrupt_test {

using stage::Stage;

TEST_CASE("an interrupted script stops at any place and the next ones do too") {
    const std::string loop = GENERATE(
        as<std::string>{}, "while true do end", "while true do pcall(error) end",
        "while true do pcall(function() while true do end end) end",
        "xpcall(function() while true do end end, function() while true do end end)",
        "local f = coroutine.wrap(function() while true do coroutine.yield() end end) while true "
        "do "
        "f() end",
        "while true do coroutine.resume(coroutine.create(function() while true do end end)) end",
        "(('a'):rep(30000)):match('.-.-.-.-b')",
        "for i = 1, 1e12 do world.gravity = vec(0, i) end");
    Stage s;
    // As a signal handler does while the script runs.
    s.runtime->on_print([&](std::string_view) { s.runtime->interrupt(); });
    CHECK_FALSE(s.runtime->run("print('go') " + loop, "chunk"));
    REQUIRE(s.errors.size() == 1);
    INFO(s.errors[0].message);
    CHECK(s.errors[0].message.find("chunk:1: stopped: it was interrupted") != std::string::npos);
    CHECK(s.runtime->interrupted());

    s.runtime->go_on();
    CHECK_FALSE(s.runtime->interrupted());
    s.errors.clear();
    s.run("n = 0 for i = 1, 1000 do n = n + i end assert(n == 500500)");
    s.run(
        "local co = coroutine.wrap(function() for i = 1, 9 do coroutine.yield(i) end end) "
        "assert(co() == 1 and co() == 2)");
    CHECK(s.console("n") == "500500");
}

TEST_CASE("a script that starts after an interruption is stopped at its start") {
    Stage s;
    s.run("function update() end");
    s.runtime->interrupt();
    CHECK_FALSE(s.runtime->run("for i = 1, 10 do end", "chunk"));
    CHECK_FALSE(s.runtime->call("update", {}));
    s.runtime->go_on();
    s.errors.clear();
    s.run("x = 1");
}

TEST_CASE("out of memory is reported with its place and the limit") {
    fettle::script::Options options;
    options.memory_limit = std::size_t{16} << 20;
    Stage s(options);
    const std::string chunk = GENERATE(
        as<std::string>{}, "local t = {}\nfor i = 1, 1e9 do t[i] = i end",
        "local t = {}\nfor i = 1, 1e9 do t[i] = 'x' .. i end", "local a\nlocal s = ('x'):rep(1e8)",
        "local s = ('x'):rep(1e6)\nfor i = 1, 10 do s = s .. s end",
        "local s = ('x'):rep(1e6)\ns = s:gsub('x', ('y'):rep(100))",
        "local t = {}\nfor i = 1, 1e6 do t[i] = ('x'):rep(100) end t = table.concat(t)",
        "local s = ('x'):rep(7e6)\nlocal t = table.pack(table.unpack({}, 1, 5e5))",
        "local f\nf = coroutine.wrap(function() local t = {} for i = 1, 1e9 do t[i] = i end end) "
        "f()");
    CHECK_FALSE(s.runtime->run(chunk, "chunk"));
    REQUIRE(s.errors.size() == 1);
    INFO(chunk << "\n" << s.errors[0].message);
    CHECK(s.errors[0].message.find("chunk:2: not enough memory: ") == 0);
    CHECK(s.errors[0].message.find("the scripts of a game may use 16 MB") != std::string::npos);
    CHECK(s.errors[0].line == 2);
    s.errors.clear();
    s.run("assert(1 + 1 == 2)");
    // A script that catches the error gets the same text.
    s.run("ok, message = pcall(function() " + chunk + "\nend)");
    CHECK(s.prints("print(ok, message:sub(1, 31))") == "false\tmain.lua:2: not enough memory: ");
    s.run("ok, message = xpcall(function() " + chunk + "\nend, function(e) return e end)");
    CHECK(s.prints("print(ok, message:sub(1, 31))") == "false\tmain.lua:2: not enough memory: ");
}

TEST_CASE("a stack that grows beyond the limit of memory is reported with its place") {
    fettle::script::Options options;
    options.memory_limit = std::size_t{16} << 20;
    Stage s(options);
    s.run(
        "local s = ('x'):rep(7e6)\n"
        "local function f(n) return f(n + 1) + 1 end\n"
        "ok, message = pcall(f, 1)");
    CHECK(s.prints("print(ok, message:sub(1, 31))") == "false\tmain.lua:2: not enough memory: ");
}

}  // namespace interrupt_test
