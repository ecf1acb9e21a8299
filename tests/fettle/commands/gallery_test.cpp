// `fettle run` without a path: the gallery.

#include <catch.h>

#include "program.h"

namespace gallery_test {

using namespace program_test;

namespace {

Outcome run_gallery(const Folder& folder, const std::string& chunk) {
    return fettle(folder, {"run", "--headless", "--steps", "3", "--eval", chunk});
}

}  // namespace

TEST_CASE("the gallery lists the games beside it") {
    const Folder folder;
    const Outcome run = run_gallery(
        folder, "for _, g in ipairs(gallery_games()) do print(g[1], g[2], #g[3] > 10) end");
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "car\tCar\ttrue\n"));
    CHECK(contains(run.out, "showcase\tShowcase\ttrue\n"));
    CHECK_FALSE(contains(run.out, "gallery"));
}

TEST_CASE("complete games come first in the gallery") {
    const Folder folder;
    const Outcome run =
        run_gallery(folder, "for _, g in ipairs(gallery_games()) do print(g[1]) end");
    CHECK(run.out.starts_with("amber\nlantern\nrusset\ncar\n"));
}

TEST_CASE("a gamepad chooses a game in the gallery and opens it") {
    const Folder folder;
    const Outcome run = fettle(
        folder,
        {"run", "--headless", "--steps", "20", "--at", "3:input.gamepad_1.left = vec(1, 0)", "--at",
         "5:input.gamepad_1.left = vec(0, 0)", "--at", "7:input.gamepad_1.dpad_right = true",
         "--at", "9:input.gamepad_1.dpad_right = false", "--at", "11:print(gallery.chosen)", "--at",
         "13:input.gamepad_1.a = true"});
    INFO(run.out << run.err);
    CHECK(contains(run.out, "3\n"));
    CHECK(contains(run.err, "a run without a window stays in the gallery"));
}

TEST_CASE("the gallery opens a game of its list and nothing else") {
    const Folder folder;
    const Outcome game = run_gallery(folder, "open_game('car')");
    CHECK(game.status == 0);
    CHECK(contains(game.err, "a run without a window stays in the gallery"));
    const Outcome wrong = run_gallery(folder, "open_game('caar')");
    CHECK(wrong.status == 1);
    CHECK(contains(wrong.err,
                   "open_game: there is no game \"caar\" in the gallery (did you mean \"car\"?)"));
    CHECK(run_gallery(folder, "open_game('../scripts/car')").status == 1);
    CHECK(run_gallery(folder, "open_game()").status == 1);
    CHECK(run_gallery(folder, "gallery_show('car')").status == 1);
}

TEST_CASE("after a game the gallery has this game selected") {
    const Folder folder;
    CHECK(contains(run_gallery(folder, "print(gallery.chosen)").out, "1\n"));
    const std::string right = "input.keys.right = true";
    CHECK(fettle(folder, {"run", "--headless", "--steps", "9", "--at", "2:" + right, "--at",
                          "4:input.keys.enter = true"})
              .status == 0);
    CHECK(contains(run_gallery(folder, "print(gallery.chosen)").out, "2\n"));
}

TEST_CASE("the program without arguments opens the gallery and reports a missing display") {
    const Folder folder;
    const Outcome run = fettle(folder, {});
    CHECK(run.status == 2);
    CHECK(contains(run.err, "there is no display for a window"));
    CHECK(contains(run.err, "fettle --help"));
}

TEST_CASE("no other game has the functions of the gallery") {
    const Folder folder;
    const Outcome run =
        fettle(folder, {"run", folder.write("main.lua", "print(rawget(_G, 'open_game'))"),
                        "--headless", "--steps", "1"});
    CHECK(run.out == "nil\n");
}

TEST_CASE("a run of the gallery is not recorded") {
    const Folder folder;
    const Outcome run = fettle(
        folder, {"run", "--headless", "--steps", "1", "--record", (folder / "a.rec").string()});
    CHECK(run.status == 2);
    CHECK(contains(run.err, "--record needs the path of a game"));
}

}  // namespace gallery_test
