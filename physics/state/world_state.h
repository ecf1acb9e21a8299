#pragma once

#include <broad_phase/pair_set.h>
#include <broad_phase/tree.h>
#include <constraints/solver_body.h>
#include <fettle/physics/world.h>
#include <geometry/make_room.h>
#include <geometry/vertex_pool.h>
#include <partition/strips.h>
#include <state/member_list.h>
#include <state/records.h>

#include <array>
#include <span>
#include <vector>

namespace fettle::physics::detail {

// The state of a world: all data that a step needs from the previous step, and nothing else. Each
// struct lists its members once, in `members`. Saving, restoring and the statistics of memory use
// these lists, and omitting a member is a compile error. `NamedMembers` divides a list into the
// lines of `World::memory`.

/// The used elements of an array of objects. The free ones are linked in a list through the array.
struct Slots {
    uint32_t free = none;  ///< the first free slot
    uint32_t count = 0;    ///< number of slots in use

    /// Allocates a slot for a new object; its elements in all arrays get initial values. Throws
    /// std::bad_alloc if there is no memory for them; then nothing has changed.
    template <class Record, class... Other>
    uint32_t allocate(std::vector<Record>& records, std::vector<Other>&... others) {
        const uint32_t slot = free;
        if (slot == none) {
            make_room_in_each(records, others...);
            (records.emplace_back(), ..., others.emplace_back());
            ++count;
            return uint32_t(records.size() - 1);
        }
        ++count;
        free = records[slot].next_free();
        records[slot] = Record();
        ((others[slot] = Other()), ...);
        return slot;
    }
    template <class Record>
    void release(std::vector<Record>& records, uint32_t slot) {
        records[slot] = Record();
        records[slot].next_free() = free;
        free = slot;
        --count;
    }
};

/// The objects of a world, by slot.
struct ObjectState {
    std::vector<BodyRecord> bodies;
    std::vector<RestPose> rest_poses;  ///< of the bodies
    std::vector<BodyTraits> traits;    ///< of the few bodies whose traits are not the defaults
    std::vector<Island> islands;
    std::vector<ShapeRecord> shapes;
    std::vector<ShapeForm> forms;  ///< of the shapes
    VertexPool pool;
    std::vector<SegmentRecord> segment_surfaces;  ///< sorted by shape, then by segment
    std::vector<ContactRecord> contacts;
    std::vector<ContactLinks> contact_links;   ///< of the contacts
    std::vector<ManifoldPose> manifold_poses;  ///< of the contacts
    std::vector<JointRecord> joints;
    std::vector<FieldRecord> fields;
    Slots body_slots, trait_slots, island_slots, shape_slots, contact_slots, joint_slots,
        field_slots;
    uint32_t dormant_joints = 0;
    /// Numbers of such bodies and shapes.
    uint32_t kinematic_bodies = 0, bullets = 0, sensors = 0;
    uint32_t crowded_shapes = 0;

    /// The shape that the user sees: the owner of a part, otherwise the shape itself.
    uint32_t named_shape(uint32_t slot) const {
        return shapes[slot].owner == none ? slot : shapes[slot].owner;
    }
    /// Place of a part among the parts of its outline; 0 for other shapes.
    uint32_t part_number(uint32_t slot) const {
        const ShapeRecord& shape = shapes[slot];
        return shape.owner == none ? 0 : shape.figure.as<PartFigure>().number;
    }
    /// False for an outline: only its parts collide.
    bool is_solid(uint32_t shape) const { return forms[shape].kind != FormKind::outline; }
    Convex convex(uint32_t shape) const {
        const ShapeForm& form = forms[shape];
        return {&pool.vertices[form.begin], &pool.directions[form.begin], &pool.offsets[form.begin],
                int(form.count), form.radius};
    }
    std::span<const Vec2> outline_of(uint32_t shape) const {
        return {&pool.local[forms[shape].begin], shapes[shape].outline};
    }
    /// Visits the shape itself, or its parts.
    void for_each_solid(uint32_t shape, auto&& visit) const {
        if (is_solid(shape)) {
            visit(shape);
            return;
        }
        for (uint32_t part = shapes[shape].first_part; part != none;) {
            const uint32_t next = shapes[part].next_part;
            visit(part);
            part = next;
        }
    }

    /// Visits the solid shapes of a body.
    void for_each_solid_of(uint32_t body, auto&& visit) const {
        for (uint32_t shape = bodies[body].lists.first_shape; shape != none;
             shape = shapes[shape].next)
            if (is_solid(shape)) visit(shape);
    }

