#include "untold.h"

#include <algorithm>

#include <fettle/property/tree.h>

namespace fettle::property {
namespace {

// Ends come with the next step; these many are of worlds that are not stepped.
constexpr std::size_t most = 4096;

}  // namespace

bool names_deleted(const Tree& tree, const Value& value) {
    if (value.is(Type::list))
        return std::ranges::any_of(
            value.list(), [&](const Value& element) { return names_deleted(tree, element); });
    return value.is(Type::reference) && value.reference() && !tree.alive(value.reference());
}

void UntoldBeginnings::note(const Tree& tree, const Occurrence& beginning) {
    if (list_.size() >= most) {
        std::erase_if(list_, [&](const Untold& untold) { return !tree.alive(untold.instance); });
        if (list_.size() >= most) list_.erase(list_.begin(), list_.begin() + most / 2);
    }
    const std::vector<Value>& values = beginning.record.values;
    const auto count =
        static_cast<std::ptrdiff_t>(std::min(values.size(), beginning.event->end->fields.size()));
    list_.push_back(
        {beginning.instance, beginning.event, {values.begin(), values.begin() + count}});
}

bool UntoldBeginnings::take(const Occurrence& end) {
    const auto found = std::ranges::find_if(list_, [&](const Untold& untold) {
        return untold.instance == end.instance && untold.event == end.event->begin &&
               untold.names == end.record.values;
    });
    if (found == list_.end()) return false;
    list_.erase(found);
    return true;
}

}  // namespace fettle::property
