// Conversion between manifolds and wide contacts. Compiled for the instruction set of the including
// file: see simd/vector.h. `prepare_constraint` does exactly the same operations for one contact.
#pragma once

#include <constraints/wide_bodies.h>
#include <constraints/wide_contact.h>

namespace fettle::physics::detail {
namespace {

inline Wide inverse_or_zero(Wide k) {
    return k > Wide{} ? splat(1.0f) / k : Wide{};
}

/// Data of a row along (x, y) for one body: lever arm, and lever arm times the inverse inertia.
struct WideLever {
    Wide arm, turn;
};
inline WideLever lever(Wide anchor_x, Wide anchor_y, Wide x, Wide y, Wide inverse_inertia) {
    const Wide arm = anchor_x * y - anchor_y * x;
    return {arm, inverse_inertia * arm};
}

struct WidePointRows {
    WideLever normal_a, normal_b, tangent_a, tangent_b;

    WidePointRows(const Columns4& anchors, Wide nx, Wide ny, const Bodies& a, const Bodies& b)
        : normal_a(lever(anchors.a, anchors.b, nx, ny, a.inertia)),
          normal_b(lever(anchors.c, anchors.d, nx, ny, b.inertia)),
          tangent_a(lever(anchors.a, anchors.b, ny, -nx, a.inertia)),
          tangent_b(lever(anchors.c, anchors.d, ny, -nx, b.inertia)) {}

