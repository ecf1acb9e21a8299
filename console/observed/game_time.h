#pragma once
// The clock `time` of the observed game.

#include <cstdint>

#include <observed/last_value.h>

namespace fettle::console {

/// Where the game is in the past that it stores.
struct GameTimes {
    std::int64_t step = 0, oldest = 0, newest = 0;
    std::int64_t end = 0;  // the last step of all branches
    double dt = 0;
    bool paused = false;
    bool halted = false;  // by an error
    bool stands() const { return paused || halted; }
    bool in_past() const { return step < newest; }
};

/// The last value of a property of the clock `time`; nil if there is none.
inline property::Value time_value(const property::Tree& tree, const char* name) {
    const property::Handle time = tree.child(tree.root(), "time");
    const property::Property* const property = time ? tree.find(time, name) : nullptr;
    return property != nullptr ? last_value(tree, time, *property) : property::Value();
}

/// Sets a boolean of the clock `time`, such as `paused`; does nothing if there is none. This is not
/// an edit by a person, so undo does not revert it.
inline void set_time_flag(property::Tree& tree, const char* name, bool on) {
    const property::Handle time = tree.child(tree.root(), "time");
    const property::Property* const property = time ? tree.find(time, name) : nullptr;
    if (property == nullptr || property->type != property::Type::boolean) return;
    const property::Tree::CauseScope cause(tree, property::Writer::module);
    tree.set(time, *property, property::Value(on));
}

}  // namespace fettle::console
