// Limits, ropes and pulleys that an edit makes shorter by meters, as the console does with
// `rope.max_length = 2`: they close soon, and throw nothing. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "catch.h"
#include "family.h"

namespace far_limits_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;
using families::turned;

namespace {

/// Two bodies with an anchor beside each center, and a joint with one limit that the distance
/// exceeds, or falls below, by `gap`.
class FarLimit {
  public:
    explicit FarLimit(Random& random) {
        const float angle = random(-3, 3);
        gap_ = random(0.3f, 25);
        a_ = body({0, 0}, random);
        b_ = body((1 + gap_) * turned(angle), random);
        const JointDef ends{.body_a = a_.id(),
                            .body_b = b_.id(),
                            .anchor_a = {0, random(0, 0.4f)},
                            .anchor_b = {random(-0.4f, 0.4f), 0}};
        const auto way =
            Vec2(b_.world_point(Vec2(ends.anchor_b)) - a_.world_point(Vec2(ends.anchor_a)));
        // The axis is in coordinates of body a.
        const Vec2 axis = a_.local_vector(way / way.length());
        switch (int(random(0, 6))) {
            case 0:
                rope(ends, way.length(), false);
                break;
            case 1:
                rope(ends, way.length(), true);
                break;
            case 2:
                slide(PrismaticJointDef(ends), axis, random,
                      [&](const auto& def) { return world_.create_prismatic_joint(def); });
                break;
            case 3:
                slide(WheelJointDef(ends), axis, random,
                      [&](const auto& def) { return world_.create_wheel_joint(def); });
                break;
            case 4:
                slide(PinSlotJointDef(ends), axis, random,
                      [&](const auto& def) { return world_.create_pin_slot_joint(def); });
                break;
            default:
                pulley(ends, random);
        }
    }
    /// The greatest speed of a body in two seconds.
    float run() {
        float fastest = 0;
        for (int i = 0; i < 120; ++i) {
            world_.step(1.0f / 60);
            for (const Body& each : {a_, b_}) fastest = std::max(fastest, each.velocity().length());
        }
        return fastest;
    }
    float beyond() const { return joint_.separation(); }
    const std::string& what() const { return what_; }
    float gap() const { return gap_; }

  private:
    Body body(Position at, Random& random) {
        Body made = world_.create_body({.position = at, .angle = random(-3, 3)});
        made.add(Box{.width = random(0.4f, 1.2f), .height = random(0.4f, 1.2f)},
                 {.density = random(0.5f, 5), .mask = 0});
        return made;
    }
    void rope(const JointDef& ends, float length, bool pushes) {
        DistanceJointDef def = ends;
        def.hertz = 0;
        DistanceJoint made = world_.create_distance_joint(def);
        pushes ? made.set_min_length(length + gap_) : made.set_max_length(length - 0.9f * gap_);
        joint_ = made;
        what_ = pushes ? "least length" : "greatest length";
    }
    template <class Def, class Create>
    void slide(Def def, Vec2 axis, Random& random, Create&& create) {
        def.axis = axis;
        if constexpr (requires { def.hertz; }) def.hertz = 0;
        auto made = create(def);
        const float now = made.translation();
        random(0, 1) < 0.5f ? made.set_upper_translation(now - gap_)
                            : made.set_lower_translation(now + gap_);
        joint_ = made;
        what_ = "slide of type " + std::to_string(int(made.type()));
    }
    void pulley(const JointDef& ends, Random& random) {
        PulleyJointDef def = ends;
        def.ground_a =
            Vec2(a_.world_point(Vec2(ends.anchor_a))) + (1 + 1.5f * gap_) * turned(random(-3, 3));
        def.ground_b =
            Vec2(b_.world_point(Vec2(ends.anchor_b))) + (1 + 1.5f * gap_) * turned(random(-3, 3));
        def.ratio = random(0.5f, 2);
        PulleyJoint made = world_.create_pulley_joint(def);
        made.set_length(made.length_now() - gap_ * std::min(1.0f, def.ratio));
        joint_ = made;
        what_ = "pulley";
    }

    World world_{WorldDef{.gravity = {0, 0}}};
    Body a_, b_;
    Joint joint_;
    float gap_ = 0;
    std::string what_;
};

}  // namespace

