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
        const float rates[] = {30, 60, 144};
        rate = rates[seed % 3];
        const float x = 6 + random(-0.5f, 0.5f), y = random(3, 5.5f);
        held = world.create_body({.type = BodyType::static_body, .position = {0, 3}});
        held.add(Box{.width = 0.8f, .height = 0.8f});
        free = world.create_body({.position = {x, y}});
        free.add(Box{.width = 0.8f, .height = 0.8f});
        for (Body& body : {std::ref(held), std::ref(free)}) body.set_mass(mass);
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

}  // namespace pulley_ends_test
