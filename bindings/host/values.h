#pragma once

#include <fettle/property/tree.h>
#include <fettle_host.h>

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "../c/calls/failure.h"

// Values of the tree as values in C, and the other way round.

namespace fettle::host {

using physics_c::Failure;
using physics_c::flag;
using physics_c::needed;

/// A text that must not be null.
inline const char* text_of(const char* name, const char* text) {
    return &needed(name, text);
}

/// The memory of texts and lists to which a caller in C gets pointers. They are valid until
/// `clear`, or until the object is destroyed.
class ReturnedData {
  public:
    const char* text(std::string_view text) { return texts_.emplace_back(text).c_str(); }
    fettle_hosted_value value(const property::Value& value);
    fettle_hosted_value result(const property::Result& result);
    void clear() {
        texts_.clear();
        lists_.clear();
    }

  private:
    fettle_hosted_value list(const property::List& list);

    std::deque<std::string> texts_;
    std::deque<std::vector<fettle_hosted_value>> lists_;
};

inline fettle_instance converted(property::Handle handle) {
    return fettle_instance{handle.generation} << 32 | handle.index;
}
inline property::Handle handle_of(fettle_instance instance) {
    return {static_cast<std::uint32_t>(instance), static_cast<std::uint32_t>(instance >> 32)};
}

/// Converts a value from C. Throws Failure for an unknown type, a null text or list, and a list
/// that is too long or nested too deep. `name`: for the message.
property::Value value_of(const char* name, const fettle_hosted_value& value);
std::vector<property::Value> values_of(const char* name, const fettle_hosted_value* values,
                                       std::uint32_t count);

}  // namespace fettle::host
