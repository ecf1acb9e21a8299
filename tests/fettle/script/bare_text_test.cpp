// Texts without quotes in scripts that run with all classes of the program.

#include <catch.h>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace bare_text_test {

using namespace program_test;

TEST_CASE("each text that a property takes is suggested with its quotes") {
    // Some are names of something else, which is refused as another value.
    const Outcome listed = run_script(Folder(), R"(
        for _, class in ipairs(classes) do
            for _, property in ipairs(class.creatable and class.properties or {}) do
                for _, text in ipairs(property.owner == class and property.enumerators or {}) do
                    if text == "end" or text == "local" or not pcall(function() return _ENV[text] end) then
                        print(class.name .. " { " .. property.name .. " = " .. text .. " }")
                        print(property.name .. ' = "' .. text .. '"')
                    end
                end
            end
        end
    )",
                                      1);
    REQUIRE(listed.err.empty());
    std::vector<std::string> expected;
    std::istringstream lines(listed.out);
    const Folder folder;
    std::vector<std::string> run = {"run", folder.write("main.lua", ""), "--headless", "--steps",
                                    "2"};
    for (std::string code, text; std::getline(lines, code) && std::getline(lines, text);) {
        run.insert(run.end(), {"--console", "1:local o = " + code});
        expected.push_back(text);
    }
    CHECK(expected.size() > 60);
    const Outcome done = fettle(folder, run);
    for (const std::string& text : expected)
        CHECK(contains(done.out + done.err, "(a text needs quotes: did you mean " + text + "?)"));
}

TEST_CASE("a text that is a word of Lua is suggested with its quotes") {
    const Folder folder;
    const std::string game = folder.write("main.lua", "");
    const auto typed = [&](const std::string& command) {
        const Outcome done = fettle(
            folder, {"run", game, "--headless", "--steps", "2", "--console", "1:" + command});
        return done.out + done.err;
    };
    CHECK(contains(typed("x = Row { align = end }"), "did you mean align = \"end\"?"));
    CHECK(contains(typed("x = Emitter { space = local }"), "did you mean space = \"local\"?"));
    CHECK(contains(typed("x = Emitter { space = world }"), "did you mean space = \"world\"?"));
    folder.write("main.lua", "x = Row {\n  align = end\n}");
    CHECK(contains(typed("1"), "did you mean align = \"end\"?"));
}

}  // namespace bare_text_test
