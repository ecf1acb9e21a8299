#pragma once

#include <solver/constraint.h>
#include <solver/strips.h>

#include <span>
#include <vector>

// What moves bodies besides constraints, and what contacts give them again in every sub-step.
//
// Each sub-step begins with the impulses that the last one found (warm start). Contacts keep their
// normals and lever arms during a step, so what their impulses do to the velocity of a body is just
// what they did to it in the sub-step before, all passes together: its velocity at the end less
// that before the warm start. So only the first sub-step of a step warm starts contact by contact.

namespace fettle::physics::detail {

/// What gravity, forces and damping do to a body in one sub-step: v ← (v + change) · keep.
struct alignas(16) SolverForce {
    V2 change;
    float turn_change = 0.0f;
    float no_change = 0.0f;  ///< of the inverse mass, which shares a vector with the velocities
    V2 keep = {1.0f, 1.0f};
    float turn_keep = 1.0f;
    float keep_all = 1.0f;
    /// Velocity before the contacts' warm start, of which joints are a part.
    V2 before;
    float turn_before = 0.0f;
    float unused = 0.0f;
};

struct SubstepLimits {
    float speed = 0.0f;  ///< m/s
    float turn = 0.0f;   ///< rad/s
};

/// Of the bodies listed in `which`. `again`: contacts give each what they gave it in the last
/// sub-step.
void integrate_velocities(std::span<const uint32_t> which, std::span<SolverBody> bodies,
                          std::span<SolverForce> forces, const SubstepLimits& limits, bool again);
void integrate_positions(std::span<const uint32_t> which, std::span<SolverBody> bodies, float h);

/// Keeps what joints do to bodies apart from what contacts do, for the joints of some nodes at a
/// time.
class JointShare {
  public:
    void clear() { bodies_.clear(); }
    /// A body that a joint of that node acts on; again and again, if need be.
    void add(uint32_t node, uint32_t body) { bodies_.push_back(uint64_t{node} << 32 | body); }
    void unite();

    /// Runs a pass over the joints of these nodes.
    template <typename Pass>
    void around(const StripNodes& nodes, std::span<const SolverBody> bodies,
                std::span<SolverForce> forces, Pass&& pass) {
        remember(nodes, bodies);
        pass();
        add_change(nodes, bodies, forces);
    }

    /// All of it is made anew in every step.
    template <class Io, class Self>
    static void scratch(Io& io, Self& self) {
        io(self.bodies_), io(self.velocities_);
    }

  private:
    struct Velocity {
        V2 linear;
        float angular = 0.0f;
    };
    void remember(const StripNodes& nodes, std::span<const SolverBody> bodies);
    void add_change(const StripNodes& nodes, std::span<const SolverBody> bodies,
                    std::span<SolverForce> forces) const;

    std::vector<uint64_t> bodies_;  // node << 32 | body
    std::vector<Velocity> velocities_;
    NodeRanges nodes_;
};

}  // namespace fettle::physics::detail
