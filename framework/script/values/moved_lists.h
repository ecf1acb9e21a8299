#pragma once
// The former values of nested lists that the running call has moved or replaced. A Lua variable
// with such a list stores only its place (see `Origin`), where another list may be now. With the
// former value, the variable still reads its own list, as it would with tables of Lua: grid[1],
// grid[2] = grid[2], grid[1].

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include <fettle/property/value.h>

#include <values/values.h>

namespace fettle::script {

class MovedLists {
  public:
    /// The value of `since` for a list that is read now.
    std::uint64_t now() const { return next_; }
    /// Stores `before`, the former value of the list at `place`, whose elements `first` to `last`
    /// (from 1) were changed.
    void note(const Origin& place, std::size_t first, std::size_t last, property::Value before);
    /// Stores `before`, the former value of the property at `place`, which is a list. A variable
    /// that refers to the list reads the new value; only an assignment of the variable uses the
    /// former one: a.points, b.points = b.points, a.points.
    void note_whole(const Origin& place, property::Value before);
    /// The former value of the list at `place` that was read at `since`; nothing if it is still
    /// there.
    std::optional<property::Value> find(const Origin& place, std::uint64_t since) const;
    /// Drops the former values, at the end of a call.
    void forget();

  private:
    struct Move {
        std::uint64_t number = 0;
        Origin place;
        std::size_t first = 0, last = 0;  // 0: the whole property
        property::Value before;           // only the element, if there is one
    };
    void keep(Move move);
    std::deque<Move> all_;
    std::uint64_t next_ = 1;
    std::size_t elements_ = 0;  // in all former values
};

}  // namespace fettle::script
