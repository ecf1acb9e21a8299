#pragma once

#include <fettle/vector/vector2.h>

#include <concepts>
#include <utility>

// Conversions between `Vec2` and the vectors of other libraries: SFML's and raylib's, which have
// members `x` and `y`, and Eigen's, which has functions of these names. No header of another
// library is included here.
//
//     sf::Vector2f on_screen = fettle::to<sf::Vector2f>(body.position());
//     body.set_position(fettle::from<fettle::physics::Vec2>(glm_point));

namespace fettle {

template <class V>
concept HasComponents = requires(const V& v) {
    { v.x } -> std::convertible_to<double>;
    { v.y } -> std::convertible_to<double>;
};
template <class V>
concept HasComponentFunctions = requires(const V& v) {
    { v.x() } -> std::convertible_to<double>;
    { v.y() } -> std::convertible_to<double>;
};

template <class V>
concept AnyVector = HasComponents<V> || HasComponentFunctions<V>;

/// A vector of another library with the components of `v`, rounded to its type.
template <AnyVector Other, class T>
Other to(const Vector2<T>& v) {
    Other other;
    if constexpr (HasComponents<Other>) {
        other.x = static_cast<decltype(other.x)>(v.x);
        other.y = static_cast<decltype(other.y)>(v.y);
    } else {
        other.x() = static_cast<std::remove_cvref_t<decltype(other.x())>>(v.x);
        other.y() = static_cast<std::remove_cvref_t<decltype(other.y())>>(v.y);
    }
    return other;
}

/// A `Vector2` with the components of a vector of another library.
template <class Vec2, AnyVector Other>
constexpr Vec2 from(const Other& v) {
    if constexpr (HasComponents<Other>)
        return {v.x, v.y};
    else
        return {v.x(), v.y()};
}

}  // namespace fettle
