#pragma once
// Products of two-dimensional vectors.

#include <limits>

#include <SFML/System/Vector2.hpp>

namespace fettle::app {

inline float dot(sf::Vector2f a, sf::Vector2f b) {
    return a.x * b.x + a.y * b.y;
}
/// Positive if `b` points to the left of `a` with y up.
inline float cross(sf::Vector2f a, sf::Vector2f b) {
    return a.x * b.y - a.y * b.x;
}

/// Larger than any coordinate.
constexpr float unlimited = std::numeric_limits<float>::max();

}  // namespace fettle::app
