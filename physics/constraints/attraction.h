#pragma once

#include <constraints/solver_body.h>
#include <fettle/physics/field.h>
#include <geometry/vector.h>

#include <cstdint>
#include <span>
#include <vector>

// The pull of attractors, which each sub-step computes for the place of the body. An orbit is as
// exact as that of a symplectic Euler method with the length of a sub-step.

namespace fettle::physics::detail {

/// The acceleration at a place, m/s².
inline Vec2 pull_of(const AttractorField& attractor, const Position& place) {
    const Vec2 d = attractor.center - place;
    const float far = max(length(d), attractor.core);
    float acceleration = attractor.strength;
    for (int i = 0; i < attractor.falloff; ++i) acceleration /= far;
    // Within the core it decreases linearly to 0.
    return (acceleration / max(far, 1e-6f)) * d;
}

/// A body that attractors pull, in one step.
struct AttractedBody {
    Position center;            ///< center of mass at the start of the step
    Vec2 moves = {1.0f, 1.0f};  ///< 0: locked along this axis
    /// Changes of velocity in a sub-step, m/s: the one that the forces of the step contain, the one
    /// that they contain now, and the sum of the differences.
    Vec2 usual, now, difference;
    uint32_t begin = 0, end = 0;  ///< its attractors
};

struct Attractions {
    std::vector<uint32_t> of_body;  ///< by body of the solver: 1 + place in `bodies`; 0: none
    std::vector<AttractedBody> bodies;
    std::vector<AttractorField> attractors;

    static void scratch(auto& io, auto& s) {
        io(s.of_body);
        io(s.bodies);
        io(s.attractors);
    }

    bool empty() const { return bodies.empty(); }
    void clear() {
        of_body.clear();
        bodies.clear();
        attractors.clear();
    }
    /// The body of the solver with this index, if attractors pull it.
    AttractedBody* find(uint32_t index) {
        const uint32_t place = index < of_body.size() ? of_body[index] : 0;
        return place != 0 ? &bodies[place - 1] : nullptr;
    }

    /// The change of velocity in a sub-step at a place.
    Vec2 change_at(const AttractedBody& body, const Position& place, float h, float most) const {
        Vec2 sum;
        for (uint32_t i = body.begin; i < body.end; ++i) sum = sum + pull_of(attractors[i], place);
        const Vec2 change = bounded(h * sum, most);
        return {body.moves.x * change.x, body.moves.y * change.y};
    }

    /// Called before a sub-step of length `h`: sets the forces on the bodies listed in `which`.
    void follow(std::span<const uint32_t> which, std::span<const SolverBody> states,
                std::span<SolverForce> forces, float h, float most) {
        for (const uint32_t i : which) {
            AttractedBody* const body = find(i);
            if (body == nullptr) continue;
            const Vec2 here = change_at(*body, body->center + states[i].shift, h, most);
            forces[i].change = forces[i].change + (here - body->now);
            body->now = here;
            body->difference = body->difference + (here - body->usual);
        }
    }

    /// Called after the last sub-step: later stages get the mean forces of the step.
    void finish(std::span<SolverForce> forces, int substeps) {
        if (empty()) return;
        for (uint32_t i = 0; i < of_body.size(); ++i) {
            AttractedBody* const body = find(i);
            if (body == nullptr) continue;
            const Vec2 mean = body->usual + (1.0f / float(substeps)) * body->difference;
            forces[i].change = forces[i].change + (mean - body->now);
            body->now = mean;
        }
    }
};

}  // namespace fettle::physics::detail
