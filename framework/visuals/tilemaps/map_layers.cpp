// The instances below a Tilemap: one for each layer of its file.

#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/error.h>

#include <properties/properties.h>
#include <tilemaps/map_objects.h>
#include <tilemaps/tilemaps.h>

namespace fettle::visuals {

using property::Handle;
using property::List;
using property::Value;
using property::Vec2;

namespace {

/// The settings of the groups around a layer.
struct Outer {
    Vec2 offset{0, 0};  // px, y down
    Vec2 parallax{1, 1};
    double opacity = 1;
    property::Color tint{1, 1, 1, 1};
    bool visible = true;

    Outer with(const maps::Layer& layer) const {
        Outer all = *this;
        all.offset += layer.offset;
        all.parallax = all.parallax.times(layer.parallax);
        all.opacity *= layer.opacity;
        all.tint = {tint.r * layer.tint.r, tint.g * layer.tint.g, tint.b * layer.tint.b,
                    tint.a * layer.tint.a};
        all.visible = visible && layer.visible;
        return all;
    }
};

class LayerMaker {
  public:
    LayerMaker(property::Tree& tree, Handle map, const LoadedMap& file, Images& images,
               MapPlace place, bool smooth, std::map<std::int64_t, Value> changes, Maker& maker)
        : tree_(tree),
          map_(map),
          file_(file),
          images_(images),
          place_(place),
          smooth_(smooth),
          changes_(std::move(changes)),
          make_(maker) {}

    List run() {
        make_all(file_.map().layers, {});
        make_.resolve_references();
        return std::move(made_);
    }

  private:
    void make_all(const std::vector<maps::Layer>& layers, const Outer& outer) {
        for (const maps::Layer& layer : layers) {
            const Outer now = outer.with(layer);
            if (layer.kind == maps::LayerKind::group) {
                make_all(layer.layers, now);
                continue;
            }
            const char* const of = layer.kind == maps::LayerKind::tiles ? "TileLayer" : "Layer";
            make_.begin_messages("layer \"" + layer.name + "\"");
            const Handle made = make_.add(tree_.class_named(of), map_, layer.name);
            made_.emplace_back(made);
            make_.set(made, "parallax", Value(now.parallax));
            make_.set(made, "opacity", Value(now.opacity));
            make_.set(made, "visible", Value(now.visible));
            if (layer.kind == maps::LayerKind::tiles) tiles(made, layer, now);
            if (layer.kind == maps::LayerKind::image) image(made, layer, now);
            make_.set_custom(made, layer.properties);
            if (layer.kind == maps::LayerKind::objects)
                make_objects(make_, file_, layer, made, place_.moved(now.offset), smooth_);
        }
    }

    /// Cells that stay empty because no tileset has their tile.
    void report_unknown_tiles(const maps::Layer& layer) {
        std::size_t count = 0;
        std::uint32_t first = 0;
        for (const maps::Cells& cells : layer.cells)
            for (const maps::Cell& cell : cells.cells) {
                if (cell.empty() || file_.map().tileset_of(cell.gid) != nullptr) continue;
                if (count++ == 0) first = cell.gid;
            }
        if (count == 0) return;
        make_.report("no tileset has the tile " + std::to_string(first) + "; " +
                     (count == 1 ? "one cell stays" : std::to_string(count) + " cells stay") +
                     " empty");
    }

    void tiles(Handle made, const maps::Layer& layer, const Outer& now) {
        report_unknown_tiles(layer);
        make_.set(made, "layer", Value(layer.id));
        make_.set(made, "offset", Value(place_.length(now.offset)));
        make_.set(made, "tint", Value(now.tint));
        if (const auto kept = changes_.find(layer.id); kept != changes_.end())
            make_.set(made, "changes", kept->second);
    }

    void image(Handle made, const maps::Layer& layer, const Outer& now) {
        if (layer.image.empty()) return;
        const Handle sprite = make_.add(tree_.class_named("Sprite"), made, "image");
        const double unit = 1 / place_.pixels_per_unit;
        make_.set(sprite, "image", Value(layer.image));
        make_.set(sprite, "position", Value(place_.point(now.offset)));
        make_.set(sprite, "pixels_per_unit", Value(place_.pixels_per_unit));
        make_.set(sprite, "origin", Value(Vec2(0, 1)));
        make_.set(sprite, "tint", Value(now.tint));
        make_.set(sprite, "smooth", Value(smooth_));
        const auto sheet = images_.get([&] { return tree_.path(sprite) + ".image"; }, layer.image);
        if (layer.repeat_x) make_.set(made, "repeat_x", Value(sheet->picture.width() * unit));
        if (layer.repeat_y) make_.set(made, "repeat_y", Value(sheet->picture.height() * unit));
    }

