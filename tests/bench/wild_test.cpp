// The generator of random worlds, the checks of their steps, and the minimizer of failing worlds.

#include <algorithm>
#include <set>

#include "catch.h"
#include "wild/generator/random_world.h"
#include "wild/minimize.h"
#include "wild/plans/cpp_text.h"
#include "wild/survey.h"

namespace wild_test {

using namespace fettle::bench::wild;

namespace {

/// An invariant that real worlds violate: fewer than three discs touch the floor, which is body 0.
class FewDiscsOnFloor : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        int discs = 0;
        for (std::size_t i = 1; i < moment.after.size(); ++i)
            if (std::ranges::count(moment.after[i].touched, 0) > 0 &&
                is_disc(moment.plan.bodies[i]))
                ++discs;
        return discs < 3 ? std::nullopt : std::optional(std::to_string(discs) + " discs");
    }

  private:
    static bool is_disc(const BodyPlan& body) {
        return !body.shapes.empty() && std::holds_alternative<Circle>(body.shapes[0].geometry);
    }
};

const std::vector<Invariant> few_discs = {
    // Fewer than three discs touch the floor.
    {"discs", [](const WorldPlan&) { return std::make_unique<FewDiscsOnFloor>(); }}};

bool fails(const WorldPlan& plan) {
    return !try_in_fettle(plan, few_discs, false).findings.empty();
}

/// Ten discs, ten boxes and some joints and edits above a floor.
WorldPlan crowd() {
    WorldPlan plan;
    plan.steps = 200;
    plan.def.substeps = 6;
    plan.bodies.push_back({.def = {.type = BodyType::static_body, .position = {0, -0.5f}},
                           .shapes = {{Box{.width = 100, .height = 1}}}});
    for (int i = 0; i < 10; ++i) {
        const Vec2 place(2.0f * float(i), 3.123f);
        plan.bodies.push_back(
            {.def = {.position = place, .velocity = {0.3f, 0}}, .shapes = {{Circle{}}}});
        plan.bodies.push_back({.def = {.position = place + Vec2(0, 2)}, .shapes = {{Box{}}}});
        plan.joints.push_back({.type = JointType::distance,
                               .a = 2 * i + 1,
                               .b = 2 * i + 2,
                               .settings = {{"set_length", {2, 0}}}});
        plan.edits.push_back({.step = 20 + i,
                              .target = Target::shape,
                              .object = 2 * i + 1,
                              .setting = {"set_friction", {0.1f, 0}}});
    }
    return plan;
}

std::string names_of(const Survey& survey) {
    std::string text;
    for (const Found& found : survey.found)
        text += std::to_string(found.seed) + " " + found.finding.invariant + ": " +
                found.finding.what + "\n";
    return text;
}

}  // namespace

TEST_CASE("equal seeds draw equal worlds and different seeds different ones") {
    std::set<std::string> texts;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const std::string text = cpp_text(random_world(seed));
        CHECK(text == cpp_text(random_world(seed)));
        texts.insert(text);
    }
    CHECK(texts.size() == 100);
}

TEST_CASE("the generator makes every kind of shape and joint and edits") {
    std::set<std::size_t> shapes;
    std::set<JointType> joints;
    std::set<std::string> setters;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const WorldPlan plan = random_world(seed);
        for (const BodyPlan& body : plan.bodies)
            for (const ShapePlan& shape : body.shapes) shapes.insert(shape.geometry.index());
        for (const JointPlan& joint : plan.joints) joints.insert(joint.type);
        for (const Edit& edit : plan.edits) setters.insert(edit.setting.setter);
    }
    CHECK(shapes.size() == std::variant_size_v<fettle::physics::Geometry>);
    CHECK(joints.size() == 12);
    CHECK(setters.size() > 20);
}

TEST_CASE("a world that violates an invariant is found") {
    CHECK(fails(crowd()));
    const PlanRun run = try_in_fettle(crowd(), few_discs, false);
    REQUIRE(run.findings.size() == 1);
    CHECK(run.findings[0].invariant == "discs");
    CHECK(run.findings[0].step < 199);
}

