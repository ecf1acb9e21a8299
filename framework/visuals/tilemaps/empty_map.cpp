#include <tilemaps/empty_map.h>

#include <stdexcept>
#include <string_view>
#include <utility>

namespace fettle::visuals {

using property::Vec2;

namespace {

constexpr std::string_view key_begin = "\ntileset ";
constexpr std::int64_t layer_number = 1;

bool is_tileset_file(const std::string& name) {
    return name.ends_with(".tsj") || name.ends_with(".tsx") || name.ends_with(".json");
}

maps::Tileset tiles_of_image(const EmptyMap& wanted, const std::string& what, Images& images) {
    const auto sheet = images.get([&] { return what; }, wanted.tileset);
    if (!sheet->found) throw std::runtime_error("its image is missing");
    maps::Tileset set;
    set.name = "tiles";
    set.image = wanted.tileset;
    set.image_size = Vec2(sheet->picture.width(), sheet->picture.height());
    set.tile_width = static_cast<int>(wanted.tile_size.x);
    set.tile_height = static_cast<int>(wanted.tile_size.y);
    set.columns = static_cast<int>(set.image_size.x) / set.tile_width;
    set.count = set.columns * (static_cast<int>(set.image_size.y) / set.tile_height);
    if (set.count == 0)
        throw std::runtime_error("the image \"" + wanted.tileset + "\" of " +
                                 std::to_string(sheet->picture.width()) + " x " +
                                 std::to_string(sheet->picture.height()) +
                                 " px is smaller than a tile of " + std::to_string(set.tile_width) +
                                 " x " + std::to_string(set.tile_height) + " px: set tile_size");
    for (const int tile : wanted.solid_tiles)
        set.tiles[static_cast<std::uint32_t>(tile - 1)].properties["solid"] = true;
    return set;
}

}  // namespace

std::string EmptyMap::key() const {
    std::string text(key_begin);
    for (const int number :
         {columns, rows, static_cast<int>(tile_size.x), static_cast<int>(tile_size.y)})
        text += std::to_string(number) + " ";
    for (const int tile : solid_tiles) text += std::to_string(tile) + ",";
    return text + " " + tileset;
}

bool is_empty_map(const std::string& key) {
    return key.starts_with(key_begin);
}

maps::Map make_empty_map(const EmptyMap& wanted, const std::string& what, Images& images,
                         const maps::ReadFile& read) {
    maps::Map map;
    map.width = wanted.columns;
    map.height = wanted.rows;
    map.tilesets.push_back(is_tileset_file(wanted.tileset)
                               ? maps::read_tileset(wanted.tileset, read)
                               : tiles_of_image(wanted, what, images));
    map.tile_width = map.tilesets[0].tile_width;
    map.tile_height = map.tilesets[0].tile_height;
    maps::Layer layer;
    layer.id = layer_number;
    layer.name = "tiles";
    layer.cells.push_back({.width = map.width, .height = map.height});
    layer.cells[0].cells.resize(static_cast<std::size_t>(map.width) *
                                static_cast<std::size_t>(map.height));
    map.layers.push_back(std::move(layer));
    return map;
}

}  // namespace fettle::visuals
