#pragma once
// What it costs to hear of an event, where one body has very many contacts: boxes that rest side by
// side on one floor, with a listener to the touches that go on.

#include <functional>
#include <vector>

namespace fettle::bench {

struct EventCost {
    int boxes = 0;
    double ns_native = 0;  // an event, with a handler in C++
    double ns_script = 0;  // with one in Lua that reads all that the event tells
};

/// `progress` is told the share that was done since it was told last.
std::vector<EventCost> event_costs(const std::function<void(double)>& progress);

}  // namespace fettle::bench
