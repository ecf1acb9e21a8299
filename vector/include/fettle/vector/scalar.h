#pragma once
// Replacements for three functions of <cmath>. This header takes longer to compile than all code
// that uses them here, because since C++17 it contains the special functions of mathematics.

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

/// The absolute value; 0 for -0.
template <class T>
constexpr T absolute(T x) {
    return x < 0 ? -x : x + T(0);  // the sum of -0 and 0 is 0
}

/// False for infinities and NaN: their difference to themselves is not 0.
template <class T>
constexpr bool finite(T x) {
    return x - x == 0;  // NOLINT: see above
}

}  // namespace fettle::detail
