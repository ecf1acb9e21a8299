// Reads make the physics compute values that edits left out of date. A replay after going back does
// not repeat the reads, so the timeline must know which reads happened between two edits.

#include "catch.h"

#include "playing.h"

namespace reads_test {

using namespace fettle;
using namespace fettle::app;

namespace {

constexpr const char* heap = R"(
    world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
    bodies = {}
    for i = 1, 30 do
        local body = Body { position = vec(i % 6 * 1.05 - 3, 1 + i * 0.9), Box {} }
        world:add(body)
        bodies[i] = body
    end
    local seed = 1
    function pick(n) seed = (seed * 16807) % 2147483647; return seed % n + 1 end
)";

void check_every_step_is_restored(Playing& game) {
    game.play(150);
    for (const int step : {149, 7, 60, 61, 59, 120, 1, 150}) game.check(step);
}

}  // namespace

TEST_CASE("a query between two edits of a step is repeated after going back") {
    Playing game(heap + std::string(R"(
        function step()
            local from, to = pick(30), pick(30)
            bodies[from].position = bodies[from].position + vec(0.3, 0.2)
            bodies[to].box.center = vec(pick(7) * 0.07 - 0.3, pick(7) * 0.05)
            world:raycast(vec(-20, 3), vec(20, 3))
            bodies[pick(30)].position = vec(pick(6) - 3, 20)
            bodies[to].box.center = vec(pick(7) * 0.03 - 0.1, pick(7) * 0.02)
            world:overlap_box(vec(-2, 0), vec(2, 4))
            bodies[to].box.width = 0.8 + pick(5) * 0.1
            bodies[to].box.center = vec(pick(7) * 0.01, 0)
        end
    )"));
    check_every_step_is_restored(game);
}

TEST_CASE("a mass or a velocity read between two edits is repeated after going back") {
    Playing game(heap + std::string(R"(
        for i = 1, 30 do bodies[i].angular_velocity = pick(9) - 5.3 end
        function step()
            local body = bodies[pick(30)]
            body.box.center = vec(pick(7) * 0.07 - 0.3, pick(7) * 0.05)
            local seen = pick(2) == 1 and body.mass or body.velocity
            body.box.center = vec(pick(7) * 0.03 - 0.1, pick(7) * 0.02)
            body.box.density = pick(5)
            seen = body.velocity
            body.center = pick(3) == 1 and vec(0.1, 0.2) or nil
            seen = body.awake
            body.box.center = vec(pick(7) * 0.05, 0.1)
        end
    )"));
    check_every_step_is_restored(game);
}

TEST_CASE("the parts of an outline read between two edits are repeated after going back") {
    Playing game(heap + std::string(R"(
        world.hills = Body { type = "static", position = vec(0, 1), Chain {} }
        world.other = Body { type = "static", position = vec(0, 3), Chain {} }
        function points(n)
            local all = {}
            for i = 1, n do all[i] = vec(i * 1.5 - 8, pick(10) * 0.1) end
            return all
        end
        function step()
            if time.step % 5 ~= 0 then return end
            world.hills.chain.points = points(4 + pick(8))
            local seen = world.hills.chain.aabb, world.other.chain.area
            world.other.chain.points = points(4 + pick(8))
            world.hills.chain.points = points(4 + pick(8))
            world:closest(vec(0, 0))
            world.hills.chain.points = points(4 + pick(8))
        end
    )"));
    check_every_step_is_restored(game);
}

TEST_CASE("bodies made and deleted between queries are the same after going back") {
    Playing game(heap + std::string(R"(
        function step()
            local i = pick(30)
            bodies[i].position = bodies[i].position + vec(0, 0.5)
            bodies[i]:delete()
            local seen = world:at(vec(0, 1))
            bodies[i] = Body { position = vec(pick(6) - 3, 8 + pick(9)), Box { width = 0.9 } }
            seen = bodies[i].mass + bodies[i].velocity.y
            bodies[i].angular_velocity = pick(9) - 5.3
            bodies[i].box.center = vec(0.1, 0)
            seen = bodies[i].inertia
            world:add(bodies[i])
            bodies[i].box.center = vec(0.2, 0)
            seen = bodies[i]:velocity_at(vec(0, 0))
            bodies[i].box.center = vec(0.15, 0.1)
            bodies[i].awake = pick(3) > 1
            seen = world:overlap(bodies[i])
            bodies[i].box.center = vec(pick(5) * 0.1, 0.07)
        end
    )"));
    check_every_step_is_restored(game);
}

TEST_CASE("a query of the console in a paused game is repeated after going back") {
    Playing game(heap);
    game.play(40);
    game.console("for i = 1, 30 do bodies[i].angular_velocity = pick(9) - 5.3 end");
    for (int i = 1; i < 8; ++i) {
        game.console("for i = 1, 30 do bodies[i].box.center = vec(pick(7) * 0.07, 0.1) end");
        game.console("world:raycast(vec(-20, 3), vec(20, 3))");
    }
    game.console("for i = 1, 30 do bodies[i].box.center = vec(0.1, 0) end");
    game.play(60);
    game.check(99);
    game.check(41);
    game.check(100);
}

TEST_CASE("edits and queries in any order are repeated exactly after going back") {
    const int seed = GENERATE(range(1, 13));
    Playing game("picked = " + std::to_string(seed * 7919) + heap + R"(
        seed = picked
        world.hills = Body { type = "static", position = vec(0, 0.2), Chain {} }
        world.rope = DistanceJoint { body_a = bodies[1], body_b = bodies[7] }
        world.pin = RevoluteJoint { body_a = bodies[3], body_b = bodies[9] }
        second = World {}
        game.second = second
        second.floor = Body { type = "static", Box { width = 20 } }
        function some() return bodies[pick(30)] end
        local edits = {
            function() local b = some(); b.position = b.position + vec(0.1, pick(9) * 0.1) end,
            function() some().box.center = vec(pick(9) * 0.05, pick(9) * 0.05) end,
            function() some().box.width = 0.5 + pick(9) * 0.1 end,
            function() some().box.density = pick(5) end,
            function() some().velocity = vec(pick(5) - 3, pick(5)) end,
            function() some().angular_velocity = pick(11) - 6.3 end,
            function() some().angle = pick(60) / 10 end,
            function() some().type = ({"static", "kinematic", "dynamic"})[pick(3)] end,
            function() some().mass = pick(4) == 1 and math.huge or pick(9) end,
            function() some().mass = nil end,
            function() some().center = pick(2) == 1 and vec(pick(9) * 0.02, 0) or nil end,
            function() some().awake = pick(2) == 1 end,
            function() some().locked_rotation = pick(3) == 1 end,
            function() some().box.sensor = pick(5) == 1 end,
            function() some().box.category = pick(3) end,
            function() some():apply_impulse(vec(pick(5) - 3, pick(4))) end,
            function() local b = some(); b:move(b.parent == world and second or world) end,
            function()
                local i = pick(20) + 10
                bodies[i]:delete()
                bodies[i] = Body { position = vec(pick(8) - 4, 4 + pick(9)), Box {} }
                local seen = pick(2) == 1 and bodies[i].mass
                world:add(bodies[i])
            end,
            function()
                local points = {}
                for i = 1, 3 + pick(6) do points[i] = vec(i * 2 - 9, pick(9) * 0.1) end
                world.hills.chain.points = points
            end,
            function() world.rope.length = pick(5) end,
            function() world.pin.enabled = pick(2) == 1 end,
        }
        local asks = {
            function() return some().mass end,
            function() return some().inertia end,
            function() return some().velocity end,
            function() return some().awake end,
            function() return some().box.area end,
            function() return some().box.aabb end,
            function() return world.hills.chain.aabb end,
            function() return some():velocity_at(vec(1, 1)) end,
            function() return world:raycast(vec(-9, pick(9)), vec(9, pick(9))) end,
            function() return world:overlap_box(vec(-2, 0), vec(pick(9), 5)) end,
            function() return world:closest(vec(pick(9), pick(9))) end,
            function() return second:at(vec(pick(9), pick(9))) end,
            function() return world:distance(some(), some()) end,
            function() return world:overlap(some()) end,
        }
        function step()
            for i = 1, 12 do
                if pick(2) == 1 then pcall(edits[pick(#edits)]) else asks[pick(#asks)]() end
            end
        end
    )");
    CAPTURE(seed);
    game.play(90);
    for (const int step : {89, 31, 61, 90}) game.check(step);
}

}  // namespace reads_test
