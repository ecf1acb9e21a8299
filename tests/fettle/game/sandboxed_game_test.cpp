// Games from strangers that attack the engine with files and properties: `fettle run --sandbox`
// ends with an error that names the place and the limit, or goes on, and neither crashes nor hangs.

#include <catch.h>

#include <filesystem>
#include <tuple>

#include "program.h"

namespace sandboxed_game_test {

using namespace program_test;
namespace fs = std::filesystem;

namespace {

Outcome play(const Folder& folder, const std::string& main, std::vector<std::string> more = {}) {
    folder.write("game/main.lua", main);
    std::vector<std::string> all = {
        "run", (folder / "game").string(), "--sandbox", "--headless", "--steps", "3"};
    all.insert(all.end(), more.begin(), more.end());
    return fettle(folder, all);
}

// These sanitizers reserve more address space than any limit allows.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
const std::string limited_memory;
#else
const std::string limited_memory = "ulimit -v 2000000; ";
#endif

}  // namespace

TEST_CASE("each limit of a sandbox is reported with its place and value", "[long]") {
    const auto [main, reason] = GENERATE(table<std::string, std::string>({
        // instructions, memory, instances, handlers, timers, log, disk, time
        {"while true do end", "main.lua:1: stopped: it ran past its budget of 100000000 instr"},
        {"local t = {} for i = 1, 1e9 do t[i] = { i } end",
         "main.lua:1: stopped: it needs more memory than the scripts of a game may use, 512 MB"},
        {"for i = 1, 2e5 do game:add(Object { }) end", "main.lua:1: stopped: there are 100"},
        {"for i = 1, 2e5 do world:watch('gravity', print) end",
         "handlers, and this game may have 100000"},
        {"for i = 1, 2e5 do after(1e6, print) end", "timers, and this game may have 100000"},
        {"print(('x'):rep(50e6))", "main.lua:1: stopped: it has printed more than 16777216 bytes"},
        {"store.x = ('x'):rep(50e6)", "main.lua:1: store.x: the store would have more than 16 MiB"},
        {"function step() for i = 1, 9 do save_game('s' .. i) end end",
         "main.lua:1: the game is asked to be saved more than 4 times at one barrier"},
        // what is made of properties
        {"local p = game for i = 1, 2000 do p.l = Layer { } p = p.l end", "main.lua:1: l.l.l.l"},
        {"local p = interface for i = 1, 2000 do p.c = Column { } p = p.c end",
         "a tree has 1000 levels at most"},
        {"for i = 1, 300 do game:add(World { }) end", "at most 255 worlds"},
        {"for i = 1, 1e6 do class('C' .. i, Body) { } end", "10000 classes"},
        {"local t = {} for i = 1, 1e6 do t['p' .. i] = i end class('C', Body)(t)",
         "main.lua:1: C: a class declares at most 10000 properties and functions"},
        {"local t = {} for i = 1, 17000 do t[i] = vec(i, i % 7) end "
         "world.b = Body { Concave { vertices = t } }",
         "main.lua:1: Concave: there are 17000 points, and at most 16384 are possible"},
        {"local t = {} for i = 1, 1e5 do t[i] = 'space' end input.actions.jump = t",
         "an action has 64 keys and buttons at most"},
        {"local all = {} for i = 1, 100 do all[i] = snapshot() end", "64 are held already"},
        {"view.window.size = vec(1e9, 1e9)", "expected a vec2 from 1 to 16384 px"},
        {"world.substeps = 1000000000", "expected an integer from 1 to 64"},
        {"game[('n'):rep(5000)] = Object { }", "a name has at most 1000"},
        {"os.date(('%c'):rep(1e6))", "main.lua:1: os.date: the format has 2000000 bytes"},
        {"world.o = Object { } function step() for i = 1, 30 do world.o['c' .. i] = "
         "world.o:clone() end end",
         "instances, and this game may have 100000"},
        {"world.luck = 1 world:watch('luck', function() world.luck = world.luck + 1 end) "
         "world.luck = 2",
         "handlers keep changing what handlers wait for"},
    }));
    CAPTURE(main);
    const Folder folder;
    const Outcome run =
        play(folder, main, {"--budget", "600000"});  // ms; other limits are met first
    CAPTURE(run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.err, reason));
}

