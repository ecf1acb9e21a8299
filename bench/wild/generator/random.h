#pragma once
// Random numbers that are equal on every machine for equal seeds.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace fettle::bench::wild {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) { bits(); }

    /// In [low, high], a multiple of 0.001, so that a printed world stays short.
    float number(float low, float high) {
        const double drawn = low + (double(high) - low) * double(bits() >> 11) / 9007199254740992.0;
        return float(std::round(drawn * 1000) / 1000);
    }
    int whole(int low, int high) { return low + int(bits() % std::uint64_t(high - low + 1)); }
    bool chance(double share) { return double(bits() >> 11) < share * 9007199254740992.0; }
    float sign() { return chance(0.5) ? 1.0f : -1.0f; }
    template <class T>
    T one_of(std::initializer_list<T> items) {
        return items.begin()[std::size_t(whole(0, int(items.size()) - 1))];
    }

  private:
    /// SplitMix64 (G. Steele, D. Lea, C. Flood: Fast splittable pseudorandom number generators).
    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

}  // namespace fettle::bench::wild
