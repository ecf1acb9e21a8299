// Small bodies in a row, each 5 to 100 m from the next, fall onto the ground: a joint holds each of
// them at a lever that is much longer than the body. The limits and angles of the joints are edited
// while they move; in some rows the first body is static. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

namespace long_levers_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;
using families::turned;

namespace {

class FarRow {
  public:
    explicit FarRow(unsigned seed) : random_{std::mt19937(seed)} {
        const float rates[] = {20, 30, 60, 144};
        dt_ = 1 / rates[seed / kinds % 4];
        kind_ = int(seed % kinds);
        lever_ = 5 * std::exp2(random_(0, 4.3f));
        Body ground = world_.create_body({.type = BodyType::static_body});
        ground.add(Box{.width = 2000, .height = 4, .center = {0, -2}});
        const int count = int(random_(2, 4.99f));
        const float up = random_(0, 3);
        Vec2 place = {0, random_(2, 8)};
        std::vector<Vec2> places;
        for (int i = 0; i < count; ++i) {
            places.push_back(place);
            place = place + lever_ * turned(i > 0 ? up + random_(-0.5f, 0.5f) : up);
        }
        float low = 1e9f;
        for (const Vec2& each : places) low = std::min(low, each.y);
        for (Vec2& each : places) {
            each.y += std::max(0.0f, 1.2f - low);
            top_ = std::max(top_, each.y);
            add_body(each);
        }
        if (random_(0, 1) < 0.3f) bodies_[0].set_type(BodyType::static_body);
        const float along = std::floor(random_(0, 3)) / 2;  // 0: at a, 0.5: between, 1: at b
        for (size_t i = 0; i + 1 < bodies_.size(); ++i)
            connect(bodies_[i], bodies_[i + 1], places[i] + along * (places[i + 1] - places[i]));
    }
    const char* what() const {
        const char* const names[kinds] = {"slide", "pin", "wheel", "weld", "pin with limits"};
        return names[kind_];
    }
    float lever() const { return lever_; }
    float rate() const { return 1 / dt_; }
    /// The speed of what falls from the top, and of what a limit or an angle moves beside it.
    float fair_speed() const { return 1.5f * std::sqrt(2 * 10 * top_) + 40; }
    /// The fastest body in 10 s.
    float fastest() {
        float fastest = 0;
        const int every = int(0.5f / dt_), end = int(10 / dt_);
        for (int i = 0; i < end; ++i) {
            if (i > end / 5 && i < 4 * end / 5 && i % every == 0) edit();
            world_.step(dt_);
            for (const Body& body : bodies_) fastest = std::max(fastest, body.velocity().length());
        }
        return fastest;
    }
    float separation() const {
        float most = 0;
        for (const Joint& joint : joints_) most = std::max(most, joint.separation());
        return most;
    }

    static constexpr unsigned kinds = 5;

  private:
    void add_body(Vec2 place) {
        Body body = world_.create_body({.position = Position(place), .angle = random_(-3, 3)});
        const float size = random_(0.2f, 0.6f), shape = random_(0, 2);
        const ShapeDef def = {.density = random_(0, 1) < 0.3f ? 2.0f : 0.5f};
        if (shape < 1)
            body.add(Circle{size}, def);
        else
            body.add(Box{.width = 2 * size, .height = size}, def);
        bodies_.push_back(body);
    }
    template <class Def>
    Def between(const Body& a, const Body& b, Vec2 at) const {
        Def def;
        def.body_a = a.id();
        def.body_b = b.id();
        def.anchor_a = Position(a.local_point(Position(at)));
        def.anchor_b = Position(b.local_point(Position(at)));
        return def;
    }
    template <class Def>
    Def on_rail(const Body& a, const Body& b, Vec2 at) {
        Def def = between<Def>(a, b, at);
        def.axis = turned(random_(-3, 3));
        def.lower_translation = -1;
        def.upper_translation = 1;
        return def;
    }
    void connect(const Body& a, const Body& b, Vec2 at) {
        if (kind_ == 0)
            joints_.push_back(world_.create_prismatic_joint(on_rail<PrismaticJointDef>(a, b, at)));
        else if (kind_ == 2)
            joints_.push_back(world_.create_wheel_joint(on_rail<WheelJointDef>(a, b, at)));
        else if (kind_ == 3)
            joints_.push_back(world_.create_weld_joint(between<WeldJointDef>(a, b, at)));
        else
            connect_by_pin(between<RevoluteJointDef>(a, b, at));
    }
    void connect_by_pin(RevoluteJointDef def) {
        if (kind_ == 4) def.lower_angle = -0.5f, def.upper_angle = 0.5f;
        joints_.push_back(world_.create_revolute_joint(def));
    }
    void edit() {
        const Joint joint = joints_[size_t(random_(0, float(joints_.size()) - 0.01f))];
        const float to = random_(-1, 1);
        if (kind_ == 0) {
            PrismaticJoint slide(&world_, joint.id());
            slide.set_lower_translation(to - 0.1f);
            slide.set_upper_translation(to + 0.1f);
        } else if (kind_ == 3) {
            WeldJoint weld(&world_, joint.id());
            weld.set_reference_angle(weld.reference_angle() + 0.3f * to);
        } else if (kind_ == 4) {
            RevoluteJoint pin(&world_, joint.id());
            pin.set_lower_angle(to - 0.1f);
            pin.set_upper_angle(to + 0.1f);
        }
    }

    Random random_;
    World world_{WorldDef{.gravity = {0, -10}}};
    std::vector<Body> bodies_;
    std::vector<Joint> joints_;
    int kind_ = 0;
    float dt_ = 0, lever_ = 0, top_ = 0;
};

}  // namespace

TEST_CASE("bodies far from their joints are not thrown") {
    float most = 0, apart = 0;
    unsigned thrown = 0;
    const unsigned seeds = seeds_or(400);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        FarRow row(seed);
        CAPTURE(seed, row.what(), row.lever(), row.rate());
        const float fastest = row.fastest();
        CHECK(fastest < 10 * row.fair_speed());
        if (fastest > row.fair_speed()) ++thrown;
        most = std::max(most, fastest / row.fair_speed());
        apart = std::max(apart, row.separation());
    }
    CHECK(thrown <= seeds / 100);
    std::printf(
        "bodies far from their joints: %u of %u thrown, %.2f of a fair speed, joints part "
        "by %.3f m\n",
        thrown, seeds, double(most), double(apart));
}

TEST_CASE("a small ball far from its pin swings as a pendulum does") {
    World world({.gravity = {0, -10}});
    Body ball = world.create_body({.position = {30 * std::sin(0.05f), -30 * std::cos(0.05f)}});
    ball.add(Circle{0.2f});
    world.create_revolute_joint({.body_b = ball.id(), .anchor_b = ball.local_point({0, 0})});
    const float period = 2 * 3.14159265f * std::sqrt(30.0f / 10);
    float time = 0;
    while (float(ball.position().x) > 0 && time < period) world.step(1.0f / 60), time += 1.0f / 60;
    time -= float(ball.position().x) / ball.velocity().x;
    CHECK(time == Approx(0.25f * period).epsilon(0.002));
}

}  // namespace long_levers_test
