#pragma once

#include <solver/joints/joint_response.h>

// The impulses of one impact of two bodies: docs/design/physics.md, "Friction belongs to the
// impact".

namespace fettle::physics::detail {

/// The velocities that unit impulses at a contact cause at its points, between two bodies.
struct ImpactResponse {
    float of_first = 0.0f, of_second = 0.0f, between = 0.0f;
    // Of friction, which acts at one place between the points that meet. All are 0 without it.
    float lever_a = 0.0f, lever_b = 0.0f;  ///< r×t
    float slip = 0.0f;                     ///< along the tangent
    float by_friction[2] = {};             ///< of the points along the normal

    explicit ImpactResponse(const ContactConstraint& c);
    void add_friction(const ContactConstraint& c, const bool (&meets)[2], const SolverBody& a,
                      const SolverBody& b);
    float of(int point) const { return point == 0 ? of_first : of_second; }
    /// The velocity along the tangent, m/s. `surface_speed`: of a belt.
    float slip_of(const ContactConstraint& c, float surface_speed, const SolverBody& a,
                  const SolverBody& b) const;
};

/// The same with the joints on these bodies.
struct JointedResponse : ImpactResponse {
    JointResponse::Reaction reactions[2];

    JointedResponse(const ContactConstraint& c, JointResponse* joints);
};

/// What an impact changes, m/s.
struct ImpactGoal {
    float change[2] = {};  ///< of the velocities of the points along the normal
    bool meets[2] = {};
    // For friction:
    float friction = 0.0f;     ///< 0: the impulses have no part along the tangent
    float around[2] = {};      ///< sum of the velocities before and after along the normal
    float slip = 0.0f;         ///< velocity along the tangent before
    float end_of_slip = 0.0f;  ///< the change that ends it
};

/// The impulses at the points of a contact that change the velocities of those that meet as
/// wanted, N s.
struct ImpactImpulses {
    float normal[2] = {};
    float tangent = 0.0f;

    ImpactImpulses() = default;
    ImpactImpulses(const ImpactResponse& response, const ImpactGoal& goal);

    void add_to(BounceSum& sum, const ContactConstraint& c, const ImpactResponse& response) const;
    /// The velocities that they cause.
    float at_point(const ImpactResponse& response, int point) const;
    float along_tangent(const ImpactResponse& response) const;
};

}  // namespace fettle::physics::detail
