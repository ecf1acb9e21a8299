// The files of a game by name.

#include <catch.h>

#include <fettle/property/error.h>
#include <fettle/property/storage/assets.h>
#include <fettle/property/storage/game_files.h>

#include "game_folder.h"

namespace assets_test {

using namespace fettle::property;
using scene_test::GameFolder;

namespace {

constexpr std::string_view pictures[] = {".png", ".jpg"};

}  // namespace

TEST_CASE("a file of the game is found before one that all games share") {
    const GameFolder game, shared;
    game.write("hero.png", "own");
    shared.write("hero.png", "shared");
    shared.write("enemy.png", "shared enemy");
    GameFiles files;
    const Assets assets(files, game.path(), shared.path());
    CHECK(assets.read("Sprite.image", "hero.png", pictures) == "own");
    CHECK(assets.read("Sprite.image", "enemy.png", pictures) == "shared enemy");
    CHECK(assets.find("Sprite.image", "hero.png", pictures) == game / "hero.png");
}

TEST_CASE("a missing file is an error with the nearest name of the same kind") {
    const GameFolder game;
    game.write("hero.PNG", "");
    game.write("hero.txt", "");
    GameFiles files;
    const Assets assets(files, game.path());
    CHECK_THROWS_WITH(assets.find("Sprite.image", "hreo.PNG", pictures),
                      "Sprite.image: there is no file \"hreo.PNG\" (did you mean \"hero.PNG\"?)");
    CHECK_THROWS_WITH(assets.find("Sprite.image", "nothing at all", pictures),
                      "Sprite.image: there is no file \"nothing at all\"");
    CHECK(assets.names(pictures) == std::vector<std::string>{"hero.PNG"});
}

TEST_CASE("a file name that leads out of the folder of the game is refused") {
    const GameFolder game;
    GameFiles files;
    const Assets assets(files, game.path());
    for (const std::string& name :
         {std::string(), std::string("/etc/passwd"), std::string("../main.lua"),
          std::string("a/../../b"), std::string("a\0b", 3)})
        CHECK_THROWS_AS(assets.path_of("scene.load", name), Error);
    CHECK_THROWS_WITH(assets.path_of("scene.load", "../x"),
                      "scene.load: \"../x\" is not a file below the game's folder");
    CHECK(assets.path_of("scene.save", "new/file.json") == game / "new/file.json");
}

}  // namespace assets_test
