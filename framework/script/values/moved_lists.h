#pragma once
// Lists within lists that the running call has put elsewhere or replaced. A variable of Lua that
// holds one names its place (see `Origin`), where another one is now. It still reads what it was,
// as with tables of Lua: grid[1], grid[2] = grid[2], grid[1].

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include <fettle/property/value.h>

#include <values/values.h>

namespace fettle::script {

class MovedLists {
  public:
    /// For a list that is read now.
    std::uint64_t now() const { return next_; }
    /// In the list at `place`, which was `before`, the elements `first` to `last`, from 1, are
    /// others now.
    void note(const Origin& place, std::size_t first, std::size_t last, property::Value before);
    /// The property at `place`, a list that was `before`, has another value now. A variable that
    /// holds the list reads the new one; only an assignment of it gives what it was:
    /// a.points, b.points = b.points, a.points.
    void note_whole(const Origin& place, property::Value before);
    /// What the list at `place` was, which was read at `since`; nothing if it is still there.
    std::optional<property::Value> find(const Origin& place, std::uint64_t since) const;
    /// Later calls read what is at the place.
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
    std::size_t elements_ = 0;  // in all that was
};

}  // namespace fettle::script
