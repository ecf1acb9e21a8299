#pragma once
// Saved values that do not fit the current declaration of their property.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <fettle/property/class.h>

namespace fettle::property {

class Misfits {
  public:
    void add(const Property& property, Value saved);
    /// One line for each property, sorted by name.
    std::vector<std::string> lines() const;

  private:
    struct OfProperty {
        const Property* property = nullptr;
        Value first{};
        std::size_t count = 0;
    };
    std::map<std::string, OfProperty> all_;  // by class and name of the property
};

}  // namespace fettle::property
