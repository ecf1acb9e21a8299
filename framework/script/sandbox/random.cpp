#include <bit>
#include <cmath>
#include <stdexcept>

#include <fettle/property/split_mix.h>
#include <fettle/script/runtime.h>

#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <sandbox/random.h>
#include <values/values.h>

namespace fettle::script {

void Random::reseed(std::uint64_t seed) {
    for (auto& word : state_) {
        word = property::split_mix(seed);
        seed += 0x9e3779b97f4a7c15u;
    }
}

std::uint64_t Random::next() {
    const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
}

double Random::unit() {
    return static_cast<double>(next() >> 11) * 0x1p-53;
}

std::int64_t Random::between(std::int64_t low, std::int64_t high) {
    const std::uint64_t span =
        static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
    if (span == 0) return static_cast<std::int64_t>(next());  // the range of all 2^64 values
    // Rejects values below this, because otherwise the first results would be more likely.
    const std::uint64_t uneven = (0 - span) % span;
    std::uint64_t value = next();
    while (value < uneven) value = next();
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(low) + value % span);
}

namespace {

// Implements random() in [0, 1), random(n) in 1..n, and random(a, b): an integer if both are, else
// any number.
int random_number(lua_State* L) {
    Random& random = machine_of(L).random;
    const int given = lua_gettop(L);
    if (given == 0) {
        lua_pushnumber(L, random.unit());
        return 1;
    }
    if (given > 2) throw std::invalid_argument("random: takes no more than two numbers");
    const int last = given;
    if ((given == 1 || lua_isinteger(L, 1)) && lua_isinteger(L, last)) {
        const lua_Integer low = given == 1 ? 1 : lua_tointeger(L, 1);
        const lua_Integer high = lua_tointeger(L, last);
        if (given == 1 && high == 0) {  // as in Lua: random(0) is any integer
            lua_pushinteger(L, static_cast<lua_Integer>(random.next()));
            return 1;
        }
        if (low > high)
            throw std::invalid_argument("random: nothing lies between " + std::to_string(low) +
                                        " and " + std::to_string(high));
        lua_pushinteger(L, random.between(low, high));
        return 1;
    }
    if (lua_istable(L, 1))
        throw std::invalid_argument("random: needs numbers (write list[random(#list)])");
    const double low = given == 1 ? 0 : check_number(L, 1, "random");
    const double high = check_number(L, last, "random");
    if (!(low <= high) || std::isinf(low) || std::isinf(high))
        throw std::invalid_argument("random: needs two finite numbers in ascending order");
    const double share = random.unit();
    // The difference of the bounds may overflow to infinity.
    lua_pushnumber(
        L, std::isinf(high - low) ? low * (1 - share) + high * share : low + (high - low) * share);
    return 1;
}

// Implements math.random, which takes only whole numbers, as in Lua.
int math_random(lua_State* L) {
    for (int i = 1; i <= lua_gettop(L) && i <= 2; ++i) {
        int whole = 0;
        const lua_Integer value = lua_tointegerx(L, i, &whole);
        if (!whole) throw std::invalid_argument("math.random: needs whole numbers");
        lua_pushinteger(L, value);
        lua_replace(L, i);
    }
    return random_number(L);
}

int random_seed(lua_State* L) {
    Machine& machine = machine_of(L);
    if (lua_gettop(L) == 0) {
        machine.random.reseed(machine.options.seed);
    } else if (lua_isinteger(L, 1)) {
        machine.random.reseed(static_cast<std::uint64_t>(lua_tointeger(L, 1)));
    } else {
        machine.random.reseed(std::bit_cast<std::uint64_t>(check_number(L, 1, "randomseed")));
    }
    return 0;
}

}  // namespace

void open_random(lua_State* L) {
    add_varying<random_number>(L, "random");
    lua_getfield(L, -1, "math");
    add_varying<math_random>(L, "random");
    add_function<random_seed>(L, "randomseed");
    lua_pop(L, 1);
}

}  // namespace fettle::script
