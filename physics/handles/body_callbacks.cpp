#include <handles/live.h>

#include <algorithm>
#include <utility>

// Setting the functions of the user that move single bodies. `world/body_functions.cpp` calls them.

namespace fettle::physics {

using namespace detail;

namespace {

/// The functions of a body, to be set; a body without any gets an entry in the order of the slots.
/// `replaced` receives those of a destroyed body that had the slot.
BodyFunctions& functions_of(WorldSelf& self, BodyId body, BodyFunctions& replaced) {
    auto& all = self.functions;
    const auto place = std::lower_bound(
        all.begin(), all.end(), body.index,
        [](const BodyFunctions& each, uint32_t slot) { return each.body.index < slot; });
    if (place == all.end() || place->body.index != body.index)
        return *all.insert(place, BodyFunctions{.body = body});
    if (place->body != body) replaced = std::exchange(*place, BodyFunctions{.body = body});
    return *place;
}

/// `function` goes to the entry of the body; an entry without functions is removed. The old
/// functions are destroyed last, because their destructors may use the world.
template <class Function>
void set_function(WorldData& data, BodyId body, Function BodyFunctions::*which,
                  Function& function) {
    auto& all = data.self.functions;
    BodyFunctions replaced;
    BodyFunctions& own = functions_of(data.self, body, replaced);
    std::swap(own.*which, function);
    if (!own.velocity && !own.position) all.erase(all.begin() + (&own - all.data()));
    data.change<wake_body>(body.index);
}

}  // namespace

void Body::set_velocity_function(VelocityFunction function) {
    FETTLE_EDIT_BODY
    set_function(data, id_, &BodyFunctions::velocity, function);
}

void Body::set_position_function(PositionFunction function) {
    FETTLE_EDIT_BODY
    set_function(data, id_, &BodyFunctions::position, function);
}

}  // namespace fettle::physics
