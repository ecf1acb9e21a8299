#pragma once

#include <broad_phase/tree.h>
#include <constraints/attraction.h>
#include <constraints/contact_constraint.h>
#include <constraints/rolling_contact.h>
#include <constraints/wide_contact.h>
#include <fettle/physics/events.h>
#include <partition/blocks.h>
#include <partition/hubs.h>
#include <partition/joint_share.h>
#include <partition/solver_end.h>
#include <partition/strips.h>
#include <partition/unsettled_contacts.h>
#include <state/member_list.h>
#include <state/stage_results.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fettle::physics::detail {

// Data that every step builds again, stage by stage. They are kept between steps only for their
// capacity, and freed when most bodies have fallen asleep (memory.cpp). `scratch` lists the
// members, as `members` does for the state.

#define FETTLE_SCRATCH(Part, ...)                           \
    static void scratch(auto& io, auto& s) {                \
        list_members<Part>(io, named("step", __VA_ARGS__)); \
    }

/// Scratch data of the search for pairs and of the narrow phase.
struct PairScratch {
    std::vector<uint8_t> relocated;                  ///< by shape: its fat box has changed
    std::vector<uint64_t> new_pairs;                 ///< upper << 32 | lower
    std::vector<uint64_t> spare_pairs;               ///< memory for sorting them
    std::vector<std::vector<uint64_t>> found_pairs;  ///< by piece
    std::vector<uint32_t> finds;                     ///< by shape: new pairs that it decides about
    std::vector<uint32_t> crowded;                   ///< crowded shapes that moved
    std::vector<uint8_t> still_crowded;              ///< of these shapes
    std::vector<Tree::NodePair> parts_of_walk;
    std::vector<CollidedPiece> collided;
    std::vector<ContactRecord> parted;  ///< last touches of parts of outlines that ended
    /// Contacts whose bodies are pressed into each other (contacts/overlaps/wedged_bodies.h); after
    /// the solver, those in which joints have priority.
    std::vector<uint32_t> pressed;

    FETTLE_SCRATCH(PairScratch, s.relocated, s.new_pairs, s.spare_pairs, s.found_pairs, s.finds,
                   s.crowded, s.still_crowded, s.parts_of_walk, s.collided, s.parted, s.pressed)
};

/// The bodies of the solver. Their index is the index in the list of awake bodies plus 1; 0 is the
/// fixed body.
struct BodyScratch {
    std::vector<SolverBody> solver_bodies;
    /// By body slot. Compact, because every contact reads it, unlike the records. Between steps all
    /// are fixed, so that a step writes only those of the awake bodies.
    std::vector<SolverEnd> solver_ends;
    std::vector<SolverForce> solver_forces;
    std::vector<uint8_t> gathered;        ///< results of the pieces of the list of awake bodies
    std::vector<uint32_t> locked;         ///< bodies with a locked axis or a maximum speed
    std::vector<uint32_t> maybe_crowded;  ///< slots of bodies that many joints may crowd
    /// Slots of bodies whose speed was limited: their stored impulses are too large.
    std::vector<uint32_t> limited;
    /// Slots of bodies in whose group this step may create no energy: solver/strained_groups.cpp.
    std::vector<uint32_t> strained;
    std::vector<uint8_t> bounced;            ///< by body: the last pass of impacts that changed it
    std::vector<FirstImpact> first_impacts;  ///< by body
    Attractions attractions;                 ///< of the bodies that attractors pull
    bool axes_locked = false;                ///< some awake body is locked along x or y
    bool driven = false;                     ///< some awake body is kinematic

    FETTLE_SCRATCH(BodyScratch, s.solver_bodies, s.solver_ends, s.solver_forces, s.gathered,
                   s.locked, s.maybe_crowded, s.limited, s.strained, s.bounced, s.first_impacts,
                   s.attractions, s.axes_locked, s.driven)
};

/// The acting joints of one type in a step, in the order of their nodes.
struct JointArray {
    std::vector<uint32_t> joints;  ///< slots
    NodeRanges nodes;
    std::vector<std::byte> constraints;  ///< of the same joints, as their type defines them
    std::vector<uint8_t> drives;         ///< 1: the motor of the joint moves its bodies
    std::vector<uint8_t> open;           ///< 1: its two points are apart, and stay so
    std::vector<Softness> softness;      ///< of each joint, if they are tuned one by one
    std::vector<float> shares;           ///< of each joint: `JointEnds::share`; empty: all are 1

    template <class Constraint>
    Constraint* as() {
        static_assert(alignof(Constraint) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);
        return std::launder(reinterpret_cast<Constraint*>(constraints.data()));
    }
    template <class Constraint>
    const Constraint* as() const {
        return const_cast<JointArray*>(this)->as<Constraint>();
    }

    FETTLE_SCRATCH(JointArray, s.joints, s.nodes, s.constraints, s.drives, s.open, s.softness,
                   s.shares)
};

struct JointScratch {
    JointShare joint_share;
    /// Joints connected with each other bear usual, heavy or very heavy loads.
    static constexpr size_t loads = 3;
    /// Behind them: the joints with a stiffness of their own.
    static constexpr size_t tuned = loads;
    /// The joints of bodies that have many: solver/joints/crowded_joints.h.
    static constexpr size_t crowded = tuned + 1;
    static constexpr size_t classes = crowded + 1;
    std::array<JointArray, classes * joint_type_count> joint_arrays;  ///< by class, then by type
    std::array<size_t, classes> acting_in_class = {};  ///< how many joints each class has
    std::vector<uint8_t> joint_codes;                  ///< of the awake joints, type by type
    std::vector<Strain> strains;

