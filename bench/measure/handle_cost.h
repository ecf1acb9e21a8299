#pragma once
// The cost of reading and writing properties of a hosted game through its interface in C.

#include <string>
#include <vector>

namespace fettle::bench {

struct HandleCost {
    std::string name;
    double ns = 0;       // median of several timings
    double ns_best = 0;  // the fastest of them, which other load has disturbed least
};

std::vector<HandleCost> handle_costs();

}  // namespace fettle::bench
