#pragma once
// The game's random numbers: the same on every machine for the same seed. xoshiro256++ (Blackman
// and Vigna 2019, "Scrambled linear pseudorandom number generators"), seeded through splitmix64.

#include <array>
#include <cstdint>

#include <lua/lua_api.h>

namespace fettle::script {

class Random {
  public:
    explicit Random(std::uint64_t seed) { reseed(seed); }
    void reseed(std::uint64_t seed);
    std::uint64_t next();
    /// 0 to 1, 1 excluded; 53 random bits.
    double unit();
    /// Both ends included; every integer equally likely.
    std::int64_t between(std::int64_t low, std::int64_t high);

    using State = std::array<std::uint64_t, 4>;
    const State& state() const { return state_; }
    void restore(const State& state) { state_ = state; }

  private:
    State state_{};
};

/// `random` among the globals on top, and in the table `math` there.
void open_random(lua_State* L);

}  // namespace fettle::script
