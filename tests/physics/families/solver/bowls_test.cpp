// Balls that roll and boxes that slide to and fro in bowls of straight edges: they gain no energy.
// FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace bowls_test {

using namespace fettle::physics;

struct Run {
    double most = 0, last = 0;  ///< energy, as a part of that at the start
};

/// Half a minute in a bowl of radius 2 to 20 m. `box`: a box slides without friction.
Run swing(unsigned seed, float rate, bool box) {
    families::Random random{std::mt19937(seed)};
    const float bowl = random(2, 20), edge = random(0.015f, 0.1f), begin = random(0.1f, 1.0f);
    const float ball = random(0.1f, 0.5f), friction = random(0, 1) < 0.5f || box ? 0.0f : 0.6f;
    World world(WorldDef{.solver = seed % 3 == 0 ? Solver::direct : Solver::soft_step});
    Chain chain;
    const int half = int(1.3f * bowl / edge);
    for (int i = -half; i <= half; ++i) {
        const float angle = float(i) * edge / bowl;
        chain.points.push_back({bowl * std::sin(angle), -bowl * std::cos(angle)});
    }
    world.create_body({.type = BodyType::static_body}).add(chain, {.friction = friction});
    const float arm = bowl - ball;
    Body body = world.create_body(
        {.position = {arm * std::sin(begin), -arm * std::cos(begin)}, .angle = box ? begin : 0});
    if (box)
        body.add(Box{.width = 2 * ball, .height = 2 * ball}, {.friction = friction});
    else
        body.add(Circle{.radius = ball}, {.friction = friction});
    for (int i = 0; i < int(rate / 10); ++i) world.step(1 / rate);  // it comes down on its corners
    const auto energy = [&] {
        return double(body.kinetic_energy()) +
               double(body.mass()) * 10 * (double(body.position().y) + double(arm));
    };
    const double start = energy();
    Run run;
    for (int i = 0; i < int(30 * rate); ++i) {
        world.step(1 / rate);
        run.most = std::max(run.most, energy() / start);
    }
    run.last = energy() / start;
    return run;
}

TEST_CASE("a ball that rolls to and fro in a bowl of edges gains no energy") {
    double most = 0, least = 1;
    for (const float rate : {30.0f, 60.0f, 144.0f}) {
        for (unsigned seed = 0; seed < families::seeds_or(24); ++seed) {
            const Run run = swing(seed, rate, false);
            INFO("seed " << seed << ", " << rate << " Hz: " << run.last << " after 30 s");
            // In steps of half a meter, a ball passes edges before it has a contact with them.
            CHECK(run.most < (rate > 30 ? 1.02 : 1.15));
            most = std::max(most, run.most);
            least = std::min(least, run.last);
        }
    }
    std::printf("balls in bowls: at most %.4f of the energy, %.2f after half a minute\n", most,
                least);
}

TEST_CASE("a box that slides to and fro in a bowl of edges gains no energy") {
    double most = 0, least = 1;
    for (const float rate : {30.0f, 60.0f, 144.0f}) {
        for (unsigned seed = 0; seed < families::seeds_or(24); ++seed) {
            const Run run = swing(seed, rate, true);
            INFO("seed " << seed << ", " << rate << " Hz: " << run.last << " after 30 s");
            CHECK(run.most < (rate > 30 ? 1.05 : 1.25));
            most = std::max(most, run.most);
            least = std::min(least, run.last);
        }
    }
    std::printf("boxes in bowls: at most %.4f of the energy, %.2f after half a minute\n", most,
                least);
}

}  // namespace bowls_test
