#include <edits/edits.h>

#include <algorithm>

// Values that few bodies have. A body gets a record for them with the first one, and loses it with
// the last one, so that other bodies take no memory for them.

namespace fettle::physics::detail {

BodyTraits& traits_of(ObjectState& objects, uint32_t body) {
    uint32_t& traits = objects.bodies[body].traits;
    if (traits == none) traits = objects.trait_slots.allocate(objects.traits);
    return objects.traits[traits];
}

void free_default_traits(ObjectState& objects, uint32_t body) {
    uint32_t& traits = objects.bodies[body].traits;
    if (traits == none || !objects.traits[traits].are_default()) return;
    objects.trait_slots.release(objects.traits, traits);
    traits = none;
}

void set_name(ObjectState& objects, uint32_t body, std::string_view name) {
    if (name.empty() && objects.bodies[body].traits == none) return;
    auto& text = traits_of(objects, body).name;
    std::fill(std::copy(name.begin(), name.end(), text.begin()), text.end(), '\0');
    free_default_traits(objects, body);
}

}  // namespace fettle::physics::detail
