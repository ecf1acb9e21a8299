// Saved games: complete or absent, and refused with a reason if they are damaged.

#include <fettle/property/storage/saves.h>

#include <cstdlib>
#include <fstream>
#include <numeric>
#include <random>

#include <sqlite3.h>

#include "catch.h"
#include "file_faults.h"
#include "game_folder.h"
#include "thorough.h"

namespace saves_test {

using namespace scene_test;
using namespace fettle::property;
namespace fs = std::filesystem;

namespace {

std::vector<std::byte> state_of(std::size_t size, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::byte> bytes(size);
    for (std::byte& each : bytes) each = static_cast<std::byte>(random());
    return bytes;
}

Thumbnail picture(std::uint32_t width, std::uint32_t height) {
    Thumbnail made{width, height, {}};
    made.pixels.resize(std::size_t{width} * height * 4);
    std::iota(made.pixels.begin(), made.pixels.end(), std::uint8_t{0});
    return made;
}

std::string bytes_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string refusal(const Saves& saves, const std::string& slot) {
    try {
        (void)saves.load(slot);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

struct Fixture {
    GameFolder folder;
    fs::path place = folder.user() / "saves";
    Saves saves{place, "ball game", "0.1.0"};
};

}  // namespace

TEST_CASE_METHOD(Fixture, "a saved game is loaded byte for byte with its picture") {
    CHECK(saves.list().empty());
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{3'000'000}}) {
        const auto state = state_of(size, 1);
        saves.save("first", 412, state, picture(16, 9));
        const SavedGame back = saves.load("first");
        CHECK(back.state == state);
        CHECK(back.info.step == 412);
        CHECK(back.info.program == "0.1.0");
        CHECK(back.thumbnail.width == 16);
        CHECK(back.thumbnail.pixels == picture(16, 9).pixels);
    }
    saves.save("Another one_2-b", 3, state_of(10, 2));
    const auto all = saves.list();
    REQUIRE(all.size() == 2);
    CHECK(all[0].slot == "Another one_2-b");
    CHECK_FALSE(all[0].thumbnail);
    CHECK(all[1].slot == "first");
    CHECK(all[1].thumbnail);
    CHECK(all[1].problem.empty());
    saves.remove("first");
    CHECK(saves.list().size() == 1);
    CHECK(has(refusal(saves, "Anther one_2-b"), "did you mean \"Another one_2-b\""));
}

TEST_CASE_METHOD(Fixture, "the name of a slot is a safe file name") {
    for (const std::string& bad :
         {std::string(), std::string("../a"), std::string("a/b"), std::string(".a"),
          std::string("a.b"), std::string(" a"), std::string("a "), std::string(65, 'a'),
          std::string("a\0b", 3), std::string("ä"), std::string("a\n")}) {
        INFO(bad);
        CHECK_THROWS_AS(saves.save(bad, 1, state_of(1, 1)), Error);
        CHECK_THROWS_AS(saves.load(bad), Error);
        CHECK_THROWS_AS(saves.remove(bad), Error);
    }
    CHECK_FALSE(fs::exists(place));
    // A file whose name is not a slot is listed with the reason, because it cannot be loaded.
    saves.save("good", 1, state_of(1, 1));
    fs::copy_file(place / "good.sqlite", place / "bad name!.sqlite");
    const auto all = saves.list();
    REQUIRE(all.size() == 2);
    CHECK(has(all.front().problem, "\"bad name!\" is not a name of a slot"));
    CHECK(all.back().problem.empty());
}

TEST_CASE_METHOD(Fixture, "a link without a target is reported equally in the list and by a load") {
    fs::create_directories(place);
    fs::create_symlink("round.sqlite", place / "round.sqlite");
    const auto all = saves.list();
    REQUIRE(all.size() == 1);
    CHECK(has(all.front().problem, "could not be read: "));
    CHECK(has(refusal(saves, "round"), all.front().problem));
    saves.remove("round");
    CHECK(saves.list().empty());
}

TEST_CASE_METHOD(Fixture, "a saved game with any byte changed is refused") {
    saves.save("a", 5, state_of(5'000, 3), picture(8, 8));
    const fs::path file = place / "a.sqlite";
    const std::string whole = bytes_of(file);
    for (std::size_t at = 0; at < whole.size(); ++at) {
        if (!is_tested(at, 61)) continue;
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        std::ofstream(file, std::ios::binary) << damaged;
        INFO("byte " << at);
        REQUIRE(has(refusal(saves, "a"), "a.sqlite: cannot be loaded: "));
        if (at % 64 == 0) {
            CHECK_FALSE(saves.list().front().problem.empty());
            CHECK(bytes_of(file) == damaged);
        }
    }
    for (std::size_t size = 0; size < whole.size(); size += 499) {
        std::ofstream(file, std::ios::binary) << whole.substr(0, size);
        REQUIRE(has(refusal(saves, "a"), "a.sqlite: cannot be loaded: "));
    }
    std::ofstream(file, std::ios::binary) << whole << '\0';
    CHECK(has(refusal(saves, "a"), "a.sqlite: cannot be loaded: "));
    std::ofstream(file, std::ios::binary) << whole;
    CHECK(saves.load("a").info.step == 5);
}

TEST_CASE_METHOD(Fixture, "a saved game is a database that other programs can read") {
    saves.save("a", 5, state_of(5'000, 3), picture(8, 8));
    sqlite3* database = nullptr;
    REQUIRE(sqlite3_open_v2((place / "a.sqlite").c_str(), &database, SQLITE_OPEN_READONLY,
                            nullptr) == SQLITE_OK);
    int step = 0;
    const auto note = [](void* to, int, char** values, char**) {
        *static_cast<int*>(to) = std::atoi(values[0]);
        return 0;
    };
    CHECK(sqlite3_exec(database, "SELECT step FROM save", note, &step, nullptr) == SQLITE_OK);
    CHECK(step == 5);
    sqlite3_close(database);
    CHECK(saves.load("a").info.problem.empty());
}

TEST_CASE_METHOD(Fixture,
                 "a save of a newer version or of another game is refused with the reason") {
    saves.save("a", 5, state_of(10, 1));
    const Saves other(place, "chess", "0.1.0");
    CHECK(has(refusal(other, "a"), "it belongs to another game, ball game"));
    sqlite3* database = nullptr;
    REQUIRE(sqlite3_open((place / "a.sqlite").c_str(), &database) == SQLITE_OK);
    sqlite3_exec(database, "PRAGMA user_version = 3", nullptr, nullptr, nullptr);
    sqlite3_close(database);
    CHECK(has(refusal(saves, "a"), "written by a newer Fettle (version 3"));
    CHECK(has(saves.list().front().problem, "newer"));
}

TEST_CASE_METHOD(Fixture, "a save that fails leaves the older one and no other files") {
    const auto older = state_of(100, 1);
    saves.save("a", 5, older);
    {
        const SmallFiles full(1000);
        CHECK_THROWS_AS(saves.save("a", 6, state_of(100'000, 2)), FileError);
        CHECK_THROWS_AS(saves.save("b", 6, state_of(100'000, 2)), FileError);
    }
    CHECK(saves.load("a").state == older);
    fs::permissions(place, fs::perms(0555));
    {
        const Nobody nobody;
        CHECK_THROWS_AS(saves.save("a", 6, older), FileError);
        CHECK(saves.load("a").state == older);
        CHECK_THROWS_AS(saves.remove("a"), FileError);
    }
    fs::permissions(place, fs::perms::all);
    CHECK(std::distance(fs::directory_iterator(place), fs::directory_iterator()) == 1);
}

TEST_CASE("a picture is scaled down by averaging") {
    Thumbnail big{4, 2, {}};
    big.pixels.assign(4 * 2 * 4, 100);
    for (std::size_t i = 0; i < 4; ++i) big.pixels[i] = 200;  // the first pixel
    const Thumbnail small = scaled_down(big, 2);
    CHECK(small.width == 2);
    CHECK(small.height == 1);
    CHECK(small.pixels == std::vector<std::uint8_t>{125, 125, 125, 125, 100, 100, 100, 100});
    CHECK(scaled_down(big, 10).width == 4);
    CHECK(scaled_down({}, 10).empty());
    CHECK(scaled_down(picture(1000, 3), 100).height == 1);
}

}  // namespace saves_test