    property::Tree& tree_;
    Handle map_;
    const LoadedMap& file_;
    Images& images_;
    MapPlace place_;
    bool smooth_;
    std::map<std::int64_t, Value> changes_;  // by layer
    Maker& make_;
    List made_;
};

}  // namespace

void Tilemaps::make_if_new(Handle map) {
    const std::string before = tree_->peek(map, *of_.made_from).text(), now = source(map);
    if (before == now) return;
    try {
        // Another file has other layers, so nothing of the old cells is kept.
        const bool same_layer = is_empty_map(before) && is_empty_map(now);
        make(map, same_layer ? changes_of(map) : std::map<std::int64_t, Value>());
    } catch (const property::Error& error) {
        // A snapshot is being restored, which makes all instances itself.
        if (error.kind() != property::ErrorKind::bad_structure) report(map, error.what());
    } catch (const std::exception& error) {
        report(map, error.what());
    }
}

/// `changes`: those that the new layers begin with, by the number of the layer.
void Tilemaps::make(Handle map, std::map<std::int64_t, Value> changes) {
    const Value made = tree_->peek(map, *of_.made);
    for (const Value& each : made.list())
        if (each.reference() != map && tree_->alive(each.reference()) &&
            tree_->is_below(each.reference(), map))
            tree_->destroy(each.reference());
    tree_->reset(map, *of_.followed);
    const std::string name = tree_->peek(map, *of_.map).text();
    const auto file = loaded(map);
    if (file == nullptr) {
        tree_->reset(map, *of_.made);
        tree_->reset(map, *of_.made_from);
        return;
    }
    const Reader read(*tree_, map);
    Maker maker(*tree_, [&](const std::string& what) {
        report(map, (name.empty() ? std::string() : name + ": ") + what);
    });
    maker.begin_messages("the map");
    maker.set_custom(map, file->map().properties);
    List layers = LayerMaker(*tree_, map, *file, images_,
                             {upper_left(map, file->map()), pixels_per_unit(map)},
                             read.flag(of_.smooth), std::move(changes), maker)
                      .run();
    tree_->set(map, *of_.made, Value(std::move(layers)));
    tree_->set(map, *of_.made_from, Value(source(map)));
    rows_[tree_->row(map)].outdated = true;
    tree_->emit(map, *loaded_event_, {});
}

std::map<std::int64_t, Value> Tilemaps::changes_of(Handle map) const {
    std::map<std::int64_t, Value> changes;
    for (const Handle layer : tile_layers(map))
        changes[tree_->peek(layer, *in_layer_.layer).integer()] =
            tree_->peek(layer, *in_layer_.changes);
    return changes;
}

void Tilemaps::reload(Handle map) {
    std::map<std::int64_t, Value> changes = changes_of(map);
    const auto before = files_.find(source(map));
    if (before != files_.end()) {
        // A file that has become unreadable changes nothing.
        const auto now = read(map);
        if (now == nullptr) return;
        before->second = now;
    }
    make(map, std::move(changes));
}

void Tilemaps::renew(const std::string& file) {
    const std::filesystem::path changed = std::filesystem::path(file).lexically_normal();
    // A tileset or a template may be part of any map.
    const std::string ending = changed.extension().string();
    const bool part = ending == ".tsj" || ending == ".tsx" || ending == ".tj" || ending == ".tx";
    std::vector<Handle> outdated;
    for (const Row& row : rows_) {
        if (!tree_->alive(row.self)) continue;
        const auto is_named = [&](const property::Property& by) {
            const std::filesystem::path name = tree_->peek(row.self, by).text();
            return !name.empty() && name.lexically_normal() == changed;
        };
        if (part || is_named(*of_.map) || is_named(*of_.tileset)) outdated.push_back(row.self);
    }
    for (const Handle map : outdated)
        if (tree_->alive(map)) reload(map);
}

}  // namespace fettle::visuals
