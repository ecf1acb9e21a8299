// A signal asks a run to end. The run ends in order, whatever its script does; a second signal ends
// it at once.

#include <catch.h>

#include <csignal>

#include "running_program.h"
#include "thorough.h"

namespace end_request_test {

using namespace program_test;

namespace {

/// Runs until it is asked to end, and writes its progress to files.
const char* const game = R"lua(
game.o = Object {}
game.o.steps = 0
function step()
    game.o.steps = game.o.steps + 1
    if game.o.steps == 3 then
        edit("by a person", function() game.o.kept = 42 end)
        print("edited")
    end
    if game.o.steps == 5 then scene.save("playing.json", Object {}) end
end
function closing() print("closing") game.o.bye = true edit("last", function() game.o.last = 1 end) end
)lua";

std::vector<std::string> run(const std::string& file) {
    return {"run", file, "--headless", "--steps", "1000000000"};
}

}  // namespace

TEST_CASE("a signal ends a run in order") {
    const auto [signal, status] =
        GENERATE(std::pair(SIGINT, 130), std::pair(SIGTERM, 143), std::pair(SIGHUP, 129));
    const Folder folder;
    const std::string file = folder.write("main.lua", game);
    RunningProgram program(folder, run(file));
    REQUIRE(program.makes("playing.json"));
    program.send(signal);
    const RunningProgram::End end = program.end();
    CHECK(end.signal == 0);
    CHECK(end.status == status);
    CHECK(end.out == "edited\nclosing\n");
    CHECK(end.err.empty());
    const Outcome next =
        fettle(folder, {"run", file, "--headless", "--steps", "1", "--eval", "tweaks() quit()"});
    CHECK(contains(next.out, "o.kept: nothing → 42"));
    CHECK(contains(next.out, "o.last: nothing → 1"));
}

TEST_CASE("an endless script is stopped and closing is still called", "[long]") {
    const std::string loops[] = {
        "while true do end",
        "while true do pcall(error) end",
        "while true do pcall(function() while true do end end) end",
        "xpcall(function() while true do end end, function() while true do end end)",
        "coroutine.wrap(function() while true do end end)()",
        "while true do coroutine.wrap(function() for i = 1, 900 do end end)() end",
        "local x <close> = setmetatable({}, { __close = function() while true do end end }) "
        "while true do end",
        "print((('a'):rep(30000)):match('.-.-.-.-b'))",
        "repeat until false"};
    const std::size_t number = GENERATE_COPY(range(std::size_t{0}, std::size(loops)));
    const std::string where = GENERATE("load", "step", "update");
    if (where == "step" ? !is_tested(number, 3) : number != 0) return;
    const std::string& loop = loops[number];
    const std::string body = "scene.save('playing.json', Object {}) " + loop;
    const Folder folder;
    const std::string file = folder.write(
        "main.lua", "function closing() print('closing') end\n" +
                        (where == "load" ? body : "function " + where + "()\n" + body + "\nend"));
    RunningProgram program(folder, run(file));
    REQUIRE(program.makes("playing.json"));
    program.send(SIGTERM);
    const RunningProgram::End end = program.end();
    INFO(where << ": " << loop << "\n" << end.out << end.err);
    CHECK(end.status == 143);
    CHECK(end.out == "closing\n");
    CHECK(contains(end.err, "fettle: in " + where + ": main.lua:"));
    CHECK(contains(end.err, "stopped: it was interrupted"));
}

TEST_CASE("closing is stopped after some seconds", "[long]") {
    const Folder folder;
    const std::string file = folder.write(
        "main.lua",
        "function step() scene.save('playing.json', Object {}) end\n"
        "function closing() print('closing') while true do pcall(function() end) end end");
    RunningProgram program(folder, run(file));
    REQUIRE(program.makes("playing.json"));
    program.send(SIGINT);
    const RunningProgram::End end = program.end();
    CHECK(end.status == 130);
    CHECK(end.out == "closing\n");
    CHECK(contains(end.err, "fettle: in closing: main.lua:2: stopped: it was interrupted"));
}

TEST_CASE("a second signal ends a run at once") {
    const Folder folder;
    const std::string file = folder.write(
        "main.lua",
        "function step() scene.save('playing.json', Object {}) end\n"
        "function closing() scene.save('closing.json', Object {}) while true do end end");
    RunningProgram program(folder, run(file));
    REQUIRE(program.makes("playing.json"));
    program.send(SIGINT);
    REQUIRE(program.makes("closing.json"));
    program.send(SIGTERM);
    const RunningProgram::End end = program.end();
    CHECK(end.signal == SIGTERM);
    CHECK(end.status == 143);
    CHECK(contains(end.err, "fettle: a second signal: the run ends at once\n"));
}

TEST_CASE("an endless call outside of scripts is ended after some seconds with a message",
          "[long]") {
    const Folder folder;
    // The first step of 40 000 bodies in one spot takes more than half a minute.
    const std::string file =
        folder.write("main.lua",
                     "for i = 1, 40000 do world:add(Body { Circle {} }) end\n"
                     "function step() scene.save('playing.json', Object {}) end");
    RunningProgram program(folder, run(file));
    REQUIRE(program.makes("playing.json"));
    program.send(SIGTERM);
    const RunningProgram::End end = program.end();
    CHECK(end.signal == 0);
    CHECK(end.status == 143);
    CHECK(contains(end.err, "the run did not end in time: it ends at once\n"));
}

TEST_CASE("a signal that the program inherited as ignored stays ignored") {
    const Folder folder;
    const std::string file = folder.write("main.lua", game);
    RunningProgram program(folder, run(file), SIGINT);
    REQUIRE(program.makes("playing.json"));
    program.send(SIGINT);
    program.send(SIGTERM);
    CHECK(program.end().status == 143);
}

TEST_CASE("a signal ends a replay and a recording in order") {
    const Folder folder;
    const std::string file = folder.write("main.lua", game);
    const std::string record = (folder / "rec").string();
    std::vector<std::string> arguments = run(file);
    arguments.insert(arguments.end(), {"--record", record});
    {
        RunningProgram program(folder, arguments);
        REQUIRE(program.makes("playing.json"));
        program.send(SIGINT);
        const RunningProgram::End end = program.end();
        CHECK(end.status == 130);
        CHECK(contains(end.out, "closing\n"));
    }
    const Outcome again = fettle(folder, {"run", "--replay", record, "--headless"});
    INFO(again.out << again.err);
    CHECK(again.status == 0);
    CHECK(contains(again.out, "closing\n"));
    CHECK(contains(again.out, "steps, each as it was recorded"));
}

}  // namespace end_request_test
