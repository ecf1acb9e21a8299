#include <solver/contacts/contact_solver.h>
#include <solver/contacts/impact_impulses.h>
#include <solver/contacts/solved_pair.h>

#include <cmath>
#include <optional>
#include <vector>

// Impacts before the sub-steps: docs/design/physics.md, "Bounces come first"; and those that the
// sub-steps stopped.

namespace fettle::physics::detail {
namespace {

float velocity_at(const ContactConstraint& c, int point, const SolverBody& a, const SolverBody& b) {
    const ConstraintPoint& p = c.points[point];
    return dot(c.normal, b.velocity - a.velocity) +
           (p.normal_lever_b * b.angular_velocity - p.normal_lever_a * a.angular_velocity);
}

/// What forces change along the normal at a point in a sub-step, m/s.
float change_at(const ContactConstraint& c, int point, const SolverForce& fa,
                const SolverForce& fb) {
    const ConstraintPoint& p = c.points[point];
    return dot(c.normal, fb.change - fa.change) +
           (p.normal_lever_b * fb.turn_change - p.normal_lever_a * fa.turn_change);
}

/// What moving along the tangent of a corner adds to the gap by the end of the step, m. `velocity`:
/// the present one along the normal, m/s.
float opening_at_corner(const ContactConstraint& c, const ContactExtra& extra, float velocity,
                        const SolverBody& a, const SolverBody& b, float dt) {
    if (!(velocity < 0.0f)) return 0.0f;
    const SolverBody at_start;
    return path_around(extra.corner, c.normal, at_start, at_start, PairMotion(a, b), 0.0f, velocity,
                       dt)
        .opening;
}

/// Turns the contact at a corner to the moment at which the cores are as near as the shapes allow,
/// on a straight path: until then they move along the tangent. The gap becomes that before the
/// tangent plane of the impact. With the normal of the beginning, a glancing bounce would end
/// another velocity than that with which the shapes meet, and lose speed. False if they pass.
/// `approach` and `slip`: velocities of the cores along the normal and the tangent.
bool turn_to_impact(ContactConstraint& c, const Corner& corner, const SolverBody& a,
                    const SolverBody& b, float approach, float slip) {
    ConstraintPoint& p = c.points[0];
    const float d = corner.distance, r = d - p.separation, outside = d * d - r * r;
    if (!(outside > 0.0f)) return true;  // they overlap
    const float way = d * approach, square = approach * approach + slip * slip;
    const float root = way * way - square * outside;
    if (!(approach < 0.0f && root > 0.0f && r > 0.0f)) return false;
    const float time = outside / (std::sqrt(root) - way);
    const Vec2 to = normalized({d + approach * time, slip * time});
    p.separation = d * to.x - r;
    c.normal = to.x * c.normal + to.y * right_perp(c.normal);
    // From the cores to the surfaces.
    const float r_a = corner.lever_a - p.tangent_lever_a, r_b = p.tangent_lever_b - corner.lever_b;
    p.tangent_lever_a = to.x * corner.lever_a - to.y * p.normal_lever_a - r_a;
    p.tangent_lever_b = to.x * corner.lever_b - to.y * p.normal_lever_b + r_b;
    p.normal_lever_a = to.x * p.normal_lever_a + to.y * corner.lever_a;
    p.normal_lever_b = to.x * p.normal_lever_b + to.y * corner.lever_b;
    p.normal_mass = inverse_or_zero(c.inverse_along(c.normal) +
                                    a.inverse_inertia * p.normal_lever_a * p.normal_lever_a +
                                    b.inverse_inertia * p.normal_lever_b * p.normal_lever_b);
    return true;
}

/// The velocity along the normal when the gap at a point closes, m/s. `velocity`: the present one.
float closing_velocity(const ContactConstraint& c, const ContactExtra& extra, int point,
                       float velocity, const SolverBody& a, const SolverBody& b) {
    const Corner& corner = extra.corner;
    if (corner.distance == 0.0f || !(velocity < 0.0f)) return velocity;
    // On a straight path with the speed u along the tangent, it is √(v² - u²·(d² - r²)/r²) where
    // the distance of the cores, now d, is r.
    const float u = dot(right_perp(c.normal), b.velocity - a.velocity) +
                    (corner.lever_b * b.angular_velocity - corner.lever_a * a.angular_velocity);
    const float gap = max(c.points[point].separation, 0.0f), radius = corner.distance - gap;
    const float bend = gap * (corner.distance + radius) / max(radius * radius, 1e-12f);
    return -std::sqrt(max(velocity * velocity - u * u * bend, 0.0f));
}

/// The contact of two bodies as it is when they meet.
struct AtImpact {
    ContactConstraint contact;
    float slowed = 0.0f;  ///< what the path around a corner takes from the approach, m/s
};

/// Nothing if the bodies pass each other at a corner. Forces do not count: a wheel that the ground
/// carries does not fall before the next seam. It lies a little below the corners of the seams,
/// though, and a ball that flies does not: of what is at a face of something else only the corners
/// that are in its way at the end of the step count, with the normal of the beginning.
std::optional<AtImpact> at_impact(const ContactConstraint& c, const ContactExtra& extra,
                                  const SolverBody& a, const SolverBody& b, float dt) {
    AtImpact impact = {c};
    // Friction acts where the surfaces meet, and these levers are those at half the gap.
    for (ConstraintPoint& p : impact.contact.points) {
        p.tangent_lever_a += 0.5f * p.separation;
        p.tangent_lever_b -= 0.5f * p.separation;
    }
    const Corner& corner = extra.corner;
    if (corner.distance == 0.0f || c.count != 1) return impact;
    const float approach = extra.approach[0];
    if (extra.restitution == 0.0f || extra.supported) {
        impact.contact.points[0].separation += opening_at_corner(c, extra, approach, a, b, dt);
        impact.slowed = closing_velocity(c, extra, 0, approach, a, b) - approach;
        return impact;
    }
    const float slip = dot(right_perp(c.normal), b.velocity - a.velocity) +
                       corner.lever_b * b.angular_velocity - corner.lever_a * a.angular_velocity;
    if (!turn_to_impact(impact.contact, corner, a, b, approach, slip)) return {};
    return impact;
}

void push(const ContactConstraint& c, int point, float impulse, std::span<SolverBody> bodies) {
    const ConstraintPoint& p = c.points[point];
    SolvedPair pair(c, bodies[c.a], bodies[c.b]);
    pair.apply(c.normal, impulse, p.normal_lever_a * impulse, p.normal_lever_b * impulse);
    pair.store(bodies[c.a], bodies[c.b]);
}

void push(const ContactConstraint& c, const ImpactResponse& response, const ImpactImpulses& by,
          std::span<SolverBody> bodies) {
    for (int k = 0; k < c.count; ++k) push(c, k, by.normal[k], bodies);
    if (by.tangent == 0.0f) return;
    SolvedPair pair(c, bodies[c.a], bodies[c.b]);
    pair.apply(right_perp(c.normal), by.tangent, response.lever_a * by.tangent,
               response.lever_b * by.tangent);
    pair.store(bodies[c.a], bodies[c.b]);
}

/// False in the pass in which a contact with this restitution e no longer passes impacts on. A body
/// passes (1 + e) / 2 of its speed on to an equal one at rest, so an impact is down to a hundredth
/// after ln 100 / ln (2 / (1 + e)) bodies. Bodies that still approach then are pressed together, by
/// a motor or between walls; the sub-steps stop them.
bool passes_on(float restitution, uint8_t pass) {
    constexpr float spent = 0.01f;
    const float passed_on = 0.5f * (1.0f + restitution);
    float left = 1.0f;
    for (uint8_t i = 1; i < pass && left > spent; ++i) left *= passed_on;
    return left > spent;
}

/// True if a point approaches fast enough to bounce.
bool is_fast(const ContactExtra& extra, float restitution_threshold) {
    return min(extra.approach[0], extra.approach[1]) < -restitution_threshold;
}

/// The velocity along the normal after an impact, here and now. The shapes meet where the gap is 0,
/// faster or slower than now, and what is left of their speed there would change on the way back.
/// `gap`: now; `velocity`: the present one; `change`: by forces, in the whole step.
float velocity_after(float restitution, float velocity, float gap, float change, float dt) {
    const float e = restitution, straight = -e * velocity;
    // A deeper overlap is older than the last step, and does not count.
    if (e >= 1.0f || !(gap > velocity * dt)) return straight;
    const float work = 2.0f * gap * change / dt;
    return std::sqrt(max(straight * straight + (1.0f - e * e) * work, 0.0f));
}

/// The points of a contact that meet within the step.
struct MeetingPoints {
    float velocity[2] = {};  ///< present ones of the points that joints allow, m/s
    ImpactGoal goal;
    float time = 1.0f;  ///< until the shapes meet, as a share of the step; < 0: they overlap

