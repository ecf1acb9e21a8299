// Shapes that lie flush beside each other act as one: what slides, lands or is pressed there meets
// no side between two of them and no corner in a level floor. Real steps, walls and gaps act as
// always.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "catch.h"
#include "family.h"

namespace flush_tiles_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;
using families::turned;

namespace {

constexpr float dt = 1.0f / 60;

enum class Ground { boxes, bodies, kinematic, overlapping, triangles, concave, segments };
constexpr int grounds = 7;
const char* const ground_names[grounds] = {
    "boxes",     "boxes of many bodies", "kinematic boxes", "overlapping boxes",
    "triangles", "concave tiles",        "segments"};
enum class Form { circle, box, rounded, capsule, ellipse, boat, pentagon, octagon, concave };
constexpr int forms = 9;
const char* const form_names[forms] = {"circle", "box",      "rounded box", "capsule", "ellipse",
                                       "boat",   "pentagon", "octagon",     "concave"};

/// A place of a world that is turned as a whole by an angle.
struct Frame {
    Vec2 x{1, 0}, y{0, 1};
    explicit Frame(float angle) : x(turned(angle)), y{-x.y, x.x} {}
    Vec2 operator()(float along, float up) const { return along * x + up * y; }
};

/// A shape whose lowest point is `size` below its center.
void add_form(Body body, Form form, float s, const ShapeDef& def) {
    if (form == Form::circle) body.add(Circle{.radius = s}, def);
    if (form == Form::box) body.add(Box{.width = 2 * s, .height = 2 * s}, def);
    if (form == Form::rounded)
        body.add(Box{.width = 2 * s, .height = 2 * s, .rounding = 0.3f * s}, def);
    if (form == Form::capsule)
        body.add(Segment{.from = {0, -0.5f * s}, .to = {0, 0.5f * s}, .rounding = 0.5f * s}, def);
    if (form == Form::ellipse) body.add(Ellipse{.radius_x = 1.5f * s, .radius_y = s}, def);
    const auto add = [&](std::vector<Vec2> points) {
        for (Vec2& p : points) p = s * p;
        body.add(Polygon{.vertices = points}, def);
    };
    if (form == Form::boat)
        add({{-0.6f, -1}, {0.6f, -1}, {1, -0.7f}, {1, 1}, {-1, 1}, {-1, -0.7f}});
    if (form == Form::pentagon) add({{0, -1}, {1, -0.6f}, {1, 1}, {-1, 1}, {-1, -0.6f}});
    if (form == Form::octagon)
        add({{-0.4f, -1},
             {0.4f, -1},
             {1, -0.4f},
             {1, 0.4f},
             {0.4f, 1},
             {-0.4f, 1},
             {-1, 0.4f},
             {-1, -0.4f}});
    if (form == Form::concave)
        body.add(Concave{.vertices = {{-s, -s},
                                      {s, -s},
                                      {s, s},
                                      {0.6f * s, s},
                                      {0.6f * s, -0.5f * s},
                                      {-0.6f * s, -0.5f * s},
                                      {-0.6f * s, s},
                                      {-s, s}}},
                 def);
}

/// A floor of tiles whose upper side is at height 0 from `low` to `high`.
void add_ground(World& world, Ground kind, const Frame& at, float angle, float low, float high,
                float width) {
    const ShapeDef def{.friction = 0};
    const BodyType type =
        kind == Ground::kinematic ? BodyType::kinematic_body : BodyType::static_body;
    Body ground = world.create_body({.type = type, .angle = angle});
    const auto corner = [&](float x, float y) { return Vec2{x, y}; };
    for (int i = 0; low + float(i) * width < high; ++i) {
        const float x = low + float(i) * width, to = low + float(i + 1) * width;
        if (kind == Ground::bodies || kind == Ground::kinematic) {
            Body tile = world.create_body(
                {.type = type, .position = at(x + 0.5f * width, -0.5f), .angle = angle});
            tile.add(Box{.width = width, .height = 1}, def);
        } else if (kind == Ground::boxes || kind == Ground::overlapping) {
            const float more = kind == Ground::overlapping ? 0.02f : 0.0f;
            ground.add(Box{.width = width + more,
                           .height = i % 2 != 0 ? 1.0f : 1.4f,
                           .center = {x + 0.5f * width, i % 2 != 0 ? -0.5f : -0.7f}},
                       def);
        } else if (kind == Ground::triangles) {
            ground.add(Polygon{.vertices = {corner(x, 0), corner(x, -1), corner(to, -1)}}, def);
            ground.add(Polygon{.vertices = {corner(x, 0), corner(to, -1), corner(to, 0)}}, def);
        } else if (kind == Ground::concave) {
            const float third = width / 3;
            ground.add(Concave{.vertices = {corner(x, 0), corner(x, -1), corner(x + third, -1),
                                            corner(x + third, -0.5f), corner(to - third, -0.5f),
                                            corner(to - third, -1), corner(to, -1), corner(to, 0)}},
                       def);
        } else {
            ground.add(Segment{.from = corner(x, 0), .to = corner(to, 0)}, def);
        }
    }
}

/// A body over a ground of tiles, in a world that is turned.
struct Scene {
    Frame at;
    World world;
    Body body;

