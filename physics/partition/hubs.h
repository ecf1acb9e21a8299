#pragma once

#include <constraints/solver_body.h>
#include <partition/solver_end.h>

#include <array>
#include <span>
#include <vector>

// A hub is a body with many contacts with much lighter bodies (a drum, a raft, a rotor). Without
// special treatment, all these contacts would be solved one after the other. So the hub gets copies
// that share its mass and inertia evenly, and each contact acts on one copy; after every pass the
// copies are averaged (mass splitting: R. Tonge, F. Benevolenski, A. Voroshilov, "Mass Splitting
// for Jitter-Free Parallel Rigid Body Simulation", 2012). Impulses count in full. A contact acts on
// a part of the mass only, which makes no difference while that part is far heavier than the other
// body.
//
// Each strip has its own copies, so its contacts with the hub are contacts inside the strip.
// Contacts with bodies that are not much lighter act on the hub itself, at the root.

namespace fettle::physics::detail {

class Hubs {
  public:
    /// A body with fewer contacts is not a hub.
    static constexpr uint32_t least_contacts = 32;
    static constexpr std::size_t most = 8;

    void begin(uint32_t strips);
    bool empty() const { return hubs_.empty(); }
    bool full() const { return hubs_.size() == most; }
    /// True if a copy of a hub with this inverse mass at its rim is at least 8 times heavier than a
    /// body with the other inverse mass.
    bool outweighs(float inverse_mass_at_rim, float inverse_mass) const {
        return inverse_mass >= much_lighter * parts() * inverse_mass_at_rim;
    }
    /// Appends the copies to the bodies.
    void add(uint32_t body, float inverse_mass_at_rim, std::vector<SolverBody>& bodies);

    /// Called before a contact with a hub is colored: chooses its node, and whether it acts on a
    /// copy. A contact that may bounce acts on the hub itself.
    void choose_node(ActingContact& contact, std::span<const SolverBody> bodies) const;
    /// Called when the contact is colored: chooses the copies in turn.
    void choose_copy(ActingContact& contact);
    /// Called for a contact that is solved one at a time: it acts on the hub itself.
    void use_hub_itself(ActingContact& contact) const;

    /// Called before a pass over these strips: writes the copies.
    void write_copies(const StripNodes& nodes, std::span<SolverBody> bodies) const;
    /// Called after the pass over all strips: averages the copies.
    void average_copies(std::span<SolverBody> bodies) const;

    /// All data are scratch: built in every step.
    static void scratch(auto& io, auto& self) { io(self.hubs_); }

  private:
    struct Hub {
        uint32_t body, first_copy;
        float inverse_mass_at_rim;
        std::array<uint32_t, most_strips> used;  ///< running count of used copies, by strip
    };
    /// Copies in a strip. Contacts that are solved at the same time act on different copies.
    static constexpr uint32_t copies = 8;
    static constexpr float much_lighter = 8.0f;

    float parts() const { return float(copies * strips_); }
    uint32_t leaf_of(uint32_t node) const { return node - strips_; }
    /// Index of the saved hub as it was before the pass; the copies follow it.
    uint32_t first_of(const Hub& hub, uint32_t leaf) const {
        return hub.first_copy + leaf * (copies + 1);
    }
    uint8_t hub_of(SolverEnd end) const;

    std::vector<Hub> hubs_;
    uint32_t strips_ = 1;
};

}  // namespace fettle::physics::detail
