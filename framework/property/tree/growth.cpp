// Estimated memory of a tree.

#include <atomic>
#include <utility>

#include <fettle/property/exception_text.h>

#include "state.h"

namespace fettle::property {

std::uint64_t Tree::State::next_number() {
    static std::atomic<std::uint64_t> last = 0;
    return ++last;
}

std::int64_t Tree::weight() const {
    return state_->changes.growth.bytes;
}

void Tree::add_weight(std::int64_t bytes) {
    state_->changes.growth.add(bytes);
}

void Tree::mark_weight(std::int64_t mark, std::function<void()> passed) {
    state_->changes.growth.mark = mark;
    state_->changes.growth.mark_passed = std::move(passed);
}

}  // namespace fettle::property
