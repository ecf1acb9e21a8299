#pragma once

#include <constraints/solver_body.h>
#include <partition/strips.h>

#include <span>
#include <vector>

namespace fettle::physics::detail {

/// Separates the change of velocity caused by joints from that caused by contacts, for the joints
/// of some nodes at a time.
class JointShare {
  public:
    void clear() { bodies_.clear(); }
    /// Adds a body that a joint of that node acts on; a body may be added several times.
    void add(uint32_t node, uint32_t body) { bodies_.push_back(uint64_t{node} << 32 | body); }
    /// Must be called after the last `add`: sorts the bodies and removes duplicates.
    void unite();

    /// Runs `pass`, which solves the joints of these nodes, and adds the changes of velocity that
    /// it causes to `forces`.
    void around(const StripNodes& nodes, std::span<const SolverBody> bodies,
                std::span<SolverForce> forces, auto&& pass) {
        save_velocities(nodes, bodies);
        pass();
        add_change(nodes, bodies, forces);
    }

    /// All data are scratch: built in every step.
    static void scratch(auto& io, auto& self) { io(self.bodies_), io(self.velocities_); }

  private:
    struct Velocity {
        Vec2 linear;
        float angular = 0.0f;
    };
    void save_velocities(const StripNodes& nodes, std::span<const SolverBody> bodies);
    void add_change(const StripNodes& nodes, std::span<const SolverBody> bodies,
                    std::span<SolverForce> forces) const;

    std::vector<uint64_t> bodies_;  // node << 32 | body
    std::vector<Velocity> velocities_;
    NodeRanges nodes_;
};

}  // namespace fettle::physics::detail
