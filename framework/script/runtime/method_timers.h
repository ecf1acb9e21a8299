#pragma once
// Timers in files. A file contains no functions, but the name of a method is enough for a timer
// that calls a method of its owner's class, as `self:every(1, self.fire)` makes it.

#include <cstdint>
#include <string>
#include <unordered_set>
#include <vector>

#include <fettle/property/bytes.h>
#include <fettle/property/value.h>

#include <handlers/timers.h>

namespace fettle::script {

struct Machine;

struct MethodTimer {
    property::Handle owner{};
    property::Handle scene{};  // whose `enter` began it
    std::string method;
    double due = 0;        // s, simulation time
    double interval = -1;  // s; below 0: once
};

/// Those of `queue` that call a method of their owner's class, in the order in which they are due.
/// `numbers` gets their numbers. Timers of the top level are left out.
std::vector<MethodTimer> method_timers(Machine& machine, const Timers::Queue& queue,
                                       std::unordered_set<std::uint64_t>& numbers);

void put(const std::vector<MethodTimer>& all, property::ByteWriter& to);
/// Throws as `from` does where the bytes are no list of timers.
std::vector<MethodTimer> method_timers_of(property::ByteReader& from);

/// Begins the timer with the method that the class has now. False if its owner is gone or has no
/// such method any more.
bool begin_again(Machine& machine, const MethodTimer& timer);

}  // namespace fettle::script
