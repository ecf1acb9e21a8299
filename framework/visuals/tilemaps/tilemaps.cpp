#include <tilemaps/tilemaps.h>

#include <array>
#include <bit>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string_view>

#include <fettle/property/storage/assets.h>

#include <properties/properties.h>

namespace fettle::visuals {

using property::Handle;
using property::Value;
using property::Vec2;

namespace {

constexpr std::array<std::string_view, 8> map_endings{".tmj", ".tmx", ".tsj",  ".tsx",
                                                      ".tj",  ".tx",  ".json", ".xml"};

}  // namespace

void Tilemaps::define(property::Tree& tree) {
    tree_ = &tree;
    define_map(tree);
    define_layer(tree);
    // The handlers run at the next barrier, which is before the next step.
    const auto follow = [this](const property::Occurrence& what) {
        Row& row = rows_[tree_->row(what.instance)];
        if (row.outdated) update_bodies(what.instance);
    };
    const property::Class& game = tree.class_of(tree.root());
    handlers_ = {tree.on(*map_class_, *loaded_event_, follow, {.label = "Tilemap"}),
                 tree.on(*map_class_, *cell_changed_, follow, {.label = "Tilemap"}),
                 // A map from a scene file or a clone has its instances already.
                 tree.on(*map_class_, *map_class_->event("ready"), follow, {.label = "Tilemap"}),
                 tree.on(tree.root(), *game.event("restored"),
                         [this](const property::Occurrence&) { report(); }, {.label = "Tilemap"})};
}

// The tree may outlive this object.
Tilemaps::~Tilemaps() {
    for (property::Connection& handler : handlers_) handler.stop();
}

bool Tilemaps::is_map(Handle instance) const {
    return instance && tree_->class_of(instance).is_a(*map_class_);
}

bool Tilemaps::is_layer(Handle instance) const {
    return tree_->class_of(instance).is_a(*layer_class_);
}

void Tilemaps::outdate(Handle map) {
    if (map && tree_->alive(map) && is_map(map)) rows_[tree_->row(map)].outdated = true;
}

void Tilemaps::report(Handle map, const std::string& problem) {
    images_.report(tree_->path(map) + ": " + problem);
}

// --- Files

std::shared_ptr<const LoadedMap> Tilemaps::loaded(Handle map) {
    const std::string& name = source(map);
    if (name.empty()) return nullptr;
    const auto known = files_.find(name);
    if (known != files_.end()) return known->second;
    return files_[name] = read(map);
}

EmptyMap Tilemaps::empty_map(Handle map) const {
    const auto whole = [](const Vec2& numbers) {
        return Vec2(std::floor(numbers.x), std::floor(numbers.y));
    };
    const Vec2 cells = whole(tree_->peek(map, *of_.cells).vec2());
    EmptyMap wanted{.tileset = tree_->peek(map, *of_.tileset).text(),
                    .columns = static_cast<int>(cells.x),
                    .rows = static_cast<int>(cells.y),
                    .tile_size = whole(tree_->peek(map, *of_.tile_size).vec2())};
    const Value solid_tiles = tree_->peek(map, *of_.solid_tiles);
    for (const Value& tile : solid_tiles.list())
        wanted.solid_tiles.push_back(static_cast<int>(tile.integer()));
    return wanted;
}

const std::string& Tilemaps::source(Handle map) {
    std::string& source = rows_[tree_->row(map)].source;
    if (!source.empty()) return source;
    source = tree_->peek(map, *of_.map).text();
    if (!source.empty()) return source;
    const EmptyMap wanted = empty_map(map);
    if (!wanted.tileset.empty()) source = wanted.key();
    return source;
}

std::shared_ptr<const LoadedMap> Tilemaps::read(Handle instance) {
    const std::string file = tree_->peek(instance, *of_.map).text();
    const std::string what = tree_->path(instance, file.empty() ? *of_.tileset : *of_.map);
    try {
        property::Assets* const assets = images_.assets();
        if (assets == nullptr) throw std::runtime_error("this program has no files");
        const auto content = [&](const std::string& name) {
            return assets->read(what, name, map_endings);
        };
        maps::Map map = file.empty() ? make_empty_map(empty_map(instance), what, images_, content)
                                     : maps::read_map(file, content);
        if (map.orientation != maps::Orientation::orthogonal)
            throw std::runtime_error(file + " is not an orthogonal map; others cannot be shown");
        return std::make_shared<const LoadedMap>(std::move(map), what, images_);
    } catch (const std::exception& error) {
        const std::string why = error.what();
        images_.report(why.starts_with(what) ? why : what + ": " + why);
        return nullptr;
    }
}

// --- Cells

Grid* Tilemaps::grid(Handle layer) {
    const Handle map = tree_->parent(layer);
    if (!is_map(map)) return nullptr;
    std::shared_ptr<const LoadedMap> file = loaded(map);
    if (file == nullptr) return nullptr;
    LayerRow& row = layer_rows_[tree_->row(layer)];
    const std::int64_t id = tree_->peek(layer, *in_layer_.layer).integer();
    const Value changes = tree_->peek(layer, *in_layer_.changes);
    if (row.file != file || row.id != id) {
        const maps::Layer* const found = file->layer(id);
        row.grid = found != nullptr ? Grid(*found) : Grid();
        row.grid.set_changes(changes);
    } else if (!(row.changes == changes)) {
        row.grid.set_changes(changes);
    }
    row.file = std::move(file);
    row.id = id;
    row.changes = changes;
    return &row.grid;
}

std::vector<Handle> Tilemaps::tile_layers(Handle map) const {
    std::vector<Handle> all;
    for (const Handle child : tree_->children(map))
        if (is_layer(child)) all.push_back(child);
    return all;
}

// --- Places

double Tilemaps::pixels_per_unit(Handle map) const {
    return Reader(*tree_, map).number(of_.pixels_per_unit);
}

Vec2 Tilemaps::upper_left(Handle map, const maps::Map& of) const {
    const double height = of.infinite ? 0 : of.height * of.tile_height / pixels_per_unit(map);
    return Reader(*tree_, map).vec2(of_.corner) + Vec2(0, height);
}

// --- Steps

void Tilemaps::step(double dt) {
    for (Row& row : rows_)
        if (row.self) row.time += dt;
}

void Tilemaps::report() {
    std::vector<Handle> outdated;
    for (const Row& row : rows_)
        if (row.self && row.outdated) outdated.push_back(row.self);
    for (const Handle map : outdated) {
        if (!tree_->alive(map)) continue;
        make_if_new(map);
        if (tree_->alive(map)) update_bodies(map);
    }
}

void Tilemaps::restored() {
    for (Row& row : rows_) {
        row.outdated = true;
        row.source.clear();
    }
}

std::uint64_t Tilemaps::hash() const {
    std::uint64_t hash = 0;
    tree_->each_below(tree_->root(), [&](Handle instance) {
        if (!is_map(instance)) return;
        const double time = rows_[tree_->row(instance)].time;
        hash = (hash ^ std::bit_cast<std::uint64_t>(time)) * 0x9e3779b97f4a7c15u;
    });
    return hash;
}

}  // namespace fettle::visuals
