#pragma once

#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

#include <span>

namespace fettle::physics::detail {

// Cuts the world for several threads, and sorts lists so that the bodies, contacts and joints of a
// strip are next to each other. All of it follows from the state of the world, which contains the
// strips: a restored world is cut like the saved world.

/// `groups`: the solver solves contacts in groups; other solvers solve the world as one strip.
void cut_into_strips(const ObjectState& objects, const ActiveLists& active, bool groups,
                     uint64_t step, Strips& strips);

/// Puts bodies, contacts and joints that are solved together next to each other in the lists: a
/// thread then finds them in its cache from one stage to the next.
void order_lists(ObjectState& objects, ActiveLists& active, const Strips& strips,
                 const BodyScratch& bodies, uint64_t step, Reordering& reordering,
                 ThreadPool* threads);

/// Finds hubs among the awake bodies from place `begin` to `end`, and adds their copies to the
/// bodies that are solved.
void find_hubs(const ObjectState& objects, std::span<const uint32_t> awake, size_t begin,
               size_t end, BodyScratch& bodies, Hubs& hubs);

// Which contacts act in a step, in which block each is solved, and with which color.

/// Lists the awake contacts that act. `groups`: the solver can solve groups of contacts; otherwise
/// it solves each contact alone.
void find_acting(const ObjectState& objects, const ActiveLists& active, const BodyScratch& bodies,
                 const ScheduleScratch& schedule, ContactScratch& contacts, bool groups, float dt,
                 ThreadPool* threads);

/// Colors the acting contacts and gives each a lane, and lists those that are solved one at a time.
/// `joints`: the number of acting joints.
void color_contacts(const ActiveLists& active, const BodyScratch& bodies, const Strips& strips,
                    size_t joints, ContactScratch& contacts, ScheduleScratch& schedule,
                    ThreadPool* threads);

}  // namespace fettle::physics::detail
