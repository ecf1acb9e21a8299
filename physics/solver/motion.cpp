#include <solver/motion.h>
#include <state/limits.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace fettle::physics::detail {
namespace {

/// Four floats at once, on every processor: velocity, angular velocity and inverse mass, or shift,
/// rotation and inverse inertia.
using Quad = float __attribute__((vector_size(16)));

template <typename From>
Quad load(const From* from) {
    Quad v;
    std::memcpy(&v, from, sizeof v);
    return v;
}
template <typename To>
void store(To* to, Quad v) {
    std::memcpy(static_cast<void*>(to), &v, sizeof v);
}

/// Shortens the velocity to `most`, and keeps its direction.
Quad limited_speed(Quad v, float most) {
    const float speed2 = v[0] * v[0] + v[1] * v[1];
    if (!(speed2 > most * most)) return v;
    const float share = most / std::sqrt(speed2);
    v[0] *= share;
    v[1] *= share;
    return v;
}

/// `slow`: the speed is limited to `most`, which is less than the two first members of `limit`.
template <bool again, bool slow>
void integrate(std::span<const uint32_t> which, std::span<SolverBody> bodies,
               std::span<SolverForce> forces, Quad limit, float most) {
    for (const uint32_t i : which) {
        SolverBody& b = bodies[i];
        SolverForce& f = forces[i];
        const Quad old = load(&b.velocity);
        Quad v = (old + load(&f.change)) * load(&f.keep);
        v = v < -limit ? -limit : v;
        v = v > limit ? limit : v;
        if constexpr (slow) v = limited_speed(v, most);
        if constexpr (again) {
            const Quad given = old - load(&f.before);
            store(&f.before, v);
            v += given;
            v[3] = old[3];
            if constexpr (slow) v = limited_speed(v, most);
        } else {
            store(&f.before, v);
        }
        store(&b.velocity, v);
    }
}

}  // namespace

void integrate_velocities(std::span<const uint32_t> which, std::span<SolverBody> bodies,
                          std::span<SolverForce> forces, const SubstepLimits& limits, bool again) {
    const Quad limit = {greatest_speed, greatest_speed, limits.turn,
                        std::numeric_limits<float>::infinity()};
    const auto with = [&]<bool slow>() {
        if (again)
            integrate<true, slow>(which, bodies, forces, limit, limits.speed);
        else
            integrate<false, slow>(which, bodies, forces, limit, limits.speed);
    };
    if (limits.speed < greatest_speed)
        with.template operator()<true>();
    else
        with.template operator()<false>();
}

void integrate_positions(std::span<const uint32_t> which, std::span<SolverBody> bodies, float h) {
    for (const uint32_t i : which) {
        SolverBody& b = bodies[i];
        const Quad moved = Quad{h, h, h, 0.0f} * load(&b.velocity) + load(&b.shift);
        store(&b.shift, moved);
    }
}

}  // namespace fettle::physics::detail
