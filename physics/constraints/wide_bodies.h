// The solver bodies of a group in vectors. Compiled for one instruction set, like simd/vector.h.
#pragma once

#include <constraints/solver_body.h>
#include <simd/vector.h>

namespace fettle::physics::detail {
namespace {

/// The solver bodies of all lanes, one vector for each component.
struct Bodies {
    Wide vx, vy, w, mass, dx, dy, turn, inertia;
};

inline Bodies gather(const SolverBody* bodies, const uint32_t* index) {
    const auto low = [=](int lane) { return reinterpret_cast<const char*>(bodies + index[lane]); };
    const auto high = [=](int lane) { return low(lane) + sizeof(Quad); };
    const Columns4 v = gather4(low), d = gather4(high);
    return {v.a, v.b, v.c, v.d, d.a, d.b, d.c, d.d};
}

/// Writes the velocities back, which are the first half of each body, with its unchanged inverse
/// mass. A body that no impulse moves is not written, because it may be in several lanes, and other
/// threads may read it.
inline void scatter(SolverBody* bodies, const uint32_t* index, const Bodies& b) {
    if (const uint32_t still = bits((b.mass == Wide{}) & (b.inertia == Wide{})); still != 0) {
        SolverBody spare;
        scatter4({b.vx, b.vy, b.w, b.mass}, [&](int lane) -> void* {
            return (still >> lane & 1) != 0 ? &spare : bodies + index[lane];
        });
        return;
    }
    scatter4({b.vx, b.vy, b.w, b.mass},
             [=](int lane) { return static_cast<void*>(bodies + index[lane]); });
}

}  // namespace
}  // namespace fettle::physics::detail