    void set_crowded(uint32_t shape, bool crowded) {
        crowded_shapes += uint32_t{crowded} - uint32_t{shapes[shape].crowded};
        shapes[shape].crowded = crowded;
    }

    ListEdge& contact_edge(uint32_t edge) { return contact_links[edge >> 1].edges[edge & 1]; }
    ListEdge& joint_edge(uint32_t edge) { return joints[edge >> 1].edges[edge & 1]; }
    void for_each_joint(uint32_t body, auto&& visit) const {
        for (uint32_t edge = bodies[body].lists.first_joint; edge != none;) {
            const uint32_t next = joints[edge >> 1].edges[edge & 1].next;
            visit(edge >> 1, edge & 1);
            edge = next;
        }
    }
    void for_each_contact(uint32_t body, auto&& visit) const {
        any_contact(bodies[body].lists.first_contact, none, [&](uint32_t contact) {
            visit(contact);
            return false;
        });
    }
    /// True if `visit` returns true for a contact in a body's list, from `edge` on and before the
    /// contact `end` (`none`: to the end of the list).
    bool any_contact(uint32_t edge, uint32_t end, auto&& visit) const {
        while (edge != none && edge >> 1 != end) {
            const uint32_t next = contact_links[edge >> 1].edges[edge & 1].next;
            if (visit(edge >> 1)) return true;
            edge = next;
        }
        return false;
    }
    /// The contacts of the shape and of its parts.
    void for_each_contact_of(uint32_t shape, auto&& visit) const {
        if (forms[shape].body == none) return;
        const auto is_its = [&](uint32_t s) { return s == shape || shapes[s].owner == shape; };
        for_each_contact(forms[shape].body, [&](uint32_t contact) {
            const ContactRecord& c = contacts[contact];
            if (is_its(c.shape_a) || is_its(c.shape_b)) visit(contact);
        });
    }
    uint32_t other_body(uint32_t contact, uint32_t body) const {
        const ContactRecord& c = contacts[contact];
        return c.body_a == body ? c.body_b : c.body_a;
    }
    float sleep_speed_of(const WorldDef& settings, const BodyRecord& body) const {
        if (body.traits == none || !is_given(traits[body.traits].sleep_speed))
            return settings.sleep_speed;
        return traits[body.traits].sleep_speed;
    }
    float max_speed_of(const BodyRecord& body) const {
        return body.traits == none ? infinity : traits[body.traits].max_speed;
    }
    /// Keeps a velocity within the locked axes and the maximum speed of a body.
    void limit_velocity(const BodyRecord& body, SolverBody& b) const {
        if (body.flags.locked_x) b.velocity.x = 0.0f;
        if (body.flags.locked_y) b.velocity.y = 0.0f;
        if (body.flags.locked_rotation) b.angular_velocity = 0.0f;
        const float most = max_speed_of(body), speed = length(b.velocity);
        if (speed > most) b.velocity = (most / speed) * b.velocity;
    }
    /// False for a joint with a disabled body, too.
    bool may_act(const JointRecord& joint) const {
        return joint.moves() && !bodies[joint.bodies[0]].flags.disabled &&
               !bodies[joint.bodies[1]].flags.disabled;
    }
    void for_each_asleep(uint32_t island, auto&& visit) const {
        for (uint32_t body = islands[island].first; body != none;) {
            const uint32_t next = bodies[body].lists.next;
            visit(body);
            body = next;
        }
    }

