// Where Box2D is not installed, it can represent no plan.

#include "wild/plans/running_world.h"

namespace fettle::bench::wild {

std::unique_ptr<RunningWorld> run_in_box2d(const WorldPlan&) {
    return nullptr;
}

}  // namespace fettle::bench::wild
