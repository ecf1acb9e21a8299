#include "running.h"

namespace fettle::module {

RunningFunction running_function() noexcept {
    const Named* const owner = running_owner.load(std::memory_order_relaxed);
    const char* const function = running_name.load(std::memory_order_relaxed);
    if (owner == nullptr || owner->module == nullptr) return {};
    return {owner->module, function, owner->class_name, owner->member};
}

}  // namespace fettle::module
