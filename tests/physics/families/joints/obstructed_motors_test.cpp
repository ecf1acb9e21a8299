// Motors of any strength that press bodies against something fixed, as a lift does below a
// ceiling, and motors that bear a load instead. FETTLE_SEEDS=n: n worlds of each kind.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "catch.h"
#include "family.h"

namespace obstructed_motors_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

enum Kind { slide, slot, piston, drive, mouse, lever, kinds };
constexpr const char* names[kinds] = {"slide", "slot", "piston", "motor joint", "mouse", "lever"};

/// A press below one to four bodies that lie on each other, and a ceiling above them.
class Press {
  public:
    Press(Kind kind, Solver solver, Random& random)
        : kind_(kind), world_({.solver = solver}), force_(std::pow(10.0f, random(2, 5))) {
        rows_ = 1 + int(random(0, 3.99f));
        const bool crates = random(0, 1) < 0.7f;
        plate_ = world_.create_body({.position = {0, 1}, .locked_rotation = kind != lever});
        plate_.add(Box{.width = 2, .height = 0.2f}, {.density = random(0.5f, 3)});
        float top = 1.1f;
        for (int i = 0; i < rows_; ++i) {
            const float size = random(0.4f, 1.2f);
            Body body =
                world_.create_body({.position = {0, top + size / 2}, .locked_rotation = !crates});
            const ShapeDef surface = {.density = random(0.5f, 4), .friction = 0.8f};
            if (crates)
                body.add(Box{.width = size, .height = size}, surface);
            else
                body.add(Circle{size / 2}, surface);
            bodies_.push_back(body);
            top += size;
        }
        ceiling_ = top + random(0.1f, 2);
        if (kind == lever) ceiling_ = top + 0.1f;
        fixed_ = world_.create_body({.type = BodyType::static_body});
        fixed_.add(Box{.width = 8, .height = 0.3f, .center = {0, ceiling_ + 0.15f}});
        connect(random(0.5f, 3));
    }
    /// How deep bodies and the plate are in each other and in the ceiling at most, in the last of
    /// six seconds.
    float depth(int hertz) {
        float deepest = 0;
        for (int i = 0; i < 6 * hertz; ++i) {
            if (kind_ == mouse) mouse_.set_target({0, 1 + raise_ * float(i) / float(hertz)});
            world_.step(1.0f / float(hertz));
            if (i < 5 * hertz) continue;
            for (const Contact& contact : world_.contacts())
                for (int k = 0; k < contact.point_count; ++k)
                    deepest = std::max(deepest, -contact.points[size_t(k)].separation);
        }
        return deepest;
    }
    float speed() const {
        float speed = 0;
        for (const Body& body : bodies_) speed = std::max(speed, body.velocity().length());
        return speed;
    }
    bool is_held() const {
        return std::all_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
            return body.position().y < ceiling_ && body.position().y > 0;
        });
    }

  private:
    void connect(float speed) {
        const BodyId body = plate_.id();
        switch (kind_) {
            case slide: {
                PrismaticJointDef def{.body_b = body, .anchor_a = {0, 1}, .axis = {0, 1}};
                def.motor_speed = speed;
                def.max_motor_force = force_;
                world_.create_prismatic_joint(def);
                break;
            }
            case slot: {
                PinSlotJointDef def{.body_b = body, .anchor_a = {0, 1}, .axis = {0, 1}};
                def.motor_speed = speed;
                def.max_motor_force = force_;
                world_.create_pin_slot_joint(def);
                break;
            }
            case piston: {
                DistanceJointDef def{.body_b = body, .anchor_a = {0, -1}};
                def.hertz = 0;
                def.motor_speed = speed;
                def.max_motor_force = force_;
                world_.create_distance_joint(def);
                guide();
                break;
            }
            case drive: {
                MotorJointDef def{.body_b = body, .anchor_a = {0, 1}};
                def.linear_velocity = {0, speed};
                def.max_force = force_;
                world_.create_motor_joint(def);
                break;
            }
            case mouse:
                mouse_ = world_.create_mouse_joint(
                    {.body = body, .target = {0, 1}, .anchor = Vec2{0, 0}, .max_force = force_});
                raise_ = speed;
                guide();
                break;
            default: {
                RevoluteJointDef def{.body_b = body, .anchor_a = {-3, 1}, .anchor_b = {-3, 0}};
                def.motor_speed = 0.3f * speed;
                def.max_motor_torque = 3 * force_;
                world_.create_revolute_joint(def);
            }
        }
    }
    void guide() {
        PinSlotJointDef rail{.body_b = plate_.id(), .anchor_a = {0, 1}, .axis = {0, 1}};
        world_.create_pin_slot_joint(rail);
    }

    Kind kind_;
    World world_;
    float force_, ceiling_ = 0;
    float raise_ = 0;
    MouseJoint mouse_;
    int rows_ = 1;
    Body plate_, fixed_;
    std::vector<Body> bodies_;
};

