#pragma once

#include <fettle/physics/events.h>
#include <state/world_state.h>

#include <span>
#include <vector>

// Creation and destruction of contacts. A pair of shapes exists while their fat boxes overlap. It
// gets a manifold in each step in which one of the two bodies is awake.

namespace fettle::physics::detail {

// Begin and end of touches, and their events. A chain or a concave polygon touches as one shape:
// when a shape moves from one of its parts to the next, no touch ends or begins.

struct SolverForce;

/// Data that change when a touch begins or ends, and the list for its events.
struct Touching {
    ObjectState& objects;
    const Columns& columns;
    Events& events;  ///< events of the step, or of the edits after it
    /// Touches of parts of outlines that ended in this step. Null between steps; then an end is
    /// reported without waiting for a touch of another part.
    std::vector<ContactRecord>* parted;
    uint32_t step;  ///< the low bits of the step number
    float restitution_threshold;
    /// What forces change in each sub-step, by the body's index in the solver, and the lengths of a
    /// sub-step and of the step, s. Of use only after the solver.
    std::span<const SolverForce> forces = {};
    float substep = 0.0f, length = 0.0f;
};

void set_touching(const Touching& touching, uint32_t contact, bool begins);
/// Skips a contact: it does not act, its touch ends, and its impulses are set to 0.
void skip_contact(const Touching& touching, uint32_t contact, Skipped reason);
/// Reports the touches of outlines that ended in this step without a touch of another part.
void report_parted(const Touching& touching);

/// Reports a shape that moved through a sensor within a step: the begin now, the end in `later`.
void report_crossing(const Touching& touching, Events& later, uint32_t sensor, uint32_t visitor);

/// True if two shapes, or parts of them, touch.
bool touch(const ObjectState& objects, uint32_t shape_a, uint32_t shape_b);

/// True if one of the two shapes is a part of an outline.
bool is_of_outline(const ObjectState& objects, const ContactRecord& contact);
/// True for exactly one of the touching contacts of two shapes, however many of their parts touch.
bool reports_for_pair(const ObjectState& objects, uint32_t contact);

/// The lists and arrays of contacts.
struct ContactList {
    Touching touching;
    PairSet& pairs;
    ActiveLists& active;
};

/// Counts a contact in the lists of its bodies. It comes before `create_contact`, because other
/// threads may read the number while one creates.
void count_contact(ObjectState& objects, uint32_t shape_a, uint32_t shape_b);
void create_contact(const ContactList& list, const WorldDef& settings, uint32_t shape_a,
                    uint32_t shape_b);
void destroy_contact(const ContactList& list, uint32_t contact);
void destroy_contacts_of_shape(const ContactList& list, uint32_t shape);  ///< and its parts
void destroy_contacts_of_body(const ContactList& list, uint32_t body);

// Which pairs of shapes may collide.

/// The filter of the user, if there is one.
struct UserFilter {
    const void* world = nullptr;
    bool (*agrees)(const void* world, uint32_t shape_a, uint32_t shape_b) = nullptr;

    explicit operator bool() const { return agrees != nullptr; }
    bool operator()(uint32_t a, uint32_t b) const { return !agrees || agrees(world, a, b); }
};

/// The callbacks of the user that decide about a contact, if there are any.
struct UserDecision {
    void* world = nullptr;
    bool (*acts)(void* world, uint32_t contact) = nullptr;

    explicit operator bool() const { return acts != nullptr; }
    bool operator()(uint32_t contact) const { return !acts || acts(world, contact); }
};

bool filters_agree(const ObjectState& objects, uint32_t shape_a, uint32_t shape_b);
/// True if the joint prevents collisions of its two bodies. False for a joint with the world: the
/// border belongs to the world, and a body that is joined to the world must still collide with the
/// border.
bool keeps_apart(const JointRecord& joint);
bool joint_forbids_contact(const ObjectState& objects, uint32_t body_a, uint32_t body_b);
bool may_collide(const ObjectState& objects, const UserFilter& filter, uint32_t shape_a,
                 uint32_t shape_b);

}  // namespace fettle::physics::detail
