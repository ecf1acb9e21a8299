#pragma once
// The branches of the past, from the method `branches` of `time`.

#include <cstdint>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::console {

struct OtherBranch {
    std::string name;
    std::int64_t fork = 0;    // the last step that it has in common with the present branch
    std::int64_t newest = 0;  // its last step
};

/// The branches besides the present one; none if the game has no timeline.
std::vector<OtherBranch> other_branches(property::Tree& tree);

}  // namespace fettle::console
