#pragma once

#include <contacts/contact_list.h>
#include <state/step_scratch.h>
#include <threads/pool.h>

// New pairs of shapes. If few shapes have moved, each of them queries the trees; otherwise the
// trees are compared with each other. Threads share both tasks, and the pairs are sorted before
// they become contacts.

namespace fettle::physics::detail {

/// Writes `scratch.new_pairs` and `scratch.relocated`, and marks crowded shapes.
void find_pairs(ObjectState& objects, const Columns& columns, BroadPhaseState& boxes,
                const WorldDef& settings, uint64_t step, PairScratch& scratch,
                const UserFilter& filter, FindOverlaps overlaps, ThreadPool* threads);

/// May run while other contacts are collided.
void create_contacts(const ContactList& list, const WorldDef& settings,
                     std::span<const uint64_t> new_pairs);

}  // namespace fettle::physics::detail
