#pragma once

#include <contacts/contact_list.h>
#include <state/step_scratch.h>

// Joints that contacts hold open. A limb that an impact has pressed between the two bodies of a
// hinge would stay there for ever: the contacts push the two bodies apart, the hinge pulls them
// together with hundreds of times their weight, and neither can win. Forces that large do not stay
// in balance over a step, whose contacts have the normals and lever arms of its beginning: knotted
// limbs of ragdolls whipped at 13 m/s. So a joint has priority over contacts between dynamic
// bodies: what holds it open passes through one of its two bodies, as a kinematic body passes
// through what it crushes (contacts/overlaps/crushed_bodies.h), and the joint closes.

namespace fettle::physics::detail {

/// Skips the contacts that hold a joint open. Must be called when the impulses of the step are
/// stored. `h`: length of a sub-step, s.
void release_held_open(const Touching& touching, const JointScratch& joints, float h);

}  // namespace fettle::physics::detail
