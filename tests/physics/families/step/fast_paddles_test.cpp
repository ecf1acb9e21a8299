// Thin bodies on paddles that turn by up to one and a half radians in a step: seen from the paddle,
// the way of a body is an arc. FETTLE_SEEDS=n: n worlds of each kind.

#include <fettle/physics/physics.h>

#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace fast_paddles_test {

using namespace fettle::physics;
using families::Random;

namespace {

constexpr float half_length = 1.25f;

/// A thin body that falls on a turning paddle.
class Paddle {
  public:
    Paddle(unsigned seed, bool ellipse) {
        Random random{std::mt19937(seed + 1)};
        const float spin = random(15, 30) * (random(0, 1) < 0.5f ? -1.0f : 1.0f);
        paddle_ = world_.create_body(
            {.type = BodyType::kinematic_body, .angle = random(0, 3), .angular_velocity = spin});
        paddle_.add(Box{.width = 2 * half_length, .height = 0.1f});
        const float x = random(-1, 1), y = random(1.6f, 2.6f);
        body_ = world_.create_body({.position = {x, y}, .angle = random(-3, 3)});
        const float length = random(0.2f, 0.6f);
        if (ellipse)
            body_.add(Ellipse{.radius_x = length / 2, .radius_y = 0.01f});
        else
            body_.add(Box{.width = length, .height = 0.02f});
    }
    /// True if the body changes from one side of the paddle to the other within a step, away from
    /// the ends.
    bool lets_pass(float rate) {
        bool passes = false;
        Vec2 before = paddle_.local_point(body_.world_center());
        for (int step = 0; step < int(1.5f * rate); ++step) {
            world_.step(1 / rate);
            const Vec2 after = paddle_.local_point(body_.world_center());
            if ((after.y > 0) != (before.y > 0) && is_beside(after) && is_beside(before))
                passes = true;
            before = after;
        }
        return passes;
    }

  private:
    static bool is_beside(const Vec2& place) {
        return std::fabs(place.x) < half_length - 0.15f && std::fabs(place.y) < 0.6f;
    }

    World world_;
    Body paddle_, body_;
};

}  // namespace

TEST_CASE("thin bodies do not pass through paddles that turn far in a step") {
    const unsigned seeds = families::seeds_or(400);
    unsigned passed = 0, all = 0;
    for (const bool ellipse : {false, true})
        for (const float rate : {20.0f, 30.0f, 60.0f})
            for (unsigned seed = 0; seed < seeds; ++seed, ++all)
                passed += Paddle(seed, ellipse).lets_pass(rate);
    std::printf("thin bodies on fast paddles: %u of %u through\n", passed, all);
    CHECK(passed <= 1 + all / 200);
}

}  // namespace fast_paddles_test
