#include <tilemaps/grid.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace fettle::visuals {

using property::List;
using property::Type;
using property::Value;

std::string flips_text(PackedCell cell) {
    std::string text;
    if (cell.has(PackedCell::flip_x)) text += 'x';
    if (cell.has(PackedCell::flip_y)) text += 'y';
    if (cell.has(PackedCell::flip_diagonal)) text += 'd';
    return text;
}

bool read_flips(const std::string& text, std::uint32_t& flips) {
    flips = 0;
    for (const char letter : text) {
        const std::uint32_t flip = letter == 'x'   ? PackedCell::flip_x
                                   : letter == 'y' ? PackedCell::flip_y
                                   : letter == 'd' ? PackedCell::flip_diagonal
                                                   : 0;
        if (flip == 0 || (flips & flip) != 0) return false;
        flips |= flip;
    }
    return true;
}

Grid::Grid(const maps::Layer& layer) {
    constexpr int none = std::numeric_limits<int>::max();
    int left = none, top = none;
    std::int64_t right = std::numeric_limits<int>::min(), bottom = right;
    for (const maps::Cells& part : layer.cells) {
        if (part.width == 0 || part.height == 0) continue;
        left = std::min(left, part.x);
        top = std::min(top, part.y);
        right = std::max(right, std::int64_t{part.x} + part.width);
        bottom = std::max(bottom, std::int64_t{part.y} + part.height);
    }
    if (left == none) return;
    // The parts of an infinite map may lie far from each other.
    constexpr std::int64_t most = std::int64_t{1} << 26;
    if ((right - left) * (bottom - top) > most) return;
    left_ = left;
    top_ = top;
    width_ = static_cast<int>(right - left);
    height_ = static_cast<int>(bottom - top);
    cells_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    for (const maps::Cells& part : layer.cells) {
        auto from = part.cells.begin();
        for (int y = 0; y < part.height; ++y)
            for (int x = 0; x < part.width; ++x)
                cells_[index(part.x + x, part.y + y)] = PackedCell(*from++);
    }
}

std::string Grid::text(int y, const Row& row) {
    std::string text = std::to_string(y) + ":";
    for (const auto& [x, cell] : row)
        text += " " + std::to_string(x) + "=" + std::to_string(cell.tile()) + flips_text(cell);
    return text;
}

/// A row as `text` writes it.
void Grid::read_row(const std::string& text) {
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto number = [&](int& into) {
        const auto found = std::from_chars(at, end, into);
        if (found.ec != std::errc()) return false;
        at = found.ptr;
        return true;
    };
    const auto sign = [&](char wanted) { return at != end && *at++ == wanted; };
    int y = 0, x = 0, tile = 0;
    if (!number(y) || !sign(':')) return;
    while (at != end) {
        if (!sign(' ') || !number(x) || !sign('=') || !number(tile) || tile < 0) return;
        const char* const letters = at;
        while (at != end && *at != ' ') ++at;
        std::uint32_t flips = 0;
        if (!read_flips(std::string(letters, at), flips)) return;
        if (!contains(x, y)) continue;
        const PackedCell cell((static_cast<std::uint32_t>(tile) & ~PackedCell::flips) | flips);
        file_.try_emplace(index(x, y), cells_[index(x, y)]);
        cells_[index(x, y)] = cell;
        changes_[y][x] = cell;
    }
}

void Grid::set_changes(const Value& list) {
    for (const auto& [at, cell] : file_) cells_[at] = cell;
    file_.clear();
    changes_.clear();
    in_order_ = true;
    if (!list.is(Type::list)) return;
    for (const Value& row : list.list())
        if (row.is(Type::text)) read_row(row.text());
    in_order_ = is_written_as(list.list());
}

bool Grid::is_written_as(const List& rows) const {
    if (rows.size() != changes_.size()) return false;
    auto row = rows.begin();
    for (const auto& [y, cells] : changes_)
        if (!row->is(Type::text) || (row++)->text() != text(y, cells)) return false;
    return true;
}

void Grid::put(const Cell& cell) {
    const auto& [x, y, content] = cell;
    const PackedCell in_file = file_.try_emplace(index(x, y), at(x, y)).first->second;
    cells_[index(x, y)] = content;
    if (content != in_file) {
        changes_[y][x] = content;
        return;
    }
    // A cell that is as in the file again is not a change.
    file_.erase(index(x, y));
    const auto row = changes_.find(y);
    if (row == changes_.end()) return;
    row->second.erase(x);
    if (row->second.empty()) changes_.erase(row);
}

Value Grid::change(const Value& list, std::span<const Cell> cells) {
    if (cells.empty()) return list;
    const auto changed = std::ranges::minmax(cells, {}, &Cell::y);
    const auto begin = [&] { return changes_.lower_bound(changed.min.y); };
    const auto end = [&] { return changes_.upper_bound(changed.max.y); };
    const auto number = std::distance(changes_.begin(), begin());
    const auto replaced = std::distance(begin(), end());
    for (const Cell& cell : cells) put(cell);
    List rows = in_order_ && list.is(Type::list) ? list.list() : List{};
    auto from = begin(), to = end();
    if (in_order_) {
        const auto first = rows.begin() + number;
        const auto now = std::distance(from, to);
        if (now < replaced)
            rows.erase(first, first + (replaced - now));
        else
            rows.insert(first, static_cast<std::size_t>(now - replaced), Value());
    } else {
        // A script has written the list in another form.
        in_order_ = true;
        rows.resize(changes_.size());
        from = changes_.begin();
        to = changes_.end();
    }
    auto row = rows.begin() + std::distance(changes_.begin(), from);
    for (; from != to; ++from, ++row) *row = Value(text(from->first, from->second));
    return Value(std::move(rows));
}

}  // namespace fettle::visuals
