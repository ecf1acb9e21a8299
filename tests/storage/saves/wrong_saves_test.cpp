#include <memory>

#include <fettle/property/storage/game_saves.h>
#include <fettle/property/storage/saves.h>
#include <fettle/property/tree.h>

#include "catch.h"
#include "temporary_folder.h"

namespace wrong_saves_test {

// Invalid calls in C++ to save and load.

using namespace fettle::property;

namespace {

template <class Act>
std::string message_of(const Act& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("saving data that could not be loaded is refused and keeps the old save") {
    const TemporaryFolder folder;
    const Saves saves(folder.path, "game", "program");
    const std::vector<std::byte> state(100, std::byte{7});
    saves.save("slot", 3, state, {.width = 1, .height = 1, .pixels = {1, 2, 3, 4}});
    CHECK_THAT(message_of([&] { saves.save("slot", UINT64_MAX, {}); }),
               contains("step 18446744073709551615: expected at most"));
    const std::vector<Thumbnail> wrong = {
        {.width = 10, .height = 10, .pixels = {}},
        {.width = 0xffffffff, .height = 0xffffffff, .pixels = {}},
        {.width = 0, .height = 1, .pixels = {1, 2, 3, 4}},
        {.width = 2048, .height = 2049, .pixels = std::vector<std::uint8_t>(2048 * 2049 * 4)}};
    for (const Thumbnail& picture : wrong)
        CHECK_THAT(message_of([&] { saves.save("slot", 4, {}, picture); }),
                   contains("expected four bytes a pixel"));
    const SavedGame loaded = saves.load("slot");
    CHECK(loaded.info.step == 3);
    CHECK(loaded.state == state);
}

TEST_CASE("a picture without pixels is not scaled") {
    CHECK_THAT(message_of([] { (void)scaled_down({.width = 10, .height = 10, .pixels = {}}, 3); }),
               contains("10 × 10 px has 0 bytes: expected four a pixel"));
    CHECK_THAT(message_of([] {
                   (void)scaled_down({.width = 1u << 31, .height = 1u << 31, .pixels = {}}, 3);
               }),
               contains("expected four a pixel"));
    const Thumbnail sound{.width = 2, .height = 1, .pixels = {0, 0, 0, 0, 2, 4, 6, 8}};
    CHECK(scaled_down(sound, 1).pixels == std::vector<std::uint8_t>{1, 2, 3, 4});
    CHECK(scaled_down({}, 1).empty());
}

TEST_CASE("saved games report that their tree was destroyed") {
    const TemporaryFolder folder;
    auto tree = std::make_unique<Tree>();
    GameSaves saves(*tree, Saves(folder.path, "game", "program"), {});
    saves.save("slot");
    tree->barrier();
    CHECK(saves.list().size() == 1);
    tree.reset();
    CHECK_THAT(message_of([&] { saves.load("slot"); }), contains("the tree of these saved games"));
    CHECK_THAT(message_of([&] { saves.save("slot"); }), contains("the tree of these saved games"));
    saves.list();
    CHECK_FALSE(saves.list().front().problem.empty());
}

}  // namespace wrong_saves_test
