#pragma once

#include <fettle/physics/export.h>

#include <cstdint>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Threads of a host that do the work of a world's steps: `World::set_scheduler`. Each step calls
/// `start` once and then `finish` once, on the thread that steps. The tasks of a step end by
/// themselves as soon as the step is over. The stepping thread works, too, and does the work that
/// no task does: so a step needs no task to run, and its result does not depend on when and where
/// they run. An exception of these functions leaves `World::step`: after `start`, the world has
/// made no step; after `finish`, it has made the whole step, and steps on one thread until
/// `World::set_scheduler` is called again.
class TaskScheduler {
  public:
    /// To be called once by the host, with the context and the number of the task.
    using Task = void (*)(void* context, uint32_t number);

    TaskScheduler() = default;
    TaskScheduler(const TaskScheduler&) = delete;
    TaskScheduler& operator=(const TaskScheduler&) = delete;
    virtual ~TaskScheduler();

    /// Lets other threads call `task(context, number)` for the numbers 0 … `count` - 1, and returns
    /// without waiting for them. On the thread that steps, a task returns at once: it does nothing
    /// that this thread does not do itself.
    virtual void start(uint32_t count, Task task, void* context) = 0;
    /// Returns when all tasks have returned. A task that has not begun may be called now, or not at
    /// all; after this it must not be called any more.
    virtual void finish() = 0;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
