#pragma once
// The queue of items that are delivered at the next barrier.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <variant>
#include <vector>

#include <fettle/property/change.h>

#include <instances/cell.h>

#include "shadows.h"
#include "undelivered_begins.h"
#include "watchers.h"

namespace fettle::property {

/// Changes of watched cells by the simulation, found at one barrier.
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
    bool retire = false;                  // their instance is deleted; they end with this item
    std::ptrdiff_t trigger = -1;          // item of the previous generation that caused this one
    std::size_t trigger_part = 0;         // in a motion: the index of the change
};

struct Queue {
    std::vector<QueueItem> items;
    std::unordered_map<Cell, std::size_t, CellHash> changes;  // cell -> its place in `items`
    std::vector<std::uint32_t> fresh;            // slots of instances made since the last barrier
    std::vector<std::function<void()>> actions;  // called at the end of a barrier between steps
    UndeliveredBegins undelivered;
    // Position of the delivery that runs now.
    bool delivering = false;
    std::ptrdiff_t item = -1;  // its index in the generation
    std::size_t part = 0;      // in a motion: the index of the change
    Watchers::List called;
};

}  // namespace fettle::property
