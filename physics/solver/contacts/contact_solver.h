#pragma once

#include <constraints/contact_constraint.h>
#include <constraints/rolling_contact.h>
#include <partition/unsettled_contacts.h>

#include <span>

namespace fettle::physics::detail {

class JointResponse;

/// Data of each body for the passes of impacts.
struct Bounced {
    std::span<uint8_t> last_pass;  ///< the last pass that changed it; 0 at the start
    std::span<FirstImpact> first;
};

struct ContactSolver {
    std::span<SolverBody> bodies;
    std::span<const SolverForce> forces;
    std::span<ContactConstraint> constraints;
    std::span<ContactExtra> extras;
    std::span<const RollingContact> rolling;
    std::span<Relaxed> relaxed;  ///< of `constraints`
    float inverse_h = 0.0f;
    float push_speed = 0.0f;
    float restitution_threshold = 0.0f;

    /// Called before the sub-steps, which compute no impacts. Contacts whose shapes approach fast
    /// enough to meet within the step (`substeps` sub-steps) get their restitution times that speed
    /// as separation speed; without restitution (contacts of jointed bodies) they keep the speed at
    /// which their gap closes within the step. This is done pass after pass (`pass` = 1, 2, …) for
    /// all pairs that approach at its beginning, until their restitution would leave nothing of an
    /// impact that has passed through so many bodies. Returns false when no pair did so in this
    /// pass. So an impact passes through a row of bodies in one step without loss. `joints`: they
    /// take part in the impact; may be null.
    bool bounce(int substeps, uint8_t pass, const Bounced& bounced, JointResponse* joints);
    /// True if some contact that takes impacts approaches fast enough.
    bool may_bounce() const;
    /// Maximum length of the row of bodies that an impact passes through in a step.
    static constexpr uint8_t most_passes = 32;
    void warm_start();
    /// Soft: overlapping shapes separate at a bias velocity. Normal directions only.
    void solve_biased();
    /// Called after the positions changed: removes the bias velocity, then applies friction and
    /// rolling resistance. Friction acts in this pass only, which makes tall stacks stand.
    void relax();
    /// The same after the last sub-step. Shapes that approach fast enough to bounce, and are still
    /// apart, keep their speed: the next step bounces them.
    void relax_at_end();
    /// Calls `visit(a, b)` for each contact that the last relax pass left unsettled.
    void for_unsettled(auto&& visit) const {
        for (std::size_t i = 0; i < constraints.size(); ++i)
            if (relaxed[i] == Relaxed::unsettled) visit(constraints[i].a, constraints[i].b);
    }
    /// Counts the contacts of rows of unsettled ones.
    void count_in_rows(UnsettledContacts& unsettled) const {
        for (const ContactConstraint& c : constraints)
            if (unsettled.are_in_row(c.a, c.b)) unsettled.count(bodies, c.a, c.b);
    }
    /// Another relax pass over the contacts of rows that are not settled.
    void relax_again(UnsettledContacts& unsettled);
    /// Called after the relax passes of a sub-step: records impulses for events and restitution.
    void record();
    /// The same two passes over some of the constraints, by index.
    void solve_biased(std::span<const uint32_t> some);
    void relax(std::span<const uint32_t> some);
    /// Called after all sub-steps, for hits that `bounce` did not predict: shapes that hit fast
    /// enough get their restitution times the approach velocity as separation velocity.
    void restitute();

  private:
    void solve_biased(ContactConstraint& c) const;
    Relaxed relax(ContactConstraint& c) const;
    bool bounces_later(const ContactConstraint& c) const;
    void follow(ContactConstraint& c, const SolverBody& a, const SolverBody& b) const;
    const Corner* corner_of(const ContactConstraint& c) const;
};

}  // namespace fettle::physics::detail
