#pragma once
// Measures the time and the memory that games of usual kinds take.

#include <functional>
#include <string>
#include <vector>

#include "report/bounds.h"

namespace fettle::bench {

struct GameCost {
    std::string name;
    std::string unit;
    Bound bound{};
    bool needs_display = false;
    std::function<double()> measure;
};

std::vector<GameCost> game_costs();

}  // namespace fettle::bench
