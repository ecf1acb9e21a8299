#pragma once
// Preferences of the player: values of properties that outlive a run. The interface reports
// changes, and a file keeps them.

#include <fettle/interface/interface.h>
#include <fettle/property/storage/store.h>

namespace fettle::program {

/// Applies the preferences in `kept` to the interface, and stores later changes in `kept`, which
/// must live as long as the interface is used.
void follow_preferences(property::Store& kept, interface::Interface& interface);

}  // namespace fettle::program
