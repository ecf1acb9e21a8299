// A body runs into a limit of its joint. A limit has no restitution, so the body stops there, the
// rigid rows of the joint hold, and a motor has its speed at once. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace limit_impacts_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;
using families::turned;

namespace {

/// A body on a joint to the world, with its center beside the anchor, that moves along the free
/// coordinate of the joint towards a limit.
class Runner {
  public:
    explicit Runner(unsigned seed) : random_{std::mt19937(seed)} {
        const float rates[] = {30, 60, 120, 240};
        dt_ = 1 / rates[seed / 5 % 4];
        kind_ = int(seed % 5);
        end_ = random_(0.3f, 1.2f);
        speed_ = random_(2, 15);
        anchor_ = random_(0, 1) * turned(random_(-3, 3));
        body_ = world_.create_body({.position = Position(-1 * anchor_)});
        body_.add(Box{.width = random_(0.3f, 2), .height = random_(0.2f, 1)},
                  {.density = random_(0.5f, 5)});
        const float forward = random_(0, 1) < 0.5f ? 1.0f : -1.0f;
        end_ *= forward;
        speed_ *= forward;
    }
    bool turns() const { return kind_ == 0; }
    /// Whether the joint leaves the body no other motion than that along the coordinate.
    bool holds_all() const { return kind_ < 2; }
    const char* what() const {
        const char* const names[] = {"revolute", "prismatic", "wheel", "pin slot", "groove"};
        return names[kind_];
    }

    /// With a limit, and no motor.
    void add_limit() {
        const float low = std::min(end_, 0.0f) - (end_ > 0 ? 5.0f : 0.0f),
                    high = std::max(end_, 0.0f) + (end_ < 0 ? 5.0f : 0.0f);
        if (kind_ == 0) {
            auto def = ends<RevoluteJointDef>();
            def.lower_angle = low, def.upper_angle = high;
            joint_ = world_.create_revolute_joint(def);
        } else if (kind_ == 4) {
            auto def = ends<GrooveJointDef>();
            def.anchor_a = Position(std::min(end_, -5.0f) * axis());
            def.end = Position(std::max(end_, 5.0f) * axis());
            if (end_ > 0)
                def.end = Position(end_ * axis());
            else
                def.anchor_a = Position(end_ * axis());
            joint_ = world_.create_groove_joint(def);
        } else if (kind_ == 1) {
            auto def = ends<PrismaticJointDef>();
            set_slide(def, low, high);
            joint_ = world_.create_prismatic_joint(def);
        } else if (kind_ == 2) {
            auto def = ends<WheelJointDef>();
            set_slide(def, low, high);
            joint_ = world_.create_wheel_joint(def);
        } else {
            auto def = ends<PinSlotJointDef>();
            set_slide(def, low, high);
            joint_ = world_.create_pin_slot_joint(def);
        }
        if (turns()) {
            body_.set_angular_velocity(speed_);
            body_.set_velocity(Vec2(-speed_ * -anchor_.y, speed_ * -anchor_.x));
        } else {
            body_.set_velocity(speed_ * axis());
        }
    }
    /// The speed back from the limit, as a share of that before: the greatest of all steps after
    /// the impact, or, if the body may also turn about its anchor, at the end of the step of it.
    float speed_back() {
        float back = 0;
        bool reached = false;
        for (int left = int(2.5f / dt_); left > 0; --left) {
            world_.step(dt_);
            apart_ = std::max(apart_, joint_.separation());
            if (kind_ == 1) turned_ = std::max(turned_, std::fabs(body_.angle()));
            if (!reached && (end_ - place()) / speed_ > 1e-3f) continue;
            back = std::max(back, (-speed() - pulled() * dt_) / speed_);
            reached = true;
            if (!holds_all()) break;
        }
        REQUIRE(reached);
        return back;
    }
    float apart() const { return apart_; }
    float turned_by() const { return turned_; }

