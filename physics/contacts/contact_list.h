#pragma once

#include <fettle/physics/events.h>
#include <state/world_state.h>

#include <vector>

// The life of a contact: a pair of shapes is kept while their fat boxes overlap, and gets a
// manifold in each step in which one of the two bodies is awake.

namespace fettle::physics::detail {

// When shapes begin and end to touch, and the events of it. A chain or a concave polygon touches as
// one: a shape that goes on from one of its parts to the next neither leaves nor arrives.

/// What a touch that begins or ends changes, and where its events go.
struct Touching {
    ObjectState& objects;
    const Columns& columns;
    Events& events;  ///< of the step, or of the edits since
    /// Touches of an outline's parts that ended in this step; null between steps, when the event of
    /// an end does not wait for the touch of another part.
    std::vector<ContactRecord>* parted;
    uint32_t step;  ///< the last digits of its number
};

void set_touching(const Touching& touching, uint32_t contact, bool begins);
/// The touches of outlines that ended in this step without going on to another part.
void report_parted(const Touching& touching);

/// A part of an outline is one of the two shapes.
bool is_of_outline(const ObjectState& objects, const ContactRecord& contact);
/// True for one of the touching contacts of two shapes, however many of their parts touch.
bool reports_for_pair(const ObjectState& objects, uint32_t contact);

/// What contacts are entered in.
struct ContactList {
    Touching touching;
    PairSet& pairs;
    ActiveLists& active;
};

void create_contact(const ContactList& list, const WorldDef& settings, uint32_t shape_a,
                    uint32_t shape_b);
void destroy_contact(const ContactList& list, uint32_t contact);
void destroy_contacts_of_shape(const ContactList& list, uint32_t shape);  ///< and of its parts
void destroy_contacts_of_body(const ContactList& list, uint32_t body);

/// Mixes the surfaces of the two shapes of a contact.
void remix(const ObjectState& objects, const WorldDef& settings, ContactRecord& contact);
void remix_shape(ObjectState& objects, const WorldDef& settings, uint32_t shape);

// Which pairs of shapes may collide.

/// The filter that the user has set, if any.
struct UserFilter {
    const void* world = nullptr;
    bool (*agrees)(const void* world, uint32_t shape_a, uint32_t shape_b) = nullptr;

    explicit operator bool() const { return agrees != nullptr; }
    bool operator()(uint32_t a, uint32_t b) const { return !agrees || agrees(world, a, b); }
};

bool filters_agree(const ObjectState& objects, uint32_t shape_a, uint32_t shape_b);
/// A joint keeps its two bodies from colliding. Not with the world: the border belongs to it, and
/// what hangs in the world still collides with the border.
bool keeps_apart(const JointRecord& joint);
bool joint_forbids_contact(const ObjectState& objects, uint32_t body_a, uint32_t body_b);
bool may_collide(const ObjectState& objects, const UserFilter& filter, uint32_t shape_a,
                 uint32_t shape_b);

}  // namespace fettle::physics::detail
