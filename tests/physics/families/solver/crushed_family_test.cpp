// Bodies that a kinematic body presses against fixed obstacles: it passes through them, and none is
// pressed through an obstacle. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "catch.h"
#include "family.h"

namespace crushed_family_test {

using namespace fettle::physics;
using families::Random;

namespace {

constexpr float low_wall = -5, high_wall = 5;  // x of the walls, m

enum class Ground { bounds, boxes, segments, chain, tiles, plates };
constexpr int grounds = 6;

/// A box without a lid, 10 m wide.
World container(Ground ground) {
    WorldDef def;
    if (ground == Ground::bounds) def.bounds = Aabb{{low_wall, 0}, {high_wall, 20}};
    World world(def);
    if (ground == Ground::bounds) return world;
    Body body = world.create_body({.type = BodyType::static_body});
    const auto box = [&](float x, float y, float width, float height) {
        body.add(Box{.width = width, .height = height, .center = {x, y}});
    };
    if (ground == Ground::boxes || ground == Ground::plates) {
        const float thick = ground == Ground::boxes ? 1.0f : 0.1f;
        box(0, -0.5f * thick, 12, thick);
        box(low_wall - 0.5f * thick, 10, thick, 20);
        box(high_wall + 0.5f * thick, 10, thick, 20);
    }
    if (ground == Ground::segments) {
        body.add(Segment{{low_wall, 0}, {high_wall, 0}});
        body.add(Segment{{low_wall, 0}, {low_wall, 20}});
        body.add(Segment{{high_wall, 0}, {high_wall, 20}});
    }
    if (ground == Ground::chain)
        body.add(Chain{
            .points = {{low_wall, 20}, {low_wall, 0}, {0, 0}, {high_wall, 0}, {high_wall, 20}}});
    if (ground == Ground::tiles) {
        for (float x = low_wall; x < high_wall; ++x) box(x + 0.5f, -0.5f, 1, 1);
        for (float y = 0; y < 20; ++y) {
            box(low_wall - 0.5f, y + 0.5f, 1, 1);
            box(high_wall + 0.5f, y + 0.5f, 1, 1);
        }
    }
    return world;
}

bool is_lost(const Body& body) {
    const Position p = body.position();
    return p.y < -0.05f || p.x < low_wall - 0.05f || p.x > high_wall + 0.05f;
}

void add_any_shape(Body body, float size, Random& random) {
    switch (int(random(0, 6))) {
        case 0:
            body.add(Circle{size});
            break;
        case 1:
            body.add(Box{.width = 2 * size, .height = random(0.6f, 2) * size});
            break;
        case 2:
            body.add(Segment{{-size, 0}, {size, 0}, size / 3});
            break;
        case 3:
            body.add(Box{.width = 3 * size, .height = 0.2f * size});
            break;
        case 4:
            body.add(Box{.width = 2 * size, .height = 0.4f * size});
            body.add(Box{.width = 0.4f * size, .height = 2 * size});
            break;
        default: {
            Polygon polygon;
            const int corners = int(random(5, 9));
            for (int i = 0; i < corners; ++i) {
                const float angle = 2 * std::numbers::pi_v<float> * float(i) / float(corners);
                polygon.vertices.push_back(size * Vec2{std::cos(angle), std::sin(angle)});
            }
            body.add(polygon);
        }
    }
}

/// Bodies in a container, and a block that passes through the container and then disappears.
struct Crush {
    Random random;
    World world;
    float dt, speed;  ///< s; of the block, m/s
    std::vector<Body> bodies;
    float fastest = 0;  ///< of the bodies while the block passes, m/s

