#include <calls/inside.h>

#include <cstdio>

#include <calls/retired.h>

namespace fettle::physics_c {

std::string name_and_value(const char* name, float value) {
    char text[64];
    std::snprintf(text, sizeof text, "%s = %g", name, double{value});
    return text;
}

fettle_world* adopt(std::unique_ptr<physics::World> world) {
    std::unique_ptr<fettle_world> made = Retired<fettle_world>::allocate();
    made->world = std::move(world);
    return made.release();
}

void retire(fettle_world* world) noexcept {
    if (world->owner != nullptr) --world->owner->worlds;
    *world = fettle_world{};
    Retired<fettle_world>::keep(world);
}

physics::World& live(const fettle_world* world) {
    return *existing("world", world).world;
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
