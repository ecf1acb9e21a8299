// What the invariants of random worlds find and what they allow, in moments made by hand.

#include <cmath>

#include "catch.h"
#include "wild/plan_run.h"

namespace wild_checks_test {

using namespace fettle::bench::wild;

namespace {

constexpr float dt = 1.0f / 60;

/// A body of the plan, a box of 1 m and 1 kg, as it is now.
BodyNow now(const BodyPlan& body) {
    return {.exists = true,
            .awake = true,
            .type = body.def.type,
            .position = body.def.position,
            .center = body.def.position,
            .mass = 1,
            .inertia = 1.0f / 6};
}

/// Runs a check on steps with the same bodies before and after, which `change` may edit.
class HandMade {
  public:
    HandMade(const char* invariant, const WorldPlan& plan)
        : plan_(plan), check_(invariants_named({invariant})[0].make_check(plan_)) {
        for (const BodyPlan& body : plan_.bodies) bodies.push_back(now(body));
    }
    /// True if the check finds something within this time.
    bool finds_within(float seconds) {
        const std::vector<bool> edited(bodies.size(), false);
        for (float end = time_ + seconds; time_ < end; time_ += dt)
            if (check_->violation({plan_, step_++, dt, false, edited, bodies, bodies})) return true;
        return false;
    }
    std::vector<BodyNow> bodies;

  private:
    WorldPlan plan_;
    std::unique_ptr<Check> check_;
    int step_ = 0;
    float time_ = 0;
};

/// Two boxes beside each other, joined where they meet.
WorldPlan two_boxes(JointType joint) {
    WorldPlan plan;
    for (const float x : {0.0f, 1.0f})
        plan.bodies.push_back({.def = {.position = {x, 5}}, .shapes = {{Box{}}}});
    plan.joints.push_back(
        {.type = joint, .a = 0, .b = 1, .anchor_a = {0.5f, 0}, .anchor_b = {-0.5f, 0}});
    return plan;
}

}  // namespace

TEST_CASE("the invariant of joints allows a weld to sag under the load that lies on it") {
    for (const float load : {0.0f, 10.0f, 3000.0f}) {
        CAPTURE(load);
        HandMade world("joints", two_boxes(JointType::weld));
        CHECK_FALSE(world.finds_within(0.1f));
        world.bodies[1].angle = 0.1f;
        world.bodies[1].position = Vec2(0.5f, 5) + 0.5f * Vec2(std::cos(0.1f), std::sin(0.1f));
        world.bodies[1].load = load;
        CHECK(world.finds_within(1) == (load < 1000));
    }
}

TEST_CASE("the invariant of frozen bodies allows what joints hold at a body in an overlap") {
    for (const float overlap : {0.0f, 0.05f}) {
        CAPTURE(overlap);
        HandMade world("frozen", two_boxes(JointType::revolute));
        world.bodies[0].deepest = overlap;
        world.bodies[0].touched = {the_world};
        world.bodies[1].velocity = {2, 0};
        CHECK(world.finds_within(0.2f) == (overlap == 0));
    }
}

TEST_CASE("the time in which a world comes to rest begins again when a tower falls over") {
    for (const bool falls : {false, true}) {
        CAPTURE(falls);
        WorldPlan plan;
        plan.bodies.push_back({.def = {.position = {0, 5}}, .shapes = {{Box{}}}});
        HandMade world("rest", plan);
        CHECK_FALSE(world.finds_within(6));
        if (falls) world.bodies[0].position.y = world.bodies[0].center.y = 3;
        CHECK(world.finds_within(4) != falls);
        CHECK((falls ? world.finds_within(6) : true));
    }
}

}  // namespace wild_checks_test