    static void members(auto& io, auto& s) {
        list_members<ObjectState>(
            io,
            named("bodies", s.bodies, s.rest_poses, s.traits, s.islands, s.body_slots,
                  s.trait_slots, s.island_slots, s.kinematic_bodies, s.bullets),
            named("shapes", s.shapes, s.forms, s.segment_surfaces, s.shape_slots, s.sensors,
                  s.crowded_shapes),
            named("vertices", s.pool),
            named("contacts", s.contacts, s.contact_links, s.manifold_poses, s.contact_slots),
            named("joints", s.joints, s.joint_slots, s.dormant_joints),
            named("fields", s.fields, s.field_slots));
    }
};

inline BodyId body_id(const Columns& columns, uint32_t slot) {
    return {slot, columns.body_generations[slot]};
}
/// Id of the shape that the user sees.
inline ShapeId shape_id(const ObjectState& objects, const Columns& columns, uint32_t slot) {
    const uint32_t named = objects.named_shape(slot);
    return {named, columns.shape_generations[named]};
}

/// The shape for the collision functions, rotated with its body.
inline Solid solid_of(const ObjectState& objects, const Columns& columns, uint32_t shape) {
    const ShapeForm& form = objects.forms[shape];
    Solid made = {objects.convex(shape), form.kind};
    if (form.kind == FormKind::convex || form.kind == FormKind::ellipse) return made;
    made.limits = &objects.pool.local[form.begin] + form.count;
    made.normals = &objects.pool.normals[form.begin];
    if (form.body != none)
        made.rotation = {columns.states[form.body].cosine, columns.states[form.body].sine};
    return made;
}

/// The boxes of the shapes, and the pairs whose boxes overlap.
struct BroadPhaseState {
    std::vector<Box4> boxes;      ///< by shape slot, tight
    std::vector<Box4> fat_boxes;  ///< by shape slot, as they are in the tree
    /// The fat boxes at the last search for pairs: two boxes that overlapped then are a known pair.
    /// Empty after an edit that may have changed which shapes collide.
    std::vector<Box4> paired_boxes;
    Tree fixed_tree, moving_tree;
    PairSet pairs;
    std::vector<uint32_t> moved_shapes;  ///< shapes for which new pairs are searched

    static void members(auto& io, auto& s) {
        list_members<BroadPhaseState>(io,
                                      named("bounding boxes", s.boxes, s.fat_boxes, s.paired_boxes),
                                      named("trees", s.fixed_tree, s.moving_tree),
                                      named("pairs", s.pairs), named("lists", s.moved_shapes));
    }
};

/// Objects that the next step processes: slots.
struct ActiveLists {
    std::vector<uint32_t> awake_bodies;  ///< index in the solver: index here plus 1
    std::vector<uint32_t> awake_contacts;
    std::array<std::vector<uint32_t>, joint_type_count> awake_joints;  ///< by type
    std::vector<uint32_t> edited_bodies, edited_shapes;                ///< to refresh
    /// Bodies that move in place among bodies at rest, by slot: sleep/rocking.h.
    std::vector<Stay> stays;

    static void members(auto& io, auto& s) {
        list_members<ActiveLists>(
            io, named("lists", s.awake_bodies, s.awake_contacts, s.awake_joints, s.edited_bodies,
                      s.edited_shapes, s.stays));
    }
};

struct WorldState : Columns, ObjectState, BroadPhaseState, ActiveLists {
    WorldDef settings;
    bool filtered = false;  ///< the last step had a filter, which may have refused pairs
    std::vector<IgnoredPair> ignored_pairs;
    /// The bodies of movers that have moved since the last step, or before it (`old`); by slot.
    std::vector<MoverBody> mover_bodies;
    std::vector<MoverPair> mover_pairs;              ///< of the moves before the next step
    std::vector<MoverWeight> mover_weights;          ///< of the moves before the next step
    std::vector<ContactUserData> contact_user_data;  ///< in the order of their pairs
    Strips strips;                                   ///< cuts of the last step
    float last_substep = 0.0f;  ///< s; warm-start impulses are scaled by the ratio of the lengths
    float last_length = 0.0f;   ///< s; of the last step, with the usual number of its sub-steps
    int last_substeps = 0;      ///< number of the sub-steps of the last step
    float long_substep = 0.0f;  ///< s; the longest of about the last second, for the stiffness
    float since_search = 0.0f;  ///< s since the last search for resting islands
    uint64_t steps = 0;
    uint32_t sleep_candidates = 0;  ///< bodies that rested long enough in the last step
    Events events;                  ///< of the last step
    Events pending;                 ///< events of edits after it
    StepStatistics statistics;

    static void members(auto& io, auto& s) {
        list_members<WorldState, Columns>(
            io,
            named("", s.settings, s.strips, s.last_substep, s.last_length, s.last_substeps,
                  s.long_substep, s.since_search, s.steps, s.sleep_candidates, s.statistics),
            named("bodies", s.states, s.previous, s.body_generations),
            named("shapes", s.shape_generations), named("joints", s.joint_generations),
            named("", part<ObjectState>(s), part<BroadPhaseState>(s), part<ActiveLists>(s)),
            named("contacts", s.filtered, s.ignored_pairs, s.mover_bodies, s.mover_pairs,
                  s.mover_weights, s.contact_user_data),
            named("events", s.events, s.pending));
    }
};

}  // namespace fettle::physics::detail
