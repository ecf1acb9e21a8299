#pragma once
// Eases: how a tween's part of the way depends on its part of the time, both 0 to 1.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::script {

/// Number of points at which a script's own ease function is sampled.
inline constexpr int ease_samples = 257;

/// "linear", then "in_quad", "out_quad", "in_out_quad" and so on.
const std::vector<std::string>& ease_names();

/// The part of the way at `time`. It starts at 0 and ends at 1, and some eases overshoot in
/// between. An unknown name is taken as "linear".
double ease(std::string_view name, double time);

/// The same for a list of at least two numbers at equal distances of time, joined by straight
/// lines.
double ease(const property::List& curve, double time);

}  // namespace fettle::script
