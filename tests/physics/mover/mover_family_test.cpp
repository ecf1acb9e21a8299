#include <fettle/physics/mover.h>

#include <cmath>
#include <random>

#include "catch.h"
#include "random.h"
#include "scenes.h"

// Movers in random worlds: wherever they go and however fast, they are never inside of anything.

namespace mover_family_test {

using namespace scenes;

namespace {

class Family {
  public:
    explicit Family(uint32_t seed) : random_(seed) {
        ground();
        for (int i = 0; i < 30; ++i) add_shape();
        for (int i = 0; i < 4; ++i) add_platform();
        for (int i = 0; i < 6; ++i) {
            Body crate = world.create_body({.position = {number(-18, 18), number(4, 9)}});
            crate.add(Box{.width = number(0.5f, 1.2f), .height = number(0.5f, 1.2f)},
                      {.density = 20});
        }
    }

    float number(float low, float high) {
        return low + (high - low) * float(random_() % 10007) / 10006.0f;
    }
    int choice(int count) { return int(random_() % uint32_t(count)); }

    World world{{.bounds = Aabb{{-20, -3}, {20, 30}}}};

  private:
    void ground() {
        Body body = world.create_body({.type = BodyType::static_body});
        if (choice(2) == 0) {
            Chain hills;
            for (int i = 0; i <= 40; ++i)
                hills.points.push_back(
                    {float(i) - 20.0f, number(-1.0f, choice(5) == 0 ? 2.5f : 0.2f)});
            body.add(hills);
        } else {
            for (int i = -20; i < 20; ++i)
                body.add(Box{.width = 1,
                             .height = 1,
                             .center = {float(i) + 0.5f, choice(6) == 0 ? 0.25f : -0.5f}});
        }
    }
    void add_shape() {
        Body body = world.create_body({.type = BodyType::static_body,
                                       .position = {number(-18, 18), number(0, 12)},
                                       .angle = number(-3, 3)});
        switch (choice(6)) {
            case 0:
                body.add(Circle{.radius = number(0.2f, 1.5f)});
                break;
            case 1:
                body.add(Box{.width = number(0.2f, 4), .height = number(0.2f, 2)});
                break;
            case 2:
                body.add(Ellipse{.radius_x = number(0.3f, 2), .radius_y = number(0.3f, 1)});
                break;
            case 3:
                body.add(Segment{.from = {-number(0.5f, 3), 0}, .to = {2, 0}});
                break;
            case 4:
                body.add(
                    Polygon{.vertices = {{-1, 0}, {number(0.5f, 2), 0}, {0, number(0.5f, 3)}}});
                break;
            default:
                body.add(Concave{{{-1, -1}, {1, -1}, {1, 0}, {0, 0}, {0, 1}, {-1, 1}}});
        }
    }
    /// Moves freely through everything, and slowly enough for a mover to give way.
    void add_platform() {
        Body body = world.create_body({.type = BodyType::kinematic_body,
                                       .position = {number(-18, 18), number(3, 12)},
                                       .velocity = {number(-2, 2), number(-1, 1)},
                                       .angular_velocity = number(-0.5f, 0.5f)});
        body.add(Box{.width = number(1, 4), .height = 0.4f});
    }