    static JointType type_of(size_t array) { return JointType(array % joint_type_count); }
    size_t acting_joints() const {
        size_t count = 0;
        for (const size_t acting : acting_in_class) count += acting;
        return count;
    }

    FETTLE_SCRATCH(JointScratch, s.joint_share, s.joint_arrays, s.acting_in_class, s.joint_codes,
                   s.strains)
};

/// Acting contacts that are computed one at a time.
struct SingleContacts {
    /// Indices in the list of acting contacts, in the order of the nodes.
    std::vector<uint32_t> acting;
    std::vector<ContactConstraint> constraints;  ///< of the same contacts
    std::vector<ContactExtra> extras;
    std::vector<RollingContact> rolling_contacts;
    NodeRanges nodes;
    std::vector<uint8_t> flags;    ///< of the same contacts: solver/contacts/serial_contacts.cpp
    std::vector<Relaxed> relaxed;  ///< of the same contacts: in the last relax pass

    FETTLE_SCRATCH(SingleContacts, s.acting, s.constraints, s.extras, s.rolling_contacts, s.nodes,
                   s.flags, s.relaxed)
};

/// The serial contacts of bodies whose joints bear a heavy load.
struct LoadedContacts {
    /// Indices in the list of serial contacts, in the order of the nodes.
    std::vector<uint32_t> serial;
    NodeRanges nodes;

    std::span<const uint32_t> of(const StripNodes& range) const {
        return std::span(serial).subspan(nodes.begin(range), nodes.end(range) - nodes.begin(range));
    }

    FETTLE_SCRATCH(LoadedContacts, s.serial, s.nodes)
};

/// The acting contacts: those in lanes, and the serial contacts, which are solved one at a time.
struct ContactScratch {
    std::vector<ActingContact> acting;
    std::vector<ActingPiece> acting_pieces;
    size_t colored_count = 0;             ///< acting contacts in groups
    std::vector<uint32_t> lane_contacts;  ///< by lane: index of the acting contact
    std::vector<uint32_t> spare_lanes;
    std::vector<GroupResult> group_results;  ///< of each group
    std::vector<uint64_t> reported;  ///< one bit for each acting contact: true if it is reported
    std::vector<std::vector<ContactHitEvent>> hits;  ///< by piece
    /// By solver body: 0 if it has no acting joint, otherwise 1 + the load of its joints. Empty if
    /// there is no acting joint or no awake contact.
    std::vector<uint8_t> jointed;
    SingleContacts serial;
    SingleContacts passing;  ///< contacts in lanes that may pass an impact on
    std::array<LoadedContacts, JointScratch::loads> loaded;  ///< by load; the first one is empty

    FETTLE_SCRATCH(ContactScratch, s.acting, s.acting_pieces, s.colored_count, s.lane_contacts,
                   s.spare_lanes, s.group_results, s.reported, s.hits, s.jointed, s.serial,
                   s.passing, s.loaded)
};

/// The wide contacts of rows of unsettled ones, as constraints that are solved one at a time.
struct UnsettledScratch {
    UnsettledContacts contacts;
    std::vector<uint32_t> lanes;                 ///< group · `group_size` + lane, in this order
    std::vector<ContactConstraint> constraints;  ///< of these lanes
    std::vector<Relaxed> relaxed;                ///< of these constraints

    FETTLE_SCRATCH(UnsettledScratch, s.contacts, s.lanes, s.constraints, s.relaxed)
};

/// Groups of constraints that are solved together, and their order.
struct ScheduleScratch {
    SolverBlocks blocks;
    Hubs hubs;
    Reordering reordering;                  ///< for sorting a list into the order of the strips
    Sections whole_sections, cut_sections;  ///< for one thread; shared by several
    std::vector<uint32_t> color_begin;      ///< first lanes, by counting thread, section and color
    std::vector<uint32_t> first_groups;     ///< by section of each block, and the end
    std::vector<std::vector<uint32_t>> out_of_colors;  ///< by section: acting contacts
    std::vector<uint64_t> colors_of_body;              ///< by solver index, one bit for each color
    std::vector<WideBlock> wide_blocks;  ///< one for each block that is solved at the same time
    std::vector<UnsettledScratch> unsettled;  ///< of each of them

    const Sections& sections_of(const SolverBlock& block) const {
        return block.cut ? cut_sections : whole_sections;
    }

    FETTLE_SCRATCH(ScheduleScratch, s.blocks, s.hubs, s.reordering, s.whole_sections,
                   s.cut_sections, s.color_begin, s.first_groups, s.out_of_colors, s.colors_of_body,
                   s.wide_blocks, s.unsettled)
};

struct FinishScratch {
    std::vector<FinishedPiece> finished;
    std::vector<FastBody> fast_bodies;
    std::vector<DrivenBody> driven_bodies;         ///< those that are awake
    std::vector<Box4> driven_boxes;                ///< of their shapes, on their way
    std::vector<uint32_t> mover_of;                ///< by body: its index in a search for impacts
    std::vector<std::vector<Crossing>> crossings;  ///< of sensors, by piece

    FETTLE_SCRATCH(FinishScratch, s.finished, s.fast_bodies, s.driven_bodies, s.driven_boxes,
                   s.mover_of, s.crossings)
};

struct StepScratch : PairScratch,
                     BodyScratch,
                     JointScratch,
                     ContactScratch,
                     ScheduleScratch,
                     FinishScratch {
    FETTLE_SCRATCH(StepScratch, part<PairScratch>(s), part<BodyScratch>(s), part<JointScratch>(s),
                   part<ContactScratch>(s), part<ScheduleScratch>(s), part<FinishScratch>(s))
};

}  // namespace fettle::physics::detail
