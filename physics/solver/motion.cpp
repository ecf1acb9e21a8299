#include <solver/motion.h>

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

template <bool again>
void integrate(std::span<const uint32_t> which, std::span<SolverBody> bodies,
               std::span<SolverForce> forces, Quad limit) {
    for (const uint32_t i : which) {
        SolverBody& b = bodies[i];
        SolverForce& f = forces[i];
        const Quad old = load(&b.velocity);
        Quad v = (old + load(&f.change)) * load(&f.keep);
        v = v < -limit ? -limit : v;
        v = v > limit ? limit : v;
        if constexpr (again) {
            const Quad given = old - load(&f.before);
            store(&f.before, v);
            v += given;
            v[3] = old[3];
        } else {
            store(&f.before, v);
        }
        store(&b.velocity, v);
    }
}

}  // namespace

void integrate_velocities(std::span<const uint32_t> which, std::span<SolverBody> bodies,
                          std::span<SolverForce> forces, const SubstepLimits& limits, bool again) {
    const Quad limit = {limits.speed, limits.speed, limits.turn,
                        std::numeric_limits<float>::infinity()};
    if (again)
        integrate<true>(which, bodies, forces, limit);
    else
        integrate<false>(which, bodies, forces, limit);
}

void integrate_positions(std::span<const uint32_t> which, std::span<SolverBody> bodies, float h) {
    for (const uint32_t i : which) {
        SolverBody& b = bodies[i];
        const Quad moved = Quad{h, h, h, 0.0f} * load(&b.velocity) + load(&b.shift);
        store(&b.shift, moved);
    }
}

}  // namespace fettle::physics::detail