TEST_CASE("an exception of a step is a finding") {
    WorldPlan plan = crowd();
    plan.edits[3].setting.value = {-1, 0};  // a friction that the library refuses
    const PlanRun run = try_in_fettle(plan, few_discs, true);
    CHECK(std::ranges::count(run.findings, "throws", &Finding::invariant) == 1);
}

TEST_CASE("a found world is minimized to what the violation needs") {
    const WorldPlan small = minimized(crowd(), fails);
    CHECK(fails(small));
    INFO(cpp_text(small));
    CHECK(small.bodies.size() == 4);  // the floor and three discs
    CHECK(small.joints.empty());
    CHECK(small.edits.empty());
    CHECK(small.def.substeps == WorldDef{}.substeps);
    CHECK(small.steps < 60);
    CHECK(small.bodies[1].def.velocity == Vec2(0, 0));
    CHECK(small.bodies[1].def.position.y == 3);
}

TEST_CASE("removing a body removes its joints and edits and renumbers the others") {
    WorldPlan plan = crowd();
    plan.remove_body(1);
    CHECK(plan.bodies.size() == 20);
    CHECK(plan.joints.size() == 9);
    CHECK(plan.joints[0].a == 2);
    CHECK(plan.edits.size() == 9);
    CHECK(plan.edits[0].object == 2);
    CHECK(plan.edits[0].step == 21);
}

TEST_CASE("small random worlds violate no invariant") {
    const Survey found = survey(
        {.seed = 1,
         .count = 200,
         .size = 0,
         .invariants = {"finite", "frozen", "momentum", "events", "consistent", "same", "throws"},
         .minimized = 1});
    INFO(names_of(found));
    CHECK(found.worlds == 200);
    CHECK(found.found.empty());
}

TEST_CASE(
    "the invariant of speed allows any speed only to a bouncing ball between a moving wall and a "
    "fixed body") {
    for (const float restitution : {0.0f, 1.0f}) {
        WorldPlan plan;
        plan.bodies.push_back({.def = {.type = BodyType::static_body, .position = {0.5f, 0}},
                               .shapes = {{Circle{.radius = 0.2f}}}});
        plan.bodies.push_back({.def = {.type = BodyType::kinematic_body, .velocity = {20, 0}},
                               .shapes = {{Box{.width = 0.1f, .height = 2}}}});
        plan.bodies.push_back({.shapes = {{Circle{.radius = 0.1f}, {.restitution = restitution}}}});
        std::vector<BodyNow> bodies(3);
        for (std::size_t i = 0; i < 3; ++i)
            bodies[i] = {.exists = true, .awake = true, .type = plan.bodies[i].def.type};
        bodies[0].position = {0.5f, 0};
        bodies[2].position = {0.2f, 0};
        bodies[2].velocity = {500, 0};
        const std::vector<bool> edited(3, false);
        const auto judged = [&](const char* name) {
            const auto check = invariants_named({name})[0].make_check(plan);
            return check->violation({plan, 0, 1.0f / 60, false, edited, bodies, bodies});
        };
        CHECK(judged("speed").has_value() == (restitution == 0));
        bodies[2].position = {5, 0};  // with nothing beside it
        CHECK(judged("speed"));
    }
}

TEST_CASE("a body that an overlap pushes may push bodies that lie on it") {
    WorldPlan plan;
    plan.steps = 30;
    plan.bodies.push_back(
        {.def = {.type = BodyType::static_body, .position = {-5.3f, 3.9f}, .angle = -0.4f},
         .shapes = {{Box{.width = 4, .height = 0.2f}}}});
    for (int i = 0; i < 6; ++i)
        plan.bodies.push_back({.def = {.position = {-6, 4.4f + 1.26f * float(i)}},
                               .shapes = {{Box{.width = 1, .height = 1.26f}}}});
    CHECK(try_in_fettle(plan, invariants_named({"energy"}), false).findings.empty());
}

TEST_CASE("an unknown invariant is named together with those that exist") {
    CHECK_THROWS_WITH(invariants_named({"trough"}), contains("through"));
}

}  // namespace wild_test
