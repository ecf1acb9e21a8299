#include <calls/inside.h>

#include <cstdio>
#include <deque>
#include <mutex>

namespace fettle::physics_c {

std::string stated(const char* name, float value) {
    char text[64];
    std::snprintf(text, sizeof text, "%s = %g", name, double{value});
    return text;
}

namespace {

/// The memory of worlds that are destroyed. It is used again when a thousand more are destroyed.
struct Retired {
    static constexpr size_t most = 1000;

    std::mutex mutex;
    std::deque<std::unique_ptr<fettle_world>> worlds;
};

Retired& retired() {
    static Retired known;
    return known;
}

/// The world of a caller, or the memory of an old one.
std::unique_ptr<fettle_world> place() {
    Retired& known = retired();
    const std::lock_guard lock(known.mutex);
    if (known.worlds.size() <= Retired::most) return std::make_unique<fettle_world>();
    std::unique_ptr<fettle_world> oldest = std::move(known.worlds.front());
    known.worlds.pop_front();
    return oldest;
}

}  // namespace

fettle_world* adopt(std::unique_ptr<physics::World> world) {
    std::unique_ptr<fettle_world> made = place();
    made->world = std::move(world);
    return made.release();
}

void retire(fettle_world* world) noexcept {
    std::unique_ptr<fettle_world> ended(world);
    if (ended->owner != nullptr) --ended->owner->worlds;
    *ended = fettle_world{};
    try {
        Retired& known = retired();
        const std::lock_guard lock(known.mutex);
        known.worlds.push_back(std::move(ended));
    } catch (...) {
        // Without memory for the list, the memory of the world is given back at once.
    }
}

physics::World& live(const fettle_world* world) {
    if (world == nullptr) throw Failure{FETTLE_INVALID, "world: expected a pointer, got null"};
    if (world->world == nullptr) throw Failure{FETTLE_STALE, "world: it was destroyed"};
    return *world->world;
}

physics::World& editable(fettle_world* world) {
    physics::World& wanted = live(world);
    if (world->visiting > 0)
        throw Failure{
            FETTLE_LOCKED,
            "the world is calling a visitor: store the change, and make it after the call"};
    return wanted;
}

}  // namespace fettle::physics_c
