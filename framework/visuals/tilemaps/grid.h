#pragma once
// The cells of a layer: those of the file, and the changes of the game.

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include <fettle/maps/map.h>
#include <fettle/property/value.h>

namespace fettle::visuals {

/// A cell in four bytes: the number of its tile, and its flips in the highest bits.
struct PackedCell {
    static constexpr std::uint32_t flip_x = 1u << 31, flip_y = 1u << 30, flip_diagonal = 1u << 29;
    static constexpr std::uint32_t flips = flip_x | flip_y | flip_diagonal;

    std::uint32_t bits = 0;

    PackedCell() = default;
    explicit PackedCell(std::uint32_t all) : bits(all) {}
    explicit PackedCell(const maps::Cell& cell)
        : bits((cell.gid & ~flips) | (cell.flip_x ? flip_x : 0) | (cell.flip_y ? flip_y : 0) |
               (cell.flip_diagonal ? flip_diagonal : 0)) {}
    std::uint32_t tile() const { return bits & ~flips; }
    bool has(std::uint32_t flip) const { return (bits & flip) != 0; }
    bool operator==(const PackedCell&) const = default;
};

/// Flips as letters: "x", "y", and "d" for the exchange of x and y; "" for none.
std::string flips_text(PackedCell cell);
/// False for a text with other letters.
bool read_flips(const std::string& text, std::uint32_t& flips);

class Grid {
  public:
    Grid() = default;
    /// The cells of a layer of a file.
    explicit Grid(const maps::Layer& layer);

    int left() const { return left_; }
    int top() const { return top_; }
    int width() const { return width_; }
    int height() const { return height_; }
    bool contains(std::int64_t x, std::int64_t y) const {
        return x >= left_ && y >= top_ && x < std::int64_t{left_} + width_ &&
               y < std::int64_t{top_} + height_;
    }
    /// An empty cell outside of the grid.
    PackedCell at(std::int64_t x, std::int64_t y) const {
        return contains(x, y) ? cells_[index(x, y)] : PackedCell();
    }
    /// Cells of a row that `contains` it, from `left`.
    const PackedCell* row(int y) const { return &cells_[index(left_, y)]; }

    /// Puts all changes in place of those that were there. A text that is not a change is skipped.
    void set_changes(const property::Value& list);
    struct Cell {
        int x = 0, y = 0;
        PackedCell content{};
    };
    /// Changes cells of the grid, in neighboring rows, and returns `list`, which must have been
    /// given to `set_changes`, with the changes.
    property::Value change(const property::Value& list, std::span<const Cell> cells);

  private:
    std::size_t index(std::int64_t x, std::int64_t y) const {
        return static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x - left_);
    }
    using Row = std::map<int, PackedCell>;  // by x
    static std::string text(int y, const Row& row);
    void read_row(const std::string& text);
    void put(const Cell& cell);
    bool is_written_as(const property::List& rows) const;

    int left_ = 0, top_ = 0, width_ = 0, height_ = 0;
    std::vector<PackedCell> cells_{};
    std::map<int, Row> changes_{};              // by y
    std::map<std::size_t, PackedCell> file_{};  // what the file has in changed cells, by index
    bool in_order_ = true;  // the list that was given has exactly the texts of `changes_`
};

}  // namespace fettle::visuals
