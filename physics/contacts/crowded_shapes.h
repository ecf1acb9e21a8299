#pragma once

#include <contacts/contact_list.h>
#include <state/step_scratch.h>
#include <threads/pool.h>

// Crowds: many shapes in one place. All pairs of n shapes would be n² / 2 contacts, which take
// seconds and gigabytes and throw the bodies apart. So each pair of dynamic bodies has a decider,
// the smaller one of its two shapes. A shape that would decide about too many pairs is crowded: in
// each step it looks for its pairs by itself, and makes a contact only with shapes that it touches,
// and only with a few at a time. Pairs with sensors, with the border, and with bodies that are not
// dynamic are always made.

namespace fettle::physics::detail {

/// A shape that decides about more pairs than this is crowded.
inline constexpr uint32_t most_decided = 32;

/// The shape that decides about a pair while it is crowded. `none`: the pair is always made.
/// Between shapes of similar area, a hash decides, so that each decides about half of its pairs. If
/// one body sleeps, the other one decides.
uint32_t decider_of(const ObjectState& objects, uint32_t shape_a, uint32_t shape_b);

/// Runs `search(piece, found)` for every piece, each with a list of its own, and adds what they
/// found to the new pairs in the order of the pieces.
void search_in_pieces(PairScratch& scratch, size_t count, ThreadPool* threads, auto&& search) {
    if (scratch.found_pairs.size() < count) scratch.found_pairs.resize(count);
    parallel_for(threads, uint32_t(count), [&](uint32_t piece) {
        scratch.found_pairs[piece].clear();
        search(piece, scratch.found_pairs[piece]);
    });
    for (size_t piece = 0; piece < count; ++piece) {
        const std::vector<uint64_t>& found = scratch.found_pairs[piece];
        scratch.new_pairs.insert(scratch.new_pairs.end(), found.begin(), found.end());
    }
}

/// Removes the pairs of crowded shapes from the new pairs, and marks these shapes. `scratch.finds`:
/// for each shape, how many new pairs it decides about; all 0 afterwards.
void remove_crowded_pairs(ObjectState& objects, PairScratch& scratch);

/// Adds the chosen pairs of the crowded shapes among the moved ones to the new pairs.
void choose_crowded_pairs(ObjectState& objects, const Columns& columns,
                          const BroadPhaseState& boxes, const WorldDef& settings, uint64_t step,
                          PairScratch& scratch, ThreadPool* threads);

}  // namespace fettle::physics::detail
