#include "measure/event_cost.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include "engines/hosted_engine.h"
#include "measure/simulation.h"
#include "measure/timing.h"

namespace fettle::bench {
namespace {

constexpr int steps_to_rest = 30;       // steps until the boxes are at rest
constexpr int timings = 15;             // of each kind, in turns
constexpr int events_a_timing = 40000;  // minimum

Scene boxes_on_a_floor(int boxes) {
    Scene scene;
    scene.sleeping = false;
    const float width = 1.5f * static_cast<float>(boxes);
    scene.bodies.push_back(fixed_box({0, -1}, {0.5f * width + 1, 1}));
    for (int i = 0; i < boxes; ++i)
        scene.bodies.push_back(
            dynamic_box({1.5f * (static_cast<float>(i) + 0.5f) - 0.5f * width, 0.5f}, 0.5f));
    return scene;
}

/// A world in the tree with a handler, or without one. The handler is registered for the class of
/// bodies, so both bodies of each touch get the event.
class WorldWithHandler {
  public:
    WorldWithHandler(const Scene& scene, const std::string& script, bool native)
        : engine_(scene, false) {
        HeadlessGame& game = engine_.game();
        if (!script.empty() && !game.runtime.run(script, "handler"))
            throw std::runtime_error("the handler of events did not run");
        const property::Class& body = game.tree.class_named("Body");
        if (native)
            game.tree.on(body, *body.event("contact_persist"),
                         [this](const property::Occurrence& o) {
                             values_received_ += o.record.values.size();
                         });
        measured_steps(engine_, steps_to_rest);
    }
    double ms(int steps) {
        const ThreadClock clock;
        measured_steps(engine_, steps);
        return clock.elapsed_ms();
    }

  private:
    HostedEngine engine_;
    std::uint64_t values_received_ = 0;
};

const char* const handler = R"lua(
local sum = 0
Body:on("contact_persist", function(contact)
    sum = sum + contact.point.x + contact.normal.y + contact.impulse + contact.speed
        + contact.friction + contact.restitution
    if contact.other == contact.shape or contact.other_shape == nil then error("no contact") end
end)
)lua";

EventCost cost_with(int boxes, const std::function<void(double)>& progress) {
    const Scene scene = boxes_on_a_floor(boxes);
    WorldWithHandler without(scene, "", false), native(scene, "", true),
        script(scene, handler, false);
    const int steps = std::max(2, events_a_timing / (2 * boxes));
    std::vector<double> ns_native, ns_script;
    for (int i = 0; i < timings; ++i) {
        const double events = 2.0 * boxes * steps;
        const double bare = without.ms(steps);
        ns_native.push_back((native.ms(steps) - bare) * 1e6 / events);
        ns_script.push_back((script.ms(steps) - bare) * 1e6 / events);
        progress(1.0 / timings);
    }
    return {boxes, median(ns_native), median(ns_script)};
}

}  // namespace

std::vector<EventCost> event_costs(const std::function<void(double)>& progress) {
    constexpr int counts[] = {100, 1000, 10000};
    std::vector<EventCost> all;
    for (const int boxes : counts)
        all.push_back(cost_with(boxes, [&](double share) { progress(share / std::size(counts)); }));
    return all;
}

}  // namespace fettle::bench
