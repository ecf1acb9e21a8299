// Calls every function and method that a script can reach with more arguments than it has. Extra
// arguments must be ignored.

#include <catch.h>

#include <sstream>

#include "patterns.h"
#include "program.h"

namespace extra_arguments_test {

using namespace program_test;

TEST_CASE("extra arguments do no harm and are not changed") {
    const Folder folder;
    // Methods with their classes, read from the reference.
    REQUIRE(fettle(folder, {"docs", (folder / "reference").string()}).status == 0);
    std::istringstream reference(folder.text("reference/fettle.lua"));
    std::string methods = "local methods = {";
    for (std::string line; std::getline(reference, line);)
        for (const auto& match : patterns::all(line, R"(^function fettle_(\w+):(\w+)\()"))
            methods += match[2] + " = \"" + match[1] + "\", ";
    folder.write("main.lua", methods + "}" + R"(
local left_out = { start = true, quit = true, print = true, load_game = true, wait = true, require = true }
local function fresh() return { a = 1, b = 2, 3 } end
local function same(t)
    local count = 0
    for k in next, t do count = count + 1 end
    return count == 3 and t.a == 1 and t.b == 2 and t[1] == 3
end
local called = 0
local firsts = { nil, 1, "text", vec(1, 2), fresh(), function() end, world }
local function try(name, f, self)
    for kind = 1, 7 do
        local extra = { fresh(), fresh(), fresh(), fresh(), fresh(), fresh() }
        if self ~= nil then
            pcall(f, self, firsts[kind], table.unpack(extra))
            pcall(f, self, firsts[kind], 1, "text", world, 2.5, vec(1, 2), false)
        else
            pcall(f, firsts[kind], table.unpack(extra))
            pcall(f, firsts[kind], 1, "text", world, 2.5, vec(1, 2), false)
        end
        called = called + 1
        for i = 1, #extra do
            if not same(extra[i]) then print("written into: " .. name .. " " .. i + 1) end
        end
    end
end
function start()
    local functions = {}  -- all of them before one of them changes anything
    for name, value in next, _G do
        if type(value) == "function" and not left_out[name] then
            functions[name] = value
        elseif type(value) == "table" and value ~= _G then
            for member, of_library in next, value do
                if type(of_library) == "function" then
                    functions[name .. "." .. member] = of_library
                end
            end
        end
    end
    for name, value in next, functions do try(name, value) end
    for name, class in next, methods do
        local made, instance = pcall(function() return _G[class] {} end)
        if not made then instance = world end
        local ok, method = pcall(function() return instance[name] end)
        if ok and method then try(name, method, instance) end
    end
    print("called " .. tostring(called > 500))
end
)");
    const Outcome outcome =
        fettle(folder, {"run", (folder / "main.lua").string(), "--headless", "--steps", "2"});
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK_FALSE(contains(outcome.out, "written into"));
    CHECK(contains(outcome.out, "called true\n"));
}

}  // namespace extra_arguments_test
