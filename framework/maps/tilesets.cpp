#include <algorithm>

#include "reader.h"

namespace fettle::maps {

using property::Vec2;

/// Files of early versions of the editor have neither of these numbers.
void Tileset::count_tiles() {
    if (image.empty()) return;
    const auto fit = [this](double pixels, int tile) {
        const double apart = tile + spacing;
        const double room = pixels - 2 * margin + spacing;
        return room >= apart && apart > 0 ? static_cast<int>(std::min(room / apart, 1e6)) : 0;
    };
    if (columns == 0) columns = fit(image_size.x, tile_width);
    if (count == 0)
        count = static_cast<int>(std::min<std::int64_t>(
            std::int64_t{columns} * fit(image_size.y, tile_height), max_tiles));
}

/// Tilesets that templates add get the numbers after those of the map's own.
void Reader::end_of_tilesets() {
    next_gid_ = 1;
    for (const Tileset& set : map_.tilesets)
        next_gid_ = std::max(next_gid_, std::int64_t{set.first_gid} + set.count);
}

Tileset Reader::tileset() {
    const Json json = parse_document(file_, read_(file_));
    return tileset({file_, json, {}}, file_);
}

/// `in`: the file that names the tileset.
Tileset Reader::tileset(const Place& outer, const std::string& in) {
    if (!outer.json.is_object()) outer.fail("a tileset is not an object");
    Tileset set;
    const std::int64_t first_gid = outer.integer("firstgid", 1, 1, 0x0fffffff);
    std::string file = in;
    Json external;
    if (const std::string source = outer.text("source"); !source.empty()) {
        file = beside(in, source);
        external = read_part(in, file);
        if (!external.is_object()) fail(file, "this is not a tileset");
        if (const std::string type = Place{file, external, {}}.text("type", "tileset");
            type != "tileset")
            fail(file, "expected a tileset, got a " + type + " (named in " + in + ")");
        first_gids_[file] = static_cast<std::uint32_t>(first_gid);
    }
    const Json& json = external.is_object() ? external : outer.json;
    set.first_gid = static_cast<std::uint32_t>(first_gid);
    set.name = Place{file, json, {}}.text("name");
    const Place place{file, json, "tileset \"" + set.name + "\""};
    set.class_name = place.text("class");
    set.tile_width = static_cast<int>(place.integer("tilewidth", 0, 0, max_side));
    set.tile_height = static_cast<int>(place.integer("tileheight", 0, 0, max_side));
    set.count = static_cast<int>(place.integer("tilecount", 0, 0, max_tiles));
    set.columns = static_cast<int>(place.integer("columns", 0, 0, max_side));
    set.spacing = static_cast<int>(place.integer("spacing", 0, 0, max_side));
    set.margin = static_cast<int>(place.integer("margin", 0, 0, max_side));
    if (const std::string image = place.text("image"); !image.empty())
        set.image = beside(file, image);
    if (!set.image.empty() && (set.tile_width == 0 || set.tile_height == 0))
        place.fail("a tileset with an image needs \"tilewidth\" and \"tileheight\"");
    set.image_size = Vec2(place.number("imagewidth", 0), place.number("imageheight", 0));
    set.alignment = place.text("objectalignment");
    if (place.has("tileoffset")) {
        const Place offset = place.at(json["tileoffset"]);
        set.offset = Vec2(offset.number("x", 0), offset.number("y", 0));
    }
    set.properties = place.properties();
    set.transparent = place.transparent_color();
    set.count_tiles();
    for (const Json& one : place.list("tiles")) {
        const Place of_tile = place.at(one);
        if (!one.is_object()) place.fail("a tile is not an object");
        const std::int64_t id = of_tile.integer("id", 0, 0, max_tiles - 1);
        Tile tile = this->tile(of_tile);
        if (!tile.image.empty()) tile.image = beside(file, tile.image);
        set.tiles[static_cast<std::uint32_t>(id)] = std::move(tile);
        // The numbers of a collection of images may have gaps.
        set.count = std::max(set.count, static_cast<int>(id + 1));
    }
    return set;
}

Tile Reader::tile(const Place& place) {
    Tile tile;
    tile.class_name = place.text("class", place.text("type"));
    tile.image = place.text("image");
    tile.image_size = Vec2(place.number("imagewidth", 0), place.number("imageheight", 0));
    tile.properties = place.properties();
    for (const Json& one : place.list("animation")) {
        const Place frame = place.at(one);
        if (!one.is_object()) place.fail("a frame of an animation is not an object");
        tile.animation.push_back(
            {static_cast<std::uint32_t>(frame.integer("tileid", 0, 0, max_tiles - 1)),
             frame.number("duration", 0) / 1000});
    }
    if (place.has("objectgroup"))
        for (const Json& one : place.at(place.json["objectgroup"]).list("objects"))
            tile.collision.push_back(object(place.at(one)));
    return tile;
}

}  // namespace fettle::maps
