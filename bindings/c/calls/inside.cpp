#include <calls/inside.h>

#include <locale>
#include <sstream>

#include <calls/retired.h>

namespace fettle::physics_c {

std::string name_and_value(const char* name, float value) {
    std::ostringstream text;
    text.imbue(std::locale::classic());  // a point, whatever the locale of the program is
    text << name << " = " << value;
    return text.str();
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
