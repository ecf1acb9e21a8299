#include "wild/same_runs.h"

#include "wild/plans/fettle_world.h"

namespace fettle::bench::wild {
namespace {

struct Run {
    std::string name;
    std::unique_ptr<FettleWorld> world;
};

}  // namespace

std::optional<Finding> compare_runs(const WorldPlan& plan) {
    const auto on_threads = [&](int threads) {
        auto world = std::make_unique<FettleWorld>(plan);
        world->fettle()->set_threads(threads);
        return world;
    };
    FettleWorld first(plan);
    std::vector<Run> others;
    // Threads of a small world mostly wait for each other, which takes longer than all other
    // checks.
    if (plan.bodies.size() > 100 || plan.seed % 4 == 0) {
        others.push_back({"on two threads", on_threads(2)});
        others.push_back({"on three threads", on_threads(3)});
    }
    others.push_back({"when it is read after edits", std::make_unique<FettleWorld>(plan)});
    others.back().world->read_after_edits();
    for (int step = 0; step < plan.steps; ++step) {
        if (step == plan.steps / 2) {
            others.push_back({"in a restored world", first.restored()});
            others.push_back({"in a copied world", std::make_unique<FettleWorld>(first)});
        }
        const auto advance = [&](FettleWorld& world) {
            world.prepare(step);
            world.advance(plan.length_of(step));
        };
        advance(first);
        const std::uint64_t hash = first.world().hash();
        for (const Run& other : others) {
            advance(*other.world);
            if (other.world->world().hash() != hash)
                return Finding{"same", step, "other bits " + other.name};
        }
    }
    return {};
}

}  // namespace fettle::bench::wild
