// A*: of the cells that were reached, the next is the one with the least estimate of the whole way
// through it. The estimate is never too long, so the first way that is found is the shortest.

#include <tilemaps/shortest_way.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <queue>
#include <tuple>
#include <unordered_map>

namespace fettle::visuals {

namespace {

constexpr int straight = 10, diagonal = 14;  // lengths of steps; whole numbers are exact
constexpr std::size_t most_cells = 250'000;

struct Reached {
    CellPlace before{};
    int length = 0;  // of the way from the beginning
};

struct Open {
    int estimate = 0;      // of the whole way
    int left = 0;          // the estimated rest of it: of equal ways, the nearer end is first
    std::uint64_t number;  // in the order in which cells were reached
    CellPlace cell{};
    bool operator<(const Open& other) const {  // the greatest comes first in a queue
        return std::tie(other.estimate, other.left, other.number) <
               std::tie(estimate, left, number);
    }
};

std::uint64_t key(CellPlace cell) {
    return std::uint64_t{static_cast<std::uint32_t>(cell.x)} << 32 |
           static_cast<std::uint32_t>(cell.y);
}

int least_length(CellPlace from, CellPlace to, bool diagonals) {
    const int across = std::abs(to.x - from.x), down = std::abs(to.y - from.y);
    if (!diagonals) return straight * (across + down);
    return straight * std::max(across, down) + (diagonal - straight) * std::min(across, down);
}

}  // namespace

std::optional<std::vector<CellPlace>> shortest_way(CellPlace from, CellPlace to, bool diagonals,
                                                   const std::function<bool(CellPlace)>& is_free) {
    if (from == to) return std::vector<CellPlace>();
    if (!is_free(to)) return std::nullopt;
    std::unordered_map<std::uint64_t, Reached> reached{{key(from), {from, 0}}};
    std::priority_queue<Open> open;
    std::uint64_t number = 0;
    const auto add = [&](CellPlace cell, CellPlace before, int length) {
        const auto [found, is_new] = reached.try_emplace(key(cell), Reached{before, length});
        if (!is_new && found->second.length <= length) return;
        found->second = {before, length};
        const int left = least_length(cell, to, diagonals);
        open.push({length + left, left, number++, cell});
    };
    open.push({least_length(from, to, diagonals), 0, number++, from});
    while (!open.empty() && reached.size() < most_cells) {
        const CellPlace here = open.top().cell;
        const int estimate = open.top().estimate, length = reached.at(key(here)).length;
        open.pop();
        if (here == to) break;
        // A shorter way to this cell was found later, and then the cell was open again.
        if (estimate > length + least_length(here, to, diagonals)) continue;
        for (const auto [x, y] : {CellPlace{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
            if (const CellPlace next{here.x + x, here.y + y}; is_free(next))
                add(next, here, length + straight);
        if (!diagonals) continue;
        for (const auto [x, y] : {CellPlace{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})
            if (const CellPlace next{here.x + x, here.y + y};
                is_free(next) && is_free({next.x, here.y}) && is_free({here.x, next.y}))
                add(next, here, length + diagonal);
    }
    if (!reached.contains(key(to))) return std::nullopt;
    std::vector<CellPlace> way;
    for (CellPlace at = to; at != from; at = reached.at(key(at)).before) way.push_back(at);
    std::ranges::reverse(way);
    return way;
}

}  // namespace fettle::visuals