    Scene(Ground ground, Form form, float angle, float width, float length, float size, Vec2 place,
          Vec2 velocity, bool locked)
        : at(angle), world({.gravity = at(0, -10)}) {
        add_ground(world, ground, at, angle, -4, length, width);
        body = world.create_body({.position = at(place.x, place.y),
                                  .angle = angle,
                                  .velocity = at(velocity.x, velocity.y),
                                  .locked_rotation = locked});
        add_form(body, form, size, {.friction = 0});
    }
    float speed() const { return body.velocity().dot(at.x); }
    float height() const { return Vec2(body.position()).dot(at.y); }
};

std::string name_of(Ground ground, Form form, unsigned seed) {
    return std::string(form_names[int(form)]) + " on " + ground_names[int(ground)] + ", seed " +
           std::to_string(seed);
}

}  // namespace

TEST_CASE("nothing catches at the seams of flush tiles") {
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        for (int k = 0; k < grounds; ++k) {
            Random random{std::mt19937(31 * seed + unsigned(k))};
            const auto ground = Ground(k);
            const auto form = Form(seed % forms);
            const float angle = seed % 3 == 0 ? 0.0f : random(-3, 3);
            const float size = random(0.15f, 0.6f), speed = random(1, 20);
            const bool locked = seed % 2 == 0 || form == Form::pentagon;
            Scene scene(ground, form, angle, random(0.3f, 1.5f), 2 * speed + 4, size,
                        {0, size + 0.001f}, {speed, 0}, locked);
            float hop = 0;
            for (int i = 0; i < 120; ++i) {
                scene.world.step(dt);
                hop = std::max(hop, scene.height() - size);
            }
            INFO(name_of(ground, form, seed));
            CHECK(std::fabs(scene.speed() / speed - 1) < 0.01f);
            CHECK(hop < 0.02f);
            CHECK(scene.height() > size - 0.02f);
        }
    }
}

TEST_CASE("what lands beside a seam goes on") {
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        for (int k = 0; k < grounds; ++k) {
            Random random{std::mt19937(37 * seed + unsigned(k))};
            const auto ground = Ground(k);
            const auto form = Form(seed % forms);
            // Deep in a line, a chamfer meets the next part from behind: on a chain as well.
            const bool chamfers =
                form == Form::boat || form == Form::pentagon || form == Form::octagon;
            if (ground == Ground::segments && chamfers) continue;

            const float size = random(0.2f, 0.5f), speed = random(1, 10),
                        width = random(0.4f, 1.5f);
            const float x = random(-size, size), drop = random(0.05f, 0.3f), fall = random(1, 20);
            Scene scene(ground, form, 0, width, 2 * speed + 4, size, {x, size + drop},
                        {speed, -fall}, true);
            for (int i = 0; i < 60; ++i) scene.world.step(dt);
            INFO(name_of(ground, form, seed));
            CHECK(std::fabs(scene.speed() / speed - 1) < 0.03f);
            CHECK(std::fabs(scene.height() - size) < 0.03f);
        }
    }
}

