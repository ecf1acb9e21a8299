#include <atomic>
#include <utility>

#include <fettle/property/exception_text.h>
#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

std::uint64_t Tree::State::next_number() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

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
    const Pin pin(*this, "the function given to mark_weight");
    const auto passed = std::exchange(mark_passed, {});
    if (!passed || ending) return;
    try {
        passed();
    } catch (...) {  // what grows is in the middle of a change
        tell_error({.path = "mark_weight",
                    .where = {},
                    .message = exception_text(),
                    .exception = std::current_exception()});
    }
}

}  // namespace fettle::property
