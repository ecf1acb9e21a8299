#pragma once

#include <state/step_scratch.h>

// The wide contacts of rows of unsettled ones. They are few in each group, so they are copied out
// of their lanes and solved one at a time.

namespace fettle::physics::detail {

/// Lists and counts the contacts of rows in a block.
void list_lanes_of_rows(const SolverBlock& block, WideBlock& wide,
                        std::span<const SolverBody> bodies, UnsettledScratch& rows);
/// Copies the listed contacts that are still in rows.
void copy_lanes_of_rows(WideBlock& wide, std::span<const SolverBody> bodies,
                        UnsettledScratch& rows);
/// Writes the impulses back into the lanes.
void write_lanes_of_rows(const UnsettledScratch& rows, WideBlock& wide);

}  // namespace fettle::physics::detail
