#pragma once

#include <solver/joints/joint_passes.h>

#include <vector>

// Ropes, rods and pulleys whose bodies obstacles hold.

namespace fettle::physics::detail {

/// A rope, a rod or a pulley pulls bodies that obstacles hold with no more than its load and some
/// weights. If it pulled like a spring over the gap, its force would do work on what it draws along
/// an obstacle, and throw what slips round it. Where only one of two bodies is held, the pull moves
/// the other one: the passes are too few to find that out, and what a rope drew into a narrow gap
/// went through it, with no great force. Under `soft_step` only.
void limit_pull(const JointSource& source, const JointRecord& joint, const Pull& pull,
                const JointStep& step, JointEnds& ends, std::vector<uint32_t>& strained);

/// A rope that is too long pulls with at most twice its force, and some weights. What it draws to
/// another body holds that one and is held by it, until one rolls away or tips over. If all of the
/// pull for the open gap then acted at once, it would throw the body. A rod that is between bodies
/// is limited in the same way.
void limit_growth(const JointSource& source, const JointRecord& joint, const Pull& pull,
                  const JointStep& step, JointEnds& ends);

/// A rope that is too long pulls a body along an obstacle in jerks: in the last sub-step there may
/// have been no force, and the next one would pull for the whole gap. So being near is enough. Of
/// one that is not too long yet, the obstacle or what it is tied to must move by itself. The more
/// the rope pulls along the obstacle, the faster the gap may close: contacts of `direct` hold a
/// pull that is not steep.
void limit_gap_of_rope(const JointSource& source, const JointRecord& joint, const Pull& pull,
                       Solver solver, JointEnds& ends);

}  // namespace fettle::physics::detail
