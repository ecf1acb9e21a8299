#include <outlines/outline.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <outlines/vectors.h>

namespace fettle::app {

namespace {

using Vector = sf::Vector2f;

constexpr float least_rounding = 0.3f;  // px; a smaller rounding is not visible
constexpr float miter_limit = 4;        // largest length of a sharp corner, in widths
constexpr float pi = std::numbers::pi_v<float>;

}  // namespace

int circle_segments(float radius) {
    // The distance of a chord from its arc is r (1 - cos(pi / n)). On small circles larger
    // distances are allowed, because they are less visible.
    radius = std::max(radius, 0.5f);
    const float bend = 1 - std::clamp(4 / radius, chord_tolerance, 4 * chord_tolerance) / radius;
    const float n = pi / std::acos(std::clamp(bend, -1.0f, 1.0f));
    return std::clamp(static_cast<int>(std::ceil(n)), 8, 512);
}

Side::Side(Vector from, Vector to) {
    const Vector edge = to - from;
    length = std::sqrt(dot(edge, edge));
    normal = Vector{edge.y, -edge.x} / length;
    // A side along a row or a column of pixels has no steps, so a short halo is enough and looks
    // sharp.
    halo = std::clamp(std::min(std::abs(edge.x), std::abs(edge.y)), 0.5f, 1.0f);
}

float area_of(std::span<const Vector> corners) {
    float twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        twice += cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
    return 0.5f * twice;
}

void set_positive_outline(std::vector<Vector>& corners, std::span<const Vector> given) {
    const auto differ = [](Vector a, Vector b) { return dot(a - b, a - b) > 1e-6f; };
    corners.clear();
    for (const Vector corner : given)
        if (corners.empty() || differ(corner, corners.back())) corners.push_back(corner);
    while (corners.size() > 1 && !differ(corners.front(), corners.back())) corners.pop_back();
    if (area_of(corners) < 0) std::reverse(corners.begin(), corners.end());
}

bool is_convex(std::span<const Vector> corners) {
    const std::size_t n = corners.size();
    if (n < 4) return true;
    const auto each_turn = [&](auto visit) {
        Vector before = corners[0] - corners[n - 1];
        for (std::size_t i = 0; i < n; ++i) {
            const Vector edge = corners[i + 1 < n ? i + 1 : 0] - corners[i];
            visit(before, edge, cross(before, edge));
            before = edge;
        }
    };
    bool left = false, right = false;
    int times_round = 0;
    each_turn([&](Vector before, Vector edge, float turn) {
        left = left || turn > 0;
        right = right || turn < 0;
        times_round += before.x < 0 && edge.x >= 0 ? 1 : 0;
    });
    if (times_round > 1) return false;
    if (!left || !right) return true;
    float to_left = 0, to_right = 0;  // sines
    each_turn([&](Vector before, Vector edge, float turn) {
        if (turn == 0) return;
        const float sine = turn / std::sqrt(dot(before, before) * dot(edge, edge));
        (sine > 0 ? to_left : to_right) += std::abs(sine);
    });
    constexpr float straight = 0.01f;
    return std::min(to_left, to_right) < straight;
}

void remove_close_corners(std::vector<Vector>& corners) {
    constexpr float near = 0.2f;  // px
    std::size_t kept = 0;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Vector step = corners[i] - corners[kept];
        if (dot(step, step) > near * near) corners[++kept] = corners[i];
    }
    corners.resize(std::min(corners.size(), kept + 1));
}

float reach_between(const Side& before, const Side& after) {
    // At a depth d the corner moves by d tan(turn / 2) along each side.
    const float tangent =
        std::abs(cross(before.normal, after.normal)) / (1 + dot(before.normal, after.normal));
    const float shorter = std::min(before.length, after.length);
    return shorter < tangent * unlimited ? shorter / tangent : unlimited;
}

Vector intersection_offset(Vector normal, float distance, Vector other_normal,
                           float other_distance) {
    const float turn = cross(normal, other_normal);
    if (std::abs(turn) < 0.05f) return {0, 0};
    return Vector{distance * other_normal.y - other_distance * normal.y,
                  other_distance * normal.x - distance * other_normal.x} /
           turn;
}

