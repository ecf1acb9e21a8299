#include "engines/engine.h"

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>

namespace fettle::bench {
namespace {

#ifdef FETTLE_BENCH_BOX2D
constexpr auto box2d = make_box2d;
#else
constexpr std::unique_ptr<Engine> (*box2d)(const Scene&) = nullptr;
#endif
#ifdef FETTLE_BENCH_CHIPMUNK
constexpr auto chipmunk = make_chipmunk;
#else
constexpr std::unique_ptr<Engine> (*chipmunk)(const Scene&) = nullptr;
#endif

void mix(std::uint64_t& hash, float number) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    for (int shift = 0; shift < 32; shift += 8) {
        hash ^= (bits >> shift) & 0xff;
        hash *= 0x100000001b3;
    }
}

}  // namespace

void Engine::arrive(std::size_t, const SceneGroup&) {
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

std::span<const EngineKind> engine_kinds() {
    static const std::array<EngineKind, 4> kinds = {{
        {"fettle", make_fettle, ""},
        {"hosted", make_hosted, ""},
        {"box2d", box2d, "libbox2d-dev"},
        {"chipmunk", chipmunk, "libchipmunk-dev"},
    }};
    return kinds;
}

const EngineKind& engine_named(std::string_view name) {
    const auto kinds = engine_kinds();
    const auto found = std::ranges::find(kinds, name, &EngineKind::name);
    if (found != kinds.end()) return *found;
    std::string names;
    for (const EngineKind& kind : kinds)
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    throw std::invalid_argument("no engine is called \"" + std::string(name) + "\"; there are " +
                                names);
}

}  // namespace fettle::bench