TEST_CASE("a player who is held to a wall of tiles jumps as beside a smooth wall") {
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        Body wall = world.create_body({.type = BodyType::static_body});
        const float width = random(0.4f, 1.5f), size = random(0.2f, 0.5f);
        for (float y = -6; y < 12; y += width)
            wall.add(Box{.width = width, .height = width, .center = {0.5f * width, y}},
                     {.friction = 0});
        const auto form = Form(seed % forms);
        Body player = world.create_body({.position = {-1.6f * size, random(-1, 1)},
                                         .velocity = {0, 10},
                                         .locked_rotation = true});
        add_form(player, form, size, {.friction = 0});
        const float start = player.position().y;
        float top = 0;
        for (int i = 0; i < 70; ++i) {
            player.set_velocity({3, player.velocity().y});
            world.step(dt);
            top = std::max(top, float(player.position().y) - start);
        }
        INFO(form_names[int(form)] << ", seed " << seed);
        CHECK(top > 4.9f);
        CHECK(player.position().x < 0);
    }
}

TEST_CASE("steps, walls and gaps of tiles act") {
    for (unsigned seed = 0; seed < seeds_or(120); ++seed) {
        Random random{std::mt19937(seed)};
        const float width = random(0.4f, 1.5f), size = random(0.2f, 0.5f);
        const float speed = random(1, 6);
        const auto form = Form(seed % forms);
        INFO(form_names[int(form)] << ", seed " << seed);
        // A step that a shape meets with its side or in front of its center.
        for (const float rise : {1.5f * size, 3.0f}) {
            World world;
            add_ground(world, Ground::boxes, Frame(0), 0, -8, 0, width);
            Body block = world.create_body({.type = BodyType::static_body});
            for (float y = -1; y < rise; y += 0.5f * rise)
                block.add(Box{.width = 1,
                              .height = std::min(0.5f * rise, rise - y),
                              .center = {std::ceil(8 / width) * width - 7.5f,
                                         y + 0.5f * std::min(0.5f * rise, rise - y)}},
                          {.friction = 0});
            Body body = world.create_body(
                {.position = {-2, size}, .velocity = {speed, 0}, .locked_rotation = true});
            add_form(body, form, size, {.friction = 0});
            for (int i = 0; i < 180; ++i) world.step(dt);
            CHECK(body.velocity().x < 0.1f * speed);
            CHECK(body.position().x < std::ceil(8 / width) * width - 8);
            CHECK(body.position().y > size - 0.05f);
        }
        // A box at a low step, and a ball at a gap.
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        for (int i = -8; i < 8; ++i)
            ground.add(Box{.width = width,
                           .height = 1,
                           .center = {(float(i) + 0.5f) * width, i < 0 ? -0.5f : -0.4f}},
                       {.friction = 0});
        Body box = world.create_body({.position = {-1.5f * size - 0.5f, size},
                                      .velocity = {speed, 0},
                                      .locked_rotation = true});
        add_form(box, Form::box, size, {.friction = 0});
        for (int i = 0; i < 120; ++i) world.step(dt);
        CHECK(std::fabs(box.velocity().x) < 0.1f);
        CHECK(box.position().x < -size + 0.01f);

        World other;
        Body sides = other.create_body({.type = BodyType::static_body});
        for (int i = 0; i < 6; ++i)
            for (const float side : {-1.0f, 1.0f})
                sides.add(Box{.center = {side * (float(i) + 0.7f), -0.5f}}, {.friction = 0});
        Body ball = other.create_body({.position = {-1.5f, 0.1f}, .velocity = {0.5f, 0}});
        ball.add(Circle{.radius = 0.1f}, {.friction = 0});
        for (int i = 0; i < 360; ++i) other.step(dt);
        CHECK(ball.position().y < -1);
    }
}

