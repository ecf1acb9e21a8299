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

    /// Called before the sub-steps, which compute no bounces: contacts whose shapes approach fast
    /// enough within `dt` (s) leave with their restitution times that speed, pair by pair, pass
    /// after pass (`pass` = 1, 2, …) until no pair approaches: then returns false. So a blow goes
    /// through a row of bodies in one step without loss. `changed`, by body: the last pass that
    /// changed it; 0 at the start.
    bool bounce(float dt, uint8_t pass, std::span<uint8_t> changed);
    /// The longest row of bodies that a blow goes through in a step.
    static constexpr uint8_t most_passes = 32;
    void warm_start();
    /// Soft: overlap is pushed out at a bias velocity. Normal directions only.
    void solve_biased();
    /// After the positions changed: removes the bias velocity, then applies friction and rolling
    /// resistance. Tall stacks stand because friction acts in this pass only.
    void relax();
    /// After all sub-steps, for hits that `bounce` did not predict: shapes that hit fast enough
    /// leave with their restitution times the approach velocity.
    void restitute();

  private:
    void follow(ContactConstraint& c, const SolverBody& a, const SolverBody& b) const;
    const Corner* corner_of(const ContactConstraint& c) const;
};

}  // namespace fettle::physics::detail
