#pragma once

#include <contacts/contact_list.h>

// Crushed bodies. A kinematic body of infinite mass that presses a body against a fixed obstacle
// would press it into the obstacle and through it, since no velocity meets both contacts. The fixed
// obstacle has priority: once the space between the two is less than half as wide as the body, the
// contact with the kinematic body does not act. It acts again when the two have parted, or when the
// kinematic body moves back and nothing presses the body against it any more. So a kinematic body
// passes through what it crushes, and a body that was crushed is neither lost below the ground nor
// thrown; what a lift has pressed against a ceiling comes down with the lift. The same holds if
// other bodies are between, each pressed into the next one.

namespace fettle::physics::detail {

/// Finds the contacts in which a kinematic body begins to crush another one, and skips them.
/// Returns true if a contact of an awake kinematic body does not act because of that.
bool skip_crushed(const Touching& touching, const ActiveLists& active);

/// Sets the impulses of the contacts of a pressed body to 0. They balance those of what presses it
/// and are far greater than all other forces on the body: without it they would throw the body.
void clear_impulses_of(ObjectState& objects, uint32_t body);
/// The same for the contacts and joints of all bodies of a list, which is empty then. To be called
/// when the impulses of the step are stored.
void drop_impulses(ObjectState& objects, std::vector<uint32_t>& bodies);

/// Must be called when the touch of a kinematic body ends: bodies that it pressed together would be
/// thrown by the stored impulses, which balanced those of the presser.
void release_pressed(ObjectState& objects, const ContactRecord& ended);

}  // namespace fettle::physics::detail
