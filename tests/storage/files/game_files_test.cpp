// The files of a game: a recorder is notified of them, and a replay provides their contents.

#include <catch.h>

#include <memory>

#include <fettle/property/storage/game_files.h>

#include "game_folder.h"

namespace game_files_test {

using namespace fettle::property;
using scene_test::GameFolder;

namespace {

std::vector<std::string> reported(std::vector<GameFiles::FileState>& states) {
    std::vector<std::string> all;
    for (const GameFiles::FileState& state : states)
        all.push_back(state.file.filename().string() +
                      (state.overwritten ? " overwritten " + state.content.value_or("nothing")
                       : state.checksum  ? " read"
                                         : " missing"));
    states.clear();
    return all;
}

}  // namespace

TEST_CASE("files are reported once when they are read and before they are written") {
    const GameFolder folder;
    folder.write("a.json", "one");
    GameFiles files;
    std::vector<GameFiles::FileState> states;
    files.record_reads();
    CHECK(files.read(folder / "a.json") == "one");
    CHECK_FALSE(files.exists(folder / "b.json"));
    files.on_first_access([&](const GameFiles::FileState& state) { states.push_back(state); });
    CHECK(states.front().checksum == file_checksum(folder / "a.json"));
    CHECK(reported(states) == std::vector<std::string>{"a.json read", "b.json missing"});
    CHECK(files.exists(folder / "a.json"));
    CHECK(files.read(folder / "a.json") == "one");
    CHECK(states.empty());
    files.write(folder / "a.json", "two");
    files.write(folder / "a.json", "three");
    files.write(folder / "b.json", "four");
    CHECK(files.read(folder / "a.json") == "three");
    CHECK(reported(states) ==
          std::vector<std::string>{"a.json overwritten one", "b.json overwritten nothing"});
    files.write(folder / "c.json", "five");
    CHECK(files.read(folder / "c.json") == "five");
    CHECK(reported(states) == std::vector<std::string>{"c.json overwritten nothing"});
    CHECK(folder.text("a.json") == "three");
}

TEST_CASE("a listener of files may replace itself") {
    const GameFolder folder;
    folder.write("a.json", "one");
    GameFiles files;
    files.record_reads();
    auto held = std::make_shared<int>();
    const std::weak_ptr<int> life = held;
    bool lived = false;
    files.on_first_access(
        [held = std::move(held), &files, &life, &lived](const GameFiles::FileState&) {
            const std::weak_ptr<int>& watched = life;
            bool& result = lived;
            files.on_first_access([](const GameFiles::FileState&) {});
            result = !watched.expired();
        });
    CHECK(files.read(folder / "a.json") == "one");
    CHECK(lived);
}

TEST_CASE("a file is the same under every name it has") {
    const GameFolder folder;
    folder.write("a.json", "one");
    std::filesystem::create_directory(folder / "sub");
    GameFiles files;
    files.put(folder / "sub/../a.json", "held");
    CHECK(files.read(folder / "a.json") == "held");
    std::filesystem::create_symlink(folder / "a.json", folder / "link.json");
    CHECK(files.read(folder / "link.json") == "held");
}

TEST_CASE("files written in memory stay in memory") {
    const GameFolder folder;
    folder.write("a.json", "as it is now");
    folder.write("b.json", "not there then");
    GameFiles files;
    files.stay_in_memory();
    files.put(folder / "a.json", "as it was");
    files.put(folder / "b.json", std::nullopt);
    CHECK(files.read(folder / "a.json") == "as it was");
    CHECK_FALSE(files.exists(folder / "b.json"));
    CHECK_THROWS_AS(files.read(folder / "b.json"), FileError);
    files.write(folder / "a.json", "written");
    files.write(folder / "b.json", "made");
    files.write(folder / "c.json", "made too");
    CHECK(files.read(folder / "a.json") == "written");
    CHECK(files.exists(folder / "b.json"));
    CHECK(files.read(folder / "c.json") == "made too");
    CHECK(folder.text("a.json") == "as it is now");
    CHECK(folder.text("b.json") == "not there then");
    CHECK_FALSE(std::filesystem::exists(folder / "c.json"));
}

}  // namespace game_files_test
