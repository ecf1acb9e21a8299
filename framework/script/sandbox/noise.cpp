#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <fettle/property/split_mix.h>

#include <lua/exception_guard.h>
#include <sandbox/noise.h>
#include <values/values.h>

// Gradient noise (K. Perlin, "Improving Noise", 2002): each point with whole coordinates has a
// slope from a hash, and between these points the slopes are mixed. Only sums and products of
// doubles, so that all machines compute the same.

namespace fettle::script {

namespace {

/// Hash of a point with whole coordinates.
std::uint64_t hash(double x, double y) {
    const auto bits = [](double whole) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(whole));
    };
    return property::split_mix(property::split_mix(bits(x)) + bits(y));
}

double smooth(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

double mixed(double a, double b, double share) {
    return a + share * (b - a);
}

/// What the slope at a point adds at a distance of (x, y) from it. The slopes have eight
/// directions.
double slope(std::uint64_t hash, double x, double y) {
    const double along = (hash & 1) != 0 ? x : -x, across = (hash & 2) != 0 ? y : -y;
    return (hash & 4) != 0 ? along + 0.5 * across : 0.5 * along + across;
}

double noise(double x) {
    const double left = std::floor(x), t = x - left;
    const auto at = [](double place, double distance) {
        const auto steep = static_cast<double>(hash(place, 0) >> 11) * 0x1p-52 - 1;
        return steep * distance;
    };
    return 2 * mixed(at(left, t), at(left + 1, t - 1), smooth(t));
}

double noise(double x, double y) {
    const double left = std::floor(x), low = std::floor(y), s = x - left, t = y - low;
    const auto at = [&](double right, double up) {
        return slope(hash(left + right, low + up), s - right, t - up);
    };
    const double below = mixed(at(0, 0), at(1, 0), smooth(s));
    const double above = mixed(at(0, 1), at(1, 1), smooth(s));
    return 4.0 / 3.0 * mixed(below, above, smooth(t));
}

int math_noise(lua_State* L) {
    constexpr double farthest = 1e15;  // beyond it, a double has no digits for the fraction
    const double x = check_number(L, 1, "math.noise");
    const bool plane = !lua_isnoneornil(L, 2);
    const double y = plane ? check_number(L, 2, "math.noise") : 0;
    if (!(std::abs(x) <= farthest && std::abs(y) <= farthest))
        throw std::invalid_argument("math.noise: expected numbers from -1e15 to 1e15");
    lua_pushnumber(L, std::clamp(plane ? noise(x, y) : noise(x), -1.0, 1.0));
    return 1;
}

}  // namespace

void open_noise(lua_State* L) {
    lua_getfield(L, -1, "math");
    add_pure<math_noise>(L, "noise");
    lua_pop(L, 1);
}

}  // namespace fettle::script
