#pragma once
// Properties that were added to single instances.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>

#include <fettle/property/class.h>

namespace fettle::property {

struct AdHoc {
    using Entry = std::pair<const Property*, Value>;
    using Own = std::map<std::string, Entry>;  // by name

    /// By slot; only instances that have ad-hoc properties (`Node::has_ad_hoc`).
    std::unordered_map<std::uint32_t, Own> of_instance;
    /// One descriptor for each name. They are never deleted.
    std::unordered_map<Symbol, std::unique_ptr<Property>> descriptors;

    /// nullptr if the instance has no ad-hoc property of that name.
    const Entry* find(std::uint32_t index, const std::string& name) const;
    /// Adds a descriptor for a new name. Throws Error(bad_name) when there are too many.
    const Property& declare(Symbol name);
};

}  // namespace fettle::property
