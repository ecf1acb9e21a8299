// The passes of the solver. Compiled for the instruction set of the including file: see
// simd/vector.h.
#pragma once

#include <constraints/wide_bodies.h>
#include <constraints/wide_contact.h>

namespace fettle::physics::detail {
namespace {

/// Applies an impulse of size `p` along (x, y) with its moments about both centers.
inline void apply(Bodies& a, Bodies& b, Wide x, Wide y, Wide p, Wide moment_a, Wide moment_b) {
    a.vx -= a.mass * p * x;
    a.vy -= a.mass * p * y;
    a.w -= a.inertia * moment_a;
    b.vx += b.mass * p * x;
    b.vy += b.mass * p * y;
    b.w += b.inertia * moment_b;
}

/// See `NormalRow` of the scalar solver.
struct Row {
    Wide bias, mass, kept;

    template <bool biased>
    static Row make(const WidePoint& p, int at, Wide s, const WideContact& c,
                    const WideStep& step) {
        const Wide zero = {};
        const auto apart = s > zero;
        const Wide mass = load(p.normal_mass + at), impulse = load(p.normal_impulse + at);
        const Wide speculative = s * splat(step.inverse_h);
        if constexpr (biased) {
            const Wide pushed = greater(load(c.bias_rate + at) * s, splat(-step.push_speed));
            return {apart ? speculative : pushed, apart ? mass : mass * load(c.mass_scale + at),
                    apart ? impulse : load(c.impulse_keep + at) * impulse};
        }
        return {apart ? speculative : zero, mass, impulse};
    }
    /// The impulse that the row alone wants; negative if it would have to pull.
    Wide wanted(Wide velocity) const { return kept - mass * (velocity + bias); }
};

/// The result of a pass along the normals.
struct NormalPass {
    Wide pushes;        ///< sum of the impulses of both points
    WideInt unsettled;  ///< see `unsettling_change`
};

template <bool biased>
inline NormalPass solve_normals(WideContact& c, int at, Bodies& a, Bodies& b,
                                const WideStep& step) {
    const Wide nx = load(c.normal_x + at), ny = load(c.normal_y + at);
    const Wide approach = nx * (b.vx - a.vx) + ny * (b.vy - a.vy);
    const Wide shift = nx * (b.dx - a.dx) + ny * (b.dy - a.dy);
    WidePoint &p = c.points[0], &q = c.points[1];
    const Wide pa = load(p.normal_lever_a + at), pb = load(p.normal_lever_b + at);
    const Wide qa = load(q.normal_lever_a + at), qb = load(q.normal_lever_b + at);
    const Wide s1 = load(p.separation + at) + shift + (pb * b.turn - pa * a.turn);
    const Wide s2 = load(q.separation + at) + shift + (qb * b.turn - qa * a.turn);
    const Wide v1 = approach + (pb * b.w - pa * a.w);
    const Wide v2 = approach + (qb * b.w - qa * a.w);
    const Row row1 = Row::make<biased>(p, at, s1, c, step);
    const Row row2 = Row::make<biased>(q, at, s2, c, step);
    // See the scalar solver.
    const Wide coupling = splat(coupled_share) * load(c.coupling_normal + at), zero = {};
    const Wide old1 = load(p.normal_impulse + at), old2 = load(q.normal_impulse + at);
    const Wide alone1 = row1.wanted(v1 - coupling * old2);
    const Wide alone2 = row2.wanted(v2 - coupling * old1);
    const Wide k1 = row1.mass * coupling, k2 = row2.mass * coupling;
    const Wide both1 = alone1 - k1 * alone2, both2 = alone2 - k2 * alone1;
    const Wide share = splat(1.0f) / (splat(1.0f) - k1 * k2);
    const Wide new1 = greater(both2 > zero ? share * both1 : alone1, zero);
    const Wide new2 = greater(both1 > zero ? share * both2 : alone2, zero);
    store(p.normal_impulse + at, new1);
    store(q.normal_impulse + at, new2);
    const Wide i1 = new1 - old1, i2 = new2 - old2;
    apply(a, b, nx, ny, i1 + i2, pa * i1 + qa * i2, pb * i1 + qb * i2);
    const auto is_large = [&](Wide change, const WidePoint& point) {
        return greater(change, -change) > splat(unsettling_change) * load(point.normal_mass + at);
    };
    return {new1 + new2, is_large(i1, p) | is_large(i2, q)};
}

inline Wide solve_tangent(WidePoint& p, int at, Wide velocity, Wide friction) {
    const Wide most = friction * load(p.normal_impulse + at);
    const Wide old = load(p.tangent_impulse + at);
    const Wide total = limit(old - load(p.tangent_mass + at) * velocity, -most, most);
    store(p.tangent_impulse + at, total);
    return total - old;
}

inline void solve_friction(WideContact& c, int at, Bodies& a, Bodies& b) {
    const Wide tx = load(c.normal_y + at), ty = -load(c.normal_x + at), mu = load(c.friction + at);
    const Wide slip = tx * (b.vx - a.vx) + ty * (b.vy - a.vy);
    WidePoint &p = c.points[0], &q = c.points[1];
    const Wide pa = load(p.tangent_lever_a + at), pb = load(p.tangent_lever_b + at);
    const Wide qa = load(q.tangent_lever_a + at), qb = load(q.tangent_lever_b + at);
    const Wide v1 = slip + (pb * b.w - pa * a.w), v2 = slip + (qb * b.w - qa * a.w);
    const Wide i1 = solve_tangent(p, at, v1, mu);
    const Wide i2 = solve_tangent(q, at, v2 + load(c.coupling_tangent + at) * i1, mu);
    apply(a, b, tx, ty, i1 + i2, pa * i1 + qa * i2, pb * i1 + qb * i2);
}

template <typename Solve>
inline void for_each_group(const WideStep& step, Solve&& solve) {
    for (std::size_t i = 0; i < step.count; ++i) {
        WideContact& c = step.contacts[i];
        for (int at = 0; at < group_size; at += width) {
            if (c.a[at] == c.b[at]) break;  // group_size are filled in order, so the rest is unused
            Bodies a = gather(step.bodies, c.a + at), b = gather(step.bodies, c.b + at);
            solve(c, at, a, b, i);
            scatter(step.bodies, c.a + at, a);
            scatter(step.bodies, c.b + at, b);
        }
    }
}

void warm_start(const WideStep& step) {
    for_each_group(step, [](WideContact& c, int at, Bodies& a, Bodies& b, std::size_t) {
        const WidePoint &p = c.points[0], &q = c.points[1];
        const Wide pn = load(p.normal_impulse + at), pt = load(p.tangent_impulse + at);
        const Wide qn = load(q.normal_impulse + at), qt = load(q.tangent_impulse + at);
        const Wide moment_a =
            load(p.normal_lever_a + at) * pn + load(p.tangent_lever_a + at) * pt +
            (load(q.normal_lever_a + at) * qn + load(q.tangent_lever_a + at) * qt);
        const Wide moment_b =
            load(p.normal_lever_b + at) * pn + load(p.tangent_lever_b + at) * pt +
            (load(q.normal_lever_b + at) * qn + load(q.tangent_lever_b + at) * qt);
        const Wide nx = load(c.normal_x + at), ny = load(c.normal_y + at), n = pn + qn, t = pt + qt;
        apply(a, b, nx * n + ny * t, ny * n - nx * t, splat(1.0f), moment_a, moment_b);
    });
}

void solve_biased(const WideStep& step) {
    for_each_group(step, [&step](WideContact& c, int at, Bodies& a, Bodies& b, std::size_t) {
        solve_normals<true>(c, at, a, b, step);
    });
}

void relax(const WideStep& step) {
    for_each_group(step, [&step](WideContact& c, int at, Bodies& a, Bodies& b, std::size_t i) {
        solve_friction(c, at, a, b);
        const NormalPass normals = solve_normals<false>(c, at, a, b, step);
        step.pushed[i] |= bits(normals.pushes > Wide{}) << at;
        const uint32_t before = at == 0 ? 0 : step.unsettled[i];
        step.unsettled[i] = before | bits(normals.unsettled) << at;
    });
}

}  // namespace
}  // namespace fettle::physics::detail
