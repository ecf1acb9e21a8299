// Several programs run one game at the same time: no kept tweak of any of them is lost.

#include <catch.h>

#include "program.h"

namespace several_programs_test {

using namespace program_test;

TEST_CASE("tweaks that programs keep at the same time are all kept") {
    const Folder folder;
    folder.write("main.lua", R"(
        game.o = Object {}
        scene.load("level.json", game.o)
        function keep_as(i)
            edit("own", function()
                game.o["p" .. i] = i
                game.o.level["q" .. i] = i
            end)
            keep("game.o.p" .. i)
            keep("game.o.level.q" .. i)
            quit()
        end)");
    folder.write("level.json",
                 "{\n  \"fettle_scene\": 1,\n  \"class\": \"Object\",\n  \"name\": \"level\"\n}\n");
    constexpr int programs = 40;
    std::string command;
    for (int i = 1; i <= programs; ++i) {
        command += "env -u DISPLAY timeout 60 " + quoted(FETTLE_PROGRAM) + " run " +
                   quoted((folder / "main.lua").string()) + " --headless --steps 2 --eval " +
                   quoted("keep_as(" + std::to_string(i) + ")") + " >>" +
                   quoted((folder / "out").string()) + " 2>&1 </dev/null & ";
        if (i % 4 == 0) command += "wait; ";  // number of programs that run at the same time
    }
    CHECK(std::system((command + "wait").c_str()) == 0);
    const std::string kept = folder.text("main.tweaks.json"), level = folder.text("level.json");
    INFO(folder.text("out") << kept << level);
    for (int i = 1; i <= programs; ++i) {
        const std::string number = std::to_string(i);
        CHECK(contains(kept, "\"o.p" + number + "\": " + number));
        CHECK(contains(level, "\"q" + number + "\": " + number));
    }
    const Outcome next = fettle(folder, {"run", (folder / "main.lua").string(), "--headless",
                                         "--steps", "1", "--eval", "tweaks() quit()"});
    CHECK(next.out == "nothing was tweaked\n");
    CHECK(next.err.empty());
}

}  // namespace several_programs_test
