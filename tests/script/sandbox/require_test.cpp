// Modules that fail, in every place of a file, and modules that require each other.

#include <fstream>

#include "stage.h"
#include "temporary_folder.h"

namespace require_test {

using stage::Stage;
using stage::starts_with;

namespace {

struct Folder : TemporaryFolder {
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name) << text;
    }
};

}  // namespace

TEST_CASE("an error in a module is reported unchanged and the module can be loaded again") {
    const auto [text, message] = GENERATE(table<std::string, std::string>({
        {"error('broken')", "broken"},
        {"error('broken', 2)", "broken"},
        {"error({})", "{}"},
        {"error()", "nil"},
        {"local a = nil; a.b = 1", "attempt to index a nil value (local 'a')"},
        {"local a, b = 1, 2; a.b.c = 1", "attempt to index a number value (local 'a')"},
        {"local t, u = {}, {}; error('broken')", "broken"},
        {"undefined_name()", "undefined_name: no such name"},
        {"local t = {}; t[nil] = 1", "index is nil"},
        {"world.mass = Body", "a class is not a value"},
        {"(function() local t, u = {}, {}; (function() error('deep') end)() end)()", "deep"},
        {"coroutine.wrap(function() error('inside') end)()", "inside"},
        {"x = = 1", "unexpected symbol"},
        {"wait(1)", "wait"},
        {"require('other')", "other.lua:1: of the other"},
    }));
    CAPTURE(text);
    const Folder folder;
    folder.write("part.lua", text);
    folder.write("other.lua", "error('of the other')");
    folder.write("main.lua", "function try() return require('part') end");
    Stage s;
    REQUIRE(s.runtime->load(folder.path));
    for (int i = 0; i < 3; ++i) {
        CHECK_THAT(s.fails("try()"), contains(message));
        CHECK(s.console("pcall(try)").find("false") == 0);
    }
    folder.write("part.lua", "return 7");
    CHECK(s.console("try() + try()") == "14");
    CHECK(s.console("#{}") == "0");
}

TEST_CASE("a module that is required with the ending of its file is named without it") {
    const Folder folder;
    folder.write("enemy.lua", "return 1");
    folder.write("main.lua", "");
    Stage s;
    REQUIRE(s.runtime->load(folder.path));
    CHECK_THAT(s.fails("require('enemy.lua')"),
               contains("the name of a module has no ending: write require(\"enemy\")"));
    CHECK_THAT(s.fails("require('enmy.lua')"), contains("no module"));
}

TEST_CASE("modules that require each other are refused by name and can be required afterwards") {
    const Folder folder;
    folder.write("a.lua", "return require('b')");
    folder.write("b.lua", "tried = pcall(require, 'a') return require('a')");
    folder.write("c.lua", "return require('c')");
    folder.write("main.lua", "");
    Stage s;
    REQUIRE(s.runtime->load(folder.path));
    CHECK_THAT(s.fails("require('a')"),
               contains("require: \"a\" is being loaded already; two modules require each other"));
    CHECK(s.console("tried") == "false");
    CHECK_THAT(s.fails("require('c')"),
               contains("require: \"c\" is being loaded already; it requires itself"));
    folder.write("b.lua", "return 3");
    CHECK(s.console("require('a')") == "3");
}

}  // namespace require_test
