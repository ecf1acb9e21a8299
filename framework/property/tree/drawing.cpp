// Drawing of the instances of a tree.

#include <fettle/property/drawing.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "state.h"

namespace fettle::property {
namespace {

thread_local double moment = 1;

}  // namespace

Drawing::Drawing(double alpha) : before_(std::exchange(moment, std::clamp(alpha, 0.0, 1.0))) {}

Drawing::~Drawing() {
    moment = before_;
}

double Drawing::alpha() {
    return moment;
}

void Tree::draw(Handle top, Painter& painter, double alpha) const {
    const State& s = *state_;
    s.instances.require(top);
    const Drawing drawing(alpha);
    const Pin pin(state_->lifetime, "a lifecycle function");
    std::vector<std::uint32_t> over;
    s.instances.visit_below(top.index, [&](std::uint32_t i) {
        const Lifecycle& lifecycle = s.instances.classes[s.instances.nodes[i].class_id].lifecycle();
        if (lifecycle.draw)
            lifecycle.draw(lifecycle.context, *this, s.instances.nodes.handle(i),
                           s.instances.nodes[i].row, painter, alpha);
        if (lifecycle.draw_over) over.push_back(i);
    });
    for (const std::uint32_t i : over) {
        const Lifecycle& lifecycle = s.instances.classes[s.instances.nodes[i].class_id].lifecycle();
        lifecycle.draw_over(lifecycle.context, *this, s.instances.nodes.handle(i),
                            s.instances.nodes[i].row, painter, alpha);
    }
}

}  // namespace fettle::property
