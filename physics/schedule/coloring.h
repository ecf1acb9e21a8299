#pragma once

#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

// Which contacts act in a step, in which block each is solved, and with which color.

namespace fettle::physics::detail {

/// Lists the awake contacts that act. `groups`: the solver can solve groups of contacts; otherwise
/// each contact is solved by itself.
void find_acting(const ObjectState& objects, const ActiveLists& active, const BodyScratch& bodies,
                 const ScheduleScratch& schedule, ContactScratch& contacts, bool groups, float dt,
                 ThreadPool* threads);

/// Colors the acting contacts and gives each a lane, and lists those that are solved one at a time.
/// `joints`: how many act.
void color_contacts(const ActiveLists& active, const BodyScratch& bodies, const Strips& strips,
                    size_t joints, ContactScratch& contacts, ScheduleScratch& schedule,
                    ThreadPool* threads);

}  // namespace fettle::physics::detail
