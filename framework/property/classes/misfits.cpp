#include "misfits.h"

#include <utility>

#include "coerce.h"

namespace fettle::property {

void Misfits::add(const Property& property, Value saved) {
    OfProperty& of = all_[property.owner->name() + "." + property.name];
    of.property = &property;
    if (of.count++ == 0) of.first = std::move(saved);
}

std::vector<std::string> Misfits::lines() const {
    std::vector<std::string> lines;
    for (const auto& [name, of] : all_) {
        const std::string others =
            of.count == 1 ? "" : " and " + std::to_string(of.count - 1) + " more";
        lines.push_back(
            name + ": the saved value " + value_text(of.first) + others + " cannot be " +
            expectation(*of.property) +
            ", as the property now requires: " + (of.count == 1 ? "it is" : "they are") +
            " the default, " + value_text(of.property->default_value));
    }
    return lines;
}

}  // namespace fettle::property
