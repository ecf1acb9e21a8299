#include <prompt/history.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fettle/console/console.h>
#include "catch.h"
#include "temporary_folder.h"

namespace history_test {

using fettle::console::History;
namespace fs = std::filesystem;

namespace {

using Folder = TemporaryFolder;

void put(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("the next run has the history of the run before") {
    Folder folder;
    fs::path file = folder.path / "deep" / "down" / "history";
    {
        History history(file);
        history.add("world.ball.mass = 2");
        history.add("for i = 1, 3 do\n  print(i)\nend");
        history.add("path = \"c:\\new\"");
        CHECK(history.consume_problem().empty());
    }
    History again(file);
    REQUIRE(again.entries().size() == 3);
    CHECK(again.entries()[1] == "for i = 1, 3 do\n  print(i)\nend");
    CHECK(again.entries()[2] == "path = \"c:\\new\"");
}

TEST_CASE("a command typed again moves to the end of the history") {
    Folder folder;
    fs::path file = folder.path / "history";
    {
        History history(file);
        for (const char* command : {"a", "b", "a", "a"}) history.add(command);
        CHECK(history.entries() == std::vector<std::string>{"b", "a"});
    }
    CHECK(History(file).entries() == std::vector<std::string>{"b", "a"});
}

TEST_CASE("two consoles on one history file both keep their commands") {
    Folder folder;
    fs::path file = folder.path / "history";
    History one(file), two(file);
    one.add("from one");
    two.add("from two");
    one.add("from one again");
    CHECK(History(file).entries() ==
          std::vector<std::string>{"from one", "from two", "from one again"});
}

TEST_CASE("a history file that became too long is cut and keeps recent commands") {
    Folder folder;
    fs::path file = folder.path / "history";
    std::ostringstream lines;
    for (int i = 0; i < 10'000; ++i) lines << "command " << i << '\n';
    put(file, lines.str());
    History history(file);
    REQUIRE(history.entries().size() == History::max_entries);
    CHECK(history.entries().back() == "command 9999");
    CHECK(history.entries().front() == "command 8000");
    CHECK(fs::file_size(file) < 40'000);
    // No temporary file is left.
    CHECK(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()) == 1);
}

TEST_CASE("the readable lines of a damaged history file are loaded") {
    Folder folder;
    fs::path file = folder.path / "history";
    put(file, std::string("good\n\xff\xfe bad\n\n\0\x01\nlast without newline", 36));
    History history(file);
    CHECK(history.consume_problem().empty());
    CHECK(history.entries().front() == "good");
    CHECK(history.entries().back() == "last without newline");
}

TEST_CASE("a history file that is a folder is reported once and the history stays in memory") {
    Folder folder;
    History history(folder.path);
    CHECK(history.consume_problem().find("not a regular file") != std::string::npos);
    history.add("kept in memory");
    CHECK(history.consume_problem().empty());
    CHECK(history.entries().size() == 1);
}

TEST_CASE("a history whose folder cannot be made is reported and stays in memory") {
    Folder folder;
    put(folder.path / "file", "in the way");
    History history(folder.path / "file" / "history");
    history.add("kept in memory");
    CHECK(history.consume_problem().find("history is not kept") != std::string::npos);
    history.add("second");
    CHECK(history.consume_problem().empty());
    CHECK(history.entries().size() == 2);
}

TEST_CASE("the history is searched by prefix and by part of a command") {
    History history;
    for (const char* command : {"world.a = 1", "print(2)", "world.b = 3", "Print(4)"})
        history.add(command);
    CHECK(history.older("world", 4) == 2u);
    CHECK(history.older("world", 2) == 0u);
    CHECK(history.older("world", 0) == std::nullopt);
    CHECK(history.newer("world", 0) == 2u);
    CHECK(history.newer("world", 2) == std::nullopt);
    CHECK(history.containing("print", 4) == 3u);  // a pattern in lower case ignores case
    CHECK(history.containing("Print", 3) == std::nullopt);
    CHECK(history.containing("print", 3) == 1u);
}

TEST_CASE("the history file is in the state folder of the user") {
    ::setenv("XDG_STATE_HOME", "/state", 1);
    CHECK(fettle::console::default_history_file() == "/state/fettle/console_history");
    ::setenv("XDG_STATE_HOME", "relative is to be ignored", 1);
    ::setenv("HOME", "/home/u", 1);
    CHECK(fettle::console::default_history_file() == "/home/u/.local/state/fettle/console_history");
    ::unsetenv("XDG_STATE_HOME");
    ::unsetenv("HOME");
    CHECK(fettle::console::default_history_file().empty());
}

}  // namespace history_test