TEST_CASE("nothing leaves a room of tiles") {
    int inside = 0, bodies = 0;
    for (unsigned seed = 0; seed < seeds_or(40); ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        const float width = random(0.2f, 1);
        const float high = std::ceil(8 / width) * width - 4;
        const auto ground = Ground(seed % grounds);
        add_ground(world, ground, Frame(0), 0, -4, high - 0.5f * width, width);
        Body walls = world.create_body({.type = BodyType::static_body});
        for (float y = -width; y < 20; y += width)
            for (const float x : {-4 - 0.5f * width, high + 0.5f * width})
                walls.add(Box{.width = width, .height = width, .center = {x, y + 0.5f * width}});
        std::vector<Body> all;
        for (int i = 0; i < 30; ++i) {
            Body body = world.create_body(
                {.position = {-2.8f + 1.4f * float(i % 5), 1 + 1.4f * float(i / 5)},
                 .angle = random(-3, 3),
                 .velocity = {random(-15, 15), random(-15, 0)},
                 .angular_velocity = random(-10, 10)});
            add_form(body, Form((unsigned(i) + seed) % forms), random(0.15f, 0.45f),
                     {.friction = random(0, 0.8f)});
            all.push_back(body);
        }
        for (int i = 0; i < 300; ++i) world.step(dt);
        for (const Body& body : all) {
            const Position p = body.position();
            inside += int(p.x > -4 && p.x < high && p.y > 0 && p.y < 20);
            ++bodies;
        }
    }
    CHECK(inside == bodies);
}

TEST_CASE("an edit of a tile changes at once what the tile beside it does") {
    for (const bool many : {false, true}) {
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        const auto add_tile = [&](float x) {
            Body body = many ? world.create_body({.type = BodyType::static_body}) : ground;
            return body.add(Box{.width = 2, .height = 1, .center = {x, -0.5f}}, {.friction = 0});
        };
        add_tile(1);
        Shape left = add_tile(-1);
        // The box is 6 cm deep in the floor and 1 cm beyond the seam.
        const Position place = {-0.39f, 0.34f};
        Body box = world.create_body({.position = place, .locked_rotation = true});
        box.add(Box{.width = 0.8f, .height = 0.8f}, {.friction = 0});
        world.set_gravity({0, 0});
        const auto speed_after = [&](int steps) {
            box.set_position(place);
            box.set_velocity({1, 0});
            for (int i = 0; i < steps; ++i) world.step(dt);
            return box.velocity().x;
        };
        CHECK(speed_after(1) > 0.99f);
        left.destroy();
        CHECK(speed_after(1) < 0.1f);  // the side of the right tile
        left = add_tile(-1);
        CHECK(speed_after(10) > 0.99f);
    }
}

TEST_CASE("contacts with flush tiles do not depend on the number of threads") {
    std::vector<uint64_t> hashes;
    for (const int threads : {1, 2, 3}) {
        Random random{std::mt19937(7)};
        World world;
        world.set_threads(threads);
        add_ground(world, Ground::boxes, Frame(0), 0, -40, 40, 0.4f);
        add_ground(world, Ground::concave, Frame(0), 0, 40.4f, 60, 0.7f);
        for (int i = 0; i < 600; ++i) {
            Body body = world.create_body(
                {.position = {-38 + 0.65f * float(i % 150), 0.5f + 0.8f * float(i / 150)},
                 .angle = random(-3, 3),
                 .velocity = {random(-10, 10), random(-10, 0)}});
            add_form(body, Form(i % forms), random(0.1f, 0.3f), {.friction = random(0, 0.8f)});
        }
        for (int i = 0; i < 120; ++i) world.step(dt);
        hashes.push_back(world.hash());
    }
    CHECK(hashes[0] == hashes[1]);
    CHECK(hashes[0] == hashes[2]);
}

}  // namespace flush_tiles_test
