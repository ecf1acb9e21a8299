#pragma once

#include <state/world_state.h>

namespace fettle::physics::detail {

/// Role of a joint in a step. `acting`: one of its dynamic bodies is awake. `asleep`: it keeps its
/// impulses until a body wakes. `idle`: it does not act and has no impulses.
enum class JointRole { idle, asleep, acting };
JointRole role_of(const ObjectState& objects, const JointRecord& joint);

void clear_impulses(ObjectState& objects, uint32_t joint);

// Changes of the lists of awake objects.

void add_awake(ObjectState& objects, ActiveLists& active, uint32_t body);
void remove_awake(ObjectState& objects, ActiveLists& active, uint32_t body);
void add_awake_contact(ObjectState& objects, ActiveLists& active, uint32_t contact);
void remove_awake_contact(ObjectState& objects, ActiveLists& active, uint32_t contact);
/// Must be called after a change of the joint or its bodies: the joint is listed while it acts and
/// one of its bodies is awake.
void list_joint(ObjectState& objects, ActiveLists& active, uint32_t joint);

}  // namespace fettle::physics::detail
