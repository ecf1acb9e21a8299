// Recordings: the external input of a run, and the equality of its replay.

#include "catch.h"

#include <fstream>
#include <iterator>

#include <fettle/app/recording.h>

#include "comma_locale.h"
#include "playing.h"
#include "temporary_folder.h"

namespace recording_test {

using namespace fettle;
using namespace fettle::app;

namespace {

constexpr const char* game = R"(
    world.ball = Body { position = vec(0, 10), Circle {} }
    pressed = 0
    function key_pressed(key) pressed = pressed + 1; world.ball.velocity = vec(random(), 5) end
    function update(dt) world.ball.seen = dt end
)";

struct File {
    TemporaryFolder folder;
    std::filesystem::path path = folder.path / "recording";
    std::string text() const {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void write(const std::string& text) const {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
    }
};

/// Frames of different length, events, commands and an edit of the inspector.
void record(const File& file, int frames, std::uint64_t hash_steps = 1) {
    Playing playing(game);
    RunStart start;
    start.game = "game";
    Recorder recorder(start);
    recorder.write_to(file.path, hash_steps);
    playing.runtime->on_command([&](std::string_view command) { recorder.command(command); });
    recorder.begin(playing.tree, *playing.loop);
    for (int i = 0; i < frames; ++i) {
        if (i % 10 == 3) {
            InputEvent event;
            event.kind = i % 20 == 3 ? EventKind::key_pressed : EventKind::key_released;
            event.name = "space";
            playing.loop->handle(event);
        }
        if (i == 20) playing.console("world.ball.mass = 3 -- \"quoted\"");
        if (i == 30) {
            const property::Tree::CauseScope cause(playing.tree, property::Writer::inspector);
            property::set(playing.tree, "world.ball.gravity_scale", 0.5);
        }
        playing.loop->frame(0.011 + 0.001 * (i % 13));
    }
}

struct Result {
    std::uint64_t steps;
    std::string difference;
    double y;
};

Result replay(const File& file, std::string_view script = game) {
    const Recording recording(file.path);
    Playing playing(script);
    Replay replay(recording, playing.tree, *playing.runtime, *playing.loop);
    while (replay.frame()) {
    }
    return {replay.steps(), replay.difference(), playing.get("world.ball.position.y").number()};
}

}  // namespace

TEST_CASE("the replay of a recorded run is equal to the run") {
    const File file;
    record(file, 100);
    const Result result = replay(file);
    REQUIRE(result.difference.empty());
    REQUIRE(result.steps == Recording(file.path).steps());
    REQUIRE(result.steps > 80);
}

TEST_CASE("a recording does not depend on the locale of the program") {
    const File with_comma, with_point;
    record(with_point, 30);
    {
        const CommaLocale comma;
        if (!comma.there()) return;
        CHECK(replay(with_point).difference.empty());
        CHECK(replay(with_point).steps > 20);
        record(with_comma, 30);
    }
    const Result result = replay(with_comma);
    CHECK(result.difference.empty());
    CHECK(result.steps == Recording(with_comma.path).steps());
    CHECK(result.steps > 20);
}

TEST_CASE("a replay reports the first step that differs and the difference") {
    const File file;
    record(file, 60);
    std::string moved = game;
    moved += "function step() if time.step == 33 then world.ball.position = vec(1, 1) end end";
    const Result other = replay(file, moved);
    REQUIRE(other.difference.find("step 33: physics differs") == 0);
    REQUIRE(other.steps == 32);
    std::string added = game;
    added += "function step() if time.step == 20 then game.extra = 1 end end";
    const Result value = replay(file, added);
    REQUIRE(value.difference.find("step 20: values differs") == 0);
}

TEST_CASE("a recording with hashes after every tenth step finds a difference there") {
    const File file;
    record(file, 60, 10);
    REQUIRE(replay(file).difference.empty());
    REQUIRE(replay(file).steps == Recording(file.path).steps());
    std::string moved = game;
    moved += "function step() if time.step == 33 then world.ball.position = vec(1, 1) end end";
    const Result other = replay(file, moved);
    REQUIRE(other.difference.find("step 40: physics differs") == 0);
    REQUIRE(other.steps == 39);
}

TEST_CASE("a run can be written into a file after it has begun with all that came before") {
    const File file, second;
    {
        Playing playing(game);
        RunStart start;
        start.game = "game";
        Recorder recorder(start);
        playing.runtime->on_command([&](std::string_view command) { recorder.command(command); });
        recorder.begin(playing.tree, *playing.loop);
        CHECK(recorder.writes_to().empty());
        for (int i = 0; i < 60; ++i) {
            if (i == 10) playing.console("world.ball.mass = 3");
            if (i == 20) {
                const property::Tree::CauseScope cause(playing.tree, property::Writer::inspector);
                property::set(playing.tree, "world.ball.gravity_scale", 0.5);
            }
            if (i == 30) recorder.write_to(file.path);
            if (i == 40) recorder.close();
            if (i == 50) recorder.write_to(second.path);
            playing.loop->frame(1.0 / 60);
        }
        CHECK(recorder.writes_to() == second.path);
        CHECK(recorder.text() == second.text());
    }
    for (const auto& [each, steps] : {std::pair{&file, 40U}, {&second, 60U}}) {
        CHECK(replay(*each).difference == "");
        CHECK(replay(*each).steps == steps);
        // A replay compares steps from the moment on at which the file was requested.
        const std::string moved = std::string(game) +
                                  "function step() if time.step == 15 then world.ball.position = "
                                  "vec(1, 1) end end";
        CHECK(replay(*each, moved).difference.starts_with("step 31: physics differs"));
    }
}

TEST_CASE("a run that cannot be repeated is not written and its file ends there") {
    const File file;
    Playing playing(game);
    RunStart start;
    start.game = "game";
    Recorder recorder(start);
    recorder.begin(playing.tree, *playing.loop);
    recorder.write_to(file.path);
    playing.loop->frame(1.0 / 60);
    recorder.end("main.lua has changed");
    playing.loop->frame(1.0 / 60);
    CHECK(recorder.writes_to().empty());
    CHECK(recorder.text().empty());
    CHECK(replay(file).steps == 1);
    REQUIRE_THROWS_WITH(recorder.write_to(file.path), contains("main.lua has changed"));
    CHECK(replay(file).steps == 1);
}

TEST_CASE("a recording that was cut off replays the run up to there") {
    const File file;
    record(file, 50);
    const std::string text = file.text();
    const std::size_t begin = text.find("begin\n") + 6;
    for (std::size_t size = begin; size < text.size(); size += 97) {
        file.write(text.substr(0, size));
        REQUIRE(replay(file).difference.empty());
    }
}

TEST_CASE("writes of a console command are recorded as the command alone") {
    const File file;
    {
        Playing playing(game);
        RunStart start;
        start.game = "game";
        Recorder recorder(start);
        recorder.write_to(file.path);
        playing.runtime->on_command([&](std::string_view command) { recorder.command(command); });
        recorder.begin(playing.tree, *playing.loop);
        for (const char* command :
             {"world.hand = MouseJoint { body = world.ball }", "world.ball:delete()", "undo",
              "world.hand:delete()", "undo", "redo", "undo", "undo", "undo"}) {
            playing.console(command);
            playing.loop->frame(0.02);
        }
    }
    const std::string text = file.text();
    CHECK(text.find("\ncommand \"undo\"") != std::string::npos);
    CHECK(text.find("\nwrite ") == std::string::npos);
    CHECK(text.find("\nreset ") == std::string::npos);
    CHECK(replay(file).difference == "");
}

TEST_CASE("undo in a replay takes back the same edit of the inspector as in the run") {
    const File file;
    {
        Playing playing(game);
        RunStart start;
        start.game = "game";
        Recorder recorder(start);
        recorder.write_to(file.path);
        playing.runtime->on_command([&](std::string_view command) { recorder.command(command); });
        recorder.begin(playing.tree, *playing.loop);
        property::Tree& tree = playing.tree;
        const auto frame = [&] { playing.loop->frame(1.0 / 60); };
        const auto by_inspector = [&](const auto& edit) {
            const property::Tree::CauseScope cause(tree, property::Writer::inspector);
            edit();
        };
        frame();
        // A drag goes on over several frames.
        tree.begin_edit("drag", false);
        for (const double scale : {0.5, 0.6, 0.7}) {
            by_inspector([&] { property::set(tree, "world.ball.gravity_scale", scale); });
            frame();
        }
        tree.end_edit();
        const property::Handle ball = tree.child(tree.child(tree.root(), "world"), "ball");
        by_inspector([&] { tree.remove_ad_hoc(ball, "seen"); });
        playing.console("world.ball.lives = world.ball.seen == nil and 1 or 2");
        frame();
        for (int i = 0; i < 3; ++i) playing.console("undo");
        frame();
        REQUIRE(playing.get("world.ball.gravity_scale").number() == 1);
    }
    const Result result = replay(file);
    REQUIRE(result.difference.empty());
    REQUIRE(result.steps == Recording(file.path).steps());
}

TEST_CASE("the instance that is selected when a command runs is it in the replay") {
    const File file;
    {
        Playing playing(game);
        RunStart start;
        start.game = "game";
        Recorder recorder(start);
        recorder.write_to(file.path);
        playing.runtime->on_command([&](std::string_view command) {
            recorder.selected({playing.runtime->selected()});
            recorder.command(command);
        });
        recorder.begin(playing.tree, *playing.loop);
        playing.runtime->set_selected(playing.get("world.ball").reference());
        for (const char* command : {"it.velocity", "_ + vec(1, 2)", "it.velocity = _"}) {
            playing.console(command);
            playing.loop->frame(0.02);
        }
        REQUIRE(playing.get("world.ball.velocity.x").number() == 1);
    }
    const std::string text = file.text();
    const std::size_t first = text.find("\nselected ");
    CHECK(first < text.find("\ncommand "));
    CHECK(text.find("\nselected ", first + 1) == std::string::npos);
    CHECK(replay(file).difference == "");
}

TEST_CASE("files that are not recordings are refused with a reason") {
    const File file;
    record(file, 5);
    const std::string text = file.text();
    const auto refused = [&](const std::string& content, const char* reason) {
        file.write(content);
        REQUIRE_THROWS_WITH(Recording(file.path), contains(reason));
    };
    refused("", "ends before the run begins");
    refused("hello\nworld\n", "is not a recording");
    refused("fettle-recording 2\n", "of format 2");
    refused(text.substr(0, 30), "ends before the run begins");
    refused(text + "nonsense 1 2 3\n", "is unknown");
    refused(text + "step x\n", "is unknown");
    refused(text + "file\n", "\"file\" has values that cannot be read");
    refused(text + "file \"a.json\" xyz\n", "\"file\" has values that cannot be read");
    refused(text + "overwritten \"a.json\" 12\n", "\"overwritten\" has values that cannot be read");
    refused(text + "write 99 00 \"mass\" 00\n", "is unknown");
    REQUIRE_THROWS_AS(Recording("/nowhere/at all"), RecordingError);
    Recorder recorder(RunStart{});
    REQUIRE_THROWS_AS(recorder.write_to("/nowhere/at all"), RecordingError);
}

TEST_CASE("a recording contains the files of its run and the existing tweaks") {
    const File file;
    RunStart start;
    start.game = "game";
    start.modules = {"/modules/wind.so"};
    start.tweaks = {{"value", "world.ball", "mass", "1 \"line\"\nand another"},
                    {"deleted", "world.wall", ""}};
    {
        Recorder recorder(start);
        recorder.write_to(file.path);
        recorder.file({.name = "main.lua", .checksum = 0x1234});
        recorder.file({.name = "main.tweaks.json"});
        recorder.file({.name = "a b.json", .overwritten = true, .content = "{\n\t\"x\": 1}\n"});
        recorder.file({.name = "new.json", .overwritten = true});
    }
    const Recording recording(file.path);
    CHECK(recording.start().modules == start.modules);
    CHECK(recording.start().tweaks == start.tweaks);
    REQUIRE(recording.files().size() == 4);
    CHECK(recording.files()[0].name == "main.lua");
    CHECK(recording.files()[0].checksum == std::uint64_t{0x1234});
    CHECK_FALSE(recording.files()[1].checksum.has_value());
    CHECK_FALSE(recording.files()[1].overwritten);
    CHECK(recording.files()[2].overwritten);
    CHECK(recording.files()[2].content == "{\n\t\"x\": 1}\n");
    CHECK(recording.files()[3].overwritten);
    CHECK_FALSE(recording.files()[3].content.has_value());
}

}  // namespace recording_test
