#pragma once
// Properties that were added to single instances.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>

#include <fettle/property/between_steps.h>
#include <fettle/property/class.h>

namespace fettle::property {

struct AdHoc {
    using Entry = std::pair<const Property*, Value>;
    using Own = std::map<std::string, Entry>;  // by name

    /// By slot; only instances that have ad-hoc properties (`Node::has_ad_hoc`).
    std::unordered_map<std::uint32_t, Own> of_instance;
    /// One descriptor for each name. They are never deleted.
    std::unordered_map<Symbol, std::unique_ptr<Property>> descriptors;

    /// By slot, of instances whose position is an ad-hoc property; empty while no step was noted.
    std::unordered_map<std::uint32_t, Track> tracks;

    /// For pictures between two steps (between_steps.h).
    void note_step_begins();
    void note_step_ended();
    /// The ad-hoc properties that place an instance; false if it has no position among them.
    static bool find_placement(const Own& own, Placement& placement);

    /// nullptr if the instance has no ad-hoc property of that name.
    const Entry* find(std::uint32_t index, const std::string& name) const;
    Value* find_value(std::uint32_t index, const std::string& name);
    /// Adds a descriptor for a new name. Throws Error(bad_name) when there are too many.
    const Property& declare(Symbol name);
};

}  // namespace fettle::property