    /// `jointed`: the bodies have joints, which change what forces do.
    MeetingPoints(const AtImpact& impact, const ContactExtra& extra, const SolverBody& a,
                  const SolverBody& b, const SolverForce& fa, const SolverForce& fb, int substeps,
                  float dt, float threshold, bool jointed) {
        const ContactConstraint& c = impact.contact;
        for (int k = 0; k < c.count; ++k) {
            const ConstraintPoint& p = c.points[k];
            velocity[k] = velocity_at(c, k, a, b);
            const float closing = velocity[k] + impact.slowed;
            const float change = change_at(c, k, fa, fb);
            const float mean = velocity[k] + 0.5f * float(substeps + 1) * change;
            goal.meets[k] =
                closing < -threshold && p.separation + dt * mean < 0.0f && p.normal_mass > 0.0f;
            if (goal.meets[k]) time = min(time, p.separation / (-dt * mean));
            // Velocities are those half a sub-step before their positions. Without this term, every
            // bounce would lose the work of the forces in a sub-step.
            if (extra.restitution > 0.0f) {
                const float now = closing + 0.5f * change;
                const float by_forces = jointed ? 0.0f : float(substeps) * change;
                goal.change[k] =
                    velocity_after(extra.restitution, now, p.separation, by_forces, dt) - now;
            } else {
                goal.change[k] = -(velocity[k] + max(p.separation, 0.0f) / dt);
            }
        }
    }
    /// Friction acts together with the bounce. Without restitution, it acts in the sub-steps, as
    /// the end of the approach does; on jointed bodies, too.
    void add_friction(const ContactConstraint& c, const ContactExtra& extra,
                      ImpactResponse& response, const SolverBody& a, const SolverBody& b) {
        response.add_friction(c, goal.meets, a, b);
        goal.friction = c.friction;
        for (int k = 0; k < c.count; ++k) goal.around[k] = 2.0f * velocity[k] + goal.change[k];
        goal.slip = response.slip_of(c, extra.surface_speed, a, b);
        goal.end_of_slip = -goal.slip;
    }
    bool any() const { return goal.meets[0] || goal.meets[1]; }
    /// A velocity that the joints of the bodies forbid does not bounce: they take it away. A point
    /// at which joints hold the bodies does not bounce if a kinematic body drives them.
    void yield_to_joints(const ContactConstraint& c, const ContactExtra& extra,
                         const JointedResponse& response, JointResponse& joints,
                         std::span<const SolverBody> bodies, float threshold) {
        for (int k = 0; k < c.count; ++k) {
            const JointResponse::Reaction& reaction = response.reactions[k];
            const float forbidden = float(joints.forbidden(reaction, bodies));
            goal.change[k] += (1.0f + extra.restitution) * forbidden;
            velocity[k] -= forbidden;
            goal.meets[k] = goal.meets[k] && velocity[k] < -threshold;
            if (joints.are_driven(reaction))
                goal.meets[k] = goal.meets[k] && !joints.are_held(reaction, response.of(k));
        }
    }
};

/// Impacts with less restitution are solved one after the other: what differs is no more than this
/// part of their speed.
constexpr float least_worth = 0.2f;

/// An impact of two bodies in a pass.
struct PairImpact {
    uint32_t constraint = 0;
    ContactConstraint contact;  ///< at the impact
    float time = 0.0f;  ///< until the shapes meet, as a share of the step; < 0: they overlap
    ImpactResponse response;
    ImpactGoal goal;      ///< in the first round
    float after[2] = {};  ///< wanted velocities of the points, m/s
    float surface_speed = 0.0f;
    float restitution = 0.0f;
    float worth = 0.0f;    ///< of the velocity that is missing after a round
    float share = 1.0f;    ///< of the impulses that would be right if it were alone
    ImpactImpulses total;  ///< of all rounds
    ImpactImpulses added;  ///< in the present round

