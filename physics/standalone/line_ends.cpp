#include <standalone/line_ends.h>

#include <algorithm>
#include <tuple>

namespace fettle::physics::detail {

LineEnds::LineEnds(std::span<const std::vector<Vec2>> lines, float reach)
    : lines_(lines), most_(reach * reach), used_(lines.size()) {
    for (uint32_t i = 0; i < lines.size(); ++i)
        for (const bool last : {false, true}) ends_.push_back({i, last});
    std::sort(ends_.begin(), ends_.end(), [this](const End& a, const End& b) {
        const Vec2 p = place_of(a), q = place_of(b);
        return std::tie(p.x, p.y, a.last, a.line) < std::tie(q.x, q.y, b.last, b.line);
    });
    std::vector<Place> places = gather_places();
    nodes_.resize(places.size());
    for (auto& nodes : node_of_) nodes.resize(lines.size());
    build(places, 0);
}

std::vector<LineEnds::Place> LineEnds::gather_places() {
    std::vector<Place> places;
    for (uint32_t i = 0; i < ends_.size(); ++i) {
        const Vec2 at = place_of(ends_[i]);
        if (places.empty() || places.back().at != at) places.push_back({at, {i, i}, {i, i}});
        Place& place = places.back();
        if (!ends_[i].last) place.end[0] = place.next[1] = i + 1;
        place.end[1] = i + 1;
    }
    return places;
}

/// Splits a range of places at its middle along the longer side of its box.
void LineEnds::build(std::span<Place> places, uint32_t begin) {
    if (places.empty()) return;
    Box4 box = no_box;
    uint32_t unused = 0;
    for (const Place& place : places) {
        box.low = {min(box.low.x, place.at.x), min(box.low.y, place.at.y)};
        box.high = {max(box.high.x, place.at.x), max(box.high.y, place.at.y)};
        unused += place.end[1] - place.next[0];
    }
    const bool wide = box.high.x - box.low.x > box.high.y - box.low.y;
    const size_t middle = places.size() / 2;
    std::nth_element(places.begin(), places.begin() + std::ptrdiff_t(middle), places.end(),
                     [wide](const Place& a, const Place& b) {
                         return wide ? std::tie(a.at.x, a.at.y) < std::tie(b.at.x, b.at.y)
                                     : std::tie(a.at.y, a.at.x) < std::tie(b.at.y, b.at.x);
                     });
    const uint32_t self = begin + uint32_t(middle);
    nodes_[self] = {places[middle], box, unused};
    for (uint32_t i = places[middle].next[0]; i < places[middle].end[1]; ++i)
        node_of_[ends_[i].last ? 1 : 0][ends_[i].line] = self;
    build(places.first(middle), begin);
    build(places.subspan(middle + 1), self + 1);
}

void LineEnds::use(uint32_t line) {
    used_[line] = true;
    for (const auto& nodes : node_of_) {
        const uint32_t target = nodes[line];
        for (uint32_t begin = 0, end = uint32_t(nodes_.size());;) {
            const uint32_t middle = begin + (end - begin) / 2;
            --nodes_[middle].unused;
            if (middle == target) break;
            if (target < middle)
                end = middle;
            else
                begin = middle + 1;
        }
    }
}

const LineEnds::End* LineEnds::first_unused(Place& place, bool last) {
    uint32_t& next = place.next[last ? 1 : 0];
    while (next < place.end[last ? 1 : 0] && used_[ends_[next].line]) ++next;
    return next < place.end[last ? 1 : 0] ? &ends_[next] : nullptr;
}

const LineEnds::End* LineEnds::nearest(Vec2 to, bool last) {
    Search search{to, last, nullptr, most_};
    visit(0, uint32_t(nodes_.size()), search);
    return search.best;
}

void LineEnds::visit(uint32_t begin, uint32_t end, Search& search) {
    if (begin >= end) return;
    const uint32_t middle = begin + (end - begin) / 2;
    Node& node = nodes_[middle];
    if (node.unused == 0) return;
    const Vec2 beside = {
        max(max(node.box.low.x - search.to.x, search.to.x - node.box.high.x), 0.0f),
        max(max(node.box.low.y - search.to.y, search.to.y - node.box.high.y), 0.0f)};
    if (length_squared(beside) > search.least) return;
    const float squared = length_squared(node.place.at - search.to);
    if (squared <= search.least) {
        for (const bool last : {search.last, !search.last}) {
            const End* const found = first_unused(node.place, last);
            if (found == nullptr) continue;
            const auto rank = [&](const End& of, float distance) {
                return std::tuple(distance, of.last != search.last, of.line);
            };
            if (search.best == nullptr ||
                rank(*found, squared) < rank(*search.best, search.least)) {
                search.best = found;
                search.least = squared;
            }
            break;  // the other end of this place comes later in any case
        }
    }
    visit(begin, middle, search);
    visit(middle + 1, end, search);
}

}  // namespace fettle::physics::detail
