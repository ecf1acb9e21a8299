// Hosts in C++ that use objects of another or a destroyed tree.

#include <fettle/property/storage/game_saves.h>
#include <fettle/property/storage/tweaks.h>

#include <memory>

#include "catch.h"
#include "game_folder.h"
#include "scene_world.h"

namespace hosts_test {

using namespace scene_test;

TEST_CASE("tweaks that outlive their tree refuse calls and end without harm") {
    const GameFolder folder;
    auto game = std::make_unique<SceneWorld>();
    Tweaks tweaks(game->tree, folder / "main.lua", [](const std::string&) {});
    const Tree other;
    CHECK(tweaks.are_of(game->tree));
    CHECK_FALSE(tweaks.are_of(other));
    const Handle world = game->world;
    game = nullptr;
    const auto message = [](const auto& act) -> std::string {
        try {
            act();
        } catch (const Error& error) {
            CHECK(error.kind() == ErrorKind::deleted);
            return error.what();
        }
        return "no error";
    };
    const std::string ended = "the tree of these tweaks was destroyed";
    CHECK(message([&] { (void)tweaks.keep("**"); }) == ended);
    CHECK(message([&] { (void)tweaks.reapply("**"); }) == ended);
    CHECK(message([&] { (void)tweaks.drop("**"); }) == ended);
    CHECK(message([&] { tweaks.scene_loaded("a.json", {}); }) == ended);
    CHECK(message([&] { tweaks.placed(world); }) == ended);
    CHECK(message([&] { tweaks.game_loaded(); }) == ended);
    CHECK(tweaks.list().empty());
    CHECK(tweaks.open_earlier() == 0);
    tweaks.barrier();
}

TEST_CASE(
    "a scene that cannot be loaded is reported with the reason even if a module throws in the "
    "cleanup") {
    const GameFolder folder;
    SceneWorld game;
    ClassDescriptor angry;
    angry.name = "Angry";
    angry.lifecycle.destroy = [](void*, Tree&, Handle, Row) {
        throw std::runtime_error("not now");
    };
    game.tree.define(angry);
    folder.write("scene.json",
                 "{\"fettle_scene\": 1, \"class\": \"Angry\", \"name\": \"a\", \"ad_hoc\": {\n"
                 "  \"x\": {\"reference\": \".missing\"}}}");
    std::string message;
    try {
        (void)load_scene(game.tree, folder / "scene.json", game.world);
    } catch (const Error& error) {
        message = error.what();
    }
    CHECK(message.find("missing") != std::string::npos);
    CHECK_FALSE(game.tree.child(game.world, "a"));
}

}  // namespace hosts_test