    PairImpact(uint32_t index, const ContactConstraint& c, const ContactExtra& extra,
               MeetingPoints& meeting, const SolverBody& a, const SolverBody& b)
        : constraint(index),
          contact(c),
          time(meeting.time),
          response(c),
          surface_speed(extra.surface_speed),
          restitution(extra.restitution),
          worth(extra.restitution) {
        if (c.friction > 0.0f) meeting.add_friction(c, extra, response, a, b);
        goal = meeting.goal;
        for (int k = 0; k < c.count; ++k) after[k] = meeting.velocity[k] + goal.change[k];
    }
    /// Computes the impulses of a round. False if hardly a change of velocity is missing.
    bool approach(std::span<const SolverBody> bodies, float part) {
        const ContactConstraint& c = contact;
        constexpr float accuracy = 0.001f;
        const SolverBody &a = bodies[c.a], &b = bodies[c.b];
        ImpactGoal missing = goal;
        bool any = false;
        for (int k = 0; k < c.count; ++k) {
            if (!goal.meets[k]) continue;
            missing.change[k] = after[k] - velocity_at(c, k, a, b);
            any = any || std::fabs(missing.change[k]) > accuracy * std::fabs(goal.change[k]);
        }
        added = {};
        if (goal.friction > 0.0f) return rub(missing, any, a, b, part);
        if (!any) return false;
        const ImpactImpulses bounce(response, missing);
        for (int k = 0; k < c.count; ++k)
            added.normal[k] = max(part * bounce.normal[k], -total.normal[k]);
        return true;
    }
    void add(std::span<SolverBody> bodies) {
        push(contact, response, added, bodies);
        for (int k = 0; k < contact.count; ++k) total.normal[k] += added.normal[k];
        total.tangent += added.tangent;
    }

