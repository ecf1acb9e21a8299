#pragma once
// What limits the scripts of one runtime.

#include <cstddef>

#include <limits/arena.h>
#include <limits/budget.h>
#include <limits/watchdog.h>

namespace fettle::script {

struct Limiters {
    Limiters(Machine& machine, std::size_t memory)
        : arena(memory), budget(machine), watchdog(machine) {}

    Arena arena;        // memory
    Budget budget;      // instructions, time and memory of a call
    Watchdog watchdog;  // time of a call of the host
};

}  // namespace fettle::script
