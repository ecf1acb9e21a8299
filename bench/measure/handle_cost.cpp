#include "measure/handle_cost.h"

#include <fettle_host.h>

#include <algorithm>
#include <stdexcept>

#include "measure/timing.h"

namespace fettle::bench {
namespace {

constexpr int handle_timings = 15;
constexpr int calls_a_timing = 1'000'000;

void require(fettle_code code) {
    if (code != FETTLE_DONE) throw std::runtime_error(fettle_last_error());
}

template <class Call>
HandleCost cost(const char* name, Call call) {
    std::vector<double> ns;
    for (int k = 0; k < handle_timings; ++k) {
        const ThreadClock clock;
        for (int i = 0; i < calls_a_timing; ++i) require(call(i));
        ns.push_back(clock.elapsed_ms() * 1e6 / calls_a_timing);
    }
    return {name, median(ns), *std::ranges::min_element(ns)};
}

}  // namespace

std::vector<HandleCost> handle_costs() {
    fettle_hosted* game = nullptr;
    require(fettle_hosted_create(nullptr, &game));
    require(
        fettle_hosted_run(game, "world.ball = Body { Circle {}, position = vec(0, 5) }", "ball"));
    fettle_property_id height = 0, position = 0, scale = 0;
    require(fettle_property_at(game, "world.ball.position.y", &height));
    require(fettle_property_at(game, "world.ball.position", &position));
    require(fettle_property_at(game, "world.ball.gravity_scale", &scale));
    double x = 0, y = 0;
    std::vector<HandleCost> costs;
    costs.push_back(cost("get a number by handle",
                         [&](int) { return fettle_property_get_number(game, scale, &x); }));
    costs.push_back(cost("get a component by handle",
                         [&](int) { return fettle_property_get_number(game, height, &y); }));
    costs.push_back(cost("get a vector by handle",
                         [&](int) { return fettle_property_get_vec2(game, position, &x, &y); }));
    costs.push_back(cost("set a number by handle",
                         [&](int i) { return fettle_property_set_number(game, scale, i % 2); }));
    require(fettle_hosted_destroy(game));
    return costs;
}

}  // namespace fettle::bench
