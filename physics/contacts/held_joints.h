#pragma once

#include <contacts/contact_list.h>
#include <state/step_scratch.h>

namespace fettle::physics::detail {

void release_held_joints(const Touching& touching, const JointScratch& joints, float h);

}  // namespace fettle::physics::detail
