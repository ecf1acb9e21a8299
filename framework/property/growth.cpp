#include <utility>

#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

std::int64_t Tree::weight() const {
    return state_->weight;
}

void Tree::add_weight(std::int64_t bytes) {
    state_->add_weight(bytes);
}

void Tree::mark_weight(std::int64_t mark, std::function<void()> passed) {
    state_->weight_mark = mark;
    state_->mark_passed = std::move(passed);
}

void Tree::State::pass_mark() {
    weight_mark = INT64_MAX;
    // It may set another.
    if (const auto passed = std::exchange(mark_passed, {})) passed();
}

}  // namespace fettle::property
