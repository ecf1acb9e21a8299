// Hits by kinematic bodies that stop at once: pistons, paddles, flippers. What they hit gets the
// velocity of one impact in the step in which they meet. FETTLE_SEEDS=n: n worlds of each kind.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace kinematic_hits_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

/// Shapes nearer than this touch, m.
constexpr float touch = 0.006f;

/// How often something was told about two shapes.
struct Told {
    size_t begins = 0, hits = 0;
    float speed = 0;  ///< of the last hit

    void add(const Events& events) {
        begins += events.contact_begin.size();
        hits += events.contact_hit.size();
        if (!events.contact_hit.empty()) speed = events.contact_hit.back().speed;
    }
};

/// A paddle that moves for a few steps, and a ball or a box before it.
class Piston {
  public:
    explicit Piston(unsigned seed) : random_{std::mt19937(seed)}, world_({.gravity = {0, 0}}) {
        const float rates[] = {30, 60, 144};
        rate_ = rates[seed % 3];
        steps_ = 1 + int(seed / 3 % 3);
        speed_ = std::exp(random_(std::log(2.0f), std::log(60.0f)));
        restitution_ = seed % 2 ? 0 : random_(0.1f, 1);
        const float size = random_(0.1f, 1), way = speed_ * float(steps_) / rate_;
        gap_ = touch + (way - touch) * random_(0.02f, 0.98f);
        paddle_ = world_.create_body({.type = BodyType::kinematic_body});
        const float half = random_(0.03f, 1);
        paddle_.add(Box{.width = 2 * half, .height = 2},
                    {.friction = 0, .restitution = restitution_});
        body_ = world_.create_body({.position = {half + gap_ + size / 2, random_(-0.3f, 0.3f)},
                                    .bullet = seed / 2 % 2 == 1});
        const ShapeDef surface = {.friction = 0, .restitution = restitution_, .hit_events = true};
        if (seed / 4 % 2)
            body_.add(Circle{size / 2}, surface);
        else
            body_.add(Box{.width = size, .height = size}, surface);
        world_.step(1 / rate_);
        paddle_.set_velocity({speed_, 0});
        for (int i = 0; i < steps_; ++i) step();
    }
    void step() {
        world_.step(1 / rate_);
        told_.add(world_.events());
    }
    void stop() { paddle_.set_velocity({0, 0}); }

    /// From a gap below 2 cm on, the contact of the sub-steps pushes, and it is soft.
    double accuracy() const { return std::fmod(gap_, speed_ / rate_) < 0.021f ? 0.15 : 0.01; }
    float wanted() const { return (1 + restitution_) * speed_; }
    float speed() const { return body_.velocity().x; }
    float spin() const { return body_.angular_velocity(); }
    float paddle_speed() const { return speed_; }
    const Told& told() const { return told_; }

  private:
    Random random_;
    World world_;
    Body paddle_, body_;
    float rate_ = 60, speed_ = 0, restitution_ = 0, gap_ = 0;
    int steps_ = 1;
    Told told_;
};

}  // namespace

TEST_CASE("a piston that stops gives the velocity of one impact") {
    for (unsigned seed = 0; seed < seeds_or(600); ++seed) {
        INFO("seed " << seed);
        Piston piston(seed);
        // In the step of the hit, and for ever.
        CHECK(piston.speed() == Approx(piston.wanted()).epsilon(piston.accuracy()));
        CHECK(piston.told().hits == 1);
        CHECK(piston.told().begins == 1);
        CHECK(piston.told().speed == Approx(piston.paddle_speed()).epsilon(0.01));
        piston.stop();
        for (int i = 0; i < 10; ++i) piston.step();
        CHECK(piston.speed() == Approx(piston.wanted()).epsilon(piston.accuracy()));
        CHECK(std::fabs(piston.spin()) < 0.01f * piston.wanted());
        CHECK(piston.told().hits == 1);
        CHECK(piston.told().begins == 1);
    }
}

TEST_CASE("a piston that goes on hits once") {
    for (unsigned seed = 0; seed < seeds_or(300); ++seed) {
        INFO("seed " << seed);
        Piston piston(seed);
        for (int i = 0; i < 10; ++i) piston.step();
        CHECK(piston.speed() == Approx(piston.wanted()).epsilon(piston.accuracy()));
        CHECK(piston.told().hits == 1);
        CHECK(piston.told().begins == 1);
    }
}

