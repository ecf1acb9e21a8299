#pragma once
// Reads the parts of a map from documents.

#include <map>
#include <string>
#include <string_view>

#include <fettle/maps/map.h>

#include "fields.h"

namespace fettle::maps {

/// Limits for the contents of a file, against damaged files.
inline constexpr std::int64_t max_side = 1 << 16;   // cells of a map or px of a tile along x or y
inline constexpr std::int64_t max_cells = 1 << 24;  // of a layer
inline constexpr std::int64_t max_tiles = 1 << 24;  // of a tileset
inline constexpr int max_groups = 32;               // nested in each other

class Reader {
  public:
    Reader(const std::string& file, const ReadFile& read) : file_(file), read_(read) {}

    Map map();
    Tileset tileset();

  private:
    // --- map.cpp
    Layer layer(const Place& place, int depth);
    void read_tiles(const Place& place, Layer& layer) const;
    Cells cells(const Place& place, const std::string& encoding, const std::string& compression,
                std::int64_t& left) const;

    // --- tilesets.cpp
    Tileset tileset(const Place& place, const std::string& in);
    void end_of_tilesets();
    Tile tile(const Place& place);

    // --- objects.cpp
    Object object(const Place& place);
    const Json& object_template(const Place& place, const std::string& file);
    std::uint32_t first_gid_of(const Place& place, const Json& tileset, const std::string& in);

    /// The name relative to the game's folder of a file that `from` names.
    static std::string beside(const std::string& from, const std::string& name);
    /// The content of a file that `from` names. Errors of reading name that file, too.
    Json read_part(const std::string& from, const std::string& file) const;

    const std::string& file_;
    const ReadFile& read_;
    Map map_{};
    std::map<std::string, std::uint32_t> first_gids_{};  // by file, of external tilesets
    std::int64_t next_gid_ = 0;                          // 0 while tilesets are read
    std::map<std::string, Json> templates_{};            // by file
};

}  // namespace fettle::maps
