// Errors and crashes of native modules in a run and in a test.

#include <catch.h>

#include <filesystem>
#include <string>
#include <vector>

#include "program.h"

namespace native_failures_test {

using namespace program_test;

namespace {

/// A game whose native module fails in step 5 in the given way, after it has printed.
void write_game(const Folder& folder, const std::string& failure) {
    std::filesystem::copy_file(FETTLE_TEST_MODULES "/thrower.so", folder / "own.so");
    folder.write("modules.json", R"({"modules": ["./own.so"]})");
    folder.write("main.lua",
                 "game.one = Fragile {}\nfunction step() print('step', time.step)\n"
                 "if time.step == 5 then game.one.fails = '" +
                     failure + "' end end\n");
    folder.write("tests/one.lua",
                 "test('six', function(t) t:steps(6) end)\n"
                 "test('two', function(t) t:steps(2) end)\n");
}

Outcome run_native(const Folder& folder, const std::vector<std::string>& more = {}) {
    std::vector<std::string> all = {"run", (folder / "").string(), "--headless", "--steps", "8"};
    all.insert(all.end(), more.begin(), more.end());
    return fettle(folder, all);
}

Outcome test_native(const Folder& folder, const std::vector<std::string>& more = {}) {
    std::vector<std::string> all = {"test", (folder / "").string()};
    all.insert(all.end(), more.begin(), more.end());
    return fettle(folder, all);
}

}  // namespace

TEST_CASE("an error in a native step halts the game and fails a run and a test") {
    const std::string function = GENERATE("step", "report");
    const Folder folder;
    write_game(folder, function);
    const Outcome ran = run_native(folder);
    INFO(ran.out << ran.err);
    CHECK(ran.status == 1);
    CHECK(contains(ran.err,
                   "error in native module: thrower: " + function + ": no " + function + " today"));
    CHECK(contains(ran.out, "step\t5\n"));
    CHECK_FALSE(contains(ran.out, "step\t6"));
    const Outcome tested = test_native(folder);
    INFO(tested.out << tested.err);
    CHECK(tested.status == 1);
    CHECK(contains(tested.out, "FAIL  tests/one.lua: six\n      thrower: " + function + ": no " +
                                   function + " today"));
    CHECK(contains(tested.out, "ok    tests/one.lua: two\n2 tests, 1 failed\n"));
}

TEST_CASE("a hash that a native module cannot compute is an error that names both") {
    const Folder folder;
    write_game(folder, "hash");
    std::vector<std::string> option = {"--hash"};
    if (GENERATE(false, true)) option = {"--record", (folder / "run.recording").string()};
    const Outcome ran = run_native(folder, option);
    INFO(ran.out << ran.err);
    CHECK(ran.status == 1);
    CHECK(contains(ran.err, "error in native module: thrower: hash: no hash today"));
}

#ifndef FETTLE_SANITIZED  // sanitizers report crashes themselves
TEST_CASE("a crash of a native module leaves what was printed and names module and function") {
    const std::string failure = GENERATE("crash", "recurse");
    const Folder folder;
    write_game(folder, failure);
    const Outcome ran = run_native(folder);
    INFO(ran.out << ran.err);
    CHECK(ran.status == 128 + 11);
    CHECK(contains(ran.out, "step\t4\nstep\t5\n"));
    CHECK(contains(ran.err,
                   "fettle: run: it crashed: segmentation fault (in the native module thrower, in "
                   "its step)\n"));
    const Outcome tested = test_native(folder);
    INFO(tested.out << tested.err);
    CHECK(tested.status == 128 + 11);
    CHECK(contains(tested.out, "step\t4\nstep\t5\n"));
    CHECK(contains(tested.err,
                   "fettle: tests/one.lua: six: it crashed: segmentation fault (in the native "
                   "module thrower, in its step)"));
}
#endif

TEST_CASE("a native module that hangs is stopped by the limit of a test and by that of a run",
          "[long]") {
    const Folder folder;
    write_game(folder, "hang");
    const Outcome tested = test_native(folder, {"--timeout", "1"});
    INFO(tested.out << tested.err);
    CHECK(tested.status == 1);
    CHECK(contains(tested.out, "step\t5\n"));
    CHECK(contains(tested.err,
                   "fettle: tests/one.lua: six: the test did not end within 1 s of processor time, "
                   "and native code ran (in the native module thrower, in its step)"));
    const Outcome ran = run_native(folder, {"--budget", "100"});
    INFO(ran.out << ran.err);
    CHECK(ran.status == 1);
    CHECK(contains(ran.out, "step\t5\n"));
    CHECK(contains(
        ran.err,
        "nothing could stop it: the run ends at once (in the native module thrower, in its step)"));
}

}  // namespace native_failures_test
