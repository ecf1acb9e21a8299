// `fettle where` prints where the files about a game are.

#include <catch.h>

#include "program.h"

namespace where_test {

using namespace program_test;

TEST_CASE("where names the places in which a run writes") {
    const Folder folder;
    const std::string game = (folder / "game").string();
    folder.write("game/main.lua", "");
    folder.write("game/game.json", R"({"id": "org.example.where"})");
    const std::string player = (folder / "user data/fettle/games/org.example.where").string();
    const Outcome before = fettle(folder, {"where", game});
    INFO(before.out << before.err);
    CHECK(before.status == 0);
    CHECK(before.out == "store        " + player + "/store.json  (not made yet)\nsaves        " +
                            player + "/saves  (not made yet)\nsettings     " + player +
                            "/settings.json  (not made yet)\npreferences  " + player +
                            "/preferences.json  (not made yet)\ntweaks       " + game +
                            "/.fettle/main.tweaks.sqlite  (not made yet)\n");
    REQUIRE(fettle(folder, {"run", game, "--headless", "--steps", "4", "--eval",
                            "store.a = 1 save_game('a') edit('x', function() world.gravity = "
                            "vec(0, 1) end)"})
                .status == 0);
    const Outcome after = fettle(folder, {"where", game});
    CHECK(contains(after.out, player + "/store.json\n"));
    CHECK(contains(after.out, player + "/saves\n"));
    CHECK(contains(after.out, game + "/.fettle/main.tweaks.sqlite\n"));
}

TEST_CASE("where needs a game") {
    const Folder folder;
    CHECK(fettle(folder, {"where"}).status == 2);
    const Outcome none = fettle(folder, {"where", (folder / "none").string()});
    CHECK(none.status == 3);
    CHECK(contains(none.err, "there is no such file or folder"));
}

}  // namespace where_test
