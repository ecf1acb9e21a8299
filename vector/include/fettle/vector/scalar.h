#pragma once
// Three functions of <cmath>, which takes longer to compile than all that uses them here: since
// C++17 it has the special functions of mathematics.

#if !defined(__GNUC__) && !defined(__clang__)
#include <cmath>
#endif

namespace fettle::detail {

/// The square root of a float or a double, correctly rounded.
template <class T>
T square_root(T x) {
#if defined(__GNUC__) || defined(__clang__)
    if constexpr (sizeof(T) == sizeof(float))
        return __builtin_sqrtf(x);
    else
        return __builtin_sqrt(x);
#else
    return std::sqrt(x);
#endif
}

/// Without the sign.
template <class T>
constexpr T absolute(T x) {
    return x < 0 ? -x : x + T(0);  // the sum of -0 and 0 is 0
}

/// False for infinities and for what is not a number: their difference to themselves is not 0.
template <class T>
constexpr bool finite(T x) {
    return x - x == 0;
}

}  // namespace fettle::detail
