#pragma once
// The game's random numbers. The same seed gives the same numbers on every machine. xoshiro256++
// (Blackman and Vigna 2019, "Scrambled linear pseudorandom number generators"), seeded with
// splitmix64.

#include <array>
#include <cstdint>

#include <lua/lua_api.h>

namespace fettle::script {

class Random {
  public:
    explicit Random(std::uint64_t seed) { reseed(seed); }
    void reseed(std::uint64_t seed);
    std::uint64_t next();
    /// In [0, 1); 53 random bits.
    double unit();
    /// Both bounds are included; all integers have the same probability.
    std::int64_t between(std::int64_t low, std::int64_t high);

    using State = std::array<std::uint64_t, 4>;
    const State& state() const { return state_; }
    void restore(const State& state) { state_ = state; }

  private:
    State state_{};
};

/// Adds `random` to the table of globals at the top of the stack, and to the table `math` in them.
void open_random(lua_State* L);

}  // namespace fettle::script
