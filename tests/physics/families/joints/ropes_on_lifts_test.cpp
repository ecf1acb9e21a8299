// Bodies on ropes, rods and pulleys that a kinematic body presses farther than these reach: a lift
// below a ball that is tied to the ground. The joint must yield, and nothing may be thrown or drawn
// into the lift. FETTLE_SEEDS=n: n bodies of each kind.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace ropes_on_lifts_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

enum Kind { rope, rod, pulley, two_rods, drawn_down, kinds };
constexpr const char* names[kinds] = {"rope", "rod", "pulley", "two rods", "drawn down"};

struct Result {
    float fastest = 0, deepest = 0;
};

class Lift {
  public:
    Lift(Kind kind, Solver solver, Random& random)
        : kind_(kind), world_({.solver = solver}), rate_(random(30, 144)) {
        world_.create_body({.type = BodyType::static_body})
            .add(Box{.width = 60, .height = 2, .center = {0, -1}});
        lift_ = world_.create_body({.type = BodyType::kinematic_body, .position = {0, 0.15f}});
        lift_.add(Box{.width = 4, .height = 0.3f});
        body_ = world_.create_body({.position = {random(-1, 1), 0.8f}});
        const ShapeDef surface = {.density = random(0.2f, 5), .friction = random(0, 1)};
        if (random(0, 1) < 0.5f)
            body_.add(Circle{.radius = 0.5f}, surface);
        else
            body_.add(Box{}, surface);
        speed_ = random(0.5f, 4);
        hook_ = {random(-1, 1), 0.2f};
        length_ = random(2, 3);
        tie();
    }

    Result run() {
        Result result;
        const Vec2 down = {0, -speed_};
        kind_ == drawn_down ? hook_body_.set_velocity(down) : lift_.set_velocity(-down);
        while (lift_.position().y < 6 && (kind_ != drawn_down || hook_body_.position().y > -4)) {
            world_.step(1 / rate_);
            result.fastest = std::max(result.fastest, body_.velocity().length());
            for (const Contact& contact : body_.contacts())
                for (int k = 0; k < contact.point_count; ++k)
                    result.deepest = std::max(result.deepest, -contact.points[k].separation);
        }
        return result;
    }

  private:
    void tie() {
        JointDef ends{.body_b = body_.id(), .anchor_a = hook_};
        if (kind_ == pulley) {
            PulleyJointDef def = ends;
            hook_body_ = world_.create_body(
                {.type = BodyType::kinematic_body, .position = {hook_.x + 20, 5}});
            def.body_a = hook_body_.id();
            def.anchor_a = {};
            def.ground_a = {hook_.x + 20, 10};
            def.ground_b = hook_;
            world_.create_pulley_joint(def);
            return;
        }
        if (kind_ == two_rods) {
            Body knot =
                world_.create_body({.position = {(hook_.x + body_.position().x) / 2, 0.5f}});
            knot.add(Circle{.radius = 0.05f}, {.mask = 0});
            DistanceJointDef lower = ends, upper = ends;
            lower.body_b = upper.body_a = knot.id();
            upper.anchor_a = {};
            lower.length = upper.length = length_ / 2;
            world_.create_distance_joint(lower);
            world_.create_distance_joint(upper);
            return;
        }
        if (kind_ == drawn_down) {
            hook_body_ = world_.create_body({.type = BodyType::kinematic_body, .position = hook_});
            ends.body_a = hook_body_.id();
            ends.anchor_a = {};
        }
        DistanceJointDef def = ends;
        def.hertz = kind_ == rod ? infinity : 0;
        if (kind_ != rod) def.max_length = length_;
        world_.create_distance_joint(def);
    }

    Kind kind_;
    World world_;
    float rate_, speed_ = 0, length_ = 0;
    Position hook_;
    Body lift_, body_, hook_body_;
};

}  // namespace

TEST_CASE("a lift that rises farther than a rope reaches throws nothing and takes nothing in",
          "[families]") {
    for (const Solver solver : {Solver::soft_step, Solver::direct}) {
        for (int kind = 0; kind < kinds; ++kind) {
            Result worst;
            unsigned fastest = 0, deepest = 0;
            for (unsigned seed = 0; seed < seeds_or(40); ++seed) {
                Random random{std::mt19937(seed)};
                const Result result = Lift(Kind(kind), solver, random).run();
                if (result.fastest > worst.fastest) worst.fastest = result.fastest, fastest = seed;
                if (result.deepest > worst.deepest) worst.deepest = result.deepest, deepest = seed;
            }
            std::printf("%s, solver %d: fastest %.1f m/s (seed %u), deepest %.3f m (seed %u)\n",
                        names[kind], int(solver), double(worst.fastest), fastest,
                        double(worst.deepest), deepest);
            INFO(names[kind] << ", solver " << int(solver));
            CHECK(worst.fastest < 35);
            CHECK(worst.deepest < 0.1f);
        }
    }
}

}  // namespace ropes_on_lifts_test