// No hook of Lua runs within these, so each is bounded by what it is asked for: by the length of
// the texts, or by instructions that are counted for its work. Without that, each takes from six
// seconds to hours; the run would end with the message that the game did not come back.
TEST_CASE("no single call of a function in C passes the time of a sandbox", "[long]") {
    const auto [main, reason] = GENERATE(table<std::string, std::string>({
        {"local s = ('x'):rep(250e6)",
         "a text would have 250000000 bytes, and the texts of this game may have 64 MB"},
        {"local s = 'x' while true do s = s .. s end",
         "a text would have 134217753 bytes, and the texts of this game may have 64 MB"},
        {"local s = ('x'):rep(40e6) while true do pcall(function() return s .. s end) end",
         "a text would have 80000025 bytes"},
        {"string.format('%q', ('\\0'):rep(60e6))", "ran past its budget"},
        {"local n, t = 240000, {} for i = 1, n do t[i] = 1e308 end "
         "string.format(('%99.99f'):rep(n), table.unpack(t))",
         "ran past its budget"},
        // texts that are equal up to their ends
        {"local a, t = ('a'):rep(60e6), {} local b = a .. 'a' "
         "for i = 1, 3000 do t[i] = i % 2 == 0 and a or b end table.sort(t)",
         "stopped: it ran"},
        {"local a, t = '1' .. (' '):rep(50e6), {} for i = 1, 300 do t[i] = a end "
         "table.sort(t, utf8.len)",
         "stopped: it ran"},
        {"local s, p = ('a'):rep(3e6), '[' .. ('b'):rep(1e6) .. ']' s:match(p)",
         "ran past its budget"},
        {"query(('*.'):rep(3e7))", "a pattern has at most 2000 names"},
        {"watch(('a.'):rep(3e7), print)", "a path has at most 2000 names"},
        {"scene.load(('a/'):rep(3e7), world)", "the name of a file has at most 4096 bytes"},
        {"go_to_scene(('a/'):rep(3e7))", "go_to_scene: there is no scene"},
    }));
    const Folder folder;
    // A slow machine does not pass the limit of time, so the message is always the same.
    const Outcome run = play(folder, main, {"--budget", "20000"});
    CAPTURE(main, run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.err, "main.lua:1: "));
    CHECK(contains(run.err, reason));
}

TEST_CASE("the time of a call in a sandbox is that of the command line") {
    const Folder folder;
    const Outcome run = play(folder, "while true do world:find('World') end",
                             {"--budget", "200", "--memory", "64"});
    CHECK(run.status == 1);
    CHECK(contains(run.err, "main.lua:1: stopped: it ran for 0.2 seconds"));
}

