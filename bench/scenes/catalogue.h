#pragma once
// All benchmark scenes by name.

#include <span>
#include <string_view>

#include "scenes/scene.h"

namespace fettle::bench {

struct CatalogueEntry {
    std::string_view name;
    Scene (*make)();
    /// Whether it runs when no scene is named.
    bool by_default = true;
    /// Maximum time per step divided by that of Box2D 2.4; 0: the design sets no bound.
    double over_box2d = 0;
};

std::span<const CatalogueEntry> catalogue();
/// Throws std::invalid_argument for a name that does not exist, with a list of the names.
const CatalogueEntry& scene_named(std::string_view name);

Scene large_pyramid();
/// The same with `base` squares in its lowest row.
Scene pyramid_of(int base);
Scene many_pyramids();
/// The same with that number of pyramids, twenty per row.
Scene pyramids_of(int count);
Scene joint_grid();
Scene tumbler();
Scene smash();
Scene washer();
Scene compounds();
Scene junkyard();
Scene spinner();
Scene rain();
/// 10 000 boxes and circles in a bin, all awake; used for measuring the cost of hosting.
Scene crowd();
/// The same with `columns` × `rows` bodies.
Scene crowd_of(int columns, int rows);
/// Boxes that lie in a bin, in rows that are shifted against each other; all stay awake.
Scene pile_of(int columns, int rows);

}  // namespace fettle::bench
