#pragma once

#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

#include <span>

namespace fettle::physics::detail {

// Cuts the world for several threads, and sorts lists so that bodies, contacts and joints of a
// strip are adjacent. The cut depends only on the state of the world, which contains the strips, so
// a restored world is cut like the saved world.

/// `groups`: the solver solves contacts in groups. Other solvers solve the world as one strip.
void cut_into_strips(const ObjectState& objects, const ActiveLists& active, bool groups,
                     uint64_t step, Strips& strips);

/// Sorts the lists so that bodies, contacts and joints that are solved together are adjacent. A
/// thread then finds them in its cache from one stage to the next.
void order_lists(ObjectState& objects, ActiveLists& active, const Strips& strips,
                 const BodyScratch& bodies, uint64_t step, Reordering& reordering,
                 ThreadPool* threads);

/// Finds hubs among the awake bodies with indices from `begin` to `end`, and adds their copies to
/// the solver bodies.
void find_hubs(const ObjectState& objects, std::span<const uint32_t> awake, size_t begin,
               size_t end, BodyScratch& bodies, Hubs& hubs);

// Selection of the acting contacts of a step, and their distribution to blocks and colors.

/// Lists the awake contacts that act. `groups`: the solver can solve groups of contacts; otherwise
/// it solves each contact alone.
void find_acting(const ObjectState& objects, const ActiveLists& active, const BodyScratch& bodies,
                 const JointScratch& joints, const WorldDef& settings,
                 const ScheduleScratch& schedule, ContactScratch& contacts, float dt,
                 ThreadPool* threads);

/// Colors the acting contacts, gives each a lane, and lists those that are solved one at a time.
/// `joints`: number of acting joints.
void color_contacts(const ActiveLists& active, const BodyScratch& bodies, const Strips& strips,
                    size_t joints, ContactScratch& contacts, ScheduleScratch& schedule,
                    ThreadPool* threads);

}  // namespace fettle::physics::detail
