// Sounds of a game: their state, which needs no device.

#include <catch.h>

#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include <fettle/property/path.h>

#include "sound_game.h"

namespace sound_test {

using namespace fettle;
using namespace fettle::app;
using sound_game::SoundGame;
using sound_measures::tone_file;

namespace {

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("a voice lives as long as its sound and then the handlers are called") {
    SoundGame game;
    game.run(R"(
        hit = Sound { file = "hit.wav" }
        hit:on("finished", function(event) print("source", event.voice == voice, voice.time) end)
        function start_it()
            voice = hit:play { volume = 0.5, pitch = 2 }
            voice:on("finished", function() print("voice", voice.playing) end)
        end
        start_it()
    )");
    CHECK(game.errors.empty());
    CHECK(game.print("hit.duration, voice.volume, voice.pitch, voice.parent == hit") ==
          "0.25\t0.5\t2.0\ttrue");
    game.printed.clear();
    game.turns(7);  // 7/60 s at twice the pitch: 0.233 s
    CHECK(game.printed.empty());
    CHECK(game.print("voice.time") == "0.2333333333333333");
    game.printed.clear();
    game.turns(1);
    CHECK(game.printed == "voice\tfalse source\ttrue\t0.25");
    CHECK(game.print("voice:alive(), #audio.voices") == "true\t1");
    game.turns(1);
    CHECK(game.print("voice:alive(), #audio.voices, #hit:children()") == "false\t0\t0");
}

TEST_CASE("a voice pauses and loops and is stopped") {
    SoundGame game;
    game.run(R"(hit = Sound { file = "hit.wav", loop = true } a = hit:play() b = hit:play()
                hit:on("finished", function() print("finished") end))");
    game.run("b.playing = false");
    game.turns(60);
    CHECK(game.print("a.time < 0.25, b.time") == "true\t0.0");
    game.run("b.playing = true b.time = 0.2");
    game.turns(1);
    CHECK(game.print("b.time > 0.21 and b.time < 0.22") == "true");
    game.run("a:stop() b:stop(0.1)");
    CHECK(game.print("a:alive(), b:alive()") == "false\ttrue");
    game.turns(3);
    CHECK(game.print("b.fade > 0.45 and b.fade < 0.55") == "true");
    game.turns(4);
    CHECK(game.print("b:alive()") == "false");
    game.run("hit:play() hit:play() hit:stop() hit:play() audio:stop()");
    CHECK(game.print("#audio.voices") == "0");
    CHECK(game.errors.empty());
}

TEST_CASE("nothing passes for voices while the game is paused") {
    SoundGame game;
    game.run("v = Synth.explosion():play() time.paused = true");
    game.turns(10);
    CHECK(game.print("v.time") == "0.0");
    CHECK(game.heard().at(0).rate == 0);
    game.run("time.step_once = true");
    game.turns(1);
    CHECK(game.print("v.time > 0.016 and v.time < 0.017") == "true");
    game.run("time.paused = false time.scale = 0.5");
    CHECK(game.heard().at(0).rate == 0.5);
    CHECK(game.services.audio.state().audible_voices(true).at(0).rate == 0);
}

TEST_CASE("a bus that does not pause and a sound that began in the pause are heard") {
    SoundGame game;
    game.run(R"(
        audio.buses.music.pauses = false
        song = Music { file = "song.wav", loop = false, fade = 0 }
        hit = Sound { file = "hit.wav" }
        engine = Sound { file = "song.wav" }
        s = song:play() e = engine:play()
        time.scale = 0.5
        song:on("finished", function() print("song") end)
        hit:on("finished", function() print("hit") end)
    )");
    game.turns(6);
    game.run("time.paused = true h = hit:play()");
    const auto rates = [&] {
        std::vector<double> all;
        for (const AudibleVoice& each : game.heard()) all.push_back(each.rate);
        return all;
    };
    CHECK(rates() == std::vector<double>{1, 0, 1});
    Mixer mixer;
    mixer.set_voices(game.heard());
    using sound_measures::level;
    CHECK(level(sound_measures::mixed(mixer, 0.2).part(0.05, 0.2).left) > 0.2);
    game.printed.clear();
    game.turns(30);
    CHECK(game.printed == "hit");
    CHECK(game.print("h:alive(), e.time > 0.09 and e.time < 0.11") == "false\ttrue");
    CHECK(game.print("s.time > 0.5 and s.time < 0.61") == "true");
    game.printed.clear();
    game.turns(100);
    CHECK(game.printed == "song");
    CHECK(game.errors.empty());

    // The only voice that is left is paused, so the mixer makes silence.
    Mixer rest;
    rest.set_voices(game.heard());
    CHECK(level(sound_measures::mixed(rest, 0.2).left) == 0);
}

TEST_CASE("nothing is heard while the past is shown") {
    SoundGame game;
    game.run(R"(
        audio.buses.music.pauses = false
        song = Music { file = "song.wav" }
        s = song:play()
    )");
    game.turns(30);
    game.run("time.paused = true time:go_to(10)");
    game.turns(1);
    const std::string then = game.print("s.time");
    CHECK(game.heard().at(0).rate == 0);
    game.turns(30);
    CHECK(game.print("s.time") == then);
    game.run("time:go_to(time.newest)");
    game.turns(1);
    CHECK(game.heard().at(0).rate == 1);
    game.turns(30);
    CHECK(game.print("s.time > 0.9 and s.time < 1.1") == "true");
    game.run("time.paused = false");
    game.turns(5);
    game.run("time:go_to(20)");
    game.turns(1);
    CHECK(game.errors.empty());
}

TEST_CASE("the oldest voice ends when there are too many") {
    SoundGame game;
    game.run(R"(
        hit = Sound { file = "hit.wav", max_voices = 2 }
        song = Music { file = "song.wav" }
        m = song:play() a = hit:play() b = hit:play() c = hit:play()
    )");
    CHECK(game.print("a:alive(), b:alive(), c:alive(), m:alive()") == "false\ttrue\ttrue\ttrue");
    game.run("audio.max_voices = 2 blip = Synth.blip() d = blip:play()");
    CHECK(game.print("b:alive(), c:alive(), d:alive(), m:alive()") == "false\tfalse\ttrue\ttrue");
    game.run("audio.max_voices = 1 e = blip:play()");
    CHECK(game.print("d:alive(), e:alive(), m:alive(), #audio.voices") == "false\ttrue\tfalse\t1");
}

TEST_CASE("music fades over to other music of its bus") {
    SoundGame game;
    game.run(R"(
        one = Music { file = "song.wav", fade = 0.5 }
        two = Music { file = "song.wav", fade = 0.5 }
        speech = Music { file = "song.wav", bus = "effects" }
        a = one:play() s = speech:play()
    )");
    game.turns(60);
    CHECK(game.print("one:play() == a, a.fade, a.time > 0.99") == "true\t1.0\ttrue");
    game.run("b = two:play()");
    game.turns(15);
    CHECK(game.print("a.fade > 0.49 and a.fade < 0.51, b.fade > 0.49 and b.fade < 0.51, s.fade") ==
          "true\ttrue\t1.0");
    game.turns(16);
    CHECK(game.print("a:alive(), b.fade, s:alive()") == "false\t1.0\ttrue");
    game.turns(200);  // longer than the file: it loops
    CHECK(game.print("b:alive()") == "true");
    CHECK(game.errors.empty());
}

TEST_CASE("music that fades out and is played again goes on where it is") {
    SoundGame game;
    game.run(R"(
        one = Music { file = "song.wav", fade = 0.5 }
        two = Music { file = "song.wav", fade = 0.5 }
        a = one:play()
    )");
    game.turns(60);
    game.run("b = two:play()");
    game.turns(15);
    game.run("fade, at = a.fade, a.time again = one:play { volume = 0.7 }");
    CHECK(game.print("again == a, a.fade == fade, a.time == at, a.volume, #one:children()") ==
          "true\ttrue\ttrue\t0.7\t1");
    game.turns(6);  // both turn round: what was louder fades out
    CHECK(game.print("a.fade > fade, a.time > at, b.fade < 0.5") == "true\ttrue\ttrue");
    game.turns(25);
    CHECK(game.print("a.fade, b:alive()") == "1.0\tfalse");
    game.run("one:stop(1) one:play { fade = 0, time = 0.25 }");
    CHECK(game.print("one:play() == a, a.fade_to, a.time") == "true\t1.0\t0.25");
    CHECK(game.errors.empty());
}

TEST_CASE("loudness is that of the source and its voice and its bus and everything") {
    SoundGame game;
    game.run(R"(
        audio.volume = 0.5 audio.buses.effects.volume = 0.5
        audio.buses.speech = Bus { volume = 0.25 }
        a = Sound { file = "hit.wav", volume = 0.5 } a:play { volume = 0.5 }
    )");
    CHECK(game.errors.empty());
    CHECK(game.heard().at(0).loudness.left == 0.0625f);
    game.run("a.bus = 'speech'");
    CHECK(game.heard().at(0).loudness.right == 0.03125f);
    game.run("audio.buses.speech.muted = true");
    CHECK(game.heard().at(0).loudness.left == 0);
    game.run("audio.buses.speech:delete()");  // no bus, no change
    CHECK(game.heard().at(0).loudness.left == 0.125f);
    game.run("audio.muted = true");
    CHECK(game.heard().at(0).loudness.left == 0);
}

TEST_CASE("the loudness of a sound on each side depends on its position") {
    SoundGame game;
    game.run(R"(
        thing = class("Thing") { position = vec(0, 0), angle = 0.0 }
        game.ship = thing { gun = Sound { file = "hit.wav", range = 10 } }
        ship.gun:play()
    )");
    CHECK(game.errors.empty());
    const auto heard = [&] { return game.heard().at(0).loudness; };
    CHECK((heard().left == 1 && heard().right == 1));
    game.run("ship.position = vec(5, 0)");
    CHECK(heard().right == 0.25f);
    CHECK(heard().left == Approx(0.25 * std::sqrt(0.5)));
    game.run("ship.position = vec(-5, 0)");
    CHECK(heard().left == 0.25f);
    CHECK(heard().right < 0.2f);
    game.run("view.center = vec(-5, 0)");
    CHECK((heard().left == 1 && heard().right == 1));
    game.run("ship.gun.position = vec(0, 5) ship.angle = math.pi / 2");
    CHECK(heard().left == Approx(0.25));  // turned to the left
    CHECK(heard().right < 0.2f);
    game.run("ship.position = vec(100, 0)");
    CHECK((heard().left == 0 && heard().right == 0));
    game.run("audio.voices[1].position = vec(-5, 0)");
    CHECK((heard().left == 1 && heard().right == 1));
    // At the right edge of the picture, with the range that a sound has at first.
    game.run(
        "ship.gun.range = 50 audio.voices[1].position = vec(-5 + 10 * view.screen.x / "
        "view.screen.y, 0)");
    CHECK(heard().right > 0.4f);
    CHECK(heard().left == Approx(heard().right / 2));
    game.run("ship.gun.range = 10");
    // What is above is seen on the right, when the view is turned to the left.
    game.run("audio.voices[1].position = vec(-5, 5) view.angle = math.pi / 2");
    CHECK(heard().right == 0.25f);
    CHECK(heard().left < 0.2f);
}

TEST_CASE("errors name the value and the nearest name") {
    SoundGame game;
    game.write("noise.ogg", "this is not a sound");
    game.write("empty.wav", "");
    std::string cut = tone_file(440, 1);
    cut.resize(cut.size() / 4);
    game.write("cut.wav", cut);
    const auto fails = [&](const std::string& chunk, const std::string& message) {
        CHECK_THAT(game.error(chunk), contains(message));
    };
    fails("Sound { file = 'hitt.wav' }",
          "Sound.file: there is no file \"hitt.wav\" (did you mean \"hit.wav\"?)");
    fails("Sound { file = 'noise.ogg' }", "Sound.file: \"noise.ogg\" cannot be played: it is");
    fails("Sound { file = 'empty.wav' }", "\"empty.wav\" cannot be played");
    fails("Sound { file = 'cut.wav' }", "\"cut.wav\" cannot be played: it is damaged");
    fails("Sound { file = '../hit.wav' }", "is not a file below the game's folder");
    fails("Sound { bus = 'efects' }", "audio.buses has no \"efects\" (did you mean \"effects\"?)");
    fails("Sound {}:play()", "it has no file to play: set `file`");
    fails("Synth { sustain = 0, decay = 0 }:play()", "it has no length");
    fails("Sound { range = 0 }", "from 0.001 to 1e6 m");
    fails("Sound { pitch = 0 }", "from 0.01 to 100");
    fails("Synth { frequency = 1e300 }", "from 1 to 20000 Hz");
    fails("Synth { attack = 0/0 }", "Synth.attack");
    fails("Synth { wave = 'sqare' }", "did you mean \"square\"");
    fails("Synth {}:preset('laser')", "there is no preset \"laser\"; there are coin, jump, ");
    fails("Synth {}:preset('coyn')", "there is no preset \"coyn\" (did you mean \"coin\"?)");
    fails("Synth {}:play { pich = 2 }", "there is no argument \"pich\" (did you mean \"pitch\"?)");
    fails("Synth {}:play { pitch = 0 }", "from 0.01 to 100");
    fails("Synth {}:play { fade = -1 }", "fade = -1: expected a time from 0 to 1000 s");
    fails("Synth {}:mutate(2)", "amount = 2: expected a number from 0 to 1");
    fails("Synth.coin(3)", "Synth.coin: takes a table of values");
    fails("Synth {}:wave_form(0)", "columns = 0: expected a number from 1 to 4096");
    fails("game.v = Voice {}", "a voice is a child of the Sound");
    CHECK(game.print("#audio.voices") == "0");
}

TEST_CASE("arguments of a method may be given by name") {
    SoundGame game;
    game.run("blip = Synth.blip() v = blip:play { pitch = 2, time = 0.01 } w = blip:play {}");
    CHECK(game.print("v.pitch, v.time, v.volume, w.pitch") == "2.0\t0.01\t1.0\t1.0");
    game.run("u = blip:play(0.5, 3)");
    CHECK(game.print("u.volume, u.pitch") == "0.5\t3.0");
    game.run("blip:stop { fade = 0.5 }");
    CHECK(game.print("v.fade_time, v.fade_to") == "0.5\t0.0");
    CHECK(game.print("view:to_world { pixels = view:to_screen { point = vec(3, 4) } }") ==
          "vec(3, 4)");
    CHECK(game.errors.empty());
    CHECK_THAT(game.error("view:to_world { pixel = vec(1, 1) }"),
               contains("there is no argument \"pixel\" (did you mean \"pixels\"?)"));
    CHECK_THAT(game.error("view:to_world {}"), contains("expected 1"));
    CHECK_THAT(game.error("blip:play { pitch = 2, 3 }"), contains("play"));
}

TEST_CASE("compressed files are decoded") {
    for (const char* name : {"tests/app/sound/tone.ogg", "tests/app/sound/tone.flac"}) {
        INFO(name);
        const auto file = std::make_shared<const SoundFile>(bytes_of(name));
        CHECK(file->duration() == Approx(0.25).margin(0.001));
        for (const bool decoded : {true, false}) {
            Mixer mixer;
            AudibleVoice heard{.id = 1, .duration = file->duration()};
            if (decoded) heard.samples = file->samples();
            if (!decoded) heard.file = file;
            mixer.set_voices({heard});
            const sound_measures::Signal all = sound_measures::mixed(mixer, 0.4);
            CHECK(sound_measures::frequency(all.part(0.05, 0.2).left) == Approx(440).margin(2));
            CHECK(sound_measures::length(all.left) == Approx(0.25).margin(0.01));
        }
    }
}

TEST_CASE("a file that was cut off is refused") {
    const auto is_refused = [](const std::string& whole, double part) {
        const auto size = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
        CHECK_THROWS_WITH(SoundFile(whole.substr(0, size)), contains("too short for that"));
    };
    is_refused(tone_file(440, 0.05), 0.3);
    for (const double part : {0.3, 0.6, 0.95})
        is_refused(bytes_of("tests/app/sound/tone.flac"), part);
}

TEST_CASE("damaged files are refused or played and never do harm") {
    std::mt19937 random(7);
    const std::vector<std::string> whole = {tone_file(440, 0.05),
                                            bytes_of("tests/app/sound/tone.ogg"),
                                            bytes_of("tests/app/sound/tone.flac")};
    for (int i = 0; i < 900; ++i) {
        std::string bytes = whole[static_cast<std::size_t>(i % 3)];
        for (int changes = 0; changes < 8; ++changes)
            bytes[random() % (i % 2 == 0 ? 44 : bytes.size())] = static_cast<char>(random());
        if (i % 4 == 0) bytes.resize(random() % (bytes.size() + 1));
        try {
            const auto file = std::make_shared<const SoundFile>(bytes);
            if (file->decoded_size() < greatest_decoded) (void)file->samples();
            SoundReader reader(file);
            (void)reader.frame(file->frames() / 2);
            (void)reader.frame(0);
            (void)reader.frame(file->frames() + 5);
        } catch (const std::invalid_argument& refused) {
            CHECK(std::string(refused.what()).size() > 10);
        }
    }
}

TEST_CASE("a sound of more than eight channels is refused") {
    std::string bytes = tone_file(440, 0.05);
    for (const int channels : {0, 9, 64, 255}) {
        bytes[22] = static_cast<char>(channels);
        CHECK_THROWS_AS(SoundFile(bytes), std::invalid_argument);
    }
}

TEST_CASE("a file that is too large when it is decoded is played as music only") {
    SoundGame game;
    game.write("long.wav",
               sound_measures::wave_file(800, 2, 22000, [](unsigned, double) { return 0.0; }));
    CHECK_THAT(game.error("Sound { file = 'long.wav' }"),
               contains("FileError") || contains("larger than 64 MB"));
    const SoundFile silent(
        sound_measures::wave_file(800, 2, 22000, [](unsigned, double) { return 0.0; }));
    CHECK(silent.decoded_size() > greatest_decoded);
}

TEST_CASE("voices are in snapshots and go on in another game") {
    SoundGame game;
    game.run(R"(game.hit = Sound { file = "hit.wav" } hit:play() game.boom = Synth.explosion())");
    game.run("boom:play { position = vec(3, 0) }");
    game.turns(6);
    const std::vector<std::byte> bytes = game.tree.snapshot().to_bytes();
    SoundGame other;
    other.write("hit.wav", tone_file(440, 0.25));
    other.tree.restore(property::Snapshot::from_bytes(bytes));
    other.loop.timeline().clear();
    CHECK(other.print("#audio.voices, hit.voice_1 and hit.voice_1.time or hit.voice.time") ==
          game.print("#audio.voices, hit.voice_1 and hit.voice_1.time or hit.voice.time"));
    for (int i = 0; i < 70; ++i) {
        game.turns(1);
        other.turns(1);
        CHECK(game.loop.hash() == other.loop.hash());
    }
    CHECK(other.print("#audio.voices") == "0");
}

TEST_CASE("nothing can be played when the services of a tree have ended") {
    property::Tree tree;
    {
        const Services services(tree);
        tree.create(tree.class_named("Synth"), tree.root(), "loud");
        const property::Handle loose = tree.create(tree.class_named("Synth"));
        tree.call(loose, "play", {});
        tree.create(tree.class_named("Voice"));
        CHECK(tree.size() > 10);
    }
    CHECK(tree.size() == 1);
    CHECK_FALSE(tree.child(tree.root(), "loud"));
    CHECK_THROWS_WITH(tree.create(tree.class_named("Synth")),
                      contains("it can have no instances any more"));
}

}  // namespace sound_test
