// Pictures in tests of games, the templates of new games as they are drawn, and random numbers of
// runs in a window, on a virtual display.

#include <catch.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

#include "temporary_folder.h"

namespace test_pictures_test {

namespace fs = std::filesystem;

namespace {

constexpr const char* no_sound =
    "fettle: note: there is no sound device: the game plays on and is not heard\n";

struct Outcome {
    int status = -1;
    std::string out;
};

/// Runs `fettle ARGUMENTS` on a virtual display; `arguments` is a part of a shell command, `before`
/// a command that ends with a semicolon.
Outcome on_display(const TemporaryFolder& folder, const std::string& arguments,
                   const std::string& before = {}) {
    // The status of the program is written to a file, because xvfb-run itself fails now and then
    // when it removes its folder.
    const std::string command = "cd '" + folder.path.string() + "' && env XDG_DATA_HOME='" +
                                folder.path.string() +
                                "/data' LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a sh -c '" + before +
                                "\"$0\" \"$@\"; echo $? >status' '" + FETTLE_PROGRAM "' " +
                                arguments + " >out 2>&1 </dev/null";
    (void)std::system(command.c_str());
    std::ifstream in(folder.path / "out"), ended(folder.path / "status");
    Outcome outcome;
    ended >> outcome.status;
    outcome.out.assign(std::istreambuf_iterator<char>(in), {});
    return outcome;
}

bool skipped() {
    const bool there = std::system("command -v xvfb-run >/dev/null 2>&1") == 0;
    if (!there) std::cout << "SKIPPED: xvfb-run not found\n";
    return !there;
}

/// Share of the pixels of a BMP file that are pure green; 0 if there is no file.
double green_share(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(in), {});
    if (bytes.size() < 54) return 0;
    const auto byte = [&](std::size_t at) {
        return std::size_t{static_cast<unsigned char>(bytes[at])};
    };
    const std::size_t begin = byte(10) + 256 * byte(11), size = byte(28) / 8;
    std::size_t all = 0, green = 0;
    for (std::size_t at = begin; size > 0 && at + 2 < bytes.size(); at += size, ++all)
        green += byte(at) == 0 && byte(at + 1) == 255 && byte(at + 2) == 0;
    return all == 0 ? 0 : static_cast<double>(green) / static_cast<double>(all);
}

void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("a picture of a test is written and compared and differs when the game does") {
    if (skipped()) return;
    const TemporaryFolder folder;
    write(folder.path / "game/main.lua",
          "world.ball = Body { Circle { radius = 3 } } world.gravity = vec(0, 0)");
    write(folder.path / "game/tests/a.lua",
          "test('it', function(t) t:steps(2) t:screenshot('start') end)");
    const Outcome none = on_display(folder, "test game");
    INFO(none.out);
    CHECK(none.status == 1);
    CHECK(none.out.find("there is no picture game/tests/pictures/start.png yet") !=
          std::string::npos);
    CHECK(on_display(folder, "test game --update").status == 0);
    CHECK(fs::exists(folder.path / "game/tests/pictures/start.png"));
    CHECK(on_display(folder, "test game").status == 0);
    write(folder.path / "game/main.lua",
          "world.ball = Body { Circle { radius = 4 } } world.gravity = vec(0, 0)");
    const Outcome other = on_display(folder, "test game");
    INFO(other.out);
    CHECK(other.status == 1);
    CHECK(other.out.find("tests/a.lua:1: the picture game/tests/pictures/start.png differs in ") !=
          std::string::npos);
    CHECK(fs::exists(folder.path / "game/.fettle/tests/start.png"));
    write(folder.path / "game/tests/pictures/start.png", "no image");
    CHECK(on_display(folder, "test game").status == 1);
}

TEST_CASE("a game of every template is drawn without an error") {
    if (skipped()) return;
    const auto pattern = GENERATE(as<std::string>(), "empty", "physics", "platformer", "topdown");
    const TemporaryFolder folder;
    REQUIRE(on_display(folder, "new game --template " + pattern).status == 0);
    const Outcome run =
        on_display(folder,
                   "run game --steps 90 --screenshot game.png --at "
                   "'30:input.mouse.left = true' --at '60:input.mouse.left = false'");
    INFO(pattern << "\n" << run.out);
    CHECK(run.status == 0);
    CHECK((run.out.empty() || run.out == no_sound));  // not every machine has a sound device
    CHECK(fs::file_size(folder.path / "game.png") > 3000);
}

TEST_CASE("a replay of a failed test ends with what the game draws and with the error") {
    if (skipped()) return;
    const TemporaryFolder folder;
    write(folder.path / "game/main.lua",
          "view.background = color(0, 0, 0)\n"
          "function draw(pen) pen.box(vec(0, 0), 500, 500, color(0, 1, 0)) end");
    write(folder.path / "game/tests/a.lua",
          "test('it', function(t) t:steps(3) expect(1):is(2) end)\n");
    CHECK(on_display(folder, "test game").status == 1);
    const std::string replay = "run --replay game/.fettle/tests/a-it.recording --screenshot ";
    for (const std::string& how : {std::string(), std::string(" --headless")}) {
        fs::remove(folder.path / "end.bmp");
        const Outcome run = on_display(folder, replay + "end.bmp" + how);
        INFO(run.out);
        CHECK(run.status == 1);
        CHECK(green_share(folder.path / "end.bmp") > 0.6);  // the strip covers the rest
        CHECK(green_share(folder.path / "end.bmp") < 0.95);
    }
}

TEST_CASE("with a random seed runs in a window differ and a recording has the numbers of its run") {
    if (skipped()) return;
    const TemporaryFolder folder;
    ::setenv("ALSOFT_DRIVERS", "null", 1);
    write(folder.path / "game/main.lua", "print(random(1e9 // 1 | 0), random(1e9 // 1 | 0))");
    write(folder.path / "game/game.json", R"({"seed": "random"})");
    const Outcome first = on_display(folder, "run game --steps 2 --record game.recording");
    const Outcome second = on_display(folder, "run game --steps 2");
    const Outcome given = on_display(folder, "run game --steps 2 --seed 7");
    INFO(first.out << second.out << given.out);
    CHECK(first.status == 0);
    CHECK(first.out != second.out);
    CHECK(given.out == on_display(folder, "run game --headless --steps 2 --seed 7").out);
    const Outcome again = on_display(folder, "run --headless --replay game.recording");
    CHECK(again.out == first.out + "2 steps, each as it was recorded\n");
}

TEST_CASE("a picture for which the disk has no room is reported and the earlier one stays") {
    if (skipped()) return;
    const TemporaryFolder folder;
    write(folder.path / "main.lua", "world.ball = Body { Circle { radius = 3 } }");
    const std::string ending = GENERATE(".png", ".jpg", ".bmp", ".tga");
    const fs::path picture = folder.path / ("a" + ending);
    const std::string command = "run main.lua --headless --steps 1 --screenshot a" + ending;
    CHECK(on_display(folder, command).status == 0);
    const auto size = fs::file_size(picture);
    CHECK(size > 1024);
    const Outcome full = on_display(folder, command, "ulimit -f 2; ");  // KiB
    INFO(full.out);
    CHECK(full.status == 3);
    CHECK(full.out.find("a" + ending + ": could not be written: ") != std::string::npos);
    CHECK(fs::file_size(picture) == size);
    std::size_t files = 0;
    for (const auto& each : fs::directory_iterator(folder.path))
        files += each.path().filename().string().starts_with("a") ||
                 each.path().filename().string().find("tmp") != std::string::npos;
    CHECK(files == 1);
}

}  // namespace test_pictures_test
