// The methods of Tilemap: cells, places, properties of tiles.

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fettle/property/spelling.h>

#include <tilemaps/shortest_way.h>
#include <tilemaps/tilemaps.h>

namespace fettle::visuals {

using property::Effect;
using property::Field;
using property::Handle;
using property::Method;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

using Arguments = std::span<const Value>;

const Field x_field{
    .name = "x", .type = Type::integer, .doc = "Column, from 0 at the left, as the editor counts."};
const Field y_field{
    .name = "y", .type = Type::integer, .doc = "Row, from 0 at the top, as the editor counts."};
const Field layer_field{.name = "layer",
                        .type = Type::text,
                        .doc = "Name of a tile layer; the first one if it is left out."};
const Field tile_field{.name = "tile",
                       .type = Type::integer,
                       .doc =
                           "Number of a tile in the map, from 1: the first tileset has the first "
                           "numbers. 0: none."};

std::string cell_text(std::int64_t x, std::int64_t y) {
    return "cell (" + std::to_string(x) + ", " + std::to_string(y) + ")";
}

std::uint32_t valid_tile(const LoadedMap& map, const Value& value) {
    const std::int64_t tile = value.integer();
    if (tile == 0 || (tile > 0 && tile <= map.last_tile() &&
                      map.map().tileset_of(static_cast<std::uint32_t>(tile)) != nullptr))
        return static_cast<std::uint32_t>(tile);
    throw std::invalid_argument("tile " + std::to_string(tile) + ": the map has tiles 1 to " +
                                std::to_string(map.last_tile()) + ", and 0 is none");
}

/// In the rows of set_tiles: the cell is not changed.
constexpr std::int64_t leave_cell = -1;

/// Throws if the layer has no such cell.
void require_cells(const property::Tree& tree, Handle layer, const Grid& cells, std::int64_t x,
                   std::int64_t y) {
    if (cells.contains(x, y)) return;
    throw std::invalid_argument(
        cell_text(x, y) + " is outside of the layer \"" + tree.name(layer) + "\"" +
        (cells.width() == 0 ? ", which has no cells: set `cells` to their numbers"
                            : ": x goes from " + std::to_string(cells.left()) + " to " +
                                  std::to_string(cells.left() + cells.width() - 1) + ", y from " +
                                  std::to_string(cells.top()) + " to " +
                                  std::to_string(cells.top() + cells.height() - 1)));
}

}  // namespace

/// Throws if the map has neither a file nor a tileset.
std::shared_ptr<const LoadedMap> Tilemaps::required(Handle map) {
    std::shared_ptr<const LoadedMap> file = loaded(map);
    if (file == nullptr)
        throw std::invalid_argument(source(map).empty()
                                        ? "it has no map file and no tileset: set `map`, or "
                                          "`tileset` and `cells`"
                                        : "its map file or its tileset could not be read");
    return file;
}

/// The tile layer of that name, or the first one.
Handle Tilemaps::layer_named(Handle map, const Value& name) {
    (void)required(map);
    std::vector<std::string> names;
    for (const Handle layer : tile_layers(map)) {
        if (name.is_nil() || tree_->name(layer) == name.text()) return layer;
        names.push_back(tree_->name(layer));
    }
    if (name.is_nil()) throw std::invalid_argument("it has no tile layer");
    throw std::invalid_argument("it has no tile layer \"" + name.text() + "\"" +
                                property::suggestion(name.text(), names));
}

PackedCell Tilemaps::cell(Handle map, const Value& x, const Value& y, const Value& layer) {
    const Handle of = layer_named(map, layer);
    // A formula that calls this depends on the changes.
    (void)tree_->get(of, *in_layer_.changes);
    const Grid* const cells = grid(of);
    return cells == nullptr ? PackedCell() : cells->at(x.integer(), y.integer());
}

