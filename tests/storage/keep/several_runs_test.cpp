// Several runs of one game, each in its own process: all kept tweaks are preserved, and no run
// removes a file that another one is writing.

#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fcntl.h>
#include <csignal>
#include <filesystem>
#include <functional>
#include <vector>

#include <fettle/property/storage/game_files.h>

#include "catch.h"
#include "file_faults.h"
#include "thorough.h"
#include "tweak_run.h"

namespace several_runs_test {

using namespace scene_test;
namespace fs = std::filesystem;

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Runs `body(i)` in `count` processes that start together. Each must return true.
void together(int count, const std::function<bool(int)>& body) {
    int start[2];
    REQUIRE(::pipe(start) == 0);
    std::vector<pid_t> all;
    for (int i = 0; i < count; ++i) {
        const pid_t made = ::fork();
        REQUIRE(made >= 0);
        if (made == 0) {
            ::close(start[1]);
            char byte;
            (void)!::read(start[0], &byte, 1);  // waits for the start of the others
            bool good = false;
            try {
                good = body(i);
            } catch (...) {
            }
            ::_exit(good ? 0 : 1);
        }
        all.push_back(made);
    }
    ::close(start[0]);
    ::close(start[1]);
    for (const pid_t each : all) {
        int status = 1;
        REQUIRE(::waitpid(each, &status, 0) == each);
        CHECK(status == 0);
    }
}

std::size_t temporary_files(const fs::path& folder) {
    std::size_t count = 0;
    for (const auto& each : fs::recursive_directory_iterator(folder))
        count += has(each.path().filename().string(), ".tmp");
    return count;
}

}  // namespace

TEST_CASE("tweaks that several runs keep at the same time are all preserved") {
    constexpr int runs = 6, rounds = 5;
    const GameFolder folder;
    std::string level =
        "{\n  \"fettle_scene\": 1,\n  \"class\": \"Object\",\n  \"name\": \"level\"\n}\n";
    folder.write("level.json", level);
    together(runs, [&](int i) {
        Run run(folder);
        run.load(folder, "level.json");
        const std::string name = "of_" + std::to_string(i);
        const Handle own = run.add("Thing", name);
        run.barrier();
        bool good = true;
        for (int round = 1; round <= rounds; ++round) {
            run.person([&] {
                run.tree.set(own, "number", static_cast<double>(round));
                run.tree.set_or_add(own, "round_" + std::to_string(round), round);
                run.tree.set_or_add(run.at("world.level"), name + "_" + std::to_string(round), i);
            });
            const TweakReport report = run.tweaks->keep("**");
            good = good && report.problems.empty() && report.count >= 3;
        }
        return good;
    });
    const std::string kept = folder.text("main.tweaks.json"), scene = folder.text("level.json");
    INFO(kept << scene);
    for (int i = 0; i < runs; ++i) {
        const std::string name = "of_" + std::to_string(i);
        CHECK(has(kept, "\"world." + name + ".number\": 5"));
        for (int round = 1; round <= rounds; ++round) {
            const std::string number = std::to_string(round);
            CHECK(has(kept, "\"world." + name + ".round_" + number + "\": " + number));
            CHECK(has(scene, "\"" + name + "_" + number + "\": " + std::to_string(i)));
        }
    }
    Run next(folder);
    CHECK(next.reported.empty());
    CHECK(next.lines().empty());
}

TEST_CASE("a run keeps the tweaks that another one has kept since it began") {
    const GameFolder folder;
    Run one(folder), two(folder);
    const Handle a = one.add("Thing", "a"), b = two.add("Thing", "b");
    one.person([&] { one.tree.set(a, "number", 1.0); });
    CHECK(one.tweaks->keep("**").count == 1);
    two.person([&] { two.tree.set(b, "number", 2.0); });
    CHECK(two.tweaks->keep("**").count == 1);
    one.person([&] { one.tree.set(a, "flag", true); });
    CHECK(one.tweaks->keep("**").count == 1);
    for (const char* const part :
         {"world.a.number\": 1", "world.b.number\": 2", "world.a.flag\": true"})
        CHECK(has(folder.text("main.tweaks.json"), part));
}

TEST_CASE(
    "a file of kept tweaks that is damaged while the game runs is reported and not overwritten") {
    const GameFolder folder;
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.person([&] { run.tree.set(a, "number", 1.0); });
    CHECK(run.tweaks->keep("**").count == 1);
    folder.write("main.tweaks.json", "{\"fettle_tweaks\": 1, oops");
    run.person([&] { run.tree.set(a, "number", 2.0); });
    const TweakReport report = run.tweaks->keep("**");
    REQUIRE(report.problems.size() == 1);
    CHECK(has(report.problems[0], "main.tweaks.json:1:"));
    CHECK(folder.text("main.tweaks.json") == "{\"fettle_tweaks\": 1, oops");
    CHECK(Run(folder).tweaks->open_earlier() == 1);
}

