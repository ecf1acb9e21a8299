#pragma once
// Saved values whose property now has another type, or is gone: they are converted, replaced by the
// default, or reported.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/class.h>

namespace fettle::property {

/// The saved values that could not be restored, for a report.
class UnfitValues {
  public:
    void add(const Property& property, Value saved);
    /// Values of a property that the class no longer has, of which `saved` is the first.
    void add_removed(const Class& of, std::string_view property, Value saved,
                     std::size_t count = 1);
    /// One line for each property, sorted by name.
    std::vector<std::string> lines() const;

  private:
    struct OfProperty {
        const Property* property = nullptr;  // null: the class no longer has it
        std::string hint{};                  // the name that is meant, if the property is gone
        Value first{};
        std::size_t count = 0;
    };
    std::map<std::string, OfProperty> all_;  // by class and name of the property
};

/// Converts a saved value to the current type of the property. If that is impossible, returns the
/// default and adds the value to `unfit`.
Value fit_saved_value(const Property& property, Value saved, UnfitValues& unfit);

}  // namespace fettle::property