void Tilemaps::set_tile(Handle map, std::span<const Value> given) {
    const Handle layer = layer_named(map, given[3]);
    const std::uint32_t tile = valid_tile(*required(map), given[2]);
    std::uint32_t flips = 0;
    if (!given[4].is_nil() && !read_flips(given[4].text(), flips))
        throw std::invalid_argument("flips \"" + given[4].text() +
                                    "\": expected letters of \"x\", \"y\", \"d\"");
    const PackedCell next(tile == 0 ? 0 : tile | flips);
    const std::int64_t x = given[0].integer(), y = given[1].integer();
    require_cells(*tree_, layer, *grid(layer), x, y);
    const Grid::Cell cell{static_cast<int>(x), static_cast<int>(y), next};
    change_cells(map, layer, {&cell, 1});
}

/// Rows of tiles, from the cell (x, y) to the right and downwards.
void Tilemaps::set_tiles(Handle map, std::span<const Value> given) {
    const Handle layer = layer_named(map, given[3]);
    const auto file = required(map);
    const std::int64_t x = given[0].integer(), y = given[1].integer();
    if (!given[2].list().empty()) require_cells(*tree_, layer, *grid(layer), x, y);
    std::vector<Grid::Cell> cells;
    std::int64_t row = 0;
    for (const Value& tiles : given[2].list()) {
        if (!tiles.list().empty()) {
            const auto last = static_cast<std::int64_t>(tiles.list().size()) - 1;
            require_cells(*tree_, layer, *grid(layer), x + last, y + row);
        }
        std::int64_t column = 0;
        for (const Value& tile : tiles.list()) {
            if (!tile.is(Type::integer))
                throw std::invalid_argument(
                    "row " + std::to_string(row + 1) + ", element " + std::to_string(column + 1) +
                    ": expected the number of a tile, got " + property::value_text(tile));
            if (tile.integer() != leave_cell)
                cells.push_back({static_cast<int>(x + column), static_cast<int>(y + row),
                                 PackedCell(valid_tile(*file, tile))});
            ++column;
        }
        ++row;
    }
    change_cells(map, layer, cells);
}

/// Reports the cells that differ, all with one write of `changes`.
void Tilemaps::change_cells(Handle map, Handle layer, std::span<const Grid::Cell> all) {
    Grid& grid = *this->grid(layer);
    std::vector<Grid::Cell> cells;
    std::vector<PackedCell> before;
    for (const Grid::Cell& cell : all) {
        const PackedCell old = grid.at(cell.x, cell.y);
        if (old == cell.content) continue;
        cells.push_back(cell);
        before.push_back(old);
    }
    if (cells.empty()) return;
    const property::Row number = tree_->row(layer);
    const Value changed = grid.change(layer_rows_[number].changes, cells);
    try {
        tree_->set(layer, *in_layer_.changes, changed);
    } catch (...) {
        grid.set_changes(
            layer_rows_[number].changes);  // a formula that runs forbids it, for example
        throw;
    }
    layer_rows_[number].changes = tree_->peek(layer, *in_layer_.changes);
    rows_[tree_->row(map)].outdated = true;
    for (std::size_t i = 0; i < cells.size(); ++i)
        tree_->emit(
            map, *cell_changed_,
            {Value(layer), Value(std::int64_t{cells[i].x}), Value(std::int64_t{cells[i].y}),
             Value(std::int64_t{cells[i].content.tile()}), Value(std::int64_t{before[i].tile()})});
}

Vec2 Tilemaps::cell_at(Handle map, const Vec2& point) {
    const auto file = required(map);
    const Vec2 pixels = (point - upper_left(map, file->map())) * pixels_per_unit(map);
    return {std::floor(pixels.x / file->map().tile_width),
            std::floor(-pixels.y / file->map().tile_height)};
}

Vec2 Tilemaps::cell_center(Handle map, const Value& x, const Value& y) {
    const auto file = required(map);
    const Vec2 cell((static_cast<double>(x.integer()) + 0.5) * file->map().tile_width,
                    -(static_cast<double>(y.integer()) + 0.5) * file->map().tile_height);
    return upper_left(map, file->map()) + cell / pixels_per_unit(map);
}