  private:
    template <class Def>
    Def ends() const {
        Def def;
        def.body_b = body_.id();
        def.anchor_b = Position(anchor_);
        return def;
    }
    Vec2 axis() const { return turned(direction_); }
    template <class Def>
    void set_slide(Def& def, float low, float high) {
        def.axis = axis();
        if constexpr (requires { def.hertz; }) def.hertz = 0;
        def.lower_translation = low;
        def.upper_translation = high;
    }
    float place() const {
        if (turns()) return body_.angle();
        return axis().dot(Vec2(body_.world_point(anchor_)));
    }
    /// A body that turns about its anchor pulls it away from the limit, m/s².
    float pulled() const {
        const float w = body_.angular_velocity();
        return holds_all() ? 0.0f : std::copysign(w * w * anchor_.length(), speed_);
    }
    float speed() const {
        if (turns()) return body_.angular_velocity();
        return axis().dot(body_.velocity_at(body_.world_point(anchor_)));
    }

    Random random_;
    World world_{WorldDef{.gravity = {0, 0}}};
    Body body_;
    Joint joint_;
    Vec2 anchor_;
    int kind_ = 0;
    float dt_ = 0, end_ = 0, speed_ = 0, direction_ = random_(-3, 3);
    float apart_ = 0, turned_ = 0;
};

}  // namespace

TEST_CASE("a body that runs into a limit of its joint stops there") {
    float back = 0, apart = 0, turned = 0;
    for (unsigned seed = 0; seed < seeds_or(400); ++seed) {
        Runner runner(seed);
        CAPTURE(seed, runner.what());
        runner.add_limit();
        const float now = runner.speed_back();
        CHECK(now < 0.01f);
        CHECK(runner.apart() < 0.01f);
        CHECK(runner.turned_by() < 0.002f);
        back = std::max(back, now);
        apart = std::max(apart, runner.apart());
        turned = std::max(turned, runner.turned_by());
    }
    std::printf("at limits: at most %.4f of the speed back, joints part by %.4f m, turn by %.4f\n",
                double(back), double(apart), double(turned));
}

TEST_CASE("limits of an angle that an edit puts past a door throw nothing") {
    float fastest = 0, outside = 0;
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {0, 0}});
        Body door = world.create_body({.position = {random(0.2f, 1.5f), random(-0.5f, 0.5f)}});
        door.add(Box{.width = random(0.5f, 3), .height = random(0.1f, 1)});
        RevoluteJoint pin = world.create_revolute_joint(
            {.body_b = door.id(), .anchor_b = Position(door.local_point({0, 0}))});
        world.step(1.0f / 60);
        const float way = random(0.2f, 1.5f), room = random(0.1f, 1);
        const float sign = random(0, 1) < 0.5f ? 1.0f : -1.0f;
        pin.set_lower_angle(std::min(sign * way, sign * (way + room)));
        pin.set_upper_angle(std::max(sign * way, sign * (way + room)));
        CAPTURE(seed, way, room);
        float most = 0;
        for (int i = 0; i < 120; ++i) {
            world.step(1.0f / 60);
            most = std::max(most, std::fabs(door.angular_velocity()));
        }
        const float left = way - sign * pin.angle();
        CHECK(most < 0.2f);
        CHECK(left < 0.01f);
        CHECK(pin.separation() < 0.01f);
        fastest = std::max(fastest, most);
        outside = std::max(outside, left);
    }
    std::printf("limits past a door: at most %.3f rad/s, %.4f rad outside after 2 s\n",
                double(fastest), double(outside));
}

TEST_CASE("a strong motor has its speed after one step") {
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {0, 0}});
        const float speed = random(-5, 5);
        Body body = world.create_body({.position = {random(-1, 1), random(-1, 1)}});
        body.add(Box{.width = random(0.3f, 2), .height = random(0.2f, 1)});
        const Position anchor = body.local_point({0, 0});
        const bool turns = seed % 2 == 0;
        if (turns)
            world.create_revolute_joint({.body_b = body.id(),
                                         .anchor_b = anchor,
                                         .motor_speed = speed,
                                         .max_motor_torque = 1e6f});
        else
            world.create_prismatic_joint({.body_b = body.id(),
                                          .anchor_b = anchor,
                                          .motor_speed = speed,
                                          .max_motor_force = 1e6f});
        world.step(1.0f / 60);
        CAPTURE(seed, turns, speed);
        const float now = turns ? body.angular_velocity() : body.velocity().x;
        CHECK(std::fabs(now - speed) < 0.01f * std::fabs(speed));
    }
}

}  // namespace limit_impacts_test
