// Saving a tree into slots and loading it.

#include <fettle/property/storage/game_saves.h>

#include <memory>

#include "catch.h"
#include "file_faults.h"
#include "game_folder.h"
#include "scene_world.h"

namespace game_saves_test {

using namespace scene_test;
namespace fs = std::filesystem;

namespace {

struct Game : SceneWorld {
    explicit Game(const GameFolder& folder, bool pictures = false)
        : saves(std::make_unique<GameSaves>(
              tree, Saves(folder.user() / "saves", "ball game", "0.1.0"),
              GameSaves::Options{.pictures = pictures, .warn = [this](const std::string& text) {
                                     reported.push_back(text);
                                 }})) {}
    std::vector<std::string> reported;
    std::unique_ptr<GameSaves> saves;
};

}  // namespace

TEST_CASE("a saved tree is restored in another run and in the same one") {
    const GameFolder folder;
    Game game(folder);
    const Handle a = game.add("Thing", "a");
    game.tree.set(a, "number", -0.0);
    game.tree.set_or_add(a, "lives", 3);
    game.saves->save("one");
    CHECK(game.saves->slots().list().empty());
    game.tree.barrier();
    CHECK(game.saves->slots().list().size() == 1);
    const std::string then = game.everything();
    game.tree.set(a, "number", 7.0);
    game.tree.destroy(a);
    game.add("Note", "later");
    game.saves->load("one");
    game.tree.barrier();
    CHECK(game.reported.empty());
    CHECK(game.everything() == then);
    CHECK(game.tree.alive(a));

    Game other(folder);
    other.saves->load("one");
    other.tree.barrier();
    CHECK(other.reported.empty());
    CHECK(other.everything() == then);
}

TEST_CASE(
    "a slot that is saved twice before the barrier is saved once with the options of the last "
    "call") {
    const GameFolder folder;
    Game game(folder);
    const Handle a = game.add("Thing", "a");
    game.tree.set(a, "number", 1.0);
    game.saves->save("old");
    game.tree.barrier();
    game.tree.set(a, "number", 2.0);
    // Another game is loaded between the two saves, so the second one contains that.
    game.saves->save("one");
    game.saves->save("two");
    game.saves->load("old");
    game.saves->save("one");
    game.tree.barrier();
    CHECK(game.reported.empty());
    const auto number = [&](const std::string& slot) {
        Game other(folder);
        other.saves->load(slot);
        other.tree.barrier();
        return other.tree.get(a, "number").number();
    };
    CHECK(number("one") == 1.0);
    CHECK(number("two") == 2.0);
    CHECK(game.saves->slots().list().size() == 3);
}

TEST_CASE("an endless loop of saves ends in an error and the queue is limited") {
    const GameFolder folder;
    Game game(folder);
    game.add("Thing", "a");
    std::size_t requests = 0;
    std::string refused;
    try {
        for (;; ++requests) game.saves->save("x");
    } catch (const Error& error) {
        refused = error.what();
    }
    CHECK(requests == GameSaves::max_requests);
    CHECK(refused.find("more than 1000 times at one barrier") != std::string::npos);
    game.tree.barrier();
    CHECK(game.reported.empty());
    CHECK(game.saves->slots().list().size() == 1);
    for (int i = 0; i < 5; ++i) game.saves->save("slot " + std::to_string(i % 3));
    game.tree.barrier();
    CHECK(game.saves->slots().list().size() == 4);
}

TEST_CASE("one save per slot waits for its picture") {
    const GameFolder folder;
    Game game(folder, true);
    const Handle a = game.add("Thing", "a");
    for (const double value : {1.0, 2.0, 3.0}) {
        game.tree.set(a, "number", value);
        game.saves->save("one");
        game.tree.barrier();
    }
    CHECK(game.saves->waits());
    game.saves->finish({});
    CHECK_FALSE(game.saves->waits());
    Game other(folder);
    other.saves->load("one");
    other.tree.barrier();
    CHECK(other.tree.get(a, "number") == Value(3.0));
}

TEST_CASE("a refused load leaves the running game unchanged") {
    const GameFolder folder;
    Game game(folder);
    game.add("Thing", "a");
    const std::string then = game.everything();
    CHECK_THROWS_AS(game.saves->load("none"), Error);
    game.saves->slots().save("no state", 1, std::vector<std::byte>(100));
    CHECK_THROWS_AS(game.saves->load("no state"), Error);
    CHECK_THROWS_AS(game.saves->save("a/b"), Error);
    game.tree.barrier();
    CHECK(game.everything() == then);
    CHECK(game.reported.empty());
}

TEST_CASE("a save waits for its picture if there is a window and is made without one at the end") {
    const GameFolder folder;
    {
        Game game(folder, true);
        game.saves->save("one");
        game.tree.barrier();
        CHECK(game.saves->waits());
        CHECK(game.saves->slots().list().empty());
        game.saves->finish({1, 1, {1, 2, 3, 4}});
        CHECK_FALSE(game.saves->waits());
        CHECK(game.saves->slots().load("one").thumbnail.pixels ==
              std::vector<std::uint8_t>{1, 2, 3, 4});
        game.saves->save("two");
        game.tree.barrier();
    }
    CHECK(Game(folder).saves->slots().load("two").thumbnail.empty());
}

namespace {

/// A part of snapshots that cannot read its own data.
struct Forgetful : SnapshotPart {
    std::string_view part_name() const override { return "forgetful"; }
    Memory save(ByteWriter& to) const override {
        to.put(std::uint64_t{1});
        return {};
    }
    std::function<void()> restore(ByteReader& from, const Memory&) override {
        from.require(!refuses, "it was forgotten");
        from.get<std::uint64_t>();
        return [] {};
    }
    bool refuses = true;
};

}  // namespace

TEST_CASE("a save that could not be loaded is reported and does not replace a valid one") {
    const GameFolder folder;
    Game game(folder);
    Forgetful part;
    part.refuses = false;
    game.tree.add_part(part);
    game.saves->save("one");
    game.tree.barrier();
    REQUIRE(game.saves->list().front().problem.empty());
    const auto before = game.saves->slots().load("one").state;
    part.refuses = true;
    game.add("Thing", "a");
    game.saves->save("one");
    game.saves->save("two");
    game.tree.barrier();
    REQUIRE(game.reported.size() == 2);
    CHECK(game.reported[0].find("the game was not saved: ") == 0);
    CHECK(game.reported[0].find("it was forgotten") != std::string::npos);
    CHECK(game.saves->slots().load("one").state == before);
    const auto listed = game.saves->list();
    REQUIRE(listed.size() == 1);
    CHECK(listed.front().problem.find("it was forgotten") != std::string::npos);
    game.tree.remove_part(part);
}

TEST_CASE("a save that the game cannot restore is listed with its problem") {
    const GameFolder folder;
    {
        Game game(folder);
        ClassDescriptor lamp;
        lamp.name = "Lamp";
        game.tree.define(std::move(lamp));
        game.saves->save("lit");
        game.tree.barrier();
    }
    Game game(folder);
    const auto listed = game.saves->list();
    REQUIRE(listed.size() == 1);
    CHECK(listed.front().problem.find("Lamp") != std::string::npos);
    // A load of it is refused at once, so that a script can catch the error.
    std::string refused;
    try {
        game.saves->load("lit");
    } catch (const Error& error) {
        refused = error.what();
    }
    CHECK(refused.find("the saved game \"lit\" cannot be loaded: ") == 0);
    CHECK(refused.find("Lamp") != std::string::npos);
    game.tree.barrier();
    CHECK(game.reported.empty());
}

TEST_CASE("a formula that cannot be saved is reported once and again when it is lost") {
    const GameFolder folder;
    {
        Game game(folder);
        const Handle a = game.add("Thing", "a");
        game.tree.set_formula(a, "number",
                              {.function = [](const Tree&) { return Value(3.0); },
                               .not_saved = "uses the local variable \"speed\" of main.lua:12"});
        for (int i = 0; i < 3; ++i) {
            game.saves->save("one");
            game.tree.barrier();
        }
        REQUIRE(game.reported.size() == 1);
        CHECK(game.reported[0] ==
              game.tree.path(a) +
                  ".number: its formula uses the local variable \"speed\" of main.lua:12: saved "
                  "games hold its last value, and no formula");
    }
    Game game(folder);
    game.saves->load("one");
    game.tree.barrier();
    REQUIRE(game.reported.size() == 1);
    CHECK(game.reported[0].find("the saved game \"one\": ") == 0);
    CHECK(game.reported[0].find(".number: its formula was not saved") != std::string::npos);
}

TEST_CASE("a load finds a save that is not yet made or not yet written") {
    const GameFolder folder;
    Game game(folder, true);
    const Handle a = game.add("Thing", "a");
    game.tree.set(a, "number", 1.0);
    game.saves->save("one");
    game.saves->load("one");
    game.tree.set(a, "number", 2.0);
    game.tree.barrier();  // saved with the value 2, and loaded with it
    CHECK(game.tree.get(a, "number") == Value(2.0));
    game.tree.set(a, "number", 3.0);
    game.saves->load("one");  // the save waits for its picture
    game.tree.barrier();
    CHECK(game.tree.get(a, "number") == Value(2.0));
    CHECK(game.reported.empty());
    game.saves->save("two");
    game.tree.barrier();
    game.saves->remove("two");
    CHECK_THROWS_AS(game.saves->load("two"), Error);
    CHECK_THROWS_AS(game.saves->remove("two"), Error);
    game.saves->finish({});
    CHECK(game.saves->slots().list().size() == 1);
}

TEST_CASE("a save that cannot be written is reported and the game continues") {
    const GameFolder folder;
    Game game(folder);
    game.saves->save("one");
    game.tree.barrier();
    {
        const SmallFiles full(10);
        game.saves->save("one");
        game.tree.barrier();
    }
    REQUIRE(game.reported.size() == 1);
    CHECK(game.reported[0].find("the game was not saved: ") == 0);
    CHECK(game.saves->slots().load("one").info.problem.empty());
}

}  // namespace game_saves_test
