#include <outlines/joined_figures.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <outlines/vectors.h>

namespace fettle::app {

namespace {

using Vector = sf::Vector2f;

// px. At this distance outside of an edge another part is searched for; if there is one, the edge
// has no border.
constexpr float probe_distance = 0.35f;
// px. Overlap of parts that touch.
constexpr float part_overlap = 0.25f;
// px. Shorter stretches are merged with a neighbor.
constexpr float shortest_stretch = 0.3f;
constexpr std::size_t max_work = 1u << 20;  // tests of one edge against another

}  // namespace

void JoinedFigures::clear() {
    parts_.clear();
}

void JoinedFigures::add(std::span<const Vector> outline) {
    Part part;
    set_positive_outline(part.corners, outline);
    const std::size_t n = part.corners.size();
    if (n < 3) return;
    part.lower = part.upper = part.corners[0];
    for (std::size_t i = 0; i < n; ++i) {
        const Vector corner = part.corners[i];
        part.sides.emplace_back(corner, part.corners[(i + 1) % n]);
        part.lower = {std::min(part.lower.x, corner.x), std::min(part.lower.y, corner.y)};
        part.upper = {std::max(part.upper.x, corner.x), std::max(part.upper.y, corner.y)};
    }
    parts_.push_back(std::move(part));
}

float JoinedFigures::extent() const {
    Vector lower{unlimited, unlimited}, upper{-unlimited, -unlimited};
    for (const Part& part : parts_) {
        lower = {std::min(lower.x, part.lower.x), std::min(lower.y, part.lower.y)};
        upper = {std::max(upper.x, part.upper.x), std::max(upper.y, part.upper.y)};
    }
    return std::max(upper.x - lower.x, upper.y - lower.y);
}

// --- Seams ---------------------------------------------------------------------------------------

bool JoinedFigures::find_seams() {
    work_ = 0;
    for (Part& part : parts_) {
        find_seams_of(part);
        if (work_ > max_work) return false;
    }
    return true;
}

void JoinedFigures::find_seams_of(Part& part) {
    part.stretches.clear();
    part.first.assign(1, 0);
    for (std::size_t i = 0; i < part.size(); ++i) {
        const Vector from = part.corners[i], to = part.corners[(i + 1) % part.size()];
        const Vector out = part.sides[i].normal * probe_distance;
        const Vector lower{std::min(from.x, to.x) - probe_distance,
                           std::min(from.y, to.y) - probe_distance};
        const Vector upper{std::max(from.x, to.x) + probe_distance,
                           std::max(from.y, to.y) + probe_distance};
        covered_.clear();
        for (const Part& other : parts_) {
            ++work_;
            if (&other == &part || other.upper.x < lower.x || other.upper.y < lower.y ||
                other.lower.x > upper.x || other.lower.y > upper.y)
                continue;
            work_ += other.size();
            if (work_ > max_work) return;
            cover(other, from + out, to + out, Kind::seam);
            // If two borders coincide, only the first is drawn.
            if (&other < &part) cover(other, from - out, to - out, Kind::shared);
        }
        add_stretches(part, part.sides[i].length);
        part.first.push_back(part.stretches.size());
    }
}

/// Adds the shares of a line that lie inside another part. They begin and end where the line
/// crosses the part's outline.
void JoinedFigures::cover(const Part& other, Vector from, Vector to, Kind kind) {
    const Vector along = to - from;
    const float squared = dot(along, along);
    crossings_.clear();
    Vector last = other.corners.back();
    float last_side = cross(along, last - from);
    for (const Vector corner : other.corners) {
        const float side = cross(along, corner - from);
        if ((side > 0) != (last_side > 0)) {
            const Vector at = last + (corner - last) * (last_side / (last_side - side));
            crossings_.push_back(dot(at - from, along) / squared);
        }
        last = corner;
        last_side = side;
    }
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
        const float begin = std::max(crossings_[i], 0.0f), end = std::min(crossings_[i + 1], 1.0f);
        if (begin < end) covered_.push_back({begin, end, kind});
    }
}

/// Divides a side into stretches by its covered shares.
void JoinedFigures::add_stretches(Part& part, float length) {
    crossings_.assign({0, 1});
    for (const Covered& each : covered_) {
        crossings_.push_back(each.from);
        crossings_.push_back(each.to);
    }
    std::sort(crossings_.begin(), crossings_.end());
    const std::size_t first = part.stretches.size();
    for (std::size_t k = 0; k + 1 < crossings_.size(); ++k) {
        const float from = crossings_[k], to = crossings_[k + 1], middle = 0.5f * (from + to);
        if ((to - from) * length < shortest_stretch) continue;
        Kind kind = Kind::border;
        for (const Covered& each : covered_)
            if (each.from < middle && middle < each.to && kind != Kind::seam) kind = each.kind;
        if (part.stretches.size() > first && part.stretches.back().kind == kind)
            part.stretches.back().to = to * length;
        else
            part.stretches.push_back({from * length, to * length, kind});
    }
    if (part.stretches.size() == first) part.stretches.push_back({0, length, Kind::border});
    // Short stretches were left out; their neighbors take their place.
    part.stretches[first].from = 0;
    part.stretches.back().to = length;
    for (std::size_t k = first + 1; k < part.stretches.size(); ++k)
        part.stretches[k].from = part.stretches[k - 1].to;
}

