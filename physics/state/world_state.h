#pragma once

#include <broad_phase/pair_set.h>
#include <broad_phase/tree.h>
#include <fettle/physics/world.h>
#include <geometry/vertex_pool.h>
#include <joints/joint_types.h>
#include <partition/strips.h>
#include <state/member_list.h>
#include <state/records.h>

#include <array>
#include <vector>

namespace fettle::physics::detail {

// The state of a world: everything that a step needs from the step before it, and nothing else.
// Each struct lists its members once, in `members`; saving, restoring and the statistics of memory
// walk these lists, and a member that is not listed does not compile. A list is divided by what
// `World::memory` calls its lines.

/// Which elements of an array of objects are used: the free ones are a list through the array.
struct Slots {
    uint32_t free = none;  ///< the first free one
    uint32_t count = 0;    ///< how many are used
};

/// What there is, by slot.
struct ObjectState {
    std::vector<BodyRecord> bodies;
    std::vector<Island> islands;
    std::vector<ShapeRecord> shapes;
    std::vector<ShapeForm> forms;  ///< of the shapes
    VertexPool pool;
    std::vector<ContactRecord> contacts;
    std::vector<ContactLinks> contact_links;  ///< of the same
    std::vector<JointRecord> joints;
    JointLists joint_lists;
    std::vector<FieldRecord> fields;
    Slots body_slots, island_slots, shape_slots, contact_slots, joint_slots, field_slots;

    template <class Io, class Self>
    static void members(Io& io, Self& s) {
        list_members<ObjectState>(
            io, named("bodies", s.bodies, s.islands, s.body_slots, s.island_slots),
            named("shapes", s.shapes, s.forms, s.shape_slots), named("vertices", s.pool),
            named("contacts", s.contacts, s.contact_links, s.contact_slots),
            named("joints", s.joints, s.joint_lists, s.joint_slots),
            named("fields", s.fields, s.field_slots));
    }
};

/// Where the shapes are, and which pairs are near each other.
struct BroadPhaseState {
    std::vector<Box4> boxes;      ///< by shape slot, tight
    std::vector<Box4> fat_boxes;  ///< by shape slot, as they are in the tree
    /// The fat boxes as they were when pairs were last looked for: two that overlapped then are
    /// known. Empty after an edit that may have changed with whom the shape collides.
    std::vector<Box4> paired_boxes;
    Tree fixed_tree, moving_tree;
    PairSet pairs;
    std::vector<uint32_t> moved_shapes;  ///< those to look for new pairs of

    template <class Io, class Self>
    static void members(Io& io, Self& s) {
        list_members<BroadPhaseState>(io,
                                      named("bounding boxes", s.boxes, s.fat_boxes, s.paired_boxes),
                                      named("trees", s.fixed_tree, s.moving_tree),
                                      named("pairs", s.pairs), named("lists", s.moved_shapes));
    }
};

/// What the next step has to do with: slots.
struct ActiveLists {
    std::vector<uint32_t> awake_bodies;  ///< the solver's index is the place + 1
    std::vector<uint32_t> awake_contacts;
    std::array<std::vector<uint32_t>, joint_type_count> awake_joints;  ///< by type
    std::vector<uint32_t> edited_bodies, edited_shapes;                ///< to refresh

    template <class Io, class Self>
    static void members(Io& io, Self& s) {
        list_members<ActiveLists>(io, named("lists", s.awake_bodies, s.awake_contacts,
                                            s.awake_joints, s.edited_bodies, s.edited_shapes));
    }
};

struct WorldState : Columns, ObjectState, BroadPhaseState, ActiveLists {
    WorldDef settings;
    Strips strips;              ///< where the last step cut the world
    float last_substep = 0.0f;  ///< s; warm-start impulses are scaled by the ratio
    uint64_t steps = 0;
    uint32_t sleep_candidates = 0;  ///< bodies that rested long enough, as of the last step
    Events events;                  ///< of the last step
    Events pending;                 ///< made by edits since
    StepStatistics statistics;

    template <class Io, class Self>
    static void members(Io& io, Self& s) {
        list_members<WorldState, Columns>(
            io,
            named("", s.settings, s.strips, s.last_substep, s.steps, s.sleep_candidates,
                  s.statistics),
            named("bodies", s.states, s.previous, s.body_generations),
            named("shapes", s.shape_generations), named("joints", s.joint_generations),
            named("", part<ObjectState>(s), part<BroadPhaseState>(s), part<ActiveLists>(s)),
            named("events", s.events, s.pending));
    }
};

}  // namespace fettle::physics::detail
