// Limits, ropes and pulleys that an edit makes shorter by meters, as the console does with
// `rope.max_length = 2`: they close soon, and throw nothing. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <string>

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

}  // namespace far_limits_test
