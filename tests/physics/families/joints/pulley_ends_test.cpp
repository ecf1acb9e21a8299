#include "catch.h"
#include "family.h"
#include "scenes.h"

// A pulley of which one end is held draws the other one to its wheel; then nothing gives way.

namespace pulley_ends_test {

using namespace families;
using namespace scenes;

namespace {

struct Winch {
    explicit Winch(unsigned seed) : random{std::mt19937(seed)} {
        rate = rate_of(seed);
        const float x = 6 + random(-0.5f, 0.5f), y = random(3, 5.5f);
        held = world.create_body({.type = BodyType::static_body, .position = {0, 3}});
        held.add(Box{.width = 0.8f, .height = 0.8f});
        free = world.create_body({.position = {x, y}});
        free.add(Box{.width = 0.8f, .height = 0.8f});
        held.set_mass(mass);
        free.set_mass(mass);
        pulley = world.create_pulley_joint({.body_a = held.id(),
                                            .body_b = free.id(),
                                            .ground_a = {0, 8},
                                            .ground_b = {6, 8},
                                            .ratio = ratio});
        length = pulley.length();
    }

    void run(float seconds) {
        for (float until = time + seconds; time < until; time += 1 / rate) {
            pulley.set_length(std::max(0.1f, length - reel * time));
            world.step(1 / rate);
            fastest = std::max({fastest, free.velocity().length(), held.velocity().length()});
            tension = std::max(tension, pulley.tension());
        }
    }

    /// s, until the free end is at its wheel.
    float way() const { return 5.1f * ratio / reel; }

    Random random;
    float rate = 60, time = 0, fastest = 0, tension = 0, length = 0;
    const float mass = random(0.5f, 20), ratio = random(0.5f, 2.5f), reel = random(0.3f, 2);
    World world;
    Body held, free;
    PulleyJoint pulley;
};

}  // namespace

TEST_CASE("a pulley whose one end is held draws the other one to its wheel and holds it there") {
    for (unsigned seed = 1; seed <= seeds_or(48); ++seed) {
        Winch winch(seed);
        winch.run(winch.way() + 3);
        INFO("seed " << seed << ", ratio " << winch.ratio << ", reel " << winch.reel);
        CHECK(winch.fastest < 4 + 3 * winch.reel / winch.ratio);
        CHECK(winch.tension < 300 * winch.mass / winch.ratio);
        winch.fastest = 0;
        winch.run(2);
        CHECK(winch.fastest < 0.1f);
        CHECK((winch.free.position() - Vec2{6, 8}).length() < 0.01f);
    }
}

TEST_CASE("the end of a pulley that comes free is drawn up and not thrown") {
    for (unsigned seed = 1; seed <= seeds_or(48); ++seed) {
        Winch winch(seed);
        winch.run(winch.way() + 3);
        winch.held.set_type(BodyType::dynamic_body);
        winch.run(4);
        INFO("seed " << seed << ", ratio " << winch.ratio << ", reel " << winch.reel);
        CHECK(winch.fastest < 18.0f);
    }
}

TEST_CASE("a pulley whose light end is at its wheel holds the heavy one") {
    const Solver solver = GENERATE(Solver::soft_step, Solver::direct);
    for (unsigned seed = 1; seed <= seeds_or(48); ++seed) {
        Random random{std::mt19937(seed)};
        const float rate = rate_of(seed);
        World world({.solver = solver});
        Body ends[2];
        for (const int i : {0, 1}) {
            const float size = random(0.3f, 1), y = random(2, 6);
            ends[i] = world.create_body({.position = {6 * float(i), y}});
            ends[i].add(Box{.width = size, .height = size});
            ends[i].set_mass(i == 0 ? random(2, 20) : random(50, 400));
        }
        PulleyJoint pulley = world.create_pulley_joint({.body_a = ends[0].id(),
                                                        .body_b = ends[1].id(),
                                                        .ground_a = {0, 8},
                                                        .ground_b = {6, 8}});
        for (float time = 0; time < 8; time += 1 / rate) world.step(1 / rate);
        INFO("seed " << seed << ", " << rate << " Hz, solver " << int(solver));
        CHECK(pulley.length_now() < pulley.length() + 0.15f);
    }
}

TEST_CASE("a pulley draws lifts that move along one axis only, and along that one alone") {
    for (unsigned seed = 1; seed <= seeds_or(48); ++seed) {
        Random random{std::mt19937(seed)};
        const float rate = rate_of(seed);
        World world;
        Body lifts[2];
        float beside[2];  // m, to the side of its wheel
        for (const int i : {0, 1}) {
            beside[i] = random(-0.5f, 0.5f);
            lifts[i] = world.create_body({.position = {6 * float(i) + beside[i], random(1, 3)},
                                          .locked_x = true,
                                          .locked_rotation = true});
            lifts[i].add(Box{.width = 0.8f, .height = 0.8f});
            lifts[i].set_mass(random(0.5f, 5));
        }
        PulleyJoint pulley = world.create_pulley_joint({.body_a = lifts[0].id(),
                                                        .body_b = lifts[1].id(),
                                                        .ground_a = {0, 8},
                                                        .ground_b = {6, 8},
                                                        .ratio = random(0.7f, 1.5f)});
        world.step(1 / rate);
        pulley.set_length(pulley.length() - random(0.5f, 4));
        for (float time = 0; time < 2; time += 1 / rate) world.step(1 / rate);
        INFO("seed " << seed << ", " << rate << " Hz");
        CHECK(pulley.length_now() < pulley.length() + 0.02f);
        for (const int i : {0, 1})
            CHECK(float(lifts[i].position().x) == Approx(6 * float(i) + beside[i]).margin(1e-5));
    }
}

}  // namespace pulley_ends_test