    std::mt19937 random_;
};

/// How deep the mover is in static bodies, or in kinematic ones as well; one-sided shapes that it
/// passes do not count. Dynamic bodies do not see a mover that has no body.
float depth(const Mover& mover, const World& world, bool of_kinematic) {
    float least = 0.0f;
    for (const MoverPlane& plane : mover.planes(world, 0.0f))
        if (plane.shape.body().type() <=
            (of_kinematic ? BodyType::kinematic_body : BodyType::static_body))
            least = std::min(least, plane.separation);
    return -least;
}

}  // namespace

TEST_CASE("movers in random worlds are never inside of anything") {
    int steps = 0, on_ground = 0, crushed = 0;
    for (uint32_t seed = 1; seed <= 50; ++seed) {
        Family family(seed);
        MoverDef def;
        def.radius = family.number(0.2f, 0.5f);
        def.height = def.radius * family.number(2, 5);
        Mover mover(def, {family.number(-15, 15), 14});
        while (!mover.fits(family.world, def.height))
            mover.set_position({family.number(-15, 15), family.number(13, 20)});
        Vec2 velocity = {};
        bool squeezed = false;
        for (int i = 0; i < 400; ++i) {
            if (i % 20 == 0) {
                velocity.x = family.number(-8, 8);
                if (family.choice(3) == 0) velocity.y = family.number(0, 10);
                if (family.choice(12) == 0)
                    velocity = {family.number(-300, 300), family.number(-300, 300)};
            }
            velocity.y -= mover.on_ground() ? 0.0f : 10.0f * frame;
            const Moved moved = mover.move(family.world, velocity, frame);
            velocity = moved.velocity;
            family.world.step(frame);
            ++steps;
            on_ground += moved.on_ground;
            crushed += moved.crushed;
            squeezed = (squeezed && depth(mover, family.world, true) > 0.0f) || moved.crushed;
            INFO("seed " << seed << " step " << i << " at " << mover.position().x << ", "
                         << mover.position().y);
            REQUIRE(std::isfinite(mover.position().x));
            REQUIRE(std::fabs(mover.position().x) < 20.5f);
            if (!squeezed) REQUIRE(depth(mover, family.world, false) < 0.005f);
            if (!squeezed) REQUIRE(depth(mover, family.world, true) < 0.1f);
        }
    }
    CHECK(on_ground > steps / 10);
    CHECK(crushed < steps / 20);
}

TEST_CASE("a mover does not catch on the seams of random tiles") {
    for (uint32_t seed = 1; seed <= 50; ++seed) {
        std::mt19937 random(seed);
        World world;
        float x = -3.0f;
        while (x < 40.0f) {  // tiles of any width, each a body of its own
            const float width = 0.1f + 1.5f * float(random() % 1000) / 1000.0f;
            Body tile = world.create_body(
                {.type = BodyType::static_body, .position = {x + width / 2, -0.5f}});
            tile.add(Box{.width = width, .height = 1});
            x += width;
        }
        const float speed = 0.5f + 19.0f * float(random() % 1000) / 1000.0f;
        Mover mover({}, {0, 0.01f});
        mover.move(world, {0, -1}, frame);
        const float start = mover.position().x;
        const int count = int(30.0f / (speed * frame));
        Vec2 velocity = {speed, 0};
        for (int i = 0; i < count; ++i) {
            const Moved moved = mover.move(world, velocity, frame);
            INFO("seed " << seed << " speed " << speed);
            REQUIRE(moved.on_ground);
            REQUIRE_FALSE(moved.hit_wall);
            REQUIRE(std::fabs(mover.position().y - 0.01f) < 0.008f);
            velocity = moved.velocity;
        }
        CHECK(mover.position().x - start == Approx(float(count) * speed * frame).epsilon(0.003));
    }
}

TEST_CASE("a body that falls freely falls as fast below a mover as alone") {
    const float drop = GENERATE(0.5f, 2.0f, 10.0f, 20.0f), density = GENERATE(1.0f, 7.0f, 40.0f);
    const bool on_another = GENERATE(false, true);
    World world;
    add_floor(world);
    Body crate = world.create_body({.position = {0, drop + 0.5f}});
    crate.add(Box{.width = 2, .height = 1}, {.density = density});
    if (on_another) {
        Body top = world.create_body({.position = {0, drop + 1.25f}});
        top.add(Box{.width = 1.5f, .height = 0.5f}, {.density = density});
    }
    Mover mover({}, {0, drop + (on_another ? 1.51f : 1.01f)});
    Vec2 velocity = {};
    const int steps = int(std::sqrt(drop / 5.0f) / frame) - 1;
    for (int i = 0; i < steps; ++i) {
        if (!mover.on_ground()) velocity.y -= 10.0f * frame;
        const Moved moved = mover.move(world, velocity, frame);
        velocity = moved.velocity;
        CHECK_FALSE(moved.crushed);
        world.step(frame);
        const float fallen = 10.0f * frame * float(i + 1);
        CHECK(-crate.velocity().y == Approx(fallen).margin(0.1f));
    }
    const float feet = mover.position().y - crate.position().y - (on_another ? 1.0f : 0.5f);
    CHECK(feet > -0.02f);
    CHECK(feet < 0.25f);
}

TEST_CASE("a mover does not throw the light bodies on whose edge it stands") {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        add_floor(world, 100.0f);
        const float density = random(0.3f, 5), walk = random(1, 6);
        float top = 0;
        if (seed % 3 == 0) {  // a seesaw
            top = random(0.5f, 1.5f);
            Body board = world.create_body({.position = {0, top}});
            board.add(Box{.width = random(3, 8), .height = 0.2f}, {.density = 4 * density});
            world.create_revolute_joint({.body_b = board.id(), .anchor_a = {0, top}});
            top += 0.1f;
        } else {  // a stack
            const int crates = 1 + int(seed % 5);
            const float width = random(0.7f, 2), height = random(0.5f, 1);
            for (int i = 0; i < crates; ++i, top += height) {
                Body crate = world.create_body({.position = {0, top + 0.5f * height}});
                crate.add(Box{.width = width, .height = height}, {.density = density});
            }
        }
        Mover mover({}, {0, top + 0.02f});
        Vec2 velocity = {};
        const float fall = std::sqrt(2 * 10 * (top + 1));
        for (int i = 0; i < 240; ++i) {
            velocity.x = i < 30 ? 0 : walk;
            if (!mover.on_ground()) velocity.y -= 10.0f * frame;
            velocity = mover.move(world, velocity, frame).velocity;
            world.step(frame);
            for (const Body& body : world.bodies()) {
                INFO("seed " << seed << ", step " << i << ", body " << body.index());
                const float most = fall + walk + 2;
                REQUIRE(body.kinetic_energy() < 0.5f * body.mass() * most * most);
            }
        }
    }
}