  private:
    /// With friction, the impulses of all rounds follow Coulomb's law, not those of each.
    bool rub(ImpactGoal& missing, bool any, const SolverBody& a, const SolverBody& b, float part) {
        constexpr float accuracy = 0.001f;
        missing.end_of_slip =
            total.along_tangent(response) - response.slip_of(contact, surface_speed, a, b);
        for (int k = 0; k < contact.count; ++k) missing.change[k] += total.at_point(response, k);
        const ImpactImpulses right(response, missing);
        const float tangent = right.tangent - total.tangent;
        const float greatest = max(std::fabs(goal.change[0]), std::fabs(goal.change[1]));
        if (!any && !(std::fabs(tangent) * response.slip > accuracy * greatest)) return false;
        for (int k = 0; k < contact.count; ++k)
            added.normal[k] = part * (right.normal[k] - total.normal[k]);
        added.tangent = part * tangent;
        return true;
    }
};

void for_moving(const ContactConstraint& c, std::span<const SolverBody> bodies, auto&& act) {
    if (moves(bodies[c.a])) act(c.a);
    if (moves(bodies[c.b])) act(c.b);
}

/// Leaves out impacts that come later than another one of the same body: after that one, the body
/// moves elsewhere. The others get their share: 1 / the number of impacts of one of its bodies.
void keep_first(std::vector<PairImpact>& impacts, std::span<const SolverBody> bodies,
                std::span<FirstImpact> first) {
    constexpr float same = 1e-4f;
    for (const PairImpact& impact : impacts)
        for_moving(impact.contact, bodies, [&](uint32_t body) { first[body] = {}; });
    for (const PairImpact& impact : impacts)
        for_moving(impact.contact, bodies,
                   [&](uint32_t body) { first[body].time = min(first[body].time, impact.time); });
    std::erase_if(impacts, [&](const PairImpact& impact) {
        const ContactConstraint& c = impact.contact;
        bool later = false;
        for_moving(c, bodies,
                   [&](uint32_t body) { later |= impact.time > first[body].time + same; });
        if (!later) for_moving(c, bodies, [&](uint32_t body) { ++first[body].count; });
        return later;
    });
}

/// Impacts that happen at the same time. Solved one after the other, the first would get more: a
/// ball that meets two others in the middle would leave to the side. So in each round all impulses
/// are computed from the same velocities, each a share of what would be right if it were alone. In
/// a narrow wedge such rounds would take long, so the last ones are one after the other. What is
/// missing at the end is left to the next pass, which bounces it: after n rounds this is worth
/// about eⁿ with the restitution e, and no less than `least_worth`.
void solve_together(std::vector<PairImpact>& impacts, std::span<SolverBody> bodies,
                    std::span<const FirstImpact> first) {
    constexpr int rounds_together = 48, rounds_in_all = 60;
    std::vector<PairImpact*> shared;  // Alone, an impact is exact after the first round.
    for (PairImpact& impact : impacts) {
        const ContactConstraint& c = impact.contact;
        uint32_t count = 1;
        for_moving(c, bodies, [&](uint32_t body) { count = max(count, first[body].count); });
        impact.share = 1.0f / float(count);
        impact.approach(bodies, impact.share);
        if (count > 1) shared.push_back(&impact);
    }
    for (PairImpact& impact : impacts) impact.add(bodies);
    for (int round = 1; round < rounds_in_all && !shared.empty(); ++round) {
        const bool in_turn = round >= rounds_together;
        bool any = false;
        for (PairImpact* const impact : shared) {
            any |= impact->approach(bodies, in_turn ? 1.0f : impact->share);
            if (in_turn) impact->add(bodies);
        }
        if (!any) return;
        for (PairImpact* const impact : shared)
            if (!in_turn) impact->add(bodies);
        std::erase_if(shared, [&](PairImpact* impact) {
            impact->worth *= impact->restitution;
            return impact->worth < least_worth;
        });
    }
}

}  // namespace

bool ContactSolver::may_bounce() const {
    for (const ContactExtra& extra : extras)
        if (extra.in_impact && is_fast(extra, restitution_threshold)) return true;
    return false;
}

bool ContactSolver::bounce(int substeps, uint8_t pass, const Bounced& bounced,
                           JointResponse* joints) {
    const float dt = float(substeps) / inverse_h;
    const std::span<uint8_t> changed = bounced.last_pass;
    std::vector<PairImpact> impacts;
    bool any = false;
    const auto mark = [&](uint32_t body) {
        if (moves(bodies[body])) changed[body] = pass;
    };
    const auto record = [&](ContactExtra& extra, const ContactConstraint& met,
                            const ImpactResponse& response, const ImpactImpulses& by) {
        for (int k = 0; k < met.count; ++k) {
            extra.greatest[k] = max(extra.greatest[k], by.normal[k]);
            extra.total[k] += by.normal[k];
        }
        by.add_to(extra.bounced, met, response);
    };
    for (uint32_t i = 0; i < constraints.size(); ++i) {
        const ContactConstraint& c = constraints[i];
        // Neither body has changed since the last pass.
        if (pass > 1 && changed[c.a] + 1 < pass && changed[c.b] + 1 < pass) continue;
        if (c.extra == 0 || !extras[c.extra - 1].in_impact) continue;
        ContactExtra& extra = extras[c.extra - 1];
        if (!passes_on(extra.restitution, pass)) continue;
        const SolverBody &a = bodies[c.a], &b = bodies[c.b];
        // After the impulses of other contacts.
        for (int k = 0; k < c.count; ++k) extra.approach[k] = velocity_at(c, k, a, b);
        // Most contacts of a heap only pass small speeds on. Their forces are not read.
        if (!is_fast(extra, restitution_threshold)) continue;
        const SolverForce &fa = forces[c.a], &fb = forces[c.b];
        const auto impact = at_impact(c, extra, a, b, dt);
        if (!impact) continue;
        const ContactConstraint& met = impact->contact;
        const bool jointed = joints != nullptr && joints->acts_on(c.a, c.b);
        MeetingPoints meeting(*impact, extra, a, b, fa, fb, substeps, dt, restitution_threshold,
                              jointed);
        if (!meeting.any()) continue;
        if (!jointed && extra.restitution > 0.0f) {
            impacts.emplace_back(i, met, extra, meeting, a, b);
            // Also if it is left out of this pass: the next one looks at it again.
            mark(c.a);
            mark(c.b);
            continue;
        }
        const bool rubs = c.friction > 0.0f && extra.restitution > 0.0f && !jointed;
        const auto apply = [&](const ImpactResponse& response) {
            const ImpactImpulses impulses(response, meeting.goal);
            push(met, response, impulses, bodies);
            record(extra, met, response, impulses);
            for (int k = 0; k < c.count && !rubs; ++k)
                extra.impact[k] += impulses.normal[k] / float(substeps);
            any = true;
            mark(c.a);
            mark(c.b);
            return impulses;
        };
        if (!jointed) {
            ImpactResponse response(met);
            if (rubs) meeting.add_friction(met, extra, response, a, b);
            apply(response);
            continue;
        }
        const JointedResponse response(met, joints);
        meeting.yield_to_joints(met, extra, response, *joints, bodies, restitution_threshold);
        if (!meeting.any()) continue;
        const ImpactImpulses impulses = apply(response);
        for (int k = 0; k < c.count; ++k)
            if (impulses.normal[k] != 0.0f)
                joints->apply(response.reactions[k], double(impulses.normal[k]), bodies, mark);
    }
    if (impacts.empty()) return any;
    keep_first(impacts, bodies, bounced.first);
    solve_together(impacts, bodies, bounced.first);
    for (const PairImpact& impact : impacts)
        record(extras[constraints[impact.constraint].extra - 1], impact.contact, impact.response,
               impact.total);
    return true;
}

bool ContactSolver::bounces_later(const ContactConstraint& c) const {
    if (c.extra == 0 || !(extras[c.extra - 1].restitution > 0.0f)) return false;
    const SolverBody &a = bodies[c.a], &b = bodies[c.b];
    bool fast = false;
    for (int k = 0; k < c.count; ++k) {
        const ConstraintPoint& p = c.points[k];
        const float velocity = velocity_at(c, k, a, b);
        const float opened = dot(c.normal, b.shift - a.shift) +
                             (p.normal_lever_b * b.turn - p.normal_lever_a * a.turn);
        float gap = p.separation + opened;
        if (const Corner* const corner = corner_of(c); corner != nullptr && c.count == 1)
            gap +=
                path_around(*corner, c.normal, a, b, PairMotion(a, b), opened, velocity, 0.0f).gap;
        if (!(gap > 0.0f)) return false;
        fast |= velocity < -restitution_threshold;
    }
    return fast;
}

void ContactSolver::restitute() {
    if (extras.empty()) return;
    for (ContactConstraint& c : constraints) {
        if (c.extra == 0 || !(extras[c.extra - 1].restitution > 0.0f)) continue;
        ContactExtra& extra = extras[c.extra - 1];
        ImpactGoal goal;
        for (int k = 0; k < c.count; ++k) {
            const SolverBody &a = bodies[c.a], &b = bodies[c.b];
            const float approach = closing_velocity(c, extra, k, extra.approach[k], a, b);
            goal.change[k] = -extra.restitution * approach - velocity_at(c, k, a, b);
            goal.meets[k] = approach <= -restitution_threshold && extra.greatest[k] > 0.0f &&
                            goal.change[k] > 0.0f && c.points[k].normal_mass > 0.0f;
        }
        const ImpactImpulses bounce(ImpactResponse(c), goal);
        for (int k = 0; k < c.count; ++k) {
            if (!goal.meets[k]) continue;
            push(c, k, bounce.normal[k], bodies);
            c.points[k].normal_impulse += bounce.normal[k];
            extra.greatest[k] = max(extra.greatest[k], c.points[k].normal_impulse);
            extra.total[k] += bounce.normal[k];
        }
    }
}

}  // namespace fettle::physics::detail
