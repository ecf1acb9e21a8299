// The list of all engines.

#include <algorithm>
#include <array>
#include <stdexcept>

#include "engines/engine.h"

namespace fettle::bench {
namespace {

#ifdef FETTLE_BENCH_BOX2D
constexpr std::unique_ptr<Engine> (*box2d)(const Scene&) = make_box2d;
#else
constexpr std::unique_ptr<Engine> (*box2d)(const Scene&) = nullptr;
#endif
#ifdef FETTLE_BENCH_CHIPMUNK
constexpr std::unique_ptr<Engine> (*chipmunk)(const Scene&) = make_chipmunk;
#else
constexpr std::unique_ptr<Engine> (*chipmunk)(const Scene&) = nullptr;
#endif

}  // namespace

std::span<const EngineKind> engine_kinds() {
    constexpr std::unique_ptr<Engine> (*fettle)(const Scene&) = make_fettle;
    static const std::array<EngineKind, 4> kinds = {{
        {"fettle", fettle, "", 64},
        {"hosted", make_hosted, "", 64},
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
