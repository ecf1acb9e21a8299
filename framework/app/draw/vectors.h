#pragma once
// Products of vectors in the plane of a picture.

#include <limits>

#include <SFML/System/Vector2.hpp>

namespace fettle::app {

inline float dot(sf::Vector2f a, sf::Vector2f b) {
    return a.x * b.x + a.y * b.y;
}
/// Positive where `b` lies to the left of `a` in a plane whose y goes up.
inline float cross(sf::Vector2f a, sf::Vector2f b) {
    return a.x * b.y - a.y * b.x;
}

/// Farther than any coordinate.
constexpr float anywhere = std::numeric_limits<float>::max();

}  // namespace fettle::app
