#pragma once
// How the observing parts of the console see the kept past.

#include <cstdint>
#include <functional>

namespace fettle::console {

/// Options::review.
using Review = std::function<void(std::int64_t from, std::int64_t to,
                                  const std::function<void(std::int64_t step)>& visit)>;

}  // namespace fettle::console
