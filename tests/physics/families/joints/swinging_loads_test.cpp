// Chains of light links whose load swings: the links turn faster than a sub-step can follow, and
// the chain must hold. FETTLE_SEEDS=n: n chains.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "catch.h"
#include "family.h"

namespace swinging_loads_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;
using families::turned;

namespace {

/// A chain that hangs from the world, in any direction and pushed, with a load at its end.
class Chain {
  public:
    Chain(Random& random, Solver solver, float greatest_ratio) : world_({.solver = solver}) {
        const int links = 1 + int(random(0, 11));
        const float length = random(0.2f, 0.6f), mass = random(0.02f, 0.1f);
        const Vec2 way = turned(random(-3, 0));
        const float ratio = std::pow(10.0f, random(1.5f, std::log10(greatest_ratio)));
        Body above;
        for (int i = 0; i <= links; ++i) {
            const bool load = i == links;
            const float half = load ? 0.5f : 0.5f * length;
            const auto center = Vec2((float(i) * length + half) * way);
            Body next = world_.create_body({.position = Position(center),
                                            .angle = std::atan2(way.y, way.x),
                                            .velocity = load ? push(random) : Vec2(),
                                            .mass = load ? ratio * mass : mass});
            next.add(Box{.width = 2 * half, .height = load ? 1.0f : 0.1f}, {.mask = 0});
            world_.create_revolute_joint(
                {.body_a = above ? above.id() : BodyId(),
                 .body_b = next.id(),
                 .anchor_a = above ? Position(0.5f * length, 0) : Position(),
                 .anchor_b = Position(-half, 0)});
            above = next;
        }
        load_ = above;
        reach_ = float(links) * length + 0.5f;
        what_ = std::to_string(links) + " links of " + std::to_string(length) + " m, load " +
                std::to_string(ratio) + " : 1";
    }

    /// Runs for five seconds.
    void run() {
        const float start = energy();
        for (int i = 0; i < 300; ++i) {
            world_.step(1.0f / 60);
            excess_ = std::max(excess_, (energy() - start) / load_.mass());
            // A slack chain that snaps taut may give way for some steps. One that parts stays so.
            for (const Joint& joint : world_.joints())
                if (i >= 240) gap_ = std::max(gap_, joint.separation());
        }
    }
    /// How far a joint was apart at most in the last second, m.
    float gap() const { return gap_; }
    /// The greatest gain of energy of the load, J/kg.
    float excess() const { return excess_; }
    float reach() const { return reach_; }
    const std::string& what() const { return what_; }

  private:
    static Vec2 push(Random& random) { return random(0, 4) * turned(random(-3, 3)); }
    float energy() const {
        return load_.kinetic_energy() + load_.mass() * 10 * float(load_.position().y);
    }

    World world_;
    Body load_;
    float reach_ = 0, gap_ = 0, excess_ = 0;
    std::string what_;
};

}  // namespace

TEST_CASE("chains of light links bear a load that swings", "[families]") {
    struct Row {
        Solver solver;
        const char* name;
        float greatest_ratio;
        float gap;  ///< as a part of the reach of the chain
    };
    const Row rows[] = {{Solver::direct, "direct", 20000, 0.05f},
                        {Solver::soft_step, "soft_step", 2000, 0.1f},
                        {Solver::sequential, "sequential", 100, 0.1f}};
    for (const Row& row : rows) {
        float widest = 0, most = 0;
        std::string worst;
        for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
            Random random{std::mt19937(seed)};
            Chain chain(random, row.solver, row.greatest_ratio);
            chain.run();
            const float gap = chain.gap() / chain.reach();
            if (gap > widest) worst = "seed " + std::to_string(seed) + ", " + chain.what();
            widest = std::max(widest, gap);
            most = std::max(most, chain.excess() / (10 * chain.reach()));
        }
        INFO(row.name << ": widest gap " << widest << " of the reach (" << worst
                      << "), energy of the load grows by " << most << " of m*g*reach");
        CHECK(widest < row.gap);
        CHECK(most < 0.1f);
    }
}

}  // namespace swinging_loads_test
