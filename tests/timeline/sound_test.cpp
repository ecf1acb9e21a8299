// Voices in a game that goes back in time.

#include <catch.h>

#include "playing.h"

namespace sound_timeline_test {

using fettle::app::Playing;

TEST_CASE("voices are where they were when the game goes back") {
    Playing game(R"(
        world.gravity = vec(0, -10)
        world.ball = Body { position = vec(0, 1), Circle { restitution = 0.9 },
                            knock = Synth.hit { decay = 0.4 } }
        world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
        world.ball:on("contact_begin", function() world.ball.knock:play { pitch = 0.8 + random() } end)
        tune = Synth.power_up { loop = true }
        game.count = Object { ended = 0 }
        world.ball.knock:on("finished", function() count.ended = count.ended + 1 end)
        function step()
            if time.step == 20 then tune:play() end
            if time.step % 50 == 0 then world.ball.knock:mutate() world.ball.knock:play() end
            if time.step == 120 then audio:stop(0.3) end
        end
    )");
    game.play(200);
    REQUIRE(game.get("count.ended").integer() > 2);
    for (const std::int64_t step : {190, 100, 101, 60, 25, 130, 2, 200}) game.check(step);
    game.check(45);
    const std::size_t sounding = game.get("audio.voices").list().size();
    CHECK(sounding >= 1);
    game.play(1);
    game.check(45);
    CHECK(game.get("audio.voices").list().size() == sounding);
}

}  // namespace sound_timeline_test
