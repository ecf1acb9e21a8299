// Rigid bodies in a program of your own: no tree, no window, no script.

#include <cstdio>
#include <vector>

#include <fettle/physics/world.h>

using namespace fettle::physics;

int main() {
    World world;
    Body ground = world.create_body({.type = BodyType::static_body, .position = {0, -1}});
    ground.add(Box{.width = 40, .height = 2});

    std::vector<Body> tower;
    for (int i = 0; i < 10; ++i) {
        tower.push_back(world.create_body({.position = {0, 0.5f + float(i)}}));
        tower.back().add(Box{.width = 1, .height = 1}, {.friction = 0.6f});
    }
    for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
    std::printf("after 2 s the tower is %.2f m high\n", double(tower.back().position().y) + 0.5);

    Body ball = world.create_body({.position = {-10, 5}, .velocity = {25, 0}});
    ball.add(Circle{.radius = 0.6f}, {.density = 4});
    std::size_t hits = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(1.0f / 60);
        for (const ContactBeginEvent& e : world.events().contact_begin)
            if (e.body_a == ball.id() || e.body_b == ball.id()) ++hits;
    }
    std::printf("the ball hit %zu times; the top lies at %.2f, %.2f\n", hits,
                double(tower.back().position().x), double(tower.back().position().y));
    return tower.back().position().y < 9 ? 0 : 1;
}
