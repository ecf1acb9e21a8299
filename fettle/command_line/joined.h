#pragma once

#include <string>
#include <vector>

namespace fettle::program {

/// The texts with ", " between them.
inline std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& each : texts) all += (all.empty() ? "" : ", ") + each;
    return all;
}

}  // namespace fettle::program