TEST_CASE("the limits of what a trusted game adds come from its settings or the command line") {
    const Folder folder;
    folder.write("game/main.lua",
                 "print(pcall(function() for i = 1, 1e7 do world:add(Body { }) end end))");
    const std::string game = (folder / "game").string();
    const auto limited = [&](const std::vector<std::string>& more, const std::string& megabytes) {
        std::vector<std::string> arguments{"run", game, "--headless", "--steps", "1"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome run = fettle(folder, arguments);
        CAPTURE(run.err);
        CHECK(run.status == 1);
        CHECK(contains(run.err,
                       "main.lua:1: stopped: it needs more memory than the scripts of a "
                       "game may add to it, " +
                           megabytes + " MB; "));
        CHECK(contains(run.err, "(\"memory\" in game.json, or --memory, raises the limit)"));
    };
    folder.write("game/game.json", R"({"memory": 20})");
    limited({}, "20");
    limited({"--memory", "10"}, "10");
    // A game that is not trusted does not raise its own limit.
    folder.write("game/main.lua", "for i = 1, 1e7 do world:add(Body { }) end");
    folder.write("game/game.json", R"({"memory": 900000})");
    const Outcome sandboxed = fettle(
        folder, {"run", game, "--headless", "--steps", "1", "--sandbox", "--budget", "600000"});
    CHECK(sandboxed.status == 1);
    CHECK(contains(sandboxed.err, "stopped: there are 100"));
}

TEST_CASE("instances that make instances when they are ready have the limit of all") {
    const Folder folder;
    const Outcome run = play(folder,
                             "class('B', Object) { } "
                             "function B:ready() for i = 1, 60 do world:add(B { }) end end "
                             "world:add(B { })",
                             {"--budget", "600000"});
    CHECK(run.status == 1);
    CHECK(contains(run.err, "main.lua:1: stopped: there are 100"));
    CHECK(contains(run.err, "instances, and this game may have 100000"));
}

TEST_CASE("one replacement of a text takes no more memory than a game may have", "[long]") {
    const std::string replacement =
        GENERATE(as<std::string>{}, "gsub('.+', ('%0'):rep(1000))", "gsub('.', ('x'):rep(1e6))",
                 "gsub('.', ('%%'):rep(1e6))", "gsub('.', { a = ('x'):rep(1e6) })");
    CAPTURE(replacement);
    const Folder folder;
    folder.write("game/main.lua", "return (('a'):rep(1e7)):" + replacement);
    // Very many pieces reach the limit of time before that of memory. The others get so much time
    // that a slow machine needs the memory first.
    const bool in_pieces = contains(replacement, "%%");
    const Outcome run = fettle(folder,
                               {"run", (folder / "game").string(), "--sandbox", "--headless",
                                "--steps", "1", "--budget", in_pieces ? "2000" : "120000"},
                               limited_memory);
    CAPTURE(run.err);
    CHECK(run.status == 1);
    const std::string stopped = "main.lua:1: stopped: it ";
    CHECK(
        (contains(run.err, stopped + "needs more memory than the scripts of a game may use, 512") ||
         (in_pieces && contains(run.err, stopped + "ran "))));
}

TEST_CASE("many deleted instances with very long paths take no more memory than a game may have",
          "[long]") {
    const Folder folder;
    folder.write("game/main.lua",
                 "local p, n, all = world, ('n'):rep(1000), {} "
                 "for i = 1, 900 do p[n] = Object { } p = p[n] end "
                 "for i = 1, 3000 do all[i] = p:add(Object { }) end "
                 "function step() for i = 1, 1000 do all[#all]:delete() all[#all] = nil end end");
    const Outcome run = fettle(folder,
                               {"run", (folder / "game").string(), "--sandbox", "--headless",
                                "--steps", "3", "--budget", "120000"},
                               limited_memory);
    CAPTURE(run.err);
    CHECK(run.status == 0);
}

TEST_CASE("an error shows the beginning of a local variable with a very long path") {
    const Folder folder;
    const Outcome run = play(folder,
                             "local p, n = world, ('n'):rep(900) "
                             "for i = 1, 500 do p[n] = Object { } p = p[n] end error('here')");
    CHECK(contains(run.err, "main.lua:1: here"));
    CHECK(contains(run.err, "p = world.nnn"));
    CHECK(run.err.size() < 5000);
}

TEST_CASE("a store with very many values is written in a short time") {
    const Folder folder;
    const Outcome run =
        play(folder, "for i = 1, 120000 do store['k' .. i] = i end", {"--budget", "20000"});
    CAPTURE(run.err);
    CHECK(run.status == 0);
}

TEST_CASE("a text that takes long to compile is stopped", "[long]") {
    // Lua compares each name with all local variables of all functions around it, which may be
    // 32767 in Lua 5.4.9.
    const std::string text =
        "local names = {} for i = 1, 190 do names[i] = 'a' .. i end "
        "local text = ('local function f() local ' .. table.concat(names, ',') .. ' '):rep(170) "
        ".. ('x=y '):rep(2000000) ";
    const std::string load =
        GENERATE(as<std::string>{}, "load(text)",
                 "load(function() local all = text text = nil return all end)");
    const Folder folder;
    const Outcome run = play(folder, text + load, {"--budget", "1000"});
    CAPTURE(load, run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.err, "main.lua:1: stopped: it ran for 1 second"));
}

TEST_CASE("a garbage collection that does not come back ends the run", "[long]") {
    // Each weak table is searched again for each key that is found, and Lua runs no hook meanwhile.
    const Folder folder;
    folder.write("game/main.lua", R"(
        local n, part, keys, order, weak = 40000, 1000, {}, {}, {}
        local parts = n // part  -- of one phase; a step makes one, so that a slow machine has the time for it
        function step()
            local phase, first = (time.step - 1) // parts, (time.step - 1) % parts * part + 1
            if time.step == 2 * parts + 1 then collectgarbage("step") end
            for i = first, first + part - 1 do
                if phase == 0 then
                    keys[i], order[i] = {}, i
                elseif phase == 1 then
                    local j = random(i, n)
                    order[i], order[j] = order[j], order[i]
                elseif phase == 2 then
                    weak[i] = setmetatable({}, { __mode = "k" })
                elseif phase == 3 and i < n then
                    weak[order[i]][keys[i]] = keys[i + 1]
                end
            end
            if phase == 4 then
                local kept = keys[1]
                keys = nil
                collectgarbage()
                print(kept)
            end
        end)");
    const Outcome run = fettle(folder, {"run", (folder / "game").string(), "--sandbox",
                                        "--headless", "--steps", "200", "--budget", "400"});
    CHECK(run.status == 1);
    CHECK(contains(run.err, "did not come back for 6 seconds"));
}

