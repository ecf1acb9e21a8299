#pragma once
// Properties that users have added to single instances.

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

    /// By slot, of the instances that have some (`Node::has_ad_hoc`).
    std::unordered_map<std::uint32_t, Own> of_instance;
    /// One for each name. They stay for ever.
    std::unordered_map<Symbol, std::unique_ptr<Property>> descriptors;

    /// nullptr where the instance has none of that name.
    const Entry* find(std::uint32_t index, const std::string& name) const;
    /// A descriptor for a name that has none. Throws Error(bad_name) when there are too many.
    const Property& declare(Symbol name);
};

}  // namespace fettle::property
