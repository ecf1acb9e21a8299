#include <tilemaps/loaded_map.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <tilemaps/grid.h>

namespace fettle::visuals {

using maps::Object;
using maps::ObjectKind;
using maps::Outline;
using maps::Tileset;
using property::Type;
using property::Vec2;

namespace {

/// The corners of an object of a tile, in pixels from its upper left corner, y down.
Outline corners_of(const Object& object) {
    Outline corners;
    const Vec2 size = object.size;
    if (object.kind == ObjectKind::rectangle) {
        corners = {{0, 0}, {size.x, 0}, size, {0, size.y}};
    } else if (object.kind == ObjectKind::ellipse) {
        constexpr int count = 16;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            corners.push_back(0.5 * (size + size.times(Vec2(std::cos(angle), std::sin(angle)))));
        }
    } else if (object.kind == ObjectKind::polygon || object.kind == ObjectKind::polyline) {
        corners = object.points;
    }
    const double turn = object.rotation * std::numbers::pi / 180;
    const double c = std::cos(turn), s = std::sin(turn);
    for (Vec2& p : corners) p = object.position + Vec2(c * p.x - s * p.y, s * p.x + c * p.y);
    return corners;
}

bool is_box(const Outline& corners, const Vec2& lower, const Vec2& upper) {
    if (corners.size() != 4) return false;
    return std::ranges::all_of(corners, [&](const Vec2& p) {
        return (p.x == lower.x || p.x == upper.x) && (p.y == lower.y || p.y == upper.y);
    });
}

bool is_solid(const maps::Tile& tile) {
    const auto found = tile.properties.find("solid");
    return found != tile.properties.end() && found->second.is(Type::boolean) &&
           found->second.boolean();
}

const maps::Layer* find_layer(const std::vector<maps::Layer>& layers, std::int64_t id) {
    for (const maps::Layer& layer : layers) {
        if (layer.id == id && layer.kind != maps::LayerKind::group) return &layer;
        if (const maps::Layer* inside = find_layer(layer.layers, id)) return inside;
    }
    return nullptr;
}

Vec2 size_of(const Tileset& set, const maps::Tile* tile) {
    if (tile != nullptr && !tile->image.empty() && tile->image_size.x > 0) return tile->image_size;
    return Vec2(set.tile_width, set.tile_height);
}

}  // namespace

LoadedMap::LoadedMap(maps::Map map, std::string user, Images& images)
    : map_(std::move(map)), user_(std::move(user)), images_(images) {
    prepare_images();
    for (const Tileset& set : map_.tilesets) {
        Vec2 largest(set.tile_width, set.tile_height);
        for (const auto& [number, tile] : set.tiles) largest = largest.max(size_of(set, &tile));
        reach_ = reach_.max(largest + set.offset.abs());
        add_shapes(set);
    }
}

void LoadedMap::prepare_images() {
    for (Tileset& set : map_.tilesets) {
        if (set.image.empty()) continue;
        images_.make_transparent(set.image, set.transparent);
        if (set.columns > 0) continue;
        const auto sheet = images_.get([this] { return user_; }, set.image);
        if (!sheet->found) continue;
        set.image_size = Vec2(sheet->picture.width(), sheet->picture.height());
        const int described = std::exchange(set.count, 0);
        set.count_tiles();
        set.count = std::max(set.count, described);
    }
    prepare_images(map_.layers);
}

void LoadedMap::prepare_images(const std::vector<maps::Layer>& layers) {
    for (const maps::Layer& layer : layers) {
        if (!layer.image.empty()) images_.make_transparent(layer.image, layer.transparent);
        prepare_images(layer.layers);
    }
}

void LoadedMap::add_shapes(const Tileset& set) {
    const Vec2 cell(map_.tile_width, map_.tile_height);
    for (const auto& [number, tile] : set.tiles) {
        TileShape shape;
        const double height = size_of(set, &tile).y;
        for (const Object& object : tile.collision) {
            Outline corners = corners_of(object);
            // From the upper left corner, y down, to the lower left one, y up.
            for (Vec2& p : corners) p = Vec2(p.x, height - p.y);
            if (object.kind == ObjectKind::polyline && corners.size() > 1)
                shape.lines.push_back(std::move(corners));
            else if (is_box(corners, Vec2(0, 0), cell))
                shape.whole = true;
            else if (corners.size() > 2)
                shape.polygons.push_back(std::move(corners));
        }
        if (shape.polygons.empty() && shape.lines.empty() && is_solid(tile)) shape.whole = true;
        if (shape.whole || !shape.polygons.empty() || !shape.lines.empty())
            shapes_.emplace(set.first_gid + number, std::move(shape));
    }
}