    explicit Crush(unsigned seed, float highest_speed)
        : random{std::mt19937(seed + 1)}, world(container(Ground(seed % grounds))) {
        constexpr float lengths[] = {1 / 60.0f, 1 / 240.0f, 1 / 30.0f};
        dt = lengths[seed / grounds % 3];
        speed = std::exp(random(std::log(0.5f), std::log(highest_speed)));
    }
    void add(Vec2 position, float size, float angle) {
        bodies.push_back(world.create_body({.position = position, .angle = angle}));
        add_any_shape(bodies.back(), size, random);
    }
    void run(float seconds) {
        for (float time = 0; time < seconds - 0.5f * dt; time += dt) {
            world.step(dt);
            for (const Body& body : bodies) fastest = std::max(fastest, body.velocity().length());
        }
    }
    /// Returns the number of lost bodies. `by_position`: the block has no velocity, and its
    /// position is set before each step.
    int pass(Vec2 from, Vec2 direction, Box block, float way, bool by_position = false) {
        Body crusher = world.create_body({.type = BodyType::kinematic_body, .position = from});
        crusher.add(block);
        fastest = 0;
        if (!by_position) {
            crusher.set_velocity(speed * direction);
            run(way / speed);
        }
        for (float gone = 0; by_position && gone < way; gone += speed * dt) {
            crusher.set_position(from + gone * direction);
            run(dt);
        }
        crusher.destroy();
        run(1);
        return int(std::count_if(bodies.begin(), bodies.end(), is_lost));
    }
    /// Bodies that overlap leave each other with 3 m/s, which may add up.
    bool is_thrown() const { return fastest > 2 * speed + 8; }
};

struct Sum {
    int lost = 0, bodies = 0, thrown = 0, worlds = 0;

    void add(const Crush& crush, int lost_bodies) {
        lost += lost_bodies;
        bodies += int(crush.bodies.size());
        thrown += crush.is_thrown();
        ++worlds;
    }
    void print(const char* name) const {
        std::printf("crushed, %s: %d of %d bodies lost, %d of %d worlds throw one\n", name, lost,
                    bodies, thrown, worlds);
    }
};

}  // namespace

TEST_CASE("a single body under a crusher is not pressed through the ground") {
    Sum sum;
    for (unsigned seed = 0; seed < families::seeds_or(360); ++seed) {
        Crush crush(seed, 20);
        const float size = crush.random(0.1f, 0.5f), x = crush.random(-2, 2);
        crush.add({x, size + 0.3f}, size, crush.random(-3, 3));
        const Box block = {.width = crush.random(1, 6), .height = crush.random(0.1f, 2)};
        const float aside = crush.random(-0.3f, 0.3f) * block.width;
        const bool by_position = crush.random(0, 1) < 0.3f;
        sum.add(crush, crush.pass({x + aside, 4}, {0, -1}, block, 8, by_position));
    }
    sum.print("one");
    CHECK(sum.lost <= sum.bodies / 1000);
    CHECK(sum.thrown <= sum.worlds / 1000);
}

TEST_CASE("a heap under a crusher stays in its container") {
    Sum sum;
    for (unsigned seed = 0; seed < families::seeds_or(60); ++seed) {
        Crush crush(seed, 10);
        const int count = 2 + int(crush.random(0, 20));
        for (int i = 0; i < count; ++i)
            crush.add({crush.random(-3, 3), 0.5f + 0.5f * float(i)}, crush.random(0.15f, 0.4f),
                      crush.random(-3, 3));
        crush.run(3);
        sum.add(crush, crush.pass({0, 12}, {0, -1}, {.width = 9.6f, .height = 2}, 14));
    }
    sum.print("heap");
    CHECK(sum.lost <= sum.bodies / 200);
    CHECK(sum.thrown <= std::max(sum.worlds / 50, 1));
}

TEST_CASE("a row of bodies before a ram is not pressed through the wall") {
    Sum sum;
    for (unsigned seed = 0; seed < families::seeds_or(120); ++seed) {
        Crush crush(seed, 30);
        const int count = 1 + int(crush.random(0, 6));
        for (int i = 0; i < count; ++i) {
            const float size = crush.random(0.1f, 0.5f);
            crush.add({4.4f - 1.2f * float(i), size}, size, 0);
        }
        const Box block = {.width = crush.random(0.05f, 2), .height = 2.9f};
        sum.add(crush, crush.pass({-4, 1.5f}, {1, 0}, block, 14));
    }
    sum.print("row");
    CHECK(sum.lost <= sum.bodies / 200);
    CHECK(sum.thrown <= std::max(sum.worlds / 30, 1));
}

TEST_CASE("crates that a lift presses against a ceiling come down with it") {
    int lost = 0, crates = 0;
    const unsigned seeds = families::seeds_or(120);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed + 1)};
        World world;
        world.create_body({.type = BodyType::static_body}).add(Box{.width = 20, .height = 1});
        const float thick = random(0.15f, 0.6f), size = random(0.3f, 0.8f);
        const float speed = random(0.3f, 4), pressed = random(0.3f, 0.8f) * size;
        Body lift = world.create_body({.type = BodyType::kinematic_body, .position = {0, -4}});
        lift.add(Box{.width = 6, .height = thick, .center = {0, -0.5f * thick}});
        std::vector<Body> on_lift;
        for (int i = -2; i <= 2; ++i) {
            const float x = 1.1f * float(i) + random(-0.1f, 0.1f);
            on_lift.push_back(world.create_body({.position = {x, -4 + 0.5f * size}}));
            if (random(0, 1) < 0.3f)
                on_lift.back().add(Circle{.radius = 0.5f * size});
            else
                on_lift.back().add(Box{.width = size, .height = size});
        }
        const int steps = int((3.5f - size + pressed) / speed * 60);
        for (const float sense : {1.0f, -1.0f, 0.0f}) {
            lift.set_velocity({0, sense * speed});
            for (int i = 0; i < steps; ++i) world.step(1 / 60.0f);
        }
        crates += int(on_lift.size());
        for (const Body& crate : on_lift) lost += crate.position().y < lift.position().y - 1;
    }
    std::printf("a lift at a ceiling: %d of %d crates lost\n", lost, crates);
    CHECK(lost <= crates / 10);
}

