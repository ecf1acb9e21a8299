#pragma once

#include <solver/joints/joint_passes.h>

#include <vector>

// Joints of a body that has many of them.
//
// A sweep solves the joints of a body one after the other, each as if it were alone. Together they
// are stronger than each of them: the impulse that all of them need is divided by S, where S is the
// greatest eigenvalue of Σ Gᵀ·K⁻¹·G over the joints, G = J·M^-½ is the part of the body in the rows
// of a joint, and K is the sum over its two bodies. S is 1 for one joint, 2 for a node of a grid,
// and nearly n for a light hub with n heavy spokes. From S = 3.1 on, a hub with equal spokes gains
// energy in each sub-step: the warm start gives it more than a sweep takes away. It is stable, for
// any number of spokes of any mass, if each joint pushes with 2/S of its mass, in two sweeps
// (eigenvalues of the linear step of 3 to 64 spokes, of 0.1 to 100 times the mass of the hub).

namespace fettle::physics::detail {

/// The joints of crowded bodies are swept this often in each pass.
inline constexpr int sweeps_of_crowded = 4;

/// For each awake joint in the order of its code, type by type: the part of its mass with which it
/// pushes, below 1 if one of its bodies is crowded. Empty if no body is.
std::vector<float> shares_of_crowded(const JointSource& source, const ActiveLists& active,
                                     const std::vector<uint8_t>& codes);

}  // namespace fettle::physics::detail
