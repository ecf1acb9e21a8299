// Synths in a game: presets, mutations, derived classes.

#include <catch.h>

#include <string>

#include "sound_game.h"

namespace presets_test {

using sound_game::SoundGame;

TEST_CASE("every preset can be heard and equal seeds give equal mutations") {
    const char* script = R"(
        for _, name in ipairs { "coin", "jump", "hit", "explosion", "blip", "power_up" } do
            local synth = Synth[name] { volume = 0.3 }
            local high = 0
            for _, column in ipairs(synth:wave_form(50)) do high = math.max(high, column.y) end
            print(name, high > 0.2 and high < 3, synth.volume, synth.duration < 2)
            local before = synth.frequency
            for _ = 1, 4 do synth:mutate(0.2) end
            print(synth.frequency, synth.decay, synth.slide)
        end
    )";
    SoundGame first, second;
    first.run(script);
    second.run(script);
    CHECK(first.errors.empty());
    CHECK(first.printed == second.printed);
    CHECK_THAT(first.printed, contains("coin\ttrue\t0.3\ttrue"));
    CHECK_THAT(first.printed, contains("power_up\ttrue\t0.3\ttrue"));
    CHECK(first.print("Synth.coin().frequency") == "988.0");
}

TEST_CASE("a preset of a derived class makes an instance of that class") {
    SoundGame game;
    game.run(R"(
        Boom = class("Boom", Synth) { heard = 0, volume = 0.9 }
        function Boom:finished() self.heard = self.heard + 1 end
        game.boom = Boom.explosion { decay = 0.05, sustain = 0 }
        boom:play()
        function Boom.coin() return "its own" end
    )");
    game.turns(30);
    CHECK(game.print("boom.class, boom.volume, boom.frequency, boom.heard, Boom.coin()") ==
          "Boom\t0.9\t160.0\t1\tits own");
    CHECK(game.print("Synth.explosion().class") == "Synth");
    const auto fails = [&](const char* what) {
        return game.print(std::string("select(2, pcall(function() ") + what + " end))");
    };
    CHECK_THAT(fails("Boom:explosion()"), contains("call it with a dot"));
    CHECK_THAT(fails("boom:explosion()"), contains("call it with a dot"));
    CHECK(game.errors.empty());
}

TEST_CASE("the filter of a synth is its low pass") {
    SoundGame game;
    game.run("game.s = Synth { filter = 800 } print(game.s.low_pass) game.s.low_pass = 500");
    CHECK(game.errors.empty());
    CHECK_THAT(game.printed, contains("800.0"));
    CHECK(game.print("game.s.filter") == "500.0");
    CHECK(game.print("(pcall(function() game.s.filter = 5 end))") == "false");
}

TEST_CASE("a synth without references is deleted when its voices end") {
    SoundGame game;
    game.run("Synth.explosion():play()");
    game.run("for i = 1, 200 do Synth {} end");
    game.turns(5);
    CHECK(game.print("#audio.voices") == "1");
    game.turns(80);
    CHECK(game.print("#audio.voices") == "0");
}

}  // namespace presets_test
