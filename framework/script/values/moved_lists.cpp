#include <values/moved_lists.h>

#include <algorithm>
#include <utility>

namespace fettle::script {

using property::List;
using property::Type;
using property::Value;

namespace {

constexpr std::size_t most_elements = 1'000'000;  // that are kept; the earliest are forgotten

bool same_property(const Origin& a, const Origin& b) {
    const auto name = [](const Origin& each) {
        return each.property != nullptr ? each.property->symbol : each.symbol;
    };
    return a.instance == b.instance && name(a) == name(b);
}

/// Whether `inner` is in one of these elements of the list at `outer`.
bool is_within(const Origin& inner, const Origin& outer, std::size_t first, std::size_t last) {
    if (inner.depth <= outer.depth || !same_property(inner, outer)) return false;
    if (!std::equal(outer.part, outer.part + outer.depth, inner.part)) return false;
    const std::size_t element = inner.part[outer.depth];
    return element >= first && element <= last;
}

}  // namespace

void MovedLists::note(const Origin& place, std::size_t first, std::size_t last, Value before) {
    const List& list = before.list();
    const auto is_list = [](const Value& each) { return each.is(Type::list); };
    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first - 1);
    if (std::none_of(begin, list.begin() + static_cast<std::ptrdiff_t>(std::min(last, list.size())),
                     is_list))
        return;
    if (first == last) before = Value(*begin);
    keep({next_++, place, first, last, std::move(before)});
}

void MovedLists::note_whole(const Origin& place, Value before) {
    keep({next_++, place, 0, 0, std::move(before)});
}

void MovedLists::keep(Move move) {
    elements_ += move.before.list().size() + 1;
    all_.push_back(std::move(move));
    while (elements_ > most_elements) {
        elements_ -= all_.front().before.list().size() + 1;
        all_.pop_front();
    }
}

std::optional<Value> MovedLists::find(const Origin& place, std::uint64_t since) const {
    if (since >= next_) return std::nullopt;
    for (auto move = std::ranges::lower_bound(all_, since, {}, &Move::number); move != all_.end();
         ++move) {
        if (place.depth == 0 && move->first == 0 && same_property(place, move->place))
            return move->before;
        if (!is_within(place, move->place, move->first, move->last)) continue;
        Value value = move->before;
        std::uint32_t depth = move->place.depth + (move->first == move->last ? 1 : 0);
        for (; depth < place.depth; ++depth) {
            const std::size_t index = place.part[depth];
            if (!value.is(Type::list) || index > value.list().size()) return std::nullopt;
            value = Value(value.list()[index - 1]);
        }
        return value;
    }
    return std::nullopt;
}

void MovedLists::forget() {
    if (all_.empty()) return;
    all_.clear();
    elements_ = 0;
}

}  // namespace fettle::script
