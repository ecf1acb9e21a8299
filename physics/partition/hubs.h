#pragma once

#include <constraints/solver_body.h>
#include <partition/acting.h>

#include <array>
#include <span>
#include <vector>

// A body that many much lighter ones touch (a drum, a raft, a rotor) would have all its contacts
// wait for each other. It gets copies, among which its mass and inertia are shared out evenly, and
// those contacts act on a copy each; after every pass what befell the copies is the hub's, and they
// are all alike again (mass splitting: R. Tonge, F. Benevolenski, A. Voroshilov, "Mass Splitting
// for Jitter-Free Parallel Rigid Body Simulation", 2012). Impulses count in full. That a contact
// meets a part of the mass only is of no account as long as the part is still far heavier than
// what lies on it.
//
// Each strip has copies of its own: its contacts with the hub then are like any others in it. What
// is not much lighter meets the hub itself, at the root.

namespace fettle::physics::detail {

class Hubs {
  public:
    /// Contacts of a body from which on it may be one.
    static constexpr uint32_t least_contacts = 32;
    static constexpr std::size_t most = 8;

    void begin(uint32_t strips);
    bool empty() const { return hubs_.empty(); }
    bool full() const { return hubs_.size() == most; }
    /// With so much inverse mass at its rim, the body is still heavy for others of so much.
    bool would_bear(float inverse_mass_at_rim, float inverse_mass) const {
        return inverse_mass >= much_lighter * parts() * inverse_mass_at_rim;
    }
    /// Appends the copies to the bodies.
    void add(uint32_t body, float inverse_mass_at_rim, std::vector<SolverBody>& bodies);

    /// Of a contact with a hub, before it is colored: at which node, and whether with a copy.
    void settle(ActingContact& contact, std::span<const SolverBody> bodies) const;
    /// With which copy, in turn. By who colors its node.
    void choose_copy(ActingContact& contact);
    /// With none: it is solved one at a time.
    void give_up_copy(ActingContact& contact) const;

    /// Before a pass over these strips.
    void hand_out(const StripNodes& nodes, std::span<SolverBody> bodies) const;
    /// When all strips have had their pass.
    void take_back(std::span<SolverBody> bodies) const;

    /// All of it is made anew in every step.
    template <class Io, class Self>
    static void scratch(Io& io, Self& self) {
        io(self.hubs_);
    }

  private:
    struct Hub {
        uint32_t body, first_copy;
        float inverse_mass_at_rim;
        std::array<uint32_t, most_strips> used;  ///< copies, by strip; again and again
    };
    /// Of a strip; contacts that are solved at a time have one each.
    static constexpr uint32_t copies = 8;
    static constexpr float much_lighter = 8.0f;

    float parts() const { return float(copies * strips_); }
    uint32_t leaf_of(uint32_t node) const { return node - strips_; }
    /// What is handed out, unchanged, and the copies after it.
    uint32_t first_of(const Hub& hub, uint32_t leaf) const {
        return hub.first_copy + leaf * (copies + 1);
    }
    uint8_t hub_of(SolverEnd end) const;

    std::vector<Hub> hubs_;
    uint32_t strips_ = 1;
};

}  // namespace fettle::physics::detail
