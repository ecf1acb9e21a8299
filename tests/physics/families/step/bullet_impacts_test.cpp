// Bullets that hit discs beside their center, with friction, spin and restitution: both leave as
// the laws of impact say. FETTLE_SEEDS=n: n pairs for each speed.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "family.h"

namespace bullet_impacts_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

/// The velocity of the first disc after an impact by Newton's and Coulomb's laws. `n`: from its
/// center to that of the other one, which has no velocity.
Vec2 velocity_by_law(const Body& first, const Body& second, float r1, float r2, Vec2 n,
                     const ShapeDef& surface) {
    const Vec2 v = first.velocity(), t = {-n.y, n.x};
    const float m1 = first.mass(), m2 = second.mass();
    const float bounce = 1 + (v.dot(n) > 1 ? surface.restitution : 0);
    const float along = bounce * v.dot(n) / (1 / m1 + 1 / m2);
    const float slip = v.dot(t) + first.angular_velocity() * r1 + second.angular_velocity() * r2;
    const float mobility = 1 / m1 + 1 / m2 + r1 * r1 / first.inertia() + r2 * r2 / second.inertia();
    const float most = surface.friction * along;
    const float across = std::clamp(-slip / mobility, -most, most);
    return v + (1 / m1) * (across * t - along * n);
}

/// How far the velocity of a bullet of this speed is from the law, as a part of its speed.
float error_of(Random& random, float speed) {
    World world({.gravity = {0, 0}});
    const ShapeDef surface = {
        .density = random(0.5f, 4), .friction = random(0, 1), .restitution = random(0, 1)};
    const float r1 = random(0.15f, 0.5f), r2 = random(0.15f, 0.5f), reach = r1 + r2;
    const float aside = random(-0.8f, 0.8f) * reach;
    const float start = -random(1, 1.5f) - reach;
    Body bullet = world.create_body({.position = {start, aside},
                                     .velocity = {speed, 0},
                                     .angular_velocity = random(-10, 10),
                                     .bullet = true});
    bullet.add(Circle{r1}, surface);
    Body target = world.create_body({.angular_velocity = random(-10, 10)});
    target.add(Circle{r2}, surface);
    const Vec2 n = (1 / reach) * Vec2{std::sqrt(reach * reach - aside * aside), -aside};
    const Vec2 expected = velocity_by_law(bullet, target, r1, r2, n, surface);
    for (int i = 0; i < int(2.6f / speed * 60) + 8; ++i) world.step(1.0f / 60);
    return (bullet.velocity() - expected).length() / speed;
}

}  // namespace

TEST_CASE("bullets that hit discs beside the center follow the laws of impact") {
    for (const float speed : {5.0f, 10.0f, 20.0f, 60.0f}) {
        Random random{std::mt19937(unsigned(speed))};
        const unsigned count = seeds_or(400);
        float sum = 0, worst = 0;
        for (unsigned i = 0; i < count; ++i) {
            const float error = error_of(random, speed);
            sum += error;
            worst = std::max(worst, error);
        }
        CAPTURE(speed, worst, sum / float(count));
        CHECK(sum < 0.005f * float(count));
        CHECK(worst < 0.05f);
    }
}

}  // namespace bullet_impacts_test
