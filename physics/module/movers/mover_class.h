#pragma once

#include <hosting/hosting.h>

namespace fettle::physics_module {

void define_mover(Hosting& hosting);

/// Moves all movers of a world, before its step of `dt` seconds.
void move_movers(HostedWorld& hosted, float dt);
/// Emits the events of the last step.
void report_movers(Hosting& hosting, HostedWorld& hosted);

/// Sets the radius, and the height for standing or for crouching if there is room for it.
void adapt_capsule(HostedWorld& hosted, std::uint32_t slot);

}  // namespace fettle::physics_module
