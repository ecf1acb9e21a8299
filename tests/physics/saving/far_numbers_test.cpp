#include "saved_worlds.h"
#include "world_inside.h"

#include <limits>

namespace far_numbers_test {

// Numbers at the ends of their allowed ranges: every state to which they lead can be saved and
// restored.

using namespace scenes;

namespace {

/// Steps a world, and saves and restores it after each.
void check_saved_in_each_step(World& world, int steps, float dt = frame) {
    for (int i = 0; i < steps; ++i) {
        world.step(dt);
        const auto fault = world.validate();
        INFO("step " << i << ": " << fault.value_or(""));
        REQUIRE_FALSE(fault);
        World back;
        REQUIRE_NOTHROW(back.restore(saved(world)));
        REQUIRE(back.hash() == world.hash());
    }
}

}  // namespace

TEST_CASE("a ratchet whose teeth are too small to be counted holds as one without teeth") {
    for (const float tooth : {1e-40f, std::numeric_limits<float>::denorm_min(), 1e-38f}) {
        for (const bool backwards : {false, true}) {
            World world({.gravity = {0, 0}});
            Body wheel = add_ball(world, {0, 0});
            RatchetJoint ratchet = world.create_ratchet_joint({.body_b = wheel.id()});
            ratchet.set_tooth(tooth);
            ratchet.set_backwards(backwards);
            wheel.set_angular_velocity(backwards ? -5.0f : 5.0f);
            check_saved_in_each_step(world, 10);
            const float caught = ratchet.caught_angle();
            REQUIRE(std::isfinite(caught));
            REQUIRE(std::abs(caught) > 0.1f);
            wheel.set_angular_velocity(backwards ? 5.0f : -5.0f);
            check_saved_in_each_step(world, 30);
            REQUIRE(std::abs(ratchet.angle() - caught) < 0.1f);
        }
    }
}

TEST_CASE("a mouse joint from one end of the world to the other can be saved") {
    World world;
    Body body = add_ball(world, {1e8f, -1e8f});
    body.set_angle(0.7f);
    MouseJoint mouse = world.create_mouse_joint({.body = body.id(), .target = {-1e8f, 1e8f}});
    REQUIRE(Vec2(mouse.anchor()).abs().largest() <= 1e8f);
    REQUIRE_NOTHROW(mouse.set_anchor(mouse.anchor()));
    check_saved_in_each_step(world, 3);
}

TEST_CASE("a body that is stopped while it turns keeps an angle that may be set") {
    World world({.gravity = {0, 0}});
    Body wall = world.create_body({.type = BodyType::static_body});
    wall.add(Box{.width = 0.2f, .height = 40});
    for (const float end : {-1e8f, 1e8f}) {
        Body stick = world.create_body({.position = {-4, 0}, .angle = end});
        stick.add(Box{.width = 0.4f, .height = 0.1f});
        stick.set_velocity({2000, 0});
        stick.set_angular_velocity(end > 0 ? -3e4f : 3e4f);
        check_saved_in_each_step(world, 20);
        REQUIRE(std::abs(stick.angle()) <= 1e8f);
        stick.destroy();
    }
}

TEST_CASE("a body whose time at rest exceeds the largest float sleeps and can be saved") {
    World world({.gravity = {0, 0}, .sleep_delay = 3e38f});
    Body body = add_ball(world, {0, 0});
    check_saved_in_each_step(world, 20, 3e38f);
    REQUIRE_FALSE(body.awake());
    body.set_velocity({1, 0});
    check_saved_in_each_step(world, 2);
    REQUIRE(body.awake());
}

TEST_CASE("a saved world in which a free contact touches is refused") {
    World world;
    add_floor(world);
    Body first = add_ball(world, {0, 0.4f});
    add_ball(world, {4, 0.4f});
    run(world, 0.2f);
    first.destroy();
    REQUIRE(world.contacts().size() == 1);
    detail::WorldData& data = detail::WorldInside::of(world);
    REQUIRE(data.contact_slots.free != detail::none);
    data.contacts[data.contact_slots.free].touching = true;
    const auto bytes = saved(world);
    data.contacts[data.contact_slots.free].touching = false;
    World target;
    REQUIRE_THROWS_WITH(target.restore(bytes), contains("a contact"));
    REQUIRE_NOTHROW(target.restore(saved(world)));
}

}  // namespace far_numbers_test