float top_of(const Body& body) {
    return float(body.aabb().max.y);
}

/// How high a lift with six crates of 50 kg rises, and then how far it stays away from the ceiling.
/// A lift of 0.4 kg bears them.
struct Lift {
    float highest = 0, ceiling = 11;
};
Lift lift_crates(float force) {
    World world;
    Lift lift;
    Body ceiling = world.create_body({.type = BodyType::static_body});
    ceiling.add(Box{.width = 6, .height = 1, .center = {0, lift.ceiling + 0.5f}});
    Body plate = world.create_body({.position = {0, 1}});
    plate.add(Box{.width = 2, .height = 0.2f});
    PrismaticJointDef def{.body_b = plate.id(), .anchor_a = {0, 1}, .axis = {0, 1}};
    def.lower_translation = 0;
    def.motor_speed = 1;
    def.max_motor_force = force;
    world.create_prismatic_joint(def);
    Body crate;
    for (int i = 0; i < 6; ++i) {
        crate = world.create_body({.position = {0, 1.6f + float(i)}});
        crate.add(Box{.width = 1, .height = 1}, {.density = 50});
    }
    for (int i = 0; i < 900; ++i) world.step(1.0f / 60);
    lift.highest = top_of(crate);
    return lift;
}

/// The height of a car of 300 kg after a motor has pushed a foot of 0.15 kg to the ground.
float lift_car() {
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Box{.width = 20, .height = 1, .center = {0, -0.5f}});
    Body car = world.create_body({.position = {0, 1}, .locked_rotation = true});
    car.add(Box{.width = 2, .height = 1}, {.density = 150});
    Body foot = world.create_body({.position = {0, 0.25f}});
    foot.add(Box{.width = 0.5f, .height = 0.3f});
    PrismaticJointDef def{.body_a = car.id(), .body_b = foot.id(), .axis = {0, 1}};
    def.anchor_a = {0, -0.6f};
    def.anchor_b = {0, 0.15f};
    def.lower_translation = -3;
    def.motor_speed = -0.5f;
    def.max_motor_force = 10000;
    world.create_prismatic_joint(def);
    for (int i = 0; i < 360; ++i) world.step(1.0f / 60);
    return float(car.position().y);
}

/// The speed of a press that has pressed a crate against the ground for five seconds, and how deep
/// the crate is in the ground and in the press.
struct Pressed {
    float speed = 0, depth = 0;
};
Pressed press_crate(float mass_of_press, float force, float motor_speed, int hertz) {
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Box{.width = 20, .height = 1, .center = {0, -0.5f}});
    Body crate = world.create_body({.position = {0, 0.5f}});
    crate.add(Box{.width = 1, .height = 1});
    Body press = world.create_body({.position = {0, 3}, .mass = mass_of_press});
    press.add(Box{.width = 1, .height = 0.4f});
    PrismaticJointDef def{.body_b = press.id(), .anchor_a = {0, 3}, .axis = {0, -1}};
    def.motor_speed = motor_speed;
    def.max_motor_force = force;
    world.create_prismatic_joint(def);
    Pressed pressed;
    for (int i = 0; i < 6 * hertz; ++i) {
        world.step(1.0f / float(hertz));
        if (i >= 5 * hertz) pressed.speed = std::max(pressed.speed, press.velocity().length());
    }
    pressed.depth = 1.2f - float(press.position().y);
    return pressed;
}

/// How far two slides are in each other that press against each other, each with `force`.
float press_slides(float force) {
    World world({.gravity = {0, 0}});
    Body slides[2];
    for (const int side : {0, 1}) {
        const float x = side == 0 ? -2.0f : 2.0f;
        slides[side] = world.create_body({.position = {x, 0}});
        slides[side].add(Box{.width = 1, .height = 1});
        PrismaticJointDef def{.body_b = slides[side].id(), .anchor_a = {x, 0}, .axis = {1, 0}};
        def.motor_speed = side == 0 ? 1.0f : -1.0f;
        def.max_motor_force = force;
        world.create_prismatic_joint(def);
    }
    for (int i = 0; i < 600; ++i) world.step(1.0f / 60);
    return 1 - float(slides[1].position().x - slides[0].position().x);
}

