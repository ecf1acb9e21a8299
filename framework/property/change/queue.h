#pragma once
// What waits to be delivered at the next barrier.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <variant>
#include <vector>

#include <fettle/property/change.h>

#include <instances/cell.h>

#include "shadows.h"
#include "untold.h"
#include "watchers.h"

namespace fettle::property {

/// What the simulation did to watched cells, found at one barrier.
struct Motion {
    std::vector<CellChange> changes;
    Cause cause;
};

struct QueueItem {
    enum class Kind : std::uint8_t { change, motion, initial, created, deleted, event };
    Kind kind = Kind::change;
    std::variant<Change, Motion, Existence, Occurrence> what;
    WatcherId until = 0;                  // watchers registered later have seen the result already
    std::vector<WatcherId> recipients{};  // fixed when queued (deletions, initial values)
    bool retire = false;                  // the recipients' instance is gone: they end with this
    std::ptrdiff_t trigger = -1;          // item of the generation before whose handler caused this
    std::size_t trigger_part = 0;         // of a motion: which of its changes
};

struct Queue {
    std::vector<QueueItem> items;
    std::unordered_map<Cell, std::size_t, CellHash> changes;  // cell -> its place in `items`
    std::vector<std::uint32_t> fresh;            // slots of instances made since the last barrier
    std::vector<std::function<void()>> actions;  // for the end of a barrier between steps
    UntoldBeginnings untold;
    // While a barrier delivers:
    bool delivering = false;
    std::ptrdiff_t item = -1;  // which of its generation
    std::size_t part = 0;      // of a motion
    Watchers::List called;

    void clear() {
        items.clear();
        changes.clear();
    }
};

}  // namespace fettle::property
