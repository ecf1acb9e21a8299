#pragma once
// Groups of bodies that contacts and joints connect.

#include <vector>

#include "wild/checks/check.h"

namespace fettle::bench::wild {

/// The bodies that touch a static body or the border of the world, directly or through contacts and
/// joints of others.
std::vector<bool> held_by_static(const Moment& moment);

/// The bodies that a kinematic body presses on or pulls at, directly or through others.
std::vector<bool> pressed(const Moment& moment);

/// The bodies that joints connect with a kinematic body, directly or through others: it may pull
/// them through a static body. It does not press them through, since it passes through what it
/// crushes.
std::vector<bool> pulled(const Moment& moment);

/// The bodies that joints connect with one that overlaps another body by more than 2 cm.
std::vector<bool> held_in_overlap(const Moment& moment);

/// The bodies of joined groups in which a body is between the two bodies of a joint and keeps them
/// apart. None under `soft_step`, where the joint presses the three deep into each other.
std::vector<bool> joined_at_wedge(const Moment& moment);

/// For each body the forces of the contacts of all bodies that joints connect with it, N.
std::vector<float> loads_of_joined(const Moment& moment);

}  // namespace fettle::bench::wild
