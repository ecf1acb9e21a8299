#pragma once
// SplitMix64: numbers without visible order from numbers that differ little.

#include <cstdint>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// One step of the generator SplitMix64 from the state `x`, whose next state is `x` +
/// 0x9e3779b97f4a7c15. Source: Steele, Lea, Flood: Fast splittable pseudorandom number generators,
/// 2014.
constexpr std::uint64_t split_mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

}  // namespace fettle::property

FETTLE_PROPERTY_END
