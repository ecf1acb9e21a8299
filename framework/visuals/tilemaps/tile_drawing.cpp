// Drawing of the cells that are in view.

#include <algorithm>
#include <cmath>

#include <properties/properties.h>
#include <tilemaps/tilemaps.h>

namespace fettle::visuals {

using property::Handle;
using property::Painter;
using property::Transform;
using property::Vec2;

namespace {

Transform inverse(const Transform& t) {
    const double area = t.area();
    Transform back;
    back.x = Vec2(t.y.y, -t.x.y) / area;
    back.y = Vec2(-t.y.x, t.x.x) / area;
    back.origin = -back.direction(t.origin);
    return back;
}

/// Cells from `first` to `last`, both in it.
struct Span {
    int first = 0, last = -1;
};

/// The cells along an axis that lie between two pixels. `begin` and `count`: those of the grid.
Span cells_between(double lower, double upper, double cell, int begin, int count) {
    const double end = std::int64_t{begin} + count - 1;
    if (!(upper >= lower)) return {};
    return {static_cast<int>(std::clamp(std::floor(lower / cell), double(begin), end + 1)),
            static_cast<int>(std::clamp(std::floor(upper / cell), double(begin) - 1, end))};
}

/// Draws single tiles. The transform of the painter maps pixels of the map, y up.
class TilePainter {
  public:
    TilePainter(Painter& painter, const LoadedMap& map, double time, property::Color tint,
                bool smooth)
        : painter_(painter), map_(map), time_(time), tint_(tint), smooth_(smooth) {}

    /// `corner`: the lower left one of the cell.
    void draw(PackedCell cell, const Vec2& corner) {
        if (cell.tile() != last_) {
            last_ = cell.tile();
            placed_ = map_.look(last_);
            shown_ = map_.look(map_.frame(last_, time_));
        }
        if (placed_ == nullptr || shown_ == nullptr || shown_->sheet == nullptr) return;
        const Vec2 at = corner + Vec2(placed_->offset.x, -placed_->offset.y);
        const Vec2 size = shown_->size;
        if (cell.has(PackedCell::flip_diagonal)) return turned(cell, at, size);
        double left = at.x, right = at.x + size.x;
        double bottom = at.y, top = at.y + size.y;
        if (cell.has(PackedCell::flip_x)) std::swap(left, right);
        if (cell.has(PackedCell::flip_y)) std::swap(bottom, top);
        picture({left, bottom}, {right, top});
    }

  private:
    /// With x and y exchanged, then flipped.
    void turned(PackedCell cell, const Vec2& at, const Vec2& size) {
        // Pixels of the tile from its upper left corner, y down, exchanged and moved to the cell.
        Transform map{Vec2(0, -1), Vec2(1, 0), at + Vec2(0, size.x)};
        if (cell.has(PackedCell::flip_x)) {
            map.y = -map.y;
            map.origin.x += size.y;
        }
        if (cell.has(PackedCell::flip_y)) {
            map.x = -map.x;
            map.origin.y -= size.x;
        }
        painter_.push(map);
        // `picture` expects y up.
        picture({0, size.y}, {size.x, 0});
        painter_.pop();
    }
    void picture(const Vec2& lower, const Vec2& upper) {
        painter_.picture(shown_->sheet->picture, shown_->area, lower, upper, tint_, smooth_);
    }

    Painter& painter_;
    const LoadedMap& map_;
    const double time_;
    const property::Color tint_;
    const bool smooth_;
    std::uint32_t last_ = 0;
    const TileLook *placed_ = nullptr, *shown_ = nullptr;
};

}  // namespace

void Tilemaps::draw(Handle layer, Painter& painter) {
    const Reader read(*tree_, layer);
    const double opacity = read.number(in_layer_.opacity);
    if (!read.flag(in_layer_.visible) || opacity <= 0) return;
    const Grid* const cells = grid(layer);
    if (cells == nullptr || cells->width() == 0) return;
    const Handle map = tree_->parent(layer);
    const LoadedMap& file = *layer_rows_[tree_->row(layer)].file;
    const double unit = 1 / pixels_per_unit(map);
    const Vec2 scroll = (Vec2(1, 1) - read.vec2(in_layer_.parallax)).times(painter.seen().center);
    const Vec2 origin = upper_left(map, file.map()) + read.vec2(in_layer_.offset) + scroll;
    painter.push({Vec2(unit, 0), Vec2(0, unit), origin});
    if (opacity < 1) painter.fade(static_cast<float>(opacity));
    const property::Blend blend = blend_of(read.value(in_layer_.blend));
    if (blend != property::Blend::normal) painter.blend(blend);

    // The visible part, in pixels of the map, y up.
    const property::Seen seen = painter.seen();
    const Transform back = inverse(painter.transform());
    Vec2 lower = back(seen.lower), upper = lower;
    for (const Vec2& corner :
         {seen.upper, Vec2(seen.lower.x, seen.upper.y), Vec2(seen.upper.x, seen.lower.y)}) {
        lower = lower.min(back(corner));
        upper = upper.max(back(corner));
    }
    const Vec2 cell(file.map().tile_width, file.map().tile_height);
    const Vec2 reach = file.reach();
    const Span across =
        cells_between(lower.x - reach.x, upper.x + reach.x, cell.x, cells->left(), cells->width());
    const Span down = cells_between(-upper.y - reach.y, -lower.y + reach.y, cell.y, cells->top(),
                                    cells->height());
    TilePainter tiles(painter, file, rows_[tree_->row(map)].time, read.color(in_layer_.tint),
                      Reader(*tree_, map).flag(of_.smooth));
    for (int y = down.first; y <= down.last; ++y) {
        const PackedCell* const row = cells->row(y);
        for (int x = across.first; x <= across.last; ++x) {
            const PackedCell here = row[x - cells->left()];
            if (here.bits != 0) tiles.draw(here, Vec2(x * cell.x, -(y + 1) * cell.y));
        }
    }
    painter.pop();
}

}  // namespace fettle::visuals
