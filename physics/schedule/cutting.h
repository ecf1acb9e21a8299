#pragma once

#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

// Where the world is cut for several threads, and lists in which the bodies, contacts and joints of
// a strip stand together. All of it follows from the state of the world, of which the strips are a
// part: a restored world is cut like the one that was saved.

namespace fettle::physics::detail {

/// `groups`: the solver solves contacts in groups; other solvers solve the world as one strip.
void cut_into_strips(const ObjectState& objects, const ActiveLists& active, bool groups,
                     uint64_t step, Strips& strips);

/// Puts what is solved together next to each other in the lists: a thread then finds it in its
/// cache from one stage to the next.
void order_lists(ObjectState& objects, ActiveLists& active, const Strips& strips,
                 const BodyScratch& bodies, uint64_t step, Reordering& reordering,
                 ThreadPool* threads);

}  // namespace fettle::physics::detail
