#pragma once

#include <collision/manifold.h>
#include <constraints/contact_constraint.h>
#include <constraints/stiffness.h>

#include <cstddef>
#include <span>
#include <vector>

// Contacts in groups of sixteen of one color: no two in a color share a body that moves, so the
// lanes do not know of each other. Structure of arrays; lanes left over have body 0 on both sides
// and no mass.

namespace fettle::physics::detail {

inline constexpr int lanes = 16;

struct alignas(64) WidePoint {
    float normal_lever_a[lanes], normal_lever_b[lanes];
    float tangent_lever_a[lanes], tangent_lever_b[lanes];
    float separation[lanes];
    float normal_mass[lanes], tangent_mass[lanes];
    float normal_impulse[lanes], tangent_impulse[lanes];
};

struct alignas(64) WideContact {
    uint32_t a[lanes], b[lanes];
    float normal_x[lanes], normal_y[lanes];
    float friction[lanes];
    float bias_rate[lanes], mass_scale[lanes], impulse_keep[lanes];  ///< softness
    float coupling_normal[lanes], coupling_tangent[lanes];
    WidePoint points[2];
};

/// Where the contacts of a group come from and go back to.
struct ContactLanes {
    Manifold* manifolds[lanes];
    Manifold spare;             ///< of lanes left over
    uint32_t touching = 0;      ///< before the step, a bit for each lane
    uint32_t tells_always = 0;  ///< whoever listens hears of it in every step
    // Of the step that was solved, a bit for each lane: an impulse flows, or the shapes are near
    // each other; the same within twice that distance.
    uint32_t near = 0, within_twice = 0;
};

/// What came of a group, a bit for each lane.
struct GroupNews {
    uint16_t told = 0;     ///< a touch begins or ends, or who listens hears of it always
    uint16_t touches = 0;  ///< now
};

/// Where a block of contacts is solved. Who solves one after the other uses the same memory again:
/// it stays in the cache.
struct WideBlock {
    std::vector<WideContact> contacts;
    std::vector<ContactLanes> lanes;
    std::size_t first = 0;  ///< of the groups of all blocks, the one that `contacts` begins with

    /// Groups `begin` to `end` are there; what they hold is of a block before.
    void make_groups(std::size_t begin, std::size_t end) {
        first = begin;
        if (contacts.size() < end - begin) contacts.resize(end - begin), lanes.resize(end - begin);
    }
    WideContact* contacts_of(std::size_t group) { return contacts.data() + (group - first); }
    ContactLanes* lanes_of(std::size_t group) { return lanes.data() + (group - first); }

    template <class Io, class Self>
    static void scratch(Io& io, Self& self) {
        io(self.contacts), io(self.lanes);
    }
};

struct PrepareStep {
    const SolverBody* bodies = nullptr;
    const ContactStiffness* stiffness = nullptr;
    float impulse_ratio = 1.0f;
};

struct WideStep {
    SolverBody* bodies = nullptr;
    WideContact* contacts = nullptr;
    std::size_t count = 0;
    float inverse_h = 0.0f;
    float push_speed = 0.0f;
};

}  // namespace fettle::physics::detail
