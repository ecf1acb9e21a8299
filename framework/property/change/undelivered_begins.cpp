#include "undelivered_begins.h"

#include <algorithm>

#include <fettle/property/tree.h>

namespace fettle::property {
namespace {

// An end event follows within a step or so. More than this number can gather only in worlds that
// are not stepped.
constexpr std::size_t limit = 4096;

}  // namespace

bool names_deleted(const Tree& tree, const Value& value) {
    if (value.is(Type::list))
        return std::ranges::any_of(
            value.list(), [&](const Value& element) { return names_deleted(tree, element); });
    return value.is(Type::reference) && value.reference() && !tree.alive(value.reference());
}

void UndeliveredBegins::note(const Tree& tree, const Occurrence& beginning,
                             const Reached& reached) {
    if (list_.size() >= limit) {
        std::erase_if(list_, [&](const Undelivered& undelivered) {
            return !tree.alive(undelivered.instance);
        });
        if (list_.size() >= limit) list_.erase(list_.begin(), list_.begin() + limit / 2);
    }
    const std::vector<Value>& values = beginning.record.values;
    const auto count =
        static_cast<std::ptrdiff_t>(std::min(values.size(), beginning.event->end->fields.size()));
    list_.push_back(
        {beginning.instance, beginning.event, {values.begin(), values.begin() + count}, reached});
}

std::optional<UndeliveredBegins::Reached> UndeliveredBegins::take(const Occurrence& end) {
    const auto found = std::ranges::find_if(list_, [&](const Undelivered& undelivered) {
        return undelivered.instance == end.instance && undelivered.event == end.event->begin &&
               undelivered.names == end.record.values;
    });
    if (found == list_.end()) return std::nullopt;
    const Reached reached = found->reached;
    list_.erase(found);
    return reached;
}

}  // namespace fettle::property
