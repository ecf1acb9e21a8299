// Settings of the player over several runs, in saved games and in replays.

#include <catch.h>

#include "program.h"

namespace preference_run_test {

using namespace program_test;

namespace {

const char* const game = R"(
    input.actions.jump = { "space" }
    audio.volume = 0.9
    state("score", 0)
    game.slider = Slider { bind = "audio.volume" }
)";

const char* const shown = "print(audio.volume, input.actions.jump[1], score)";

Outcome run_game(const Folder& folder, const std::vector<std::string>& more) {
    Outcome outcome = run_script(folder, game, 20, more);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 0);
    return outcome;
}

}  // namespace

TEST_CASE("the next run begins with the settings of the player") {
    const Folder folder;
    CHECK(run_game(folder, {"--at", std::string("5:") + shown}).out == "0.9\tspace\t0\n");
    run_game(folder, {"--at", "5:slider.value = 0.25", "--at",
                      "6:interface:prefer('input.actions.jump', { 'j', { 'a', 'd', 's', 'w' } })"});
    CHECK(run_game(folder, {"--at", std::string("5:") + shown + " print(#input.actions.jump[2])"})
              .out == "0.25\tj\t0\n4\n");
    run_game(folder, {"--at", "5:interface:prefer('audio.volume')"});
    CHECK(run_game(folder, {"--at", std::string("5:") + shown}).out == "0.9\tj\t0\n");
}

TEST_CASE("a saved game does not change settings that were made later") {
    const Folder folder;
    run_game(folder, {"--at", "3:slider.value = 0.5", "--at", "5:score = 3 save_game('a')"});
    run_game(folder, {"--at", "3:slider.value = 0.25"});
    CHECK(run_game(folder, {"--at", "3:load_game('a')", "--at", std::string("7:") + shown}).out ==
          "0.25\tspace\t3\n");
}

TEST_CASE("a replay has the settings that the recorded run began with") {
    const Folder folder;
    const std::string file = (folder / "run.rec").string();
    run_game(folder, {"--at", "3:slider.value = 0.5"});
    const Outcome made =
        run_game(folder, {"--record", file, "--at", std::string("2:") + shown, "--at",
                          "9:slider.value = 0.75", "--at", "12:rewind(0.1)"});
    run_game(folder, {"--at", "3:slider.value = 0.25"});
    const Outcome again = fettle(folder, {"run", "--headless", "--replay", file});
    INFO(again.out << again.err);
    CHECK(again.status == 0);
    CHECK(contains(again.out, "0.5\tspace\t0\n"));
    CHECK(run_game(folder, {"--at", std::string("2:") + shown}).out == "0.25\tspace\t0\n");
}

}  // namespace preference_run_test