/// The height of a crate that a hand with two jaws of 0.3 kg has lifted by 3 m.
float grip_crate(float mass, float force) {
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Box{.width = 20, .height = 1, .center = {0, -0.5f}});
    Body hand = world.create_body({.type = BodyType::kinematic_body, .position = {0, 3}});
    for (const float side : {-1.0f, 1.0f}) {
        Body jaw = world.create_body({.position = {1.2f * side, 1.1f}});
        jaw.add(Box{.width = 0.2f, .height = 1.5f}, {.friction = 1});
        PrismaticJointDef def{.body_a = hand.id(), .body_b = jaw.id(), .axis = {1, 0}};
        def.anchor_a = {1.2f * side, -1.9f};
        def.motor_speed = -side;
        def.max_motor_force = force;
        world.create_prismatic_joint(def);
    }
    Body crate = world.create_body({.position = {0, 0.5f}});
    crate.add(Box{.width = 1, .height = 1}, {.density = mass, .friction = 1});
    for (int i = 0; i < 60; ++i) world.step(1.0f / 60);
    hand.set_velocity({0, 1});
    for (int i = 0; i < 180; ++i) world.step(1.0f / 60);
    return float(crate.position().y);
}

}  // namespace

TEST_CASE("motors of any strength press nothing through a fixed obstacle", "[families]") {
    for (const Solver solver : {Solver::soft_step, Solver::direct}) {
        for (int kind = 0; kind < kinds; ++kind) {
            float deepest = 0, fastest = 0;
            unsigned lost = 0, worst = 0;
            const unsigned count = seeds_or(solver == Solver::soft_step ? 40 : 12);
            for (unsigned seed = 0; seed < count; ++seed) {
                Random random{std::mt19937(seed)};
                Press press(Kind(kind), solver, random);
                // The stiffness of contacts does not grow with the rate of steps.
                const float depth = press.depth(seed % 4 == 3 ? 144 : 60);
                lost += !press.is_held();
                if (depth > deepest) worst = seed;
                deepest = std::max(deepest, depth);
                fastest = std::max(fastest, press.speed());
            }
            INFO(names[kind] << ", solver " << int(solver) << ": deepest " << deepest << ", seed "
                             << worst << ", fastest " << fastest);
            CHECK(lost == 0);
            CHECK(deepest < 0.07f);
            CHECK(fastest < 0.2f);
        }
    }
}

// After an impact the contact of a heavy press bears nothing in some steps. With all of its force
// again, the motor hammered on for ever.
TEST_CASE("a press that is heavier than what it presses comes to rest", "[families]") {
    for (const int hertz : {30, 60, 144}) {
        for (const float mass : {1.0f, 3.0f, 10.0f}) {
            for (const float force : {1e3f, 1e4f, 1e5f}) {
                for (const float motor_speed : {0.5f, 2.0f}) {
                    CAPTURE(hertz, mass, force, motor_speed);
                    const Pressed pressed = press_crate(mass, force, motor_speed, hertz);
                    CHECK(pressed.speed < 0.05f);
                    CHECK(pressed.depth < 0.07f);
                }
            }
        }
    }
}

TEST_CASE("a strong motor bears its load while an obstacle bears the rest", "[families]") {
    for (const float force : {1e4f, 1e5f}) {
        const Lift lift = lift_crates(force);
        CAPTURE(force, lift.highest);
        CHECK(std::abs(lift.highest - lift.ceiling) < 0.02f);
    }
    CHECK(lift_car() > 3.5f);
    for (const float mass : {1.0f, 10.0f, 30.0f, 100.0f}) CHECK(grip_crate(mass, 1000) > 3);
    CHECK(grip_crate(10, 1e5f) > 3);
}

TEST_CASE("two motors that press against each other do not pass each other", "[families]") {
    for (const float force : {100.0f, 1e3f, 1e4f, 1e5f}) CHECK(press_slides(force) < 0.06f);
}

// The pad counts as the lightest body, and the pile weighs more than 280 pads.
TEST_CASE("a light pad presses a heavy pile with a force that does not flicker") {
    for (const float rate : {20.0f, 60.0f, 144.0f}) {
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Box{.width = 20, .height = 1, .center = {0, -0.5f}});
        float weight = 1;
        for (const float mass : {5.0f, 25.0f}) {
            Body crate =
                world.create_body({.position = {0, mass == 5 ? 0.4f : 1.2f}, .mass = mass});
            crate.add(Box{.width = 0.8f, .height = 0.8f});
            weight += 10 * mass;
        }
        Body pad = world.create_body({.position = {0, 1.9f}, .mass = 0.1f});
        pad.add(Box{.width = 1, .height = 0.3f});
        PrismaticJointDef press{.body_b = pad.id(), .anchor_a = {0, 1.9f}, .axis = {0, 1}};
        press.motor_speed = -0.5f, press.max_motor_force = 1e6f;
        world.create_prismatic_joint(press);
        float least = 1e6f, most = 0;
        for (int i = 0; i < int(10 * rate); ++i) {
            world.step(1 / rate);
            float force = 0;
            for (const auto& contact : ground.contacts()) force += contact.normal_force;
            if (i > int(7 * rate)) least = std::min(least, force), most = std::max(most, force);
        }
        CAPTURE(rate);
        CHECK(least > weight + 30);
        CHECK(most < weight + 285);
        CHECK(most < least + 2);
    }
}

}  // namespace obstructed_motors_test
