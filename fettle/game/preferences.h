#pragma once
// Settings of the player that outlive a run. The interface reports changes, and a file keeps them.

#include <fettle/interface/interface.h>
#include <fettle/property/storage/store.h>

namespace fettle::program {

/// Gives the interface the settings in `kept`, and notes its later ones there. `kept` must live as
/// long as the interface is used.
void follow_preferences(property::Store& kept, interface::Interface& interface);

}  // namespace fettle::program