    /// `kept`: lanes that have this point.
    void write(const Columns4& state, Wide mass, WideInt kept, float ratio, WidePoint& to,
               int at) const {
        const Wide k_n = mass + normal_a.turn * normal_a.arm + normal_b.turn * normal_b.arm;
        const Wide k_t = mass + tangent_a.turn * tangent_a.arm + tangent_b.turn * tangent_b.arm;
        const auto put = [&](float* out, Wide v) { store(out + at, kept ? v : Wide{}); };
        put(to.normal_lever_a, normal_a.arm);
        put(to.normal_lever_b, normal_b.arm);
        put(to.tangent_lever_a, tangent_a.arm);
        put(to.tangent_lever_b, tangent_b.arm);
        put(to.separation, state.a);
        put(to.normal_mass, inverse_or_zero(k_n));
        put(to.tangent_mass, inverse_or_zero(k_t));
        put(to.normal_impulse, state.b * splat(ratio));
        put(to.tangent_impulse, state.c * splat(ratio));
    }
};

void write_softness(const ContactStiffness& stiffness, Wide impulse, const Bodies& a,
                    const Bodies& b, WideContact& c, int at) {
    const WideInt fixed = (a.mass == Wide{}) | (b.mass == Wide{});
    const Wide t = limit(impulse * greater(a.mass, b.mass) * splat(stiffness.share()) -
                             splat(ContactStiffness::least_share),
                         Wide{}, splat(1.0f));
    const auto between = [&](float Softness::*part) {
        const Wide u =
            fixed ? splat(stiffness.idle(true).*part) : splat(stiffness.idle(false).*part);
        const Wide v =
            fixed ? splat(stiffness.loaded(true).*part) : splat(stiffness.loaded(false).*part);
        return u + t * (v - u);
    };
    const auto gyration = [](const Bodies& body) {
        return ((body.mass > Wide{}) & (body.inertia > Wide{})) ? body.mass / body.inertia
                                                                : splat(1e30f);
    };
    constexpr float least_rate = ContactStiffness::least_rate;
    const Wide size = lesser(
        splat(ContactStiffness::large_gyration) * lesser(gyration(a), gyration(b)), splat(1.0f));
    const Wide yields = size * size;
    const Wide impulse_scale = between(&Softness::impulse_scale);
    store(c.bias_rate + at,
          (splat(least_rate) + splat(1.0f - least_rate) * yields) * between(&Softness::bias_rate));
    store(c.mass_scale + at,
          between(&Softness::mass_scale) + (splat(1.0f) - yields) * impulse_scale);
    store(c.impulse_keep + at, splat(1.0f) - yields * impulse_scale);
}

inline auto part_of(Manifold* const* manifolds, size_t at) {
    return [=](int lane) { return reinterpret_cast<char*>(manifolds[lane]) + at; };
}

constexpr size_t first_point = offsetof(Manifold, points);
constexpr size_t second_point = first_point + sizeof(ManifoldPoint);
constexpr size_t point_state = offsetof(ManifoldPoint, separation);

/// Prepares the lanes from `at` on; `a`, `b` and `friction` of the contacts must be set already.
void prepare_lanes(const PrepareStep& step, Manifold* const* manifolds, WideContact& c, int at) {
    const Columns4 head = gather4(part_of(manifolds, 0));
    const Wide nx = head.a, ny = head.b;
    const WideInt count = as_int(head.c);
    const Bodies a = gather(step.bodies, c.a + at), b = gather(step.bodies, c.b + at);
    const Wide mass = a.mass + b.mass;
    const WidePointRows p(gather4(part_of(manifolds, first_point)), nx, ny, a, b);
    const WidePointRows q(gather4(part_of(manifolds, second_point)), nx, ny, a, b);
    store(c.normal_x + at, nx);
    store(c.normal_y + at, ny);
    const WideInt both = count > 1;
    const float ratio = step.impulse_ratio;
    p.write(gather4(part_of(manifolds, first_point + point_state)), mass, count > 0, ratio,
            c.points[0], at);
    q.write(gather4(part_of(manifolds, second_point + point_state)), mass, both, ratio, c.points[1],
            at);
    const Wide coupling_n =
        mass + p.normal_a.turn * q.normal_a.arm + p.normal_b.turn * q.normal_b.arm;
    const Wide coupling_t =
        mass + p.tangent_a.turn * q.tangent_a.arm + p.tangent_b.turn * q.tangent_b.arm;
    store(c.coupling_normal + at, both ? coupling_n : Wide{});
    store(c.coupling_tangent + at, both ? coupling_t : Wide{});
    const Wide impulse =
        load(c.points[0].normal_impulse + at) + load(c.points[1].normal_impulse + at);
    write_softness(*step.stiffness, impulse, a, b, c, at);
}

void prepare_contacts(const PrepareStep& step, std::span<const ContactLanes> from,
                      WideContact* to) {
    for (size_t i = 0; i < from.size(); ++i) {
        for (int at = 0; at < group_size; at += width) {
            if (to[i].a[at] == to[i].b[at]) {
                // Lanes are filled in order, so the rest is unused; the passes stop here, too.
                break;
            }
            prepare_lanes(step, from[i].manifolds + at, to[i], at);
        }
    }
}

/// Like `bounded` for one number: the results of a step are always finite, so they can be saved.
inline Wide bounded(Wide v, float limit) {
    const Wide below = v > splat(limit) ? splat(limit) : v;
    const Wide within = below < splat(-limit) ? splat(-limit) : below;
    return within == within ? within : Wide{};  // NOLINT: false where it is no number
}

/// Stores the impulses, and marks the contacts that push or are near.
void store_contacts(const WideContact* from, std::span<ContactLanes> to, float near) {
    for (size_t i = 0; i < to.size(); ++i) {
        ContactLanes& group = to[i];
        group.near = group.within_twice = 0;
        for (int at = 0; at < group_size; at += width) {
            if (from[i].a[at] == from[i].b[at]) break;
            Wide least = splat(1e30f);
            WideInt pushes = {};
            const WideInt count = as_int(gather4(part_of(group.manifolds + at, 0)).c);
            for (int k = 0; k < 2; ++k) {
                const auto state = part_of(group.manifolds + at,
                                           (k == 0 ? first_point : second_point) + point_state);
                Columns4 columns = gather4(state);
                const WideInt kept = count > k;
                const WidePoint& point = from[i].points[k];
                const Wide normal = bounded(load(point.normal_impulse + at), greatest_impulse);
                const Wide tangent = bounded(load(point.tangent_impulse + at), greatest_impulse);
                columns.b = kept ? normal : columns.b;
                columns.c = kept ? tangent : columns.c;
                scatter4(columns, state);
                pushes |= kept & (normal > Wide{});
                least = (kept & (columns.a < least)) ? columns.a : least;
            }
            group.near |= bits(pushes | (least <= splat(near))) << at;
            group.within_twice |= bits(pushes | (least <= splat(2.0f * near))) << at;
        }
    }
}

}  // namespace
}  // namespace fettle::physics::detail