// --- Contours and borders ------------------------------------------------------------------------

void JoinedFigures::contour(std::size_t number, float depth, std::vector<Vector>& outline) const {
    const Part& part = parts_[number];
    const std::size_t n = part.size();
    const auto moved = [depth](Kind kind) { return kind == Kind::seam ? part_overlap : -depth; };
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t last = (i + n - 1) % n;
        const Vector corner = part.corners[i];
        const Vector before = part.sides[last].normal, after = part.sides[i].normal;
        const float out_before = moved(part.end_of(last)), out_after = moved(part.begin_of(i));
        // The point where the two moved sides meet, unless it is far away.
        const Vector way = intersection_offset(before, out_before, after, out_after);
        const float most = 4 * std::max(std::abs(out_before), std::abs(out_after));
        if (dot(way, way) > 0 && dot(way, way) < most * most) {
            outline.push_back(corner + way);
        } else {
            outline.push_back(corner + before * out_before);
            outline.push_back(corner + after * out_after);
        }
        const Vector along{-after.y, after.x};
        for (std::size_t s = part.first[i]; s + 1 < part.first[i + 1]; ++s) {
            const Vector at = corner + along * part.stretches[s].to;
            outline.push_back(at + after * moved(part.stretches[s].kind));
            outline.push_back(at + after * moved(part.stretches[s + 1].kind));
        }
    }
}

std::vector<Run> JoinedFigures::border(float overlap) const {
    std::vector<Run> runs;
    for (const Part& part : parts_) add_runs(part, overlap, runs);
    return runs;
}

/// Adds the end of a run at a point of a side. If another part covers the space beyond the end, the
/// border continues by `overlap` beneath it (backwards if negative). That piece has no halo,
/// because the other part draws it.
void JoinedFigures::add_end(const Part& part, std::size_t side, float where, float overlap,
                            std::vector<Bend>& bends) const {
    const Vector out = part.sides[side].normal, along{-out.y, out.x};
    const Vector end = part.corners[side] + along * where;
    const Bend cut{end, out, out, out * part.sides[side].halo, unlimited};
    if (overlap == 0 ||
        !in_other_part(part, end + out * probe_distance + along * std::copysign(1.0f, overlap)))
        return bends.push_back(cut);
    const Bend bare{end, out, out, {0, 0}, unlimited};
    const Bend into{end + along * overlap, out, out, {0, 0}, unlimited};
    if (overlap > 0)
        bends.insert(bends.end(), {cut, bare, into});
    else
        bends.insert(bends.end(), {into, bare, cut});
}

/// Whether the point lies in a part other than `part`.
bool JoinedFigures::in_other_part(const Part& part, Vector point) const {
    return std::any_of(parts_.begin(), parts_.end(), [&](const Part& other) {
        if (&other == &part) return false;
        bool inside = false;
        Vector last = other.corners.back();
        for (const Vector corner : other.corners) {
            if ((corner.y > point.y) != (last.y > point.y) &&
                point.x < last.x + (corner.x - last.x) * (point.y - last.y) / (corner.y - last.y))
                inside = !inside;
            last = corner;
        }
        return inside;
    });
}

void JoinedFigures::add_runs(const Part& part, float overlap, std::vector<Run>& runs) const {
    const std::size_t n = part.size();
    const auto add_corner = [&](std::size_t i, std::vector<Bend>& bends) {
        const Side &before = part.sides[(i + n - 1) % n], &after = part.sides[i];
        add_bends(part.corners[i], before, after, reach_between(before, after), bends);
    };
    if (std::all_of(part.stretches.begin(), part.stretches.end(),
                    [](const Stretch& s) { return s.kind == Kind::border; })) {
        Run& run = runs.emplace_back(Run{{}, true});
        for (std::size_t i = 0; i < n; ++i) add_corner(i, run.bends);
        return;
    }
    // Start at a side that begins without a border, if there is one, so that no run is split.
    const auto begins = [&](std::size_t side) { return part.begin_of(side) == Kind::border; };
    std::size_t start = 0;
    while (start < n && begins(start)) ++start;
    start %= n;
    bool open = false;
    std::vector<Run> found;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = (start + k) % n, next = (i + 1) % n;
        for (std::size_t s = part.first[i]; s < part.first[i + 1]; ++s) {
            const Stretch& stretch = part.stretches[s];
            if (stretch.kind != Kind::border) {
                open = false;
                continue;
            }
            if (!open) {
                found.emplace_back();
                add_end(part, i, stretch.from, -overlap, found.back().bends);
                open = true;
            }
            if (s + 1 == part.first[i + 1] && begins(next))
                add_corner(next, found.back().bends);
            else
                add_end(part, i, stretch.to, overlap, found.back().bends);
        }
    }
    if (open && begins(start) && found.size() > 1) {  // the last run continues as the first
        Run& last = found.back();
        const auto rest = std::find_if(found[0].bends.begin(), found[0].bends.end(),
                                       [](const Bend& b) { return dot(b.halo, b.halo) > 0; });
        last.bends.insert(last.bends.end(), rest + 1, found[0].bends.end());
        found.erase(found.begin());
    }
    for (Run& run : found) runs.push_back(std::move(run));
}

}  // namespace fettle::app
