#include "outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace fettle::app {

namespace {

using Vector = sf::Vector2f;

float dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y;
}
float cross(Vector a, Vector b) {
    return a.x * b.y - a.y * b.x;
}

constexpr float sharp = 0.3f;     // px; rounding below that cannot be seen
constexpr float miter_limit = 4;  // how far a sharp corner may stick out, in widths
constexpr float pi = std::numbers::pi_v<float>;

}  // namespace

int circle_segments(float radius) {
    // A chord may miss the arc by a fifth of a pixel: r (1 - cos(pi / n)) = 1/5.
    const float bend = 1 - 0.2f / std::max(radius, 0.5f);
    const float n = pi / std::acos(std::clamp(bend, -1.0f, 1.0f));
    return std::clamp(static_cast<int>(std::ceil(n)), 8, 256);
}

void Outline::set(std::span<const Vector> corners, float rounding) {
    points_.clear();
    corners_.clear();
    normals_.clear();
    rounding_ = rounding < sharp ? 0 : rounding;
    for (const Vector corner : corners)
        if (corners_.empty() || corner != corners_.back()) corners_.push_back(corner);
    while (corners_.size() > 1 && corners_.front() == corners_.back()) corners_.pop_back();
    const std::size_t n = corners_.size();
    if (n == 0) return;

    float area = 0;
    for (std::size_t i = 0; i < n; ++i)
        area += cross(corners_[i] - corners_[0], corners_[(i + 1) % n] - corners_[0]);
    if (area < 0) std::reverse(corners_.begin(), corners_.end());

    Vector middle{0, 0};
    for (const Vector corner : corners_) middle += corner / static_cast<float>(n);
    float inner = n < 3 ? 0 : std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < n && n > 1; ++i) {
        const Vector edge = corners_[(i + 1) % n] - corners_[i];
        const Vector normal =
            Vector{edge.y, -edge.x} / std::sqrt(edge.x * edge.x + edge.y * edge.y);
        normals_.push_back(normal);
        if (n > 2) inner = std::min(inner, dot(corners_[i] - middle, normal));
    }
    depth_limit_ = rounding_ + 0.98f * std::max(inner, 0.0f);
    if (n == 1) {
        add_corner(corners_[0], {-1, 0}, {-1, 0});
    } else {
        for (std::size_t i = 0; i < n; ++i)
            add_corner(corners_[i], normals_[(i + n - 1) % n], normals_[i]);
    }
}

void Outline::add_corner(Vector corner, Vector before, Vector after) {
    // The miter m has m . before = m . after = 1.
    const Vector sum = before + after;
    const float scale = 1 + dot(before, after);
    const Vector miter = scale > 2 / (miter_limit * miter_limit) ? sum / scale : after;
    if (rounding_ == 0) {
        points_.push_back({corner, after, miter});
        return;
    }
    const bool whole = corners_.size() == 1;
    const float turn = whole ? 2 * pi : std::atan2(cross(before, after), dot(before, after));
    const float angle = turn < 0 ? turn + 2 * pi : turn;
    const int segments = std::max(
        whole ? 8 : 1, static_cast<int>(std::ceil(static_cast<float>(circle_segments(rounding_)) *
                                                  angle / (2 * pi))));
    const float start = std::atan2(before.y, before.x);
    for (int i = 0; i < segments + (whole ? 0 : 1); ++i) {
        const float a = start + angle * static_cast<float>(i) / static_cast<float>(segments);
        points_.push_back({corner, {std::cos(a), std::sin(a)}, whole ? Vector{0, 0} : miter});
    }
}

void Outline::ring(float depth, std::vector<Vector>& points) const {
    for (const Point& p : points_) {
        // Within the rounding a ring is an arc around the corner; deeper it has a sharp corner.
        if (rounding_ == 0)
            points.push_back(p.corner - p.miter * depth);
        else if (depth <= rounding_)
            points.push_back(p.corner + p.normal * (rounding_ - depth));
        else
            points.push_back(p.corner - p.miter * (depth - rounding_));
    }
}

}  // namespace fettle::app