Value Tilemaps::path(Handle map, const Vec2& from, const Vec2& to, bool diagonals) {
    const auto file = required(map);
    const std::vector<Handle> layers = tile_layers(map), solid = solid_layers(map);
    for (const Handle layer : layers) (void)tree_->get(layer, *in_layer_.changes);  // for formulas
    const auto is_free = [&](CellPlace at) {
        const auto has = [&](Handle layer) {
            const Grid* const cells = grid(layer);
            return cells != nullptr && cells->contains(at.x, at.y);
        };
        const auto is_solid = [&](Handle layer) {
            const Grid* const cells = grid(layer);
            const TileShape* const shape =
                cells == nullptr ? nullptr : file->shape(cells->at(at.x, at.y).tile());
            return shape != nullptr && (shape->whole || !shape->polygons.empty());
        };
        return std::ranges::any_of(layers, has) && std::ranges::none_of(solid, is_solid);
    };
    const auto place = [&](const Vec2& point) {
        constexpr double far = 1e8;
        const Vec2 cell = cell_at(map, point).max({-far, -far}).min({far, far});
        return CellPlace{static_cast<int>(cell.x), static_cast<int>(cell.y)};
    };
    const auto way = shortest_way(place(from), place(to), diagonals, is_free);
    if (!way) return {};
    property::List points;
    for (const CellPlace& cell : *way)
        points.emplace_back(
            cell_center(map, Value(std::int64_t{cell.x}), Value(std::int64_t{cell.y})));
    return Value(std::move(points));
}

Value Tilemaps::tile_property(Handle map, const Value& tile, const std::string& name) {
    const auto file = required(map);
    const std::uint32_t number = valid_tile(*file, tile);
    const maps::Tile* const found = file->map().tile(number);
    if (found == nullptr) return {};
    if (const auto at = found->properties.find(name); at != found->properties.end())
        return at->second;
    return name == "class" && !found->class_name.empty() ? Value(found->class_name) : Value();
}

namespace {

/// `call`: captureless lambda (Tilemaps&, Handle, Arguments) -> Result.
template <class Call>
Method method(Tilemaps& maps, Method described, Call) {
    described.context = &maps;
    described.call = [](void* context, property::Tree&, Handle self, property::Row,
                        Arguments given) -> property::Result {
        return Call{}(*static_cast<Tilemaps*>(context), self, given);
    };
    return described;
}

}  // namespace

std::vector<Method> Tilemaps::cell_methods() {
    return {
        method(*this,
               {.name = "tile",
                .parameters = {x_field, y_field, layer_field},
                .required = 2,
                .returns = {tile_field},
                .doc = "The tile of a cell; 0 if it is empty or outside of the layer.",
                .effect = Effect::nothing},
               [](Tilemaps& t, Handle self, Arguments given) -> property::Result {
                   return Value(std::int64_t{t.cell(self, given[0], given[1], given[2]).tile()});
               }),
        method(*this,
               {.name = "tile_flips",
                .parameters = {x_field, y_field, layer_field},
                .required = 2,
                .returns = {{.name = "flips",
                             .type = Type::text,
                             .doc = "Letters: x for left and right, y for top and bottom, d for "
                                    "the exchange of x and y before these."}},
                .doc = "How the tile of a cell is flipped.",
                .effect = Effect::nothing},
               [](Tilemaps& t, Handle self, Arguments given) -> property::Result {
                   return Value(flips_text(t.cell(self, given[0], given[1], given[2])));
               }),
        method(*this,
               {.name = "set_tile",
                .parameters = {x_field,
                               y_field,
                               tile_field,
                               layer_field,
                               {.name = "flips",
                                .type = Type::text,
                                .doc = "As tile_flips returns them; not flipped if it is left "
                                       "out."}},
                .required = 3,
                .doc = "Changes a cell. Its collisions follow at the next barrier, before the "
                       "next step.",
                .effect = Effect::tree},
               [](Tilemaps& t, Handle self, Arguments given) -> property::Result {
                   t.set_tile(self, given);
                   return Value();
               }),
        method(*this,
               {.name = "set_tiles",
                .parameters = {x_field,
                               y_field,
                               {.name = "rows",
                                .type = Type::list,
                                .doc = "A list of tiles for each row, downwards: 0 is an empty "
                                       "cell, -1 leaves the cell as it is.",
                                .element = Type::list},
                               layer_field},
                .required = 3,
                .doc = "Changes many cells at once, from column x and row y to the right and "
                       "downwards. For a whole level it takes a small part of the time of "
                       "set_tile for each cell.",
                .effect = Effect::tree},
               [](Tilemaps& t, Handle self, Arguments given) -> property::Result {
                   t.set_tiles(self, given);
                   return Value();
               }),
    };
}

