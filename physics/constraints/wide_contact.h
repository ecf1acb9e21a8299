#pragma once

#include <collision/manifold.h>
#include <constraints/contact_constraint.h>
#include <constraints/stiffness.h>

#include <cstddef>
#include <span>
#include <vector>

// Contacts in groups of sixteen of one color. No two contacts of a color share a moving body, so
// the lanes are independent. The data are a structure of arrays. Unused lanes have body 0 on both
// sides and no mass.

namespace fettle::physics::detail {

/// Contacts of a group, one for each lane.
inline constexpr int group_size = 16;

struct alignas(64) WidePoint {
    float normal_lever_a[group_size], normal_lever_b[group_size];
    float tangent_lever_a[group_size], tangent_lever_b[group_size];
    float separation[group_size];
    float normal_mass[group_size], tangent_mass[group_size];
    float normal_impulse[group_size], tangent_impulse[group_size];
};

struct alignas(64) WideContact {
    uint32_t a[group_size], b[group_size];
    float normal_x[group_size], normal_y[group_size];
    float friction[group_size];
    float bias_rate[group_size], mass_scale[group_size], impulse_keep[group_size];  ///< softness
    float coupling_normal[group_size], coupling_tangent[group_size];
    WidePoint points[2];
};

/// The manifolds of a group, for reading and writing back.
struct ContactLanes {
    Manifold* manifolds[group_size];
    Manifold spare;               ///< for unused lanes
    uint32_t touching = 0;        ///< before the step, one bit for each lane
    uint32_t reports_always = 0;  ///< contacts that are reported in every step, one bit each
    // After the step, one bit for each lane. `near`: there is an impulse, or the shapes are near
    // each other. `within_twice`: the same with twice that distance.
    uint32_t near = 0, within_twice = 0;
};

/// The result of a group, one bit for each lane.
struct GroupResult {
    uint16_t reported = 0;  ///< a touch begins or ends, or the contact is reported in every step
    uint16_t touches = 0;   ///< touching now
};

/// Memory for solving a block of contacts. A thread uses it for one block after the other, so that
/// it stays in the cache.
struct WideBlock {
    std::vector<WideContact> contacts;
    std::vector<ContactLanes> lanes;
    /// The contacts that pushed in some sub-step, one bit for each lane. An impact that nothing
    /// presses on is over before the step is.
    std::vector<uint32_t> pushed;
    /// The contacts at which the last relax pass changed a velocity much, one bit for each lane.
    std::vector<uint32_t> unsettled;
    std::size_t first = 0;  ///< index of the first group in `contacts`, counted over all blocks

    /// Makes room for groups `begin` to `end`; they still have the data of an earlier block.
    void make_groups(std::size_t begin, std::size_t end) {
        first = begin;
        if (contacts.size() < end - begin) contacts.resize(end - begin), lanes.resize(end - begin);
        pushed.assign(end - begin, 0);
        unsettled.assign(end - begin, 0);
    }
    WideContact* contacts_of(std::size_t group) { return contacts.data() + (group - first); }
    ContactLanes* lanes_of(std::size_t group) { return lanes.data() + (group - first); }
    uint32_t* pushed_of(std::size_t group) { return pushed.data() + (group - first); }
    uint32_t* unsettled_of(std::size_t group) { return unsettled.data() + (group - first); }

    static void scratch(auto& io, auto& self) {
        io(self.contacts), io(self.lanes), io(self.pushed), io(self.unsettled);
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
    uint32_t* pushed = nullptr;     ///< of each group: `WideBlock::pushed`
    uint32_t* unsettled = nullptr;  ///< of each group: `WideBlock::unsettled`
    std::size_t count = 0;
    float inverse_h = 0.0f;
    float push_speed = 0.0f;  ///< of the world, m/s
};

}  // namespace fettle::physics::detail
