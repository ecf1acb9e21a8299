#pragma once
// Maps without a file: one layer of empty cells, with the tiles of an image or of a tileset.

#include <string>
#include <vector>

#include <fettle/maps/map.h>
#include <fettle/property/value.h>

#include <images/images.h>

namespace fettle::visuals {

struct EmptyMap {
    std::string tileset{};           // an image or a tileset file
    int columns = 0, rows = 0;       // cells
    property::Vec2 tile_size{};      // px, of the tiles in an image
    std::vector<int> solid_tiles{};  // numbers of tiles of an image, from 1

    /// A text that differs if any of the values does. No file has such a name.
    std::string key() const;
};

/// Whether the text is a key of an EmptyMap, and not the name of a file.
bool is_empty_map(const std::string& key);

/// `what`: the property that names the tileset, for messages. Throws as maps::read_tileset does,
/// and std::runtime_error for an image that is missing or smaller than a tile.
maps::Map make_empty_map(const EmptyMap& wanted, const std::string& what, Images& images,
                         const maps::ReadFile& read);

}  // namespace fettle::visuals