std::vector<Method> Tilemaps::methods() {
    std::vector<Method> all = cell_methods();
    const std::vector<Method> others = {
        method(*this,
               {.name = "cell_at",
                .parameters = {{.name = "point",
                                .type = Type::vec2,
                                .unit = "m",
                                .doc = "A point in the world."}},
                .required = 1,
                .returns = {{.name = "cell",
                             .type = Type::vec2,
                             .doc = "Column and row, whole numbers; also outside of the map."}},
                .doc = "The cell at a point of the world.",
                .effect = Effect::nothing},
               [](Tilemaps& t, Handle self, Arguments given) -> property::Result {
                   return Value(t.cell_at(self, given[0].vec2()));
               }),
        method(*this,
               {.name = "cell_center",
                .parameters = {x_field, y_field},
                .required = 2,
                .returns = {{.name = "point",
                             .type = Type::vec2,
                             .unit = "m",
                             .doc = "The point in the world."}},
                .doc = "The middle of a cell.",
                .effect = Effect::nothing},
               [](Tilemaps& t, Handle self, Arguments given) -> property::Result {
                   return Value(t.cell_center(self, given[0], given[1]));
               }),
        method(
            *this,
            {.name = "path",
             .parameters =
                 {{.name = "from", .type = Type::vec2, .unit = "m", .doc = "A point in the world."},
                  {.name = "to", .type = Type::vec2, .unit = "m", .doc = "A point in the world."},
                  {.name = "diagonals",
                   .type = Type::boolean,
                   .doc = "Whether a step may lead over a corner, if both cells "
                          "beside it are free; true if it is left out."}},
             .required = 2,
             .returns = {{.name = "points",
                          .type = Type::list,
                          .doc = "The middles of the cells after that of `from`; nil if there "
                                 "is no way, or none that is found in 250 000 cells.",
                          .element = Type::vec2,
                          .nullable = true}},
             .doc = "The shortest way over cells without solid tiles.",
             .effect = Effect::nothing},
            [](Tilemaps& t, Handle self, Arguments given) -> property::Result {
                return t.path(self, given[0].vec2(), given[1].vec2(),
                              given[2].is_nil() || given[2].boolean());
            }),
        method(*this,
               {.name = "tile_property",
                .parameters = {tile_field,
                               {.name = "name",
                                .type = Type::text,
                                .doc = "Name of a custom property, or \"class\"."}},
                .required = 2,
                .returns = {{.name = "value",
                             .type = Type::nil,
                             .doc = "Its value; nil if the tile does not have it.",
                             .nullable = true}},
                .doc = "A custom property of a tile, as the editor saved it.",
                .effect = Effect::nothing},
               [](Tilemaps& t, Handle self, Arguments given) -> property::Result {
                   return t.tile_property(self, given[0], given[1].text());
               }),
        method(*this,
               {.name = "reload",
                .doc = "Reads the map file again and makes its instances again. Changed cells stay "
                       "changed in layers that the file still has.",
                .effect = Effect::tree},
               [](Tilemaps& t, Handle self, Arguments) -> property::Result {
                   t.reload(self);
                   return Value();
               }),
    };
    all.insert(all.end(), others.begin(), others.end());
    return all;
}

}  // namespace fettle::visuals
