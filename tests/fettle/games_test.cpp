// The tests of the games that come with Fettle: `fettle test` for each folder in scripts/ that has
// some.

#include <algorithm>

#include <catch.h>

#include "program.h"

namespace games_test {

using namespace program_test;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> games_with_tests() {
    std::vector<fs::path> games;
    for (const fs::directory_entry& entry : fs::directory_iterator("scripts"))
        if (fs::is_directory(entry.path() / "tests")) games.push_back(entry.path());
    std::ranges::sort(games);
    return games;
}

}  // namespace

TEST_CASE("the games that come with Fettle pass their own tests") {
    const std::vector<fs::path> games = games_with_tests();
    REQUIRE_FALSE(games.empty());
    for (const fs::path& game : games) {
        const Folder folder;
        const Outcome run = fettle(folder, {"test", game.string(), "--timeout", "1000"});
        INFO(game << '\n' << run.out << run.err);
        CHECK(run.status == 0);
        CHECK(contains(run.out, " 0 failed"));
    }
}

}  // namespace games_test
