#pragma once

#include <constraints/contact_constraint.h>
#include <constraints/rolling_contact.h>

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

    /// Before the sub-steps, which know no bounce: what meets fast enough within `dt` (s) leaves
    /// with its share of the speed, pair by pair, pass after pass (`pass` = 1, 2, …) until none
    /// meets any more: false. So a blow goes through a row of bodies in one step and none of it is
    /// lost in between. `changed`, by body: the last pass that did anything to it; at first 0.
    bool bounce(float dt, uint8_t pass, std::span<uint8_t> changed);
    /// The longest row that a blow goes through in a step.
    static constexpr uint8_t most_passes = 32;
    void warm_start();
    /// Soft: overlap is pushed out at a bias velocity. Normal directions only.
    void solve_biased();
    /// After the positions moved: takes the bias velocity out again, then friction and rolling.
    /// Friction in this pass only is what makes tall stacks stand.
    void relax();
    /// After all sub-steps, for what `bounce` did not foresee: what hit fast enough leaves with its
    /// share of the approach velocity.
    void restitute();

  private:
    void follow(ContactConstraint& c, const SolverBody& a, const SolverBody& b) const;
    const Corner* corner_of(const ContactConstraint& c) const;
};

}  // namespace fettle::physics::detail
