#pragma once
// Every benchmark scene by name.

#include <span>
#include <string_view>

#include "scenes/scene.h"

namespace fettle::bench {

struct CatalogueEntry {
    std::string_view name;
    /// Null where the scene cannot be built yet; `missing` says what it lacks.
    Scene (*make)();
    std::string_view missing;
    /// Run when nobody asks for scenes by name.
    bool by_default = true;
    /// What a step may take at most, over that of Box2D 2.4; 0: the design sets no bound.
    double over_box2d = 0;
};

std::span<const CatalogueEntry> catalogue();
/// Throws std::invalid_argument that lists the names for one that does not exist, or says what is
/// missing.
const CatalogueEntry& scene_named(std::string_view name);

Scene large_pyramid();
/// The same with `base` squares in its lowest row.
Scene pyramid_of(int base);
Scene many_pyramids();
/// The same with so many pyramids, twenty a row.
Scene pyramids_of(int count);
Scene joint_grid();
Scene tumbler();
Scene smash();
Scene washer();
Scene compounds();
Scene junkyard();
Scene spinner();
Scene rain();
/// 10 000 boxes and circles in a bin, all awake: where the cost of hosting is measured.
Scene crowd();
/// The same with `columns` × `rows` bodies.
Scene crowd_of(int columns, int rows);

}  // namespace fettle::bench