TEST_CASE("a flipper that turns for a step or two throws a ball") {
    double least = 9, most = 0;
    for (unsigned seed = 0; seed < seeds_or(300); ++seed) {
        Random random{std::mt19937(seed)};
        const float rates[] = {60, 120, 240}, rate = rates[seed % 3];
        const int steps = 1 + int(seed / 3 % 3);
        const float angle = random(0.05f, 1), turn = angle / float(steps);
        const float radius = random(0.05f, 0.2f), distance = random(0.3f, 1);
        World world({.gravity = {0, 0}});
        Body flipper = world.create_body({.type = BodyType::kinematic_body});
        flipper.add(Box{.width = 2.4f, .height = 0.1f}, {.friction = 0});
        const float gap = std::max(random(0.1f, 0.9f) * distance * std::sin(angle), touch);
        Body ball = world.create_body(
            {.position = {distance, 0.05f + radius + gap}, .bullet = seed % 2 == 1});
        ball.add(Circle{radius}, {.friction = 0, .hit_events = true});
        world.step(1 / rate);
        flipper.set_angular_velocity(turn * rate);
        Told told;
        for (int i = 0; i < steps; ++i) {
            world.step(1 / rate);
            told.add(world.events());
        }
        INFO("seed " << seed);
        const float wanted = turn * rate * distance, speed = ball.velocity().length();
        // The lever arm changes a little on the way.
        CHECK(speed > 0.65f * wanted);
        CHECK(speed < 1.6f * wanted);
        if (wanted > 1.5f) CHECK(told.hits >= 1);  // the threshold is 1 m/s
        if (wanted > 1.5f && steps == 1) CHECK(told.hits == 1);
        flipper.set_angular_velocity(0);
        for (int i = 0; i < 3; ++i) world.step(1 / rate);
        CHECK(ball.velocity().length() == Approx(speed).epsilon(0.01));
        least = std::min(least, double(speed / wanted));
        most = std::max(most, double(speed / wanted));
    }
    std::printf("flippers of a few steps: %.2f to %.2f of the speed of their surface\n", least,
                most);
}

TEST_CASE("a crate that stands on the ground is hit by a piston") {
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        world.create_body({.type = BodyType::static_body})
            .add(Box{.width = 200, .height = 1, .center = {0, -0.5f}}, {.friction = 0});
        const float speed = random(4, 30), size = random(0.3f, 1), way = speed / 60;
        Body piston = world.create_body({.type = BodyType::kinematic_body, .position = {0, 0.6f}});
        piston.add(Box{.width = 0.4f, .height = 1}, {.friction = 0});
        const float gap = random(0, 0.9f) * std::max(way - 0.01f, 0.0f);
        Body crate = world.create_body({.position = {0.2f + gap + size / 2, size / 2}});
        crate.add(Box{.width = size, .height = size}, {.friction = 0});
        world.step(1.0f / 60);
        piston.set_velocity({speed, 0});
        world.step(1.0f / 60);
        piston.set_velocity({0, 0});
        for (int i = 0; i < 6; ++i) world.step(1.0f / 60);
        INFO("seed " << seed);
        CHECK(crate.velocity().x == Approx(speed).epsilon(0.05));
    }
}

TEST_CASE("a piston does not catch what slides over a train of flush boxes") {
    for (unsigned seed = 0; seed < seeds_or(100); ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        const float train = random(0.5f, 20), speed = random(5, 30), width = random(0.4f, 1.5f);
        const bool one_body = seed % 2 == 0;
        Body body;
        for (int i = -20; i < 40; ++i) {
            if (i == -20 || !one_body)
                body =
                    world.create_body({.type = BodyType::kinematic_body, .velocity = {train, 0}});
            body.add(Box{.width = width, .height = 1, .center = {width * float(i), -0.5f}},
                     {.friction = 0});
        }
        Body box = world.create_body(
            {.position = {0, 0.25f}, .velocity = {train + speed, 0}, .locked_rotation = true});
        box.add(Box{.width = 0.5f, .height = 0.5f}, {.friction = 0});
        const int steps = int(15 * width / speed * 60);
        for (int i = 0; i < steps; ++i) world.step(1.0f / 60);
        INFO("seed " << seed);
        const float time = float(steps) / 60;
        CHECK(box.position().x == Approx((train + speed) * time).epsilon(0.01));
        CHECK(box.velocity().x == Approx(train + speed).epsilon(0.01));
    }
}

TEST_CASE("callbacks decide about the hit of a piston") {
    for (const bool enabled : {true, false}) {
        World world({.gravity = {0, 0}});
        int calls = 0;
        world.set_before_solve([&](ContactEdit& contact) {
            ++calls;
            contact.enabled = enabled;
        });
        Body piston = world.create_body({.type = BodyType::kinematic_body});
        piston.add(Box{.width = 0.2f, .height = 1});
        Body ball = world.create_body({.position = {0.4f, 0}});
        ball.add(Circle{0.2f});
        world.step(1.0f / 60);
        piston.set_velocity({20, 0});
        world.step(1.0f / 60);
        CHECK(calls == 1);
        CHECK(ball.velocity().x == Approx(enabled ? 20.0f : 0.0f));
        CHECK(world.events().contact_begin.size() == size_t(enabled));
        CHECK(!world.validate());
    }
}

TEST_CASE("an account has the hit of a piston") {
    World world({.gravity = {0, 0}});
    Body piston = world.create_body({.type = BodyType::kinematic_body});
    piston.add(Box{.width = 0.2f, .height = 1});
    Body ball = world.create_body({.position = {0.4f, 0}});
    ball.add(Circle{0.2f});
    world.keep_account(ball.id());
    world.step(1.0f / 60);
    piston.set_velocity({20, 0});
    world.step(1.0f / 60);
    const auto account = world.account(ball.id());
    REQUIRE(account);
    REQUIRE(account->contacts.size() == 1);
    CHECK(account->contacts[0].change.x == Approx(20.0f));
    CHECK(account->rest.length() < 0.001f);
}

}  // namespace kinematic_hits_test
