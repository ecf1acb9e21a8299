#include "scenes/catalogue.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace fettle::bench {

std::span<const CatalogueEntry> catalogue() {
    static const std::array<CatalogueEntry, 11> entries = {{
        {"large_pyramid", large_pyramid, true, 0.16},
        {"many_pyramids", many_pyramids, true, 0.096},
        {"joint_grid", joint_grid, true, 0.56},
        {"smash", smash, true, 0.073},
        {"tumbler", tumbler, true, 0.125},
        {"compounds", compounds, true, 0.05},
        {"washer", washer, false},
        {"junkyard", junkyard, false},
        {"spinner", spinner, false},
        {"rain", rain, false},
        {"crowd", crowd, false},
    }};
    return entries;
}

const CatalogueEntry& scene_named(std::string_view name) {
    const auto entries = catalogue();
    const auto found =
        std::find_if(entries.begin(), entries.end(),
                     [&](const CatalogueEntry& entry) { return entry.name == name; });
    if (found == entries.end()) {
        std::string names;
        for (const CatalogueEntry& entry : entries)
            names += (names.empty() ? "" : ", ") + std::string(entry.name);
        throw std::invalid_argument("no scene is called \"" + std::string(name) + "\"; there are " +
                                    names);
    }
    return *found;
}

}  // namespace fettle::bench
