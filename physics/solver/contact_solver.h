#pragma once

#include <solver/constraint.h>
#include <solver/rolling_contact.h>

#include <span>

namespace fettle::physics::detail {

struct ContactSolver {
    std::span<SolverBody> bodies;
    std::span<ContactConstraint> constraints;
    std::span<ContactExtra> extras;
    std::span<const RollingContact> rolling;
    float inverse_h = 0.0f;
    float push_speed = 3.0f;
    float restitution_threshold = 1.0f;

    void warm_start();
    /// Soft: overlap is pushed out at a bias velocity. Normal directions only.
    void solve_biased();
    /// After the positions moved: takes the bias velocity out again, then friction and rolling.
    /// Friction in this pass only is what makes tall stacks stand.
    void relax();
    /// Once after all sub-steps: what hit fast enough leaves with its share of the approach
    /// velocity.
    void restitute();

  private:
    void follow(ContactConstraint& c, const SolverBody& a, const SolverBody& b) const;
    const Corner* corner_of(const ContactConstraint& c) const;
};

}  // namespace fettle::physics::detail
