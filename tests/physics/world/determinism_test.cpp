#include <random>

#include "catch.h"
#include "scenes.h"

namespace determinism_test {

using namespace scenes;

namespace {

void fill(World& world) {
    for (int i = 0; i < 12; ++i) {
        for (int k = 0; k < 12; ++k) {
            const Vec2 at = {float(i) * 0.9f - 5.0f, 1.0f + float(k) * 0.9f};
            Body body = world.create_body({.position = at, .angle = float(i * k)});
            if ((i + k) % 3 == 0)
                body.add(Circle{.radius = 0.4f}, {.restitution = 0.3f});
            else if ((i + k) % 3 == 1)
                body.add(Box{.width = 0.8f, .height = 0.6f});
            else
                body.add(Polygon{.vertices = {{-0.4f, -0.4f}, {0.5f, -0.2f}, {0, 0.5f}}});
        }
    }
}

/// A busy scene with edits and deletions on the way; the hash after every step.
std::vector<uint64_t> history(int steps) {
    World world({.bounds = Aabb{{-6, 0}, {6, 30}}});
    fill(world);
    std::vector<uint64_t> hashes;
    for (int i = 0; i < steps; ++i) {
        auto bodies = world.bodies();
        if (i % 50 == 20) bodies[size_t(i) % bodies.size()].destroy();
        if (i % 50 == 30) world.create_body({.position = {0, 20}}).add(Circle{});
        if (i % 50 == 40) bodies[3].set_velocity({3, 10});
        world.step(frame);
        hashes.push_back(world.hash());
    }
    REQUIRE_FALSE(world.validate());
    return hashes;
}

}  // namespace

TEST_CASE("the same inputs make the same hash in every step") {
    REQUIRE(history(400) == history(400));
}

TEST_CASE("a copied world goes on as the original does bit for bit") {
    World world({.bounds = Aabb{{-6, 0}, {6, 30}}});
    fill(world);
    run(world, 1.0f);
    const World snapshot = world.clone();
    run(world, 4.0f);
    const uint64_t expected = world.hash();
    World copy = snapshot.clone();
    run(copy, 4.0f);
    REQUIRE(copy.hash() == expected);
    world.restore(snapshot);
    run(world, 4.0f);
    REQUIRE(world.hash() == expected);
    REQUIRE_FALSE(world.validate());
}

namespace {

/// Bodies of concave polygons, compounds and boxes, one of which is edited; `read`: a body is read
/// before.
uint64_t hash_of_mixed(unsigned seed, int edit, bool read) {
    World world;
    world.create_body({.type = BodyType::static_body})
        .add(Box{.width = 20, .height = 1, .center = {0, -0.5f}});
    std::mt19937 engine(seed);
    const auto random = [&](float low, float high) {
        return low + (high - low) * float(engine()) / 4294967296.0f;
    };
    std::vector<Body> bodies;
    for (unsigned i = 0; i < 4; ++i) {
        const float x = random(-2, 2), y = random(0.3f, 3);
        const float angle = seed % 3 == 0 ? 0.0f : random(-3, 3);
        Body body = world.create_body({.position = {x, y}, .angle = angle});
        if (i == 1 && seed % 2 == 0) {
            body.add(Box{.width = 0.6f, .height = 0.2f});
            body.add(Circle{.radius = 0.2f, .center = {0.3f, 0.2f}});
        } else {
            body.add(Concave{{{-0.5f, -0.4f},
                              {0.5f, -0.4f},
                              {0.5f, 0.4f},
                              {0.3f, 0.4f},
                              {0.3f, -0.1f},
                              {-0.3f, -0.1f},
                              {-0.3f, 0.4f},
                              {-0.5f, 0.4f}}});
        }
        bodies.push_back(body);
    }
    if (read) bodies[0].aabb();
    if (edit == 0) bodies[2].set_type(BodyType::static_body);
    if (edit == 1) bodies[2].destroy();
    if (edit == 2) {
        run(world, 0.3f);
        bodies[2].add(Circle{.radius = 0.1f, .center = {0.6f, 0}});
        if (read) bodies[2].mass();
        bodies[2].set_angle(1.0f);
    }
    run(world, 0.7f);
    return world.hash();
}

}  // namespace

// The parts of an outline have slots of their own, and the order of pairs follows from the slots.
// An edit of the angle is no rotation, and where the center of mass moves depends on the angle
// before.
TEST_CASE("reading a world between edits of outlines does not change later bits") {
    for (const int edit : {0, 1, 2}) {
        for (unsigned seed = 0; seed < 40; ++seed) {
            CAPTURE(edit, seed);
            CHECK(hash_of_mixed(seed, edit, false) == hash_of_mixed(seed, edit, true));
        }
    }
}

TEST_CASE("the smallest change of a world changes its hash") {
    World a, b;
    Body x = add_ball(a, {1, 2}), y = add_ball(b, {1, 2});
    REQUIRE(a.hash() == b.hash());
    y.set_position({1, std::nextafter(2.0f, 3.0f)});
    REQUIRE(a.hash() != b.hash());
    REQUIRE(x.position() == Vec2(1, 2));
}

TEST_CASE("two worlds do not affect each other") {
    World a, b({.gravity = {0, 0}});
    Body x = add_ball(a, {0, 0}), y = add_ball(b, {0, 0});
    run(a, 1.0f);
    run(b, 1.0f);
    REQUIRE(x.position().y < -1.0f);
    REQUIRE(y.position() == Vec2(0, 0));
}

namespace {

/// Piles side by side on one floor, five leaning boxes each; the bodies in the order of the piles.
std::vector<Body> piles(World& world, int count) {
    Body floor = world.create_body({.type = BodyType::static_body});
    floor.add(Box{.width = 8000, .height = 2, .center = {0, -1}});
    std::vector<Body> bodies;
    for (int pile = 0; pile < count; ++pile) {
        for (int k = 0; k < 5; ++k) {
            const Vec2 at = {3.0f * float(pile) + 0.13f * float(k % 3), 0.5f + 1.01f * float(k)};
            bodies.push_back(world.create_body({.position = at, .angle = 0.02f * float(k)}));
            bodies.back().add(Box{.width = 1, .height = 1});
        }
    }
    return bodies;
}

}  // namespace

TEST_CASE("a pile falls the same alone and among so many that they are solved in blocks") {
    World one({.sleeping = false}), many({.sleeping = false});
    const auto alone = piles(one, 1), among = piles(many, 1000);
    for (int i = 0; i < 120; ++i) {
        one.step(frame);
        many.step(frame);
        for (size_t k = 0; k < alone.size(); ++k) {
            REQUIRE(alone[k].position() == among[k].position());
            REQUIRE(alone[k].angle() == among[k].angle());
        }
    }
    REQUIRE(many.statistics().touching > 4000);
}

}  // namespace determinism_test