TEST_CASE("runs that journal their first tweaks at the same time share one journal") {
    constexpr int runs = 8;
    const GameFolder folder;
    together(runs, [&](int i) {
        Run run(folder);
        const Handle own = run.add("Thing", "of_" + std::to_string(i));
        run.person([&] { run.tree.set(own, "number", 1.0 + i); });
        return run.reported.empty();
    });
    Run next(folder);
    CHECK(next.tweaks->open_earlier() == runs);
    CHECK(next.reported.empty());
    CHECK_FALSE(fs::exists(folder / ".fettle/main.tweaks.2.sqlite"));
}

TEST_CASE("the last tweaks of a run wait until another run has written") {
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a");
        run.person([&] { run.tree.set(a, "number", 1.0); });
    }
    // Many runs that each make one tweak and end at the same time: none may fail because the
    // journal is busy.
    together(8, [&](int i) {
        Run run(folder);
        const Handle own = run.add("Thing", "of_" + std::to_string(i));
        run.person([&] { run.tree.set(own, "number", 1.0 + i); });
        run.person([&] { run.tree.set(own, "flag", true); });
        run.tweaks.reset();
        return true;
    });
    CHECK(Run(folder).tweaks->open_earlier() == 17);
}

TEST_CASE("temporary files of killed processes are removed and those of living ones stay") {
    const GameFolder folder;
    const std::string large(3'000'000, 'x');
    int ready[2];
    REQUIRE(::pipe(ready) == 0);
    std::size_t left = 0;
    for (int round = 0; round < 30; ++round) {
        if (!is_tested(std::size_t(round), 3)) continue;
        const pid_t made = ::fork();
        REQUIRE(made >= 0);
        if (made == 0) {
            GameFiles files;
            files.stay_below(folder.path());
            for (int i = 0;; ++i) {
                if (i == round && ::write(ready[1], "x", 1) != 1) ::_exit(1);
                files.write(folder / ("level" + std::to_string(i % 3) + ".json"), large);
            }
        }
        char byte;
        REQUIRE(::read(ready[0], &byte, 1) == 1);
        ::usleep(static_cast<useconds_t>(round * 211));
        ::kill(made, SIGKILL);
        ::waitpid(made, nullptr, 0);
        left = std::max(left, temporary_files(folder.path()));
    }
    CHECK(left <= 1);

    // A file that is being written: a living process has locked it.
    const fs::path living = folder / ".level.json.1234.fettle.tmp";
    const int held = ::open(living.c_str(), O_RDWR | O_CREAT, 0600);
    REQUIRE(::flock(held, LOCK_EX | LOCK_NB) == 0);
    // Names that are not of temporary files.
    for (const char* const name : {".level.json.tmp", "level.json.12.fettle.tmp", "notes.tmp",
                                   ".level.json.x12.fettle.tmp", ".12.fettle.tmp"})
        folder.write(name, "mine");
    fs::create_symlink(folder / "notes.tmp", folder / ".link.json.77.fettle.tmp");
    folder.write(".dead.json.5.fettle.tmp", "left");
    GameFiles files;
    files.stay_below(folder.path());
    files.write(folder / "other.json", "text");
    CHECK(fs::exists(living));
    CHECK(folder.text("notes.tmp") == "mine");
    CHECK(folder.text(".level.json.tmp") == "mine");
    CHECK(folder.text(".level.json.x12.fettle.tmp") == "mine");
    CHECK(fs::is_symlink(folder / ".link.json.77.fettle.tmp"));
    CHECK_FALSE(fs::exists(folder / ".dead.json.5.fettle.tmp"));
    ::close(held);
    files.write(folder / "other.json", "text");
    CHECK_FALSE(fs::exists(living));
}

TEST_CASE("keep waits some time for another program and then reports that nothing was written") {
    const GameFolder folder;
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.person([&] { run.tree.set(a, "number", 1.0); });
    const int other = ::open(folder.path().c_str(), O_RDONLY | O_DIRECTORY);
    REQUIRE(::flock(other, LOCK_EX | LOCK_NB) == 0);
    const TweakReport report = run.tweaks->keep("**");
    CHECK(report.count == 0);
    REQUIRE(report.problems.size() == 1);
    CHECK(has(report.problems[0], "another program holds the lock on this folder"));
    ::close(other);
    CHECK(run.tweaks->keep("**").count == 1);
}

TEST_CASE("on a full disk the message names the file") {
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a");
        run.person([&] { run.tree.set(a, "number", 2.0); });
    }
    Run run(folder);
    const Handle b = run.add("Thing", "b");
    const SmallFiles full(100);
    run.person([&] { run.tree.set(b, "number", 3.0); });
    REQUIRE(run.reported.size() == 1);
    INFO(run.reported[0]);
    CHECK(has(run.reported[0], "tweaks cannot be journaled: " +
                                   (folder / ".fettle/main.tweaks.sqlite").string() + ": "));
    CHECK(has(run.reported[0], "a file may not become that large here"));
    CHECK(has(run.reported[0], "those that wait (1) are lost if the game ends before"));
}

}  // namespace several_runs_test
