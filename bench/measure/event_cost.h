#pragma once
// The cost of receiving an event when one body has very many contacts: boxes that rest side by side
// on one floor, with a handler for continuing touches.

#include <functional>
#include <vector>

namespace fettle::bench {

struct EventCost {
    int boxes = 0;
    double ns_native = 0;  // per event, with a handler in C++
    double ns_script = 0;  // per event, with a handler in Lua that reads all its data
};

/// `progress` receives the share of work done since the previous call.
std::vector<EventCost> event_costs(const std::function<void(double)>& progress);

}  // namespace fettle::bench
