#include <fettle/maps/map.h>
#include <fettle/property/error.h>

#include <filesystem>
#include <set>

#include "cells.h"
#include "reader.h"

namespace fettle::maps {

using property::Vec2;

namespace {

/// Layers are found by their ids. Maps of early versions of the editor and of other programs have
/// none, or the same twice; such layers get ids that are free.
class LayerIds {
  public:
    void complete(std::vector<Layer>& layers) {
        collect(layers);
        for (Layer* layer : without_) {
            while (!used_.insert(next_).second) ++next_;
            layer->id = next_;
        }
    }

  private:
    void collect(std::vector<Layer>& layers) {
        for (Layer& layer : layers) {
            if (layer.id == 0 || !used_.insert(layer.id).second) without_.push_back(&layer);
            collect(layer.layers);
        }
    }

    std::set<std::int64_t> used_;
    std::vector<Layer*> without_;
    std::int64_t next_ = 1;
};

}  // namespace

const Tileset* Map::tileset_of(std::uint32_t gid) const {
    for (const Tileset& set : tilesets)
        if (set.contains(gid)) return &set;
    return nullptr;
}

const Tile* Map::tile(std::uint32_t gid) const {
    const Tileset* const set = tileset_of(gid);
    if (set == nullptr) return nullptr;
    const auto found = set->tiles.find(gid - set->first_gid);
    return found == set->tiles.end() ? nullptr : &found->second;
}

Map read_map(const std::string& file, const ReadFile& read) {
    return Reader(file, read).map();
}

Tileset read_tileset(const std::string& file, const ReadFile& read) {
    return Reader(file, read).tileset();
}

std::string Reader::beside(const std::string& from, const std::string& name) {
    return (std::filesystem::path(from).parent_path() / name).lexically_normal().generic_string();
}

Json Reader::read_part(const std::string& from, const std::string& file) const {
    std::string text;
    try {
        text = read_(file);
    } catch (const property::Error& error) {
        throw property::Error(error.kind(), std::string(error.what()) + " (named in " + from + ")");
    }
    return parse_document(file, text);
}

Map Reader::map() {
    const Json document = parse_document(file_, read_(file_));
    if (!document.is_object()) fail(file_, "this is not a map");
    const Place place{file_, document, {}};
    if (const std::string type = place.text("type", "map"); type != "map")
        place.fail("expected a map, got a " + type);
    map_.class_name = place.text("class");
    map_.width = static_cast<int>(place.integer("width", 0, 0, max_side));
    map_.height = static_cast<int>(place.integer("height", 0, 0, max_side));
    map_.tile_width = static_cast<int>(place.integer("tilewidth", 0, 1, max_side));
    map_.tile_height = static_cast<int>(place.integer("tileheight", 0, 1, max_side));
    if (map_.tile_width == 0 || map_.tile_height == 0)
        place.fail("this is not a map: it has no \"tilewidth\" and \"tileheight\"");
    const std::string orientation = place.text("orientation", "orthogonal");
    constexpr const char* orientations[] = {"orthogonal", "isometric", "staggered", "hexagonal"};
    int number = 0;
    while (number < 4 && orientation != orientations[number]) ++number;
    if (number == 4) place.fail("unknown orientation \"" + orientation.substr(0, 60) + "\"");
    map_.orientation = static_cast<Orientation>(number);
    map_.infinite = place.boolean("infinite", false);
    map_.background = place.color("backgroundcolor", map_.background);
    map_.hex_side = static_cast<int>(place.integer("hexsidelength", 0, 0, max_side));
    map_.stagger_x = place.text("staggeraxis") == "x";
    map_.stagger_odd = place.text("staggerindex") != "even";
    map_.properties = place.properties();
    for (const Json& one : place.list("tilesets"))
        map_.tilesets.push_back(tileset(place.at(one), file_));
    end_of_tilesets();
    for (const Json& one : place.list("layers")) map_.layers.push_back(layer(place.at(one), 0));
    LayerIds().complete(map_.layers);
    return std::move(map_);
}

Layer Reader::layer(const Place& outer, int depth) {
    if (!outer.json.is_object()) outer.fail("a layer is not an object");
    if (depth > max_groups) outer.fail("groups are nested too deep");
    Layer layer;
    layer.name = outer.text("name");
    const Place place{file_, outer.json, "layer \"" + layer.name + "\""};
    layer.id = place.integer("id", 0, 0, INT64_MAX);
    layer.class_name = place.text("class");
    layer.visible = place.boolean("visible", true);
    layer.opacity = place.number("opacity", 1);
    layer.tint = place.color("tintcolor", layer.tint);
    layer.offset = Vec2(place.number("offsetx", 0), place.number("offsety", 0));
    layer.parallax = Vec2(place.number("parallaxx", 1), place.number("parallaxy", 1));
    layer.properties = place.properties();
    const std::string type = place.text("type");
    if (type == "tilelayer") {
        layer.kind = LayerKind::tiles;
        read_tiles(place, layer);
    } else if (type == "objectgroup") {
        layer.kind = LayerKind::objects;
        for (const Json& one : place.list("objects"))
            layer.objects.push_back(object(place.at(one)));
    } else if (type == "imagelayer") {
        layer.kind = LayerKind::image;
        if (const std::string image = place.text("image"); !image.empty())
            layer.image = beside(file_, image);
        layer.transparent = place.transparent_color();
        layer.repeat_x = place.boolean("repeatx", false);
        layer.repeat_y = place.boolean("repeaty", false);
    } else if (type == "group") {
        layer.kind = LayerKind::group;
        for (const Json& one : place.list("layers"))
            layer.layers.push_back(this->layer(place.at(one), depth + 1));
    } else {
        place.fail("unknown type \"" + type.substr(0, 60) + "\"");
    }
    return layer;
}

void Reader::read_tiles(const Place& place, Layer& layer) const {
    const std::string encoding = place.text("encoding"), compression = place.text("compression");
    std::int64_t left = max_cells;
    if (!place.has("chunks")) {
        layer.cells.push_back(cells(place, encoding, compression, left));
        return;
    }
    for (const Json& one : place.list("chunks"))
        layer.cells.push_back(cells(place.at(one), encoding, compression, left));
}

/// `left`: number of cells that the layer may still have.
Cells Reader::cells(const Place& place, const std::string& encoding, const std::string& compression,
                    std::int64_t& left) const {
    Cells all;
    all.x = static_cast<int>(place.integer("x", 0, -(1 << 30), 1 << 30));
    all.y = static_cast<int>(place.integer("y", 0, -(1 << 30), 1 << 30));
    all.width = static_cast<int>(place.integer("width", map_.width, 0, max_side));
    all.height = static_cast<int>(place.integer("height", map_.height, 0, max_side));
    left -= std::int64_t{all.width} * all.height;
    if (left < 0) place.fail("more than " + std::to_string(max_cells) + " cells");
    all.cells = read_cells(place, encoding, compression, all.width, all.height);
    return all;
}

}  // namespace fettle::maps
