#include "engines/engine.h"

#include <cstring>
#include <stdexcept>

namespace fettle::bench {
namespace {

void mix(std::uint64_t& hash, float number) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    for (int shift = 0; shift < 32; shift += 8) {
        hash ^= (bits >> shift) & 0xff;
        hash *= 0x100000001b3;
    }
}

}  // namespace

void Engine::replace_group(std::size_t, const SceneGroup&) {
    throw std::logic_error("this engine runs no scene in which bodies come and go");
}

void mix(std::uint64_t& hash, const BodyMotion& body) {
    for (const float number : {body.position.x, body.position.y, body.angle, body.velocity.x,
                               body.velocity.y, body.angular_velocity})
        mix(hash, number);
}

std::uint64_t hash_of(const Engine& engine, std::size_t count) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (std::size_t i = 0; i < count; ++i) mix(hash, engine.motion(i));
    engine.mix_groups(hash);
    return hash;
}

}  // namespace fettle::bench
