#include <fettle/physics/mover.h>

#include <cmath>

#include "catch.h"
#include "random.h"
#include "scenes.h"
#include "thorough.h"

// A mover that stands still on ground that moves stays at its place on it.

namespace mover_standing_test {

using namespace scenes;

namespace {

/// Where a mover was on its ground, along it.
struct Stand {
    Mover mover;
    Vec2 velocity = {};
    float least = 1e9f, most = -1e9f;  ///< m
    bool left = false, stepped = false;

    void step(World& world, const Body& ground, float dt, bool counts) {
        velocity.x = 0.0f;
        if (!mover.on_ground()) velocity.y -= 10.0f * dt;
        const Moved moved = mover.move(world, velocity, dt);
        velocity = moved.velocity;
        world.step(dt);
        if (!counts) return;
        left |= !moved.on_ground;
        stepped |= moved.stepped;
        const float place = ground.local_point(mover.position()).x;
        least = std::min(least, place);
        most = std::max(most, place);
    }
};

void add_deck(Body& body, int form) {
    if (form == 0) body.add(Box{.width = 8, .height = 0.4f});
    if (form == 1) body.add(Ellipse{.radius_x = 8, .radius_y = 0.2f});
    if (form == 2)
        for (int i = -4; i < 4; ++i)
            body.add(Box{.width = 1, .height = 0.4f, .center = {float(i) + 0.5f, 0}});
}

}  // namespace

TEST_CASE("a mover that stands on a kinematic platform stays at its place, however that moves") {
    const float rate = GENERATE(20.0f, 30.0f, 60.0f, 144.0f);
    for (unsigned seed = 1; seed <= 50; ++seed) {
        if (!is_tested(seed, 5)) continue;
        Random random{std::mt19937(seed)};
        World world;
        Body deck =
            world.create_body({.type = BodyType::kinematic_body, .angle = random(-0.2f, 0.2f)});
        add_deck(deck, int(seed % 3));
        const float swing = random(0, 0.6f), pace = random(0.5f, 3);
        const float circle = random(0, 3), shake = seed % 4 == 0 ? 1.0f : 0.0f;
        const float place = random(-1.5f, 1.5f), dt = 1 / rate;
        Stand stand{Mover({}, deck.world_point({place, 0.22f}))};
        for (int i = 0; i < int(8 * rate); ++i) {
            const float t = float(i) * dt, settled = i < int(rate) ? 0.0f : 1.0f;
            // So that the platform turns by `swing` to both sides, to within what it was tilted.
            deck.set_angular_velocity(settled * swing * pace * std::cos(pace * (t - 1)));
            deck.set_velocity(settled * (circle * Vec2{std::cos(2 * t), std::sin(2 * t)} +
                                         shake * Vec2{random(-1, 1), random(-1, 1)}));
            stand.step(world, deck, dt, i >= int(rate));
        }
        INFO("seed " << seed << ", " << rate << " Hz");
        CHECK_FALSE(stand.left);
        CHECK_FALSE(stand.stepped);
        CHECK(stand.most - stand.least < 0.003f);
    }
}

TEST_CASE("a mover that stands on a dynamic platform lags by no more than its motion in a step") {
    const float rate = GENERATE(20.0f, 60.0f, 144.0f);
    for (unsigned seed = 1; seed <= 50; ++seed) {
        if (!is_tested(seed, 5)) continue;
        Random random{std::mt19937(seed)};
        World world;
        Body deck = world.create_body({.position = {0, 0}});
        add_deck(deck, 0);
        deck.set_mass(random(300, 1000));
        RevoluteJoint pin;
        float fastest = 0.0f;
        if (seed % 2 == 0) {  // a swing
            for (const float x : {-3.0f, 3.0f})
                world.create_distance_joint({.body_b = deck.id(),
                                             .anchor_a = {x, 5},
                                             .anchor_b = {x, 0},
                                             .max_length = 5,
                                             .hertz = 0});
            fastest = random(0.3f, 2);
            deck.set_velocity({fastest, 0});
        } else {  // a seesaw with a motor
            pin = world.create_revolute_joint({.body_b = deck.id(), .max_motor_torque = 1e6f});
        }
        const float swing = random(0.1f, 0.6f), pace = random(0.5f, 2);
        const float dt = 1 / rate;
        Stand stand{Mover({}, {random(-1.5f, 1.5f), 0.22f})};
        for (int i = 0; i < int(8 * rate); ++i) {
            if (pin) pin.set_motor_speed(swing * pace * std::cos(pace * float(i) * dt));
            stand.step(world, deck, dt, i >= int(rate));
        }
        INFO("seed " << seed << ", " << rate << " Hz");
        CHECK_FALSE(stand.left);
        CHECK_FALSE(stand.stepped);
        CHECK(stand.most - stand.least < 2 * (fastest + 0.2f) * dt + 0.03f);
    }
}

}  // namespace mover_standing_test
