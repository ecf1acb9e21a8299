#pragma once
// The common properties of the view and of cameras: height, following an instance, limits, shaking.

#include <vector>

#include <fettle/property/class.h>

namespace fettle::app {

/// Range of the height that is shown, m.
inline constexpr property::Range view_heights{1e-3, 1e6};
/// Throws std::invalid_argument for a height outside of that range, to which a zoom would lead.
void require_view_height(double height);

/// `follow`, `follow_damping`, `dead_zone`, `limits` and the hidden numbers of a shake, as values
/// that the tree stores.
std::vector<property::Property> following_properties();

/// `shake` of a class with these properties.
property::Method shake_method();

}  // namespace fettle::app
