// `fettle run --record` and `--replay` as commands.

#include <catch.h>

#include <fstream>
#include <iterator>

#include "program.h"

using namespace program_test;
namespace fs = std::filesystem;

namespace {

constexpr const char* game = R"(
    for i = 1, 12 do world:add(Body { position = vec(i, 2 + i), Box {} }) end
    world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
    every(0.1, function() world.body_3:apply_impulse(vec(random(), 1)) end)
    function step() if time.step == 20 then world:add(Body { Circle {} }) end end
)";

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a recorded run is replayed step by step") {
    const Folder folder;
    const std::string path = folder.write("main.lua", game);
    const std::string file = (folder / "run.rec").string();
    const Outcome made =
        fettle(folder, {"run", path, "--headless", "--steps", "60", "--seed", "7", "--hash", "--at",
                        "30:world.body_5.mass = 9", "--record", file});
    REQUIRE(made.status == 0);
    const Outcome again = fettle(folder, {"run", "--headless", "--hash", "--replay", file});
    CHECK(again.err.empty());
    CHECK(again.status == 0);
    CHECK(again.out == "60 steps, each as it was recorded\n" + made.out);
}

TEST_CASE("a replay that differs ends with 1 and names the step") {
    const Folder folder;
    const std::string path = folder.write("main.lua", game);
    const fs::path file = folder / "run.rec";
    fettle(folder, {"run", path, "--headless", "--steps", "40", "--record", file.string()});
    std::string text = read(file);
    const std::size_t at = text.find("physics ", text.find("\nstep 17 ")) + 8;
    text[at] = text[at] == '0' ? '1' : '0';
    std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
    const Outcome run = fettle(folder, {"run", "--headless", "--replay", file.string()});
    CHECK(run.status == 1);
    CHECK(run.err.find("step 17: physics differs") != std::string::npos);
}

TEST_CASE("recordings of another game and damaged ones end with 3") {
    const Folder folder;
    const std::string path = folder.write("main.lua", game);
    const fs::path file = folder / "run.rec";
    fettle(folder, {"run", path, "--headless", "--steps", "5", "--record", file.string()});
    const std::string good = read(file);
    folder.write("main.lua", std::string(game) + " -- changed");
    const Outcome other = fettle(folder, {"run", "--headless", "--replay", file.string()});
    CHECK(other.status == 3);
    CHECK(other.err.find("another version") != std::string::npos);
    folder.write("main.lua", game);
    for (const std::string& bad :
         {std::string("fettle-recording 9\n"), good.substr(0, 40), good + "rubbish\n"}) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bad;
        const Outcome run = fettle(folder, {"run", "--headless", "--replay", file.string()});
        CHECK(run.status == 3);
        CHECK(run.err.find("run.rec") != std::string::npos);
    }
    CHECK(fettle(folder, {"run", "--headless", "--replay", "missing.rec"}).status == 3);
    CHECK(fettle(folder,
                 {"run", path, "--headless", "--steps", "1", "--record", "/nowhere/there.rec"})
              .status == 3);
}
