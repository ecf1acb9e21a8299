// No include guard on purpose beyond this one: included by one source file for each instruction
// set, which defines FETTLE_LANES before: 4 or 8. Everything is in an unnamed namespace, so that no
// code for one instruction set is ever linked into another.
#pragma once

#include <solver/wide_contact.h>

#include <cstring>

namespace fettle::physics::detail {
namespace {

inline constexpr int width = FETTLE_LANES;
using Wide = float __attribute__((vector_size(width * sizeof(float))));
using Quad = float __attribute__((vector_size(4 * sizeof(float))));

inline Wide load(const float* from) {
    Wide v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
inline void store(float* to, Wide v) {
    std::memcpy(to, &v, sizeof v);
}
inline Wide splat(float v) {
    return v - Wide{};
}
inline Wide greater(Wide a, Wide b) {
    return a > b ? a : b;
}
inline Wide limit(Wide v, Wide low, Wide high) {
    return v < low ? low : (v > high ? high : v);
}

/// The solver bodies of all lanes, one component a vector.
struct Bodies {
    Wide vx, vy, w, mass, dx, dy, turn, inertia;
};

#define FETTLE_SHUFFLE __builtin_shufflevector

#if FETTLE_LANES == 8
/// Eight rows of eight to eight columns of eight.
inline Bodies transpose(const Wide (&r)[8]) {
    Bodies b;
    Wide t[8], u[8];
    for (int i = 0; i < 8; i += 2) {
        t[i] = FETTLE_SHUFFLE(r[i], r[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
        t[i + 1] = FETTLE_SHUFFLE(r[i], r[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
    }
    for (int i = 0; i < 8; i += 4) {
        u[i] = FETTLE_SHUFFLE(t[i], t[i + 2], 0, 1, 8, 9, 4, 5, 12, 13);
        u[i + 1] = FETTLE_SHUFFLE(t[i], t[i + 2], 2, 3, 10, 11, 6, 7, 14, 15);
        u[i + 2] = FETTLE_SHUFFLE(t[i + 1], t[i + 3], 0, 1, 8, 9, 4, 5, 12, 13);
        u[i + 3] = FETTLE_SHUFFLE(t[i + 1], t[i + 3], 2, 3, 10, 11, 6, 7, 14, 15);
    }
    b.vx = FETTLE_SHUFFLE(u[0], u[4], 0, 1, 2, 3, 8, 9, 10, 11);
    b.vy = FETTLE_SHUFFLE(u[1], u[5], 0, 1, 2, 3, 8, 9, 10, 11);
    b.w = FETTLE_SHUFFLE(u[2], u[6], 0, 1, 2, 3, 8, 9, 10, 11);
    b.mass = FETTLE_SHUFFLE(u[3], u[7], 0, 1, 2, 3, 8, 9, 10, 11);
    b.dx = FETTLE_SHUFFLE(u[0], u[4], 4, 5, 6, 7, 12, 13, 14, 15);
    b.dy = FETTLE_SHUFFLE(u[1], u[5], 4, 5, 6, 7, 12, 13, 14, 15);
    b.turn = FETTLE_SHUFFLE(u[2], u[6], 4, 5, 6, 7, 12, 13, 14, 15);
    b.inertia = FETTLE_SHUFFLE(u[3], u[7], 4, 5, 6, 7, 12, 13, 14, 15);
    return b;
}
#else
/// Four rows of four to four columns of four.
inline void transpose4(Quad& a, Quad& b, Quad& c, Quad& d) {
    const Quad ab_low = FETTLE_SHUFFLE(a, b, 0, 4, 1, 5),
               ab_high = FETTLE_SHUFFLE(a, b, 2, 6, 3, 7);
    const Quad cd_low = FETTLE_SHUFFLE(c, d, 0, 4, 1, 5),
               cd_high = FETTLE_SHUFFLE(c, d, 2, 6, 3, 7);
    a = FETTLE_SHUFFLE(ab_low, cd_low, 0, 1, 4, 5);
    b = FETTLE_SHUFFLE(ab_low, cd_low, 2, 3, 6, 7);
    c = FETTLE_SHUFFLE(ab_high, cd_high, 0, 1, 4, 5);
    d = FETTLE_SHUFFLE(ab_high, cd_high, 2, 3, 6, 7);
}

#endif

inline Bodies gather(const SolverBody* bodies, const uint32_t* index) {
#if FETTLE_LANES == 8
    Wide rows[8];
    for (int i = 0; i < 8; ++i) std::memcpy(&rows[i], &bodies[index[i]], sizeof(Wide));
    return transpose(rows);
#else
    Quad low[4], high[4];
    for (int i = 0; i < 4; ++i) {
        const char* from = reinterpret_cast<const char*>(&bodies[index[i]]);
        std::memcpy(&low[i], from, 16);
        std::memcpy(&high[i], from + 16, 16);
    }
    transpose4(low[0], low[1], low[2], low[3]);
    transpose4(high[0], high[1], high[2], high[3]);
    return {low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]};
#endif
}

/// Writes the velocities back: the first half of each body, with the inverse mass as it was.
inline void scatter(SolverBody* bodies, const uint32_t* index, const Bodies& b) {
#if FETTLE_LANES == 8
    const Wide v_low = FETTLE_SHUFFLE(b.vx, b.vy, 0, 8, 1, 9, 4, 12, 5, 13);
    const Wide v_high = FETTLE_SHUFFLE(b.vx, b.vy, 2, 10, 3, 11, 6, 14, 7, 15);
    const Wide w_low = FETTLE_SHUFFLE(b.w, b.mass, 0, 8, 1, 9, 4, 12, 5, 13);
    const Wide w_high = FETTLE_SHUFFLE(b.w, b.mass, 2, 10, 3, 11, 6, 14, 7, 15);
    const Wide pairs[4] = {FETTLE_SHUFFLE(v_low, w_low, 0, 1, 8, 9, 4, 5, 12, 13),
                           FETTLE_SHUFFLE(v_low, w_low, 2, 3, 10, 11, 6, 7, 14, 15),
                           FETTLE_SHUFFLE(v_high, w_high, 0, 1, 8, 9, 4, 5, 12, 13),
                           FETTLE_SHUFFLE(v_high, w_high, 2, 3, 10, 11, 6, 7, 14, 15)};
    for (int i = 0; i < 4; ++i) {
        const Quad low = FETTLE_SHUFFLE(pairs[i], pairs[i], 0, 1, 2, 3);
        const Quad high = FETTLE_SHUFFLE(pairs[i], pairs[i], 4, 5, 6, 7);
        std::memcpy(static_cast<void*>(&bodies[index[i]]), &low, 16);
        std::memcpy(static_cast<void*>(&bodies[index[i + 4]]), &high, 16);
    }
#else
    Quad rows[4] = {b.vx, b.vy, b.w, b.mass};
    transpose4(rows[0], rows[1], rows[2], rows[3]);
    for (int i = 0; i < 4; ++i) std::memcpy(static_cast<void*>(&bodies[index[i]]), &rows[i], 16);
#endif
}

/// An impulse of size `p` along (x, y) with its moments about both centers.
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
    Wide total(Wide velocity) const { return greater(kept - mass * (velocity + bias), Wide{}); }
};

template <bool biased>
inline void solve_normals(WideContact& c, int at, Bodies& a, Bodies& b, const WideStep& step) {
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
    const Wide coupling = load(c.coupling_normal + at), half = splat(0.5f);
    const Wide old1 = load(p.normal_impulse + at), old2 = load(q.normal_impulse + at);
    const Wide first1 = row1.total(v1), first2 = row2.total(v2);
    const Wide second1 = row1.total(v1 + coupling * (first2 - old2));
    const Wide second2 = row2.total(v2 + coupling * (first1 - old1));
    const Wide new1 = half * (first1 + second1), new2 = half * (first2 + second2);
    store(p.normal_impulse + at, new1);
    store(q.normal_impulse + at, new2);
    const Wide i1 = new1 - old1, i2 = new2 - old2;
    apply(a, b, nx, ny, i1 + i2, pa * i1 + qa * i2, pb * i1 + qb * i2);
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
        for (int at = 0; at < lanes; at += width) {
            Bodies a = gather(step.bodies, c.a + at), b = gather(step.bodies, c.b + at);
            solve(c, at, a, b);
            scatter(step.bodies, c.a + at, a);
            scatter(step.bodies, c.b + at, b);
        }
    }
}

void warm_start(const WideStep& step) {
    for_each_group(step, [](WideContact& c, int at, Bodies& a, Bodies& b) {
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
    for_each_group(step, [&step](WideContact& c, int at, Bodies& a, Bodies& b) {
        solve_normals<true>(c, at, a, b, step);
    });
}

void relax(const WideStep& step) {
    for_each_group(step, [&step](WideContact& c, int at, Bodies& a, Bodies& b) {
        solve_normals<false>(c, at, a, b, step);
        solve_friction(c, at, a, b);
    });
}

#undef FETTLE_SHUFFLE

}  // namespace
}  // namespace fettle::physics::detail
