#pragma once

#include <fettle/physics/export.h>

#include <cstdint>

// Functions of the host that the library calls for all worlds of the process. They belong to the
// process because a host has one log, and because they must be there before the first world.
//
// Memory has no hook of its own: the library allocates by `operator new` only, and frees by
// `operator delete`. A program that replaces these two gets all memory of its worlds, but for the
// matrices of `Solver::direct`, which are from `malloc`.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

class World;

/// Severity of a line of the log.
enum class LogLevel : uint8_t {
    note,     ///< done in another way than requested, with the same results
    warning,  ///< a meaningless argument was ignored
    error     ///< something was lost
};

/// Gets the messages of the library that are neither a result nor an exception. `text` is one
/// line and lives for the call. It is called on the thread that made the call of the library, so
/// several threads may be in it at once. It may read the world, must not edit it, and what it
/// throws is ignored.
using LogFunction = void (*)(void* user, LogLevel level, const char* text);

/// Sets the log of the process; null: none, as at first.
void set_log(LogFunction function, void* user) noexcept;

/// Gets the first fault of a world: `what` is that of `World::validate` and lives for the call. It
/// may throw: the step throws the exception, when it is complete.
using FailureFunction = void (*)(void* user, const World& world, const char* what);

/// While there is such a function, each world is checked by `World::validate` after each step,
/// which takes several times as long as the step and calls the filter of the world. Use it to find
/// an error of the library, or code that writes into its memory. Null: no checks, as at first.
void set_failure_function(FailureFunction function, void* user) noexcept;

}  // namespace fettle::physics

FETTLE_PHYSICS_END
