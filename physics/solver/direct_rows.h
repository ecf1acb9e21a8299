#pragma once

#include <solver/contact_solver.h>
#include <solver/direct_row.h>

namespace fettle::physics::detail {

/// Normals, rolling and friction of a contact; `extra` may be null.
void write_rows(RowWriter& rows, ContactConstraint& c, ContactExtra* extra, const SolverBody& a,
                const SolverBody& b, float push_speed, float restitution_threshold);

}  // namespace fettle::physics::detail