TEST_CASE("a limit that an edit puts meters away closes and throws nothing") {
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        Random random{std::mt19937(seed)};
        FarLimit pair(random);
        CAPTURE(seed, pair.what(), pair.gap());
        const float fastest = pair.run();
        CHECK(fastest < 30);  // a gap is closed at 16 m/s
        CHECK(pair.beyond() < 0.05f);
    }
}

namespace {

/// A row of bodies of a meter that is fixed at its left end, with joints of one kind. An edit
/// changes the angle of the first joint, or turns a body.
class Row {
  public:
    explicit Row(Random& random) : kind_(int(random(0, 5))), count_(1 + int(random(0, 5))) {
        const float density = random(0.5f, 5);
        Body last = world_.create_body({.type = BodyType::static_body, .position = {-1, 0}});
        for (int i = 0; i < count_; ++i) {
            Body next = world_.create_body({.position = {float(i), 0}});
            next.add(Box{.width = 1, .height = 0.2f}, {.density = density, .group = -1});
            join(last, next);
            last = next;
            bodies_.push_back(next);
        }
    }
    /// Returns the greatest speed of a body in the three seconds after the edit.
    float edit(Random& random) {
        for (int i = 0; i < 60; ++i) world_.step(1.0f / 60);
        const float angle = random(-2.5f, 2.5f);
        switch (kind_) {
            case 0:
                world_.joint<WeldJoint>(joints_[0].id()).set_reference_angle(angle);
                break;
            case 1:
                world_.joint<RevoluteJoint>(joints_[0].id()).set_lower_angle(angle);
                world_.joint<RevoluteJoint>(joints_[0].id()).set_upper_angle(angle + 0.2f);
                break;
            case 2:
                world_.joint<RotaryLimitJoint>(limit_.id()).set_lower_angle(angle);
                world_.joint<RotaryLimitJoint>(limit_.id()).set_upper_angle(angle + 0.2f);
                break;
            case 3:
                world_.joint<PrismaticJoint>(joints_[0].id()).set_reference_angle(angle);
                break;
            default:
                bodies_[0].set_angle(angle);
        }
        float fastest = 0;
        for (int i = 0; i < 180; ++i) {
            world_.step(1.0f / 60);
            for (const Body& body : bodies_) fastest = std::max(fastest, body.velocity().length());
        }
        return fastest;
    }
    float separation() const {
        float widest = 0;
        for (const Joint& joint : joints_) widest = std::max(widest, joint.separation());
        return widest;
    }
    int kind() const { return kind_; }
    int count() const { return count_; }

  private:
    void join(const Body& a, const Body& b) {
        const JointDef ends{
            .body_a = a.id(), .body_b = b.id(), .anchor_a = {0.5f, 0}, .anchor_b = {-0.5f, 0}};
        const bool first = joints_.empty();
        if (first && kind_ == 3) {
            PrismaticJointDef def(ends);
            def.lower_translation = def.upper_translation = 0;
            joints_.push_back(world_.create_prismatic_joint(def));
        } else if (kind_ == 1 || kind_ == 2) {
            RevoluteJointDef def(ends);
            if (!(first && kind_ == 2)) def.lower_angle = -0.1f, def.upper_angle = 0.1f;
            joints_.push_back(world_.create_revolute_joint(def));
        } else {
            joints_.push_back(world_.create_weld_joint(ends));
        }
        if (first && kind_ == 2) {
            RotaryLimitJointDef def(ends);
            def.lower_angle = -0.1f, def.upper_angle = 0.1f;
            limit_ = world_.create_rotary_limit_joint(def);
        }
    }

    World world_;
    int kind_, count_;
    std::vector<Body> bodies_;
    std::vector<Joint> joints_;
    Joint limit_;
};

}  // namespace

TEST_CASE("an angle that an edit changes by radians turns a row of bodies and throws nothing") {
    float worst[6] = {};  // by number of bodies
    for (unsigned seed = 0; seed < seeds_or(400); ++seed) {
        Random random{std::mt19937(seed)};
        Row row(random);
        const float fastest = row.edit(random);
        CAPTURE(seed, row.kind(), row.count());
        worst[row.count()] = std::max(worst[row.count()], fastest);
        CHECK(fastest <
              7 * float(row.count()));  // an angle changes at 5 rad/s, and a row swings on
        CHECK(row.separation() < 0.05f);
    }
    for (int count = 1; count <= 5; ++count)
        std::printf("rows of %d bodies: fastest %.1f m/s\n", count, double(worst[count]));
}

}  // namespace far_limits_test
