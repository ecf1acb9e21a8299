// The hash of a world: of the poses and velocities of all bodies.

#include <world/world_data.h>

#include <cstring>

namespace fettle::physics {

using namespace detail;

uint64_t detail::hash_of(const Columns& columns) {
    // FNV-1a over whole words, each mixed before. It is cheap, and every bit influences the result.
    uint64_t hash = 0xcbf29ce484222325u;
    auto mix = [&hash](uint64_t word) {
        word *= 0x9e3779b97f4a7c15u;
        hash = (hash ^ word ^ (word >> 31)) * 0x100000001b3u;
    };
    auto add = [&mix](float a, float b) {
        uint32_t words[2];
        std::memcpy(&words[0], &a, 4);
        std::memcpy(&words[1], &b, 4);
        mix(uint64_t{words[1]} << 32 | words[0]);
    };
    for (uint32_t i = 1; i < columns.states.size(); ++i) {
        if (columns.body_generations[i] == 0) continue;
        const BodyState& s = columns.states[i];
#ifdef FETTLE_PHYSICS_DOUBLE
        uint64_t words[2];
        std::memcpy(words, &s.position, sizeof words);
        mix(words[0]);
        mix(words[1]);
#else
        add(s.position.x, s.position.y);
#endif
        add(s.angle, s.angular_velocity);
        add(s.velocity.x, s.velocity.y);
    }
    return hash;
}

uint64_t World::hash() const {
    return hash_of(*data_);
}

}  // namespace fettle::physics
