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
    /// True if the check finds something in a step in which a body moves to that place, or in the
    /// second after it.
    bool finds_on_way(std::size_t body, Vec2 to) {
        const std::vector<BodyNow> before = bodies;
        BodyNow& moved = bodies[body];
        moved.velocity = (to - moved.position) / dt;
        moved.position = moved.center = to;
        const std::vector<bool> edited(bodies.size(), false);
        time_ += dt;
        return check_->violation({plan_, step_++, dt, false, edited, before, bodies}) ||
               finds_within(1);
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

TEST_CASE("a body that clips a corner in a step does not pass through") {
    struct Way {
        Vec2 from, to;
        bool through;
    };
    // Both ways round each corner, and through the middle.
    std::vector<Way> ways = {{{0, -1}, {0, 1}, true}, {{2, 0}, {-2, 0}, true}};
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f}) {
            ways.push_back({{1.27f * x, 0.13f * y}, {1.2f * x, 0.17f * y}, false});
            ways.push_back({{1.2f * x, 0.17f * y}, {1.27f * x, 0.13f * y}, false});
        }
    for (const Way& way : ways) {
        CAPTURE(way.from.x, way.from.y, way.to.x);
        WorldPlan plan;
        plan.bodies.push_back({.def = {.type = BodyType::static_body},
                               .shapes = {{Box{.width = 2.5f, .height = 0.3f}}}});
        plan.bodies.push_back(
            {.def = {.position = way.from}, .shapes = {{Circle{.radius = 0.01f}}}});
        HandMade world("through", plan);
        CHECK(world.finds_on_way(1, way.to) == way.through);
    }
}

TEST_CASE("a thin body that is pressed in by its own thickness does not pass through") {
    struct Pressed {
        fettle::physics::Geometry body, obstacle;
        float depth;
        bool through;
    };
    const fettle::physics::Geometry thick = Box{.height = 1}, thin = Box{.height = 0.01f};
    const fettle::physics::Geometry line = Segment{.from = {-5, 0}, .to = {5, 0}};
    const fettle::physics::Geometry grain = Circle{.radius = 0.01f}, ball = Circle{.radius = 0.2f};
    for (const Pressed& each : {Pressed{grain, line, 0.005f, false},
                                {grain, line, 0.02f, true},
                                Pressed{ball, line, 0.02f, true},
                                {grain, thick, 0.005f, false},
                                Pressed{grain, thick, 0.02f, true},
                                {ball, thick, 0.02f, true},
                                Pressed{grain, thin, 0.004f, true}}) {
        CAPTURE(each.depth, each.through);
        const bool on_line = std::holds_alternative<Segment>(each.obstacle);
        const float top = on_line ? 0 : 0.5f * std::get<Box>(each.obstacle).height;
        WorldPlan plan;
        plan.bodies.push_back(
            {.def = {.type = BodyType::static_body}, .shapes = {{each.obstacle}}});
        plan.bodies.push_back({.def = {.position = {0, top + 0.3f}}, .shapes = {{each.body}}});
        HandMade world("through", plan);
        CHECK_FALSE(world.finds_within(0.1f));  // a body that is made inside another is not judged
        CHECK(world.finds_on_way(1, {0, top - each.depth}) == each.through);
    }
}

TEST_CASE("the invariant of energy allows a push to move what is joined to its body at once") {
    for (const bool overlaps : {false, true}) {
        CAPTURE(overlaps);
        HandMade world("energy", two_boxes(JointType::revolute));
        world.bodies[1].mass = 10;
        world.bodies[0].deepest = overlaps ? 0.1f : 0.0f;
        CHECK(world.finds_on_way(1, world.bodies[1].position + Vec2(2.5f * dt, 0)) != overlaps);
    }
}

TEST_CASE("the invariant of energy allows more speed to a body far up in a row that overlaps") {
    struct Row {
        bool overlaps, stands;
        float speed;  // of the third body, m/s
        bool found;
    };
    for (const Row& row : {Row{false, true, 8, true},
                           {true, true, 8, false},
                           {true, false, 8, true},
                           Row{true, true, 11, true}}) {
        CAPTURE(row.overlaps, row.stands, row.speed);
        WorldPlan plan;
        plan.def.gravity = {};
        plan.bodies.push_back({.def = {.type = BodyType::static_body}, .shapes = {{Box{}}}});
        for (int i = 1; i <= 3; ++i)
            plan.bodies.push_back({.def = {.position = {0, 0.9f * float(i)}}, .shapes = {{Box{}}}});
        HandMade world("energy", plan);
        for (std::size_t i = 1; i <= 3; ++i) {
            world.bodies[i].deepest = row.overlaps ? 0.1f : 0;
            if (i > 1 || row.stands) world.bodies[i].touched.push_back(int(i) - 1);
            if (i < 3) world.bodies[i].touched.push_back(int(i) + 1);
            world.bodies[i].mass = i < 3 ? 1e-3f : 1;
        }
        const Vec2 place = world.bodies[3].position;
        CHECK(world.finds_on_way(3, place + Vec2(0, row.speed * dt)) == row.found);
    }
}

TEST_CASE("the invariant of energy knows a joint at a wrong angle as a spring") {
    for (const float angle : {0.0f, 0.1f}) {
        CAPTURE(angle);
        HandMade world("energy", two_boxes(JointType::weld));
        world.bodies[1].angle = angle;
        world.bodies[1].position = Vec2(0.5f, 5) + 0.5f * Vec2(std::cos(angle), std::sin(angle));
        world.bodies[1].center = world.bodies[1].position;
        CHECK_FALSE(world.finds_within(0.1f));
        world.bodies[1].angular_velocity = 4;
        CHECK(world.finds_within(0.1f) == (angle == 0));
    }
}

TEST_CASE("the invariant of energy does not judge what a body without inertia turns") {
    for (const float rate : {0.0f, 1.0f}) {
        CAPTURE(rate);
        HandMade world("energy", two_boxes(JointType::revolute));
        world.bodies[0].inertia = 0;
        world.bodies[0].angular_velocity = rate;
        CHECK_FALSE(world.finds_within(0.1f));
        world.bodies[1].velocity = {5, 0};
        CHECK(world.finds_within(0.1f) == (rate == 0));
    }
}

TEST_CASE("a bullet that takes a body along round its tip does not pass through it") {
    // The paddle turns by a radian. Seen from it, the body moves round the tip: the chord between
    // its places is beyond the tip, and the way at constant speed goes through the paddle.
    for (const bool bullet : {false, true}) {
        CAPTURE(bullet);
        WorldPlan plan;
        plan.bodies.push_back(
            {.def = {.type = bullet ? BodyType::dynamic_body : BodyType::kinematic_body,
                     .bullet = bullet},
             .shapes = {{Box{.width = 2, .height = 0.1f}}}});
        plan.bodies.push_back(
            {.def = {.position = {0.97f, -0.2f}}, .shapes = {{Circle{.radius = 0.05f}}}});
        HandMade world(bullet ? "bullets" : "through", plan);
        world.bodies[0].angle = 1;
        const Vec2 beyond = 1.2f * Vec2(std::cos(1.05f), std::sin(1.05f));
        CHECK_FALSE(world.finds_on_way(1, beyond));
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
