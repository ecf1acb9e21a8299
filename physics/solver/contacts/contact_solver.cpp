#include <solver/contacts/contact_solver.h>
#include <solver/contacts/solved_pair.h>

#include <cmath>

// Sequential impulses (E. Catto, "Iterative Dynamics with Temporal Coherence", 2005) on small steps
// with soft contacts (E. Catto, "Solver2D", 2024: "soft step"). The normal impulses of two points
// are solved together, friction at one point after the other. The effect of an impulse at one point
// on the relative velocity at the other is computed in advance (`coupling`).

namespace fettle::physics::detail {
namespace {

/// Total normal impulse of a point. Biased: soft if the shapes overlap; otherwise the gap may
/// close, but not more.
struct NormalRow {
    float bias = 0.0f;
    float mass = 0.0f;
    float kept;  ///< share of the accumulated impulse that softness keeps

    template <bool biased>
    static NormalRow make(const ConstraintPoint& p, float separation, const Softness& soft,
                          float inverse_h, float push_speed) {
        if (separation > 0.0f) return {separation * inverse_h, p.normal_mass, p.normal_impulse};
        if constexpr (biased) {
            return {max(soft.bias_rate * separation, -push_speed), p.normal_mass * soft.mass_scale,
                    (1.0f - soft.impulse_scale) * p.normal_impulse};
        }
        return {0.0f, p.normal_mass, p.normal_impulse};
    }
    /// The impulse that the row alone wants; negative if it would have to pull.
    float wanted(float velocity) const { return kept - mass * (velocity + bias); }
};

template <bool biased>
inline void solve_normals(ContactConstraint& c, const SolverBody& a, const SolverBody& b,
                          SolvedPair& pair, const Corner* corner, float inverse_h,
                          float push_speed) {
    const Softness& soft = c.soft;
    const Vec2 n = c.normal;
    const float approach = dot(n, pair.vb - pair.va);
    const float shift = dot(n, b.shift - a.shift);
    ConstraintPoint& p = c.points[0];
    float s1 = p.separation + shift + (p.normal_lever_b * b.turn - p.normal_lever_a * a.turn);
    float v1 = approach + (p.normal_lever_b * pair.wb - p.normal_lever_a * pair.wa);
    if (c.count == 1) {
        if (corner != nullptr) {
            const CornerPath path =
                path_around(*corner, n, a, b, pair, s1 - p.separation, v1, 1.0f / inverse_h);
            v1 += path.opening * inverse_h;
            s1 += path.gap;
        }
        const float total =
            max(NormalRow::make<biased>(p, s1, soft, inverse_h, push_speed).wanted(v1), 0.0f);
        const float impulse = total - p.normal_impulse;
        p.normal_impulse = total;
        pair.apply(n, impulse, p.normal_lever_a * impulse, p.normal_lever_b * impulse);
        return;
    }
    ConstraintPoint& q = c.points[1];
    const float s2 = q.separation + shift + (q.normal_lever_b * b.turn - q.normal_lever_a * a.turn);
    const float v2 = approach + (q.normal_lever_b * pair.wb - q.normal_lever_a * pair.wa);
    const NormalRow row1 = NormalRow::make<biased>(p, s1, soft, inverse_h, push_speed);
    const NormalRow row2 = NormalRow::make<biased>(q, s2, soft, inverse_h, push_speed);
    const float old1 = p.normal_impulse, old2 = q.normal_impulse;
    // What each point wants if the other one has no impulse, and if both have one.
    const float coupling = coupled_share * c.coupling_normal;
    const float alone1 = row1.wanted(v1 - coupling * old2);
    const float alone2 = row2.wanted(v2 - coupling * old1);
    const float k1 = row1.mass * coupling, k2 = row2.mass * coupling;
    const float both1 = alone1 - k1 * alone2, both2 = alone2 - k2 * alone1;
    const float share = 1.0f / (1.0f - k1 * k2);
    p.normal_impulse = max(both2 > 0.0f ? share * both1 : alone1, 0.0f);
    q.normal_impulse = max(both1 > 0.0f ? share * both2 : alone2, 0.0f);
    const float i1 = p.normal_impulse - old1, i2 = q.normal_impulse - old2;
    pair.apply(n, i1 + i2, p.normal_lever_a * i1 + q.normal_lever_a * i2,
               p.normal_lever_b * i1 + q.normal_lever_b * i2);
}

inline float tangent_impulse(ConstraintPoint& p, float velocity, float friction, float impact) {
    const float greatest = friction * (p.normal_impulse + impact);
    const float total = clamp(p.tangent_impulse - p.tangent_mass * velocity, -greatest, greatest);
    const float impulse = total - p.tangent_impulse;
    p.tangent_impulse = total;
    return impulse;
}

/// `impacts`: normal impulses beside those of the points, in a sub-step.
inline void solve_friction(ContactConstraint& c, SolvedPair& pair, float surface_speed,
                           const float (&impacts)[2]) {
    const Vec2 t = right_perp(c.normal);
    const float slip = dot(t, pair.vb - pair.va) + surface_speed;
    ConstraintPoint& p = c.points[0];
    const float v1 = slip + (p.tangent_lever_b * pair.wb - p.tangent_lever_a * pair.wa);
    if (c.count == 1) {
        const float impulse = tangent_impulse(p, v1, c.friction, impacts[0]);
        pair.apply(t, impulse, p.tangent_lever_a * impulse, p.tangent_lever_b * impulse);
        return;
    }
    ConstraintPoint& q = c.points[1];
    const float v2 = slip + (q.tangent_lever_b * pair.wb - q.tangent_lever_a * pair.wa);
    const float i1 = tangent_impulse(p, v1, c.friction, impacts[0]);
    const float i2 = tangent_impulse(q, v2 + c.coupling_tangent * i1, c.friction, impacts[1]);
    pair.apply(t, i1 + i2, p.tangent_lever_a * i1 + q.tangent_lever_a * i2,
               p.tangent_lever_b * i1 + q.tangent_lever_b * i2);
}

inline void solve_rolling(ContactConstraint& c, ContactExtra& extra, SolvedPair& pair) {
    if (!(extra.rolling_resistance > 0.0f)) return;
    float normal = c.points[0].normal_impulse;
    if (c.count == 2) normal += c.points[1].normal_impulse;
    const float greatest = extra.rolling_resistance * normal;
    const float wanted = extra.rolling_impulse - extra.rolling_mass * (pair.wb - pair.wa);
    const float total = clamp(wanted, -greatest, greatest);
    const float impulse = total - extra.rolling_impulse;
    extra.rolling_impulse = total;
    pair.wa -= pair.ia * impulse;
    pair.wb += pair.ib * impulse;
}

/// True if a pass changed the velocity at a point much: see `unsettling_change`. `old`: the
/// impulses before it.
bool changes_much(const ContactConstraint& c, const float (&old)[2]) {
    const auto at = [&](int k) {
        const ConstraintPoint& p = c.points[k];
        return std::fabs(p.normal_impulse - old[k]) > unsettling_change * p.normal_mass;
    };
    return at(0) || at(1);
}

}  // namespace

void ContactSolver::follow(ContactConstraint& c, const SolverBody& a, const SolverBody& b) const {
    if (c.extra != 0 && extras[c.extra - 1].rolling != 0)
        rolling[extras[c.extra - 1].rolling - 1].follow(c, a, b);
}

void ContactSolver::warm_start() {
    for (ContactConstraint& c : constraints) {
        SolverBody& a = bodies[c.a];
        SolverBody& b = bodies[c.b];
        follow(c, a, b);
        SolvedPair pair(c, a, b);
        const Vec2 t = right_perp(c.normal);
        const ConstraintPoint& p = c.points[0];
        float pn = p.normal_impulse, pt = p.tangent_impulse;
        float angular_a = p.normal_lever_a * pn + p.tangent_lever_a * pt;
        float angular_b = p.normal_lever_b * pn + p.tangent_lever_b * pt;
        if (c.count == 2) {
            const ConstraintPoint& q = c.points[1];
            angular_a +=
                q.normal_lever_a * q.normal_impulse + q.tangent_lever_a * q.tangent_impulse;
            angular_b +=
                q.normal_lever_b * q.normal_impulse + q.tangent_lever_b * q.tangent_impulse;
            pn += q.normal_impulse;
            pt += q.tangent_impulse;
        }
        if (c.extra != 0) {
            angular_a += extras[c.extra - 1].rolling_impulse;
            angular_b += extras[c.extra - 1].rolling_impulse;
        }
        const Vec2 impulse = {c.normal.x * pn + t.x * pt, c.normal.y * pn + t.y * pt};
        pair.apply(impulse, 1.0f, angular_a, angular_b);
        pair.store(a, b);
    }
}

const Corner* ContactSolver::corner_of(const ContactConstraint& c) const {
    if (c.extra == 0 || extras[c.extra - 1].corner.distance == 0.0f) return nullptr;
    return &extras[c.extra - 1].corner;
}

void ContactSolver::solve_biased(ContactConstraint& c) const {
    SolverBody& a = bodies[c.a];
    SolverBody& b = bodies[c.b];
    follow(c, a, b);
    SolvedPair pair(c, a, b);
    solve_normals<true>(c, a, b, pair, corner_of(c), inverse_h, push_speed);
    pair.store(a, b);
}

Relaxed ContactSolver::relax(ContactConstraint& c) const {
    SolverBody& a = bodies[c.a];
    SolverBody& b = bodies[c.b];
    follow(c, a, b);
    SolvedPair pair(c, a, b);
    const float old[2] = {c.points[0].normal_impulse, c.points[1].normal_impulse};
    if (c.extra == 0) {
        solve_friction(c, pair, 0.0f, {0.0f, 0.0f});
    } else {
        ContactExtra& extra = extras[c.extra - 1];
        solve_rolling(c, extra, pair);
        solve_friction(c, pair, extra.surface_speed, extra.impact);
    }
    solve_normals<false>(c, a, b, pair, corner_of(c), inverse_h, push_speed);
    c.pushed |=
        c.points[0].normal_impulse > 0.0f || (c.count > 1 && c.points[1].normal_impulse > 0.0f);
    pair.store(a, b);
    return changes_much(c, old) ? Relaxed::unsettled : Relaxed::settled;
}

void ContactSolver::solve_biased() {
    for (ContactConstraint& c : constraints) solve_biased(c);
}

void ContactSolver::relax() {
    for (size_t i = 0; i < constraints.size(); ++i) relaxed[i] = relax(constraints[i]);
}

void ContactSolver::relax_at_end() {
    for (size_t i = 0; i < constraints.size(); ++i)
        relaxed[i] = bounces_later(constraints[i]) ? Relaxed::left_out : relax(constraints[i]);
}

void ContactSolver::relax_again(UnsettledContacts& unsettled) {
    for (size_t i = 0; i < constraints.size(); ++i) {
        ContactConstraint& c = constraints[i];
        if (relaxed[i] == Relaxed::left_out || !unsettled.are_relaxed(c.a, c.b)) continue;
        relaxed[i] = relax(c);
        if (relaxed[i] == Relaxed::unsettled) unsettled.leave(c.a, c.b);
    }
}

void ContactSolver::record() {
    for (size_t i = 0; i < constraints.size(); ++i) {
        const ContactConstraint& c = constraints[i];
        if (c.extra != 0 && relaxed[i] != Relaxed::left_out) extras[c.extra - 1].record(c);
    }
}

void ContactSolver::solve_biased(std::span<const uint32_t> some) {
    for (const uint32_t i : some) solve_biased(constraints[i]);
}

void ContactSolver::relax(std::span<const uint32_t> some) {
    for (const uint32_t i : some) relax(constraints[i]);
}

}  // namespace fettle::physics::detail
