#include <tilemaps/solid_outlines.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace fettle::visuals {

using maps::Outline;
using property::Vec2;

namespace {

/// Consecutive cells of a row that are solid as a whole.
struct Run {
    int from = 0, to = 0;  // `to` is not in it
    bool operator==(const Run&) const = default;
};

class Collector {
  public:
    Collector(const Grid& grid, const LoadedMap& map)
        : grid_(grid), map_(map), cell_(map.map().tile_width, map.map().tile_height) {}

    std::vector<SolidLine> run() {
        const int bottom = grid_.top() + grid_.height();
        std::vector<Run> above, here;
        int since = grid_.top();  // the row in which the runs of `above` began
        for (int y = grid_.top(); y <= bottom; ++y) {
            here.clear();
            if (y < bottom) read_row(y, here);
            if (here == above) continue;
            for (const Run& run : above) add_box(run, since, y);
            std::swap(here, above);
            since = y;
        }
        std::vector<SolidLine> all;
        for (Outline& outline : maps::merged_outlines(polygons_)) {
            // Tiles are solid inside, and bodies stay on the left side of a line.
            std::ranges::reverse(outline);
            all.push_back({std::move(outline), true});
        }
        join_lines(all);
        return all;
    }

  private:
    void read_row(int y, std::vector<Run>& runs) {
        const PackedCell* const row = grid_.row(y);
        for (int i = 0; i < grid_.width(); ++i) {
            const TileShape* const shape = row[i].bits == 0 ? nullptr : shape_of(row[i].tile());
            if (shape == nullptr) continue;
            const int x = grid_.left() + i;
            if (shape->whole) {
                if (runs.empty() || runs.back().to != x) runs.push_back({x, x});
                runs.back().to = x + 1;
            }
            if (!shape->polygons.empty() || !shape->lines.empty()) add_shapes(*shape, row[i], x, y);
        }
    }

    /// Neighbors are often of the same tile.
    const TileShape* shape_of(std::uint32_t tile) {
        if (tile != last_) {
            last_ = tile;
            shape_ = map_.shape(tile);
        }
        return shape_;
    }

    void add_box(const Run& run, int top, int bottom) {
        const double left = run.from * cell_.x, right = run.to * cell_.x;
        const double upper = -top * cell_.y, lower = -bottom * cell_.y;
        polygons_.push_back({{left, lower}, {right, lower}, {right, upper}, {left, upper}});
    }

    void add_shapes(const TileShape& shape, PackedCell cell, int x, int y) {
        const TileLook* const look = map_.look(cell.tile());
        const Vec2 corner(x * cell_.x, -(y + 1) * cell_.y);
        const TileShape placed =
            LoadedMap::flipped(shape, cell.bits & PackedCell::flips, look->size);
        const auto move = [&](Outline points) {
            for (Vec2& p : points) p += corner;
            return points;
        };
        for (const Outline& each : placed.polygons) polygons_.push_back(move(each));
        for (const Outline& each : placed.lines) lines_.push_back(move(each));
    }

    // --- Lines

    static std::pair<std::int64_t, std::int64_t> key(const Vec2& p) {
        return {std::llround(p.x * 256), std::llround(p.y * 256)};
    }

    /// Joins lines where one begins at the end of another.
    void join_lines(std::vector<SolidLine>& all) const {
        std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> begins;
        std::map<std::pair<std::int64_t, std::int64_t>, int> ends;
        for (std::size_t i = lines_.size(); i-- > 0;) {
            begins[key(lines_[i].front())].push_back(i);
            ++ends[key(lines_[i].back())];
        }
        std::vector<bool> used(lines_.size());
        const auto follow = [&](std::size_t first) {
            std::vector<Vec2> points;
            for (std::size_t next = first;;) {
                used[next] = true;
                for (const Vec2& p : lines_[next]) append(points, p);
                auto& after = begins[key(points.back())];
                while (!after.empty() && used[after.back()]) after.pop_back();
                if (after.empty()) break;
                next = after.back();
            }
            const bool closed = points.size() > 3 && key(points.front()) == key(points.back());
            if (closed) points.pop_back();
            if (points.size() > 1) all.push_back({std::move(points), closed});
        };
        // First the lines to which no other line leads, then the rest, which are rings.
        for (std::size_t i = 0; i < lines_.size(); ++i)
            if (!used[i] && !ends.contains(key(lines_[i].front()))) follow(i);
        for (std::size_t i = 0; i < lines_.size(); ++i)
            if (!used[i]) follow(i);
    }

    /// Leaves out points in the middle of a straight line.
    static void append(std::vector<Vec2>& points, const Vec2& p) {
        if (!points.empty() && key(points.back()) == key(p)) return;
        if (points.size() > 1) {
            const Vec2 before = points.back() - points[points.size() - 2];
            const Vec2 after = p - points.back();
            const double turn = before.x * after.y - before.y * after.x;
            if (std::abs(turn) <= 1e-9 * before.length() * after.length() && before.dot(after) > 0)
                points.pop_back();
        }
        points.push_back(p);
    }

    const Grid& grid_;
    const LoadedMap& map_;
    const Vec2 cell_;
    std::uint32_t last_ = 0;
    const TileShape* shape_ = nullptr;
    std::vector<Outline> polygons_, lines_;
};

}  // namespace

std::vector<SolidLine> solid_lines(const Grid& grid, const LoadedMap& map) {
    if (grid.width() == 0 || grid.height() == 0) return {};
    return Collector(grid, map).run();
}

}  // namespace fettle::visuals