void add_bends(Vector corner, const Side& before, const Side& after, float reach,
               std::vector<Bend>& bends) {
    // The miter m is defined by m . before = m . after = 1.
    const float scale = 1 + dot(before.normal, after.normal);
    const Vector miter = scale > 1e-5f ? (before.normal + after.normal) / scale : Vector{0, 0};
    const bool sharp = scale < 2 / (miter_limit * miter_limit);
    Vector halo = miter * (0.5f * (before.halo + after.halo));
    if (before.halo != after.halo && !sharp) {
        const Vector met =
            intersection_offset(before.normal, before.halo, after.normal, after.halo);
        if (dot(met, met) > 0) halo = met;
    }
    if (!sharp) {
        bends.push_back({corner, miter, miter, halo, reach});
    } else if (cross(before.normal, after.normal) >= 0) {  // convex corner: cut off on the outside
        bends.push_back({corner, before.normal, miter, before.normal * before.halo, reach});
        bends.push_back({corner, after.normal, miter, after.normal * after.halo, reach});
    } else {  // concave corner: cut off on the inside
        bends.push_back({corner, miter, before.normal, before.normal * before.halo, reach});
        bends.push_back({corner, miter, after.normal, after.normal * after.halo, reach});
    }
}

void Outline::begin(std::span<const Vector> corners) {
    set_positive_outline(corners_, corners);
    bends_.clear();
    sides_.clear();
    goes_round_once_ = true;
}

void Outline::set(std::span<const Vector> corners, float rounding) {
    begin(corners);
    rounding_ = rounding < least_rounding ? 0 : rounding;
    depth_limit_ = rounding_;
    const std::size_t n = corners_.size();
    if (n == 0) return;
    if (n == 1) return add_circle();

    Vector middle{0, 0};
    for (const Vector corner : corners_) middle += corner / static_cast<float>(n);
    float inner = n < 3 ? 0 : unlimited;
    for (std::size_t i = 0; i < n; ++i) {
        sides_.emplace_back(corners_[i], corners_[i + 1 < n ? i + 1 : 0]);
        if (n > 2) inner = std::min(inner, dot(corners_[i] - middle, sides_[i].normal));
    }
    depth_limit_ += 0.98f * std::max(inner, 0.0f);
    for (std::size_t i = 0; i < n; ++i) {
        const Side &before = sides_[i > 0 ? i - 1 : n - 1], &after = sides_[i];
        if (rounding_ > 0)
            add_arc(corners_[i], before, after);
        else
            add_bends(corners_[i], before, after, unlimited, bends_);
    }
}

void Outline::set_any(std::span<const Vector> corners) {
    begin(corners);
    rounding_ = 0;
    depth_limit_ = unlimited;
    const std::size_t n = corners_.size();
    if (n < 2) return;
    for (std::size_t i = 0; i < n; ++i) sides_.emplace_back(corners_[i], corners_[(i + 1) % n]);
    float turned = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Side &before = sides_[(i + n - 1) % n], &after = sides_[i];
        turned += std::atan2(cross(before.normal, after.normal), dot(before.normal, after.normal));
        add_bends(corners_[i], before, after, reach_between(before, after), bends_);
    }
    goes_round_once_ = std::abs(std::abs(turned) - 2 * pi) < pi;
}

void Outline::add_circle() {
    const int segments = circle_segments(rounding_);
    for (int i = 0; i < segments; ++i) {
        const float a = 2 * pi * static_cast<float>(i) / static_cast<float>(segments);
        const Vector normal{std::cos(a), std::sin(a)};
        bends_.push_back({corners_[0], normal, {0, 0}, normal * (rounding_ + 1), unlimited});
    }
}

void Outline::add_arc(Vector corner, const Side& before, const Side& after) {
    const float scale = 1 + dot(before.normal, after.normal);
    const Vector miter = scale > 1e-5f ? (before.normal + after.normal) / scale : Vector{0, 0};
    const float turn =
        std::atan2(cross(before.normal, after.normal), dot(before.normal, after.normal));
    // The end of a line is half a turn; rounding may give -pi instead of pi.
    const float angle = turn < -1 ? turn + 2 * pi : std::max(turn, 0.0f);
    const int segments =
        std::max(1, static_cast<int>(std::ceil(static_cast<float>(circle_segments(rounding_)) *
                                               angle / (2 * pi))));
    const float start = std::atan2(before.normal.y, before.normal.x);
    for (int i = 0; i <= segments; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(segments);
        const float a = start + angle * share;
        const Vector normal{std::cos(a), std::sin(a)};
        const float halo = std::min(
            1.0f, (1 - share) * before.halo + share * after.halo + 2 * share * (1 - share));
        bends_.push_back({corner, normal, miter, normal * (rounding_ + halo), unlimited});
    }
}

void Outline::halo(std::vector<Vector>& points) const {
    for (const Bend& b : bends_) points.push_back(b.corner + b.halo);
}

void Outline::ring(float depth, std::vector<Vector>& points) const {
    for (const Bend& b : bends_) {
        // At depths within the rounding a ring is an arc around the corner; deeper rings have sharp
        // corners.
        if (rounding_ == 0)
            points.push_back(b.at(depth));
        else if (depth <= rounding_)
            points.push_back(b.corner + b.out * (rounding_ - depth));
        else
            points.push_back(b.corner - b.in * (depth - rounding_));
    }
}

}  // namespace fettle::app
