#pragma once

#include <joints/joint_types.h>
#include <solver/contact_solver.h>
#include <solver/direct_row.h>

namespace fettle::physics::detail {

// The rows of each type of joint, where its bodies are now. What holds in the sweeps of the other
// solvers (`solve` and `relax` of the constraint) holds here, at once.
void write_rows(RowWriter& rows, MouseConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, DistanceConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, RevoluteConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, PrismaticConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, WheelConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, WeldConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, MotorConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, PulleyConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, GearConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, PinSlotConstraint& c, SolverBody& a, SolverBody& b);
void write_rows(RowWriter& rows, RatchetConstraint& c, SolverBody& a, SolverBody& b);

/// Normals, rolling and friction of a contact; `extra` may be null.
void write_rows(RowWriter& rows, ContactConstraint& c, ContactExtra* extra, const SolverBody& a,
                const SolverBody& b, float push_speed, float restitution_threshold);

}  // namespace fettle::physics::detail