TEST_CASE("a mover that pushes a crate stays in touch with it") {
    const float walk = GENERATE(1.5f, 3.0f, 6.0f), density = GENERATE(1.0f, 10.0f, 60.0f);
    World world;
    add_floor(world, 200.0f);
    Body crate = add_box(world, {1, 0.4f}, 0.8f);
    crate.shapes().front().set_density(density);
    Mover mover({}, {0, 0.01f});
    Vec2 velocity = {};
    for (int i = 0; i < 240; ++i) {
        velocity.x = walk;
        if (!mover.on_ground()) velocity.y -= 10.0f * frame;
        const Moved moved = mover.move(world, velocity, frame);
        velocity = moved.velocity;
        world.step(frame);
        if (i < 60) continue;
        CHECK(moved.hit_wall);
        CHECK(crate.position().x - 0.4f - mover.position().x - 0.4f < 0.02f);
        CHECK(moved.motion.x > 0.75f * walk * frame);
    }
}

TEST_CASE("a mover that two leaning walls squeeze is not thrown to the end of their wedge") {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        const float lean = random(0.002f, 0.05f), squeezed = random(0.01f, 0.06f);
        for (const float side : {-1.0f, 1.0f}) {
            Body wall = world.create_body({.type = BodyType::static_body,
                                           .position = {side * (0.9f - 0.5f * squeezed), 0},
                                           .angle = -side * lean});
            wall.add(Box{.width = 1, .height = 200});
        }
        Mover mover(MoverDef{.radius = 0.4f, .height = 0.8f}, {0, -0.4f});
        for (int step = 0; step < 20; ++step) {
            const Position before = mover.position();
            mover.move(world, {random(-4, 4), random(-4, 0)}, 1.0f / 60);
            INFO("seed " << seed << ", step " << step);
            REQUIRE((mover.position() - before).length() < 1);
        }
    }
}

}  // namespace mover_family_test