const TileShape* LoadedMap::shape(std::uint32_t tile) const {
    const auto found = shapes_.find(tile);
    return found == shapes_.end() ? nullptr : &found->second;
}

TileShape LoadedMap::flipped(const TileShape& shape, std::uint32_t flips, const Vec2& size) {
    TileShape made = shape;
    const PackedCell cell(flips);
    const bool mirrors = cell.has(PackedCell::flip_x) != cell.has(PackedCell::flip_y);
    for (auto* group : {&made.polygons, &made.lines})
        for (Outline& corners : *group) {
            for (Vec2& p : corners) {
                // A diagonal flip exchanges x and y in coordinates with y down.
                if (cell.has(PackedCell::flip_diagonal)) p = Vec2(size.y - p.y, size.x - p.x);
                if (cell.has(PackedCell::flip_x)) p.x = size.x - p.x;
                if (cell.has(PackedCell::flip_y)) p.y = size.y - p.y;
            }
            // A mirrored line would be solid from its other side.
            if (mirrors != cell.has(PackedCell::flip_diagonal)) std::ranges::reverse(corners);
        }
    return made;
}

const TileLook* LoadedMap::look(std::uint32_t tile) const {
    const auto found = looks_.find(tile);
    if (found != looks_.end()) return &found->second;
    if (map_.tileset_of(tile) == nullptr) return nullptr;
    return &looks_.emplace(tile, make_look(tile)).first->second;
}

TileLook LoadedMap::make_look(std::uint32_t number) const {
    const Tileset& set = *map_.tileset_of(number);
    const maps::Tile* const tile = map_.tile(number);
    const std::uint32_t in_set = number - set.first_gid;
    TileLook look;
    look.size = size_of(set, tile);
    look.offset = set.offset;
    const std::string& image = tile != nullptr && !tile->image.empty() ? tile->image : set.image;
    if (!image.empty()) look.sheet = images_.get([this] { return user_; }, image);
    if (image != set.image || set.columns <= 0) {
        if (look.sheet != nullptr)
            look.area = {0, 0, static_cast<double>(look.sheet->picture.width()),
                         static_cast<double>(look.sheet->picture.height())};
    } else {
        const auto columns = static_cast<std::uint32_t>(set.columns);
        const std::uint32_t column = in_set % columns, row = in_set / columns;
        look.area = {static_cast<double>(set.margin) +
                         static_cast<double>(column) * (set.tile_width + set.spacing),
                     static_cast<double>(set.margin) +
                         static_cast<double>(row) * (set.tile_height + set.spacing),
                     static_cast<double>(set.tile_width), static_cast<double>(set.tile_height)};
        // The checkerboard in place of a missing image is shown as a whole.
        if (look.sheet != nullptr && !look.sheet->found)
            look.area = {0, 0, static_cast<double>(look.sheet->picture.width()),
                         static_cast<double>(look.sheet->picture.height())};
    }
    if (tile == nullptr) return look;
    for (const maps::Frame& frame : tile->animation)
        if (frame.seconds > 0) {
            look.frames.push_back({set.first_gid + frame.tile, frame.seconds});
            look.seconds += frame.seconds;
        }
    return look;
}

std::uint32_t LoadedMap::frame(std::uint32_t tile, double seconds) const {
    const TileLook* const shown = look(tile);
    if (shown == nullptr || shown->frames.empty()) return tile;
    // The tolerance makes six steps of 1/60 s a tenth of a second.
    double rest = std::fmod(seconds + 1e-9, shown->seconds);
    for (const maps::Frame& frame : shown->frames) {
        if (rest < frame.seconds) return frame.tile;
        rest -= frame.seconds;
    }
    return shown->frames.back().tile;
}

const maps::Layer* LoadedMap::layer(std::int64_t id) const {
    return find_layer(map_.layers, id);
}

std::uint32_t LoadedMap::last_tile() const {
    std::uint32_t last = 0;
    for (const Tileset& set : map_.tilesets)
        last = std::max(last, set.first_gid + static_cast<std::uint32_t>(set.count) - 1);
    return last;
}

}  // namespace fettle::visuals
