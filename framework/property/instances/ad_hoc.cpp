#include "ad_hoc.h"

#include <fettle/property/error.h>

namespace fettle::property {
namespace {

constexpr std::size_t max_descriptors = 100'000;

}  // namespace

const AdHoc::Entry* AdHoc::find(std::uint32_t index, const std::string& name) const {
    const auto own = of_instance.find(index);
    if (own == of_instance.end()) return nullptr;
    const auto found = own->second.find(name);
    return found == own->second.end() ? nullptr : &found->second;
}

Value* AdHoc::find_value(std::uint32_t index, const std::string& name) {
    const Entry* const found = find(index, name);
    return found == nullptr ? nullptr : const_cast<Value*>(&found->second);
}

bool AdHoc::find_placement(const Own& own, Placement& placement) {
    const auto value = [&own](const char* name) {
        const auto found = own.find(name);
        return found == own.end() ? Value() : found->second.second;
    };
    const Value position = value("position"), angle = value("angle"), scale = value("scale");
    if (!position.is(Type::vec2)) return false;
    placement.position = position.vec2();
    if (angle.is_numeric()) placement.angle = angle.as_double();
    if (scale.is_numeric()) placement.scale = scale.as_double();
    return true;
}

void AdHoc::note_step_begins() {
    static const Symbol position("position");
    if (!descriptors.contains(position)) return;
    // Tracks are left out if the instance has no position any more.
    std::unordered_map<std::uint32_t, Track> noted;
    for (const auto& [index, own] : of_instance) {
        Placement now;
        if (!find_placement(own, now)) continue;
        const auto known = tracks.find(index);
        Track& track = noted[index] = known == tracks.end() ? Track() : known->second;
        track.step_begins(now);
    }
    tracks = std::move(noted);
}

void AdHoc::note_step_ended() {
    for (auto& [index, track] : tracks) {
        const auto own = of_instance.find(index);
        Placement now;
        if (own != of_instance.end() && find_placement(own->second, now)) track.step_ended(now);
    }
}

const Property& AdHoc::declare(Symbol name) {
    if (descriptors.size() >= max_descriptors)
        throw Error(ErrorKind::bad_name,
                    "\"" + name.text().substr(0, 80) + "\": properties of " +
                        std::to_string(max_descriptors) +
                        " different names were added already; keep what is counted in a list, "
                        "or in children");
    auto made = std::make_unique<Property>();
    made->name = name.text();
    made->symbol = name;
    made->type = Type::nil;
    made->any_type = made->infinity = true;
    made->doc = "Added to this instance by a user.";
    made->binding.kind = BindingKind::ad_hoc;
    return *(descriptors[name] = std::move(made));
}

}  // namespace fettle::property