TEST_CASE("a hostile file is a message and the game goes on") {
    const Folder folder;
    const auto [name, content, code,
                reason] = GENERATE(table<std::string, std::string, std::string, std::string>({
        {"a.ttf", "\0\1\0\0",
         "game.t = Text { text = 'x', font = 'a.ttf' } print(game.t.text_width)", "is not a font"},
        {"a.png", "\x89PNG\r\n", "game.s = Sprite { image = 'a.png' } print(game.s.image_width)",
         "cannot be read as PNG"},
        {"a.json", R"({"frames": [], "meta": {"image": "a.json"}})",
         "game.s = Sprite { image = 'a.json' } print(game.s.image_width)", "a.json"},
        {"a.tmj",
         R"({"type": "map", "orientation": "orthogonal", "width": 1000000000, "height": 1,
                 "tilewidth": 16, "tileheight": 16, "layers": [], "tilesets": []})",
         "game.m = Tilemap { map = 'a.tmj' } print(game.m.size)",
         "expected an integer from 0 to 65536, got 1000000000"},
        {"a.tmx",
         "<?xml version=\"1.0\"?><!DOCTYPE m [<!ENTITY a SYSTEM \"file:///etc/passwd\">]>"
         "<map><properties><property name=\"x\" value=\"&a;\"/></properties></map>",
         "game.m = Tilemap { map = 'a.tmx' } print(game.m.size)", "a.tmx"},
        {"a.tmx", "<map><layer>", "game.m = Tilemap { map = 'a.tmx' } print(game.m.size)", "a.tmx"},
    }));
    CAPTURE(name, content);
    folder.write("game/" + name, content);
    const Outcome run = play(folder, code + " function step() print('goes on') end");
    CAPTURE(run.out, run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "goes on"));
    CHECK(contains(run.err, reason));
    CHECK_FALSE(contains(run.out + run.err, "root:"));
}

TEST_CASE("the work that a game can cause in the engine is limited") {
    const std::string main = GENERATE(
        as<std::string>{},
        "for i = 1, 3000 do game:add(Emitter { limit = 200000, burst = 200000, lifetime = 1e4 "
        "}) end",
        "game.t = Text { text = ('hello '):rep(10000000), wrap = 3 } print(game.t.text_width)",
        "game.t = Text { text = ('\\n'):rep(10000000) } print(game.t.text_height)",
        "interface.b = Button { text = 'x' } interface.b:on('pressed', function() "
        "interface.b:delete() end) function step() if interface:has('b') then interface.b:focus() "
        "end end",
        "interface.s = Slider { bind = 'interface.t.value' } "
        "interface.t = Slider { bind = 'interface.s.value' }",
        "game.s = Synth { sustain = 10, retrigger = 1e-9, flanger = 50 } "
        "function step() for i = 1, 1000 do game.s:play() end end",
        "local function f() after(0, f) after(0, f) end f()",
        "world.o = Object { } world.o:on('deleted', function() world.o = Object { } "
        "world.o = nil end) world.o = nil",
        "for i = 1, 3000 do world:add(Body { Circle { } }) end",
        "game:run(function() while true do wait(0) end end)");
    CAPTURE(main);
    const Folder folder;
    const Outcome run = play(folder, main);
    CAPTURE(run.err);
    // On a busy machine the time limit may come first.
    CHECK((run.status == 0 || contains(run.err, "stopped: it ran for 2 seconds")));
}

TEST_CASE("files outside of a game are not read") {
    const Folder folder;
    folder.write("secret.json", R"({"secret": "found it"})");
    folder.write("scenes/secret.json", R"({"secret": "found it"})");
    folder.write("secret.lua", "print('found it')");
    folder.write("game/inside.txt", "");
    fs::create_symlink(folder / "secret.lua", folder / "game/link.lua");
    fs::create_symlink(folder / "secret.json", folder / "game/link.json");
    const std::string path =
        GENERATE(as<std::string>{}, "../secret", "../secret.lua", "../secret.json", "link",
                 "link.lua", "link.json", "./../secret.lua", "x/../../secret.lua", "absolute");
    const std::string tried = path == "absolute" ? (folder / "secret.lua").string() : path;
    CAPTURE(path);
    const Outcome run = play(folder, "local p = '" + tried + R"lua('
for _, read in ipairs {
    function() require(p) end,
    function() exec(p) end,
    function() go_to_scene(p) end,
    function() scene.load(p, game) end,
    function() scene.save(p, world) end,
    function() game.t = Tilemap { map = p } print(game.t.size) end,
    function() game.s = Sprite { image = p } print(game.s.image_width) end,
    function() game.f = Text { text = "x", font = p } print(game.f.text_width) end,
    function() game.a = Sound { file = p } game.a:play() end,
} do pcall(read) end)lua");
    CAPTURE(run.out, run.err);
    CHECK_FALSE(contains(run.out + run.err, "found it"));
    CHECK(folder.text("secret.json") == R"({"secret": "found it"})");
    CHECK(folder.text("secret.lua") == "print('found it')");
}

}  // namespace sandboxed_game_test