TEST_CASE("crates that a press held are not thrown when it disappears") {
    int thrown = 0;
    float fastest = 0;
    const unsigned seeds = families::seeds_or(60);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed + 1)};
        World world;
        world.create_body({.type = BodyType::static_body})
            .add(Box{.width = 20, .height = 1, .center = {0, -0.5f}});
        const int count = 2 + int(random(0, 3));
        const float size = random(0.3f, 1), dt = seed % 2 == 0 ? 1 / 60.0f : 1 / 120.0f;
        std::vector<Body> crates;
        for (int i = 0; i < count; ++i) {
            crates.push_back(world.create_body({.position = {0, size * (0.5f + float(i))}}));
            crates.back().add(Box{.width = size, .height = size});
        }
        const float gap = size * (float(count) - random(0.1f, 0.35f)), start = gap + size;
        Body press = world.create_body({.type = BodyType::kinematic_body,
                                        .position = {0, start + 0.5f},
                                        .velocity = {0, -0.5f}});
        press.add(Box{.width = 4, .height = 1});
        while (press.position().y > gap + 0.5f) world.step(dt);
        press.set_velocity({0, 0});
        for (float time = 0; time < 3; time += dt) world.step(dt);
        press.destroy();
        float most = 0;
        for (float time = 0; time < 0.5f; time += dt) {
            world.step(dt);
            for (const Body& crate : crates) most = std::max(most, crate.velocity().length());
        }
        thrown += most > 8;
        fastest = std::max(fastest, most);
    }
    std::printf("a press disappears: %d of %u stacks thrown, at most %.1f m/s\n", thrown, seeds,
                double(fastest));
    CHECK(thrown <= int(seeds + 19) / 20);
}

