#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fettle::physics::detail {

/// Room for so many more elements, in steps of a fifth. A vector that grows by itself doubles: of
/// what a world keeps for every body and shape, nearly half would be slack in the worst case. A
/// body that is made takes 0.7 µs instead of 0.45 for it, which the first step, 2.6, does not
/// notice.
template <class T>
void make_room(std::vector<T>& list, std::size_t more = 1) {
    const std::size_t needed = list.size() + more;
    if (needed <= list.capacity()) return;
    list.reserve(std::max(needed, list.capacity() + list.capacity() / 5 + 8));
}

/// As `make_room`, for lists that grow together.
template <class... T>
void make_room_in_each(std::vector<T>&... lists) {
    (make_room(lists), ...);
}

}  // namespace fettle::physics::detail
