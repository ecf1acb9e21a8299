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
    const Instances& instances = s.instances;
    instances.require(top);
    const Drawing drawing(alpha);
    const Pin pin(state_->lifetime, "a lifecycle function");
    // The functions of modules may change the tree, so the instances are collected before.
    std::vector<Handle> drawn, over;
    instances.visit_below(top.index, [&](std::uint32_t i) {
        const Lifecycle& lifecycle = instances.class_of(instances.nodes[i]).lifecycle();
        if (lifecycle.draw) drawn.push_back(instances.nodes.handle(i));
        if (lifecycle.draw_over) over.push_back(instances.nodes.handle(i));
    });
    const auto draw_all = [&](const std::vector<Handle>& all, auto Lifecycle::*function) {
        for (const Handle self : all) {
            const Node* const node = instances.nodes.find(self);
            if (node == nullptr) continue;
            const Lifecycle& lifecycle = instances.class_of(*node).lifecycle();
            (lifecycle.*function)(lifecycle.context, *this, self, node->row, painter, alpha);
        }
    };
    draw_all(drawn, &Lifecycle::draw);
    draw_all(over, &Lifecycle::draw_over);
}

}  // namespace fettle::property