TEST_CASE("a concave body that a lift pressed against a ceiling does not hang in the lift") {
    const int form = GENERATE(0, 1);
    const unsigned seeds = families::seeds_or(20);
    unsigned fast = 0;  // bodies that stay in the lift while their velocity grows
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed + 1)};
        World world;
        Body fixed = world.create_body({.type = BodyType::static_body});
        fixed.add(Box{.width = 60, .height = 2, .center = {0, -1}});
        fixed.add(Box{.width = 20, .height = 1, .center = {0, 10.5f}});
        const float size = random(0.5f, 1.2f), h = 0.5f * size, q = 0.25f * size;
        const float speed = random(0.5f, 3), aside = random(-1, 1), angle = random(0, 6);
        Body lift = world.create_body(
            {.type = BodyType::kinematic_body, .position = {0, 0.5f}, .velocity = {0, speed}});
        lift.add(Box{.width = 4, .height = 0.4f});
        Body body = world.create_body({.position = {aside, 1.5f}, .angle = angle});
        if (form == 0)  // a U
            body.add(Concave{
                .vertices = {
                    {-h, -h}, {h, -h}, {h, h}, {q, h}, {q, -q}, {-q, -q}, {-q, h}, {-h, h}}});
        else  // an L
            body.add(Concave{.vertices = {{-h, -h}, {h, -h}, {h, -q}, {-q, -q}, {-q, h}, {-h, h}}});
        int held = 0;
        for (int i = 0; i < 900; ++i) {
            const float y = lift.position().y;
            if (held <= 30 && y > 9.6f) lift.set_velocity({0, ++held > 30 ? -2.0f : 0.0f});
            if (held > 30 && y < 5) lift.set_velocity({0, 0});
            world.step(1 / 60.0f);
        }
        fast += body.velocity().length() > 20;  // a fall from the ceiling ends with 14 m/s
    }
    CHECK(fast <= seeds / 20);
}

TEST_CASE("a ram takes along what it crushed as soon as nothing holds it") {
    World world({.gravity = {}});
    Body ram = world.create_body({.type = BodyType::kinematic_body, .velocity = {10, 0}});
    ram.add(Box{.width = 0.1f, .height = 2});
    Body ball = world.create_body({.position = {1, 0}});
    ball.add(Circle{.radius = 0.15f});
    Body wall = world.create_body({.type = BodyType::static_body, .position = {1.65f, 0}});
    wall.add(Box{.height = 2});
    const auto ahead = [&] { return float(ball.position().x - ram.position().x); };
    for (int i = 0; i < 60 && ahead() > 0.1f; ++i) world.step(1 / 240.0f);
    CHECK(ahead() > 0);
    CHECK(ball.position().x < 1.15f);
    wall.destroy();
    ball.set_velocity({9.9f, 0});  // nearly as fast as the ram
    for (int i = 0; i < 240; ++i) world.step(1 / 240.0f);
    CHECK(ahead() > 0);
    CHECK(world.is_touching(ContactId::of(ball.shapes()[0].id(), ram.shapes()[0].id())));
    CHECK(ball.velocity().x >= 9.99f);
}

TEST_CASE("the touch of a crushed body ends and begins again when the two bodies have parted") {
    World world;
    world.create_body({.type = BodyType::static_body})
        .add(Box{.width = 20, .height = 1, .center = {0, -0.5f}});
    Body crate = world.create_body({.position = {0, 0.5f}});
    crate.add(Box{});
    Body press = world.create_body(
        {.type = BodyType::kinematic_body, .position = {0, 3}, .velocity = {0, -1}});
    press.add(Box{.width = 2, .height = 2});
    int begins = 0, ends = 0;
    const auto run = [&](float seconds) {
        for (float time = 0; time < seconds; time += 1.0f / 60) {
            world.step(1.0f / 60);
            const auto with_press = [&](const auto& event) {
                return event.body_a == press.id() || event.body_b == press.id();
            };
            const Events& events = world.events();
            begins += int(std::count_if(events.contact_begin.begin(), events.contact_begin.end(),
                                        with_press));
            ends += int(
                std::count_if(events.contact_end.begin(), events.contact_end.end(), with_press));
        }
    };
    run(2);
    CHECK(begins == 1);
    CHECK(ends == 1);
    CHECK(crate.position().y > 0.4f);
    press.set_velocity({0, 0});
    run(2);
    CHECK(crate.position().y == Approx(0.5f).margin(0.02f));  // the press stands where the crate is
    CHECK_FALSE(crate.awake());
    // What is in the press goes on like the original after it was saved.
    World copy = world.clone();
    press.set_velocity({0, 2});
    copy.body(press.id()).set_velocity({0, 2});
    run(3);
    for (float time = 0; time < 3; time += 1.0f / 60) copy.step(1.0f / 60);
    CHECK(copy.hash() == world.hash());
    CHECK(press.position().y > 5);
    CHECK(crate.position().y == Approx(0.5f).margin(0.02f));
    press.set_velocity({0, -1});
    run(6);
    CHECK(begins == 2);
    CHECK(ends == 2);
}

}  // namespace crushed_family_test
