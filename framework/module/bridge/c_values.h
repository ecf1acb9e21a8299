#pragma once
// Conversion of values at the C interface. Small values are copied; others point into memory that
// the sender keeps until its next call.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <fettle/module/abi.h>
#include <fettle/property/class.h>
#include <fettle/property/error.h>
#include <fettle/property/value.h>

namespace fettle::module {

/// Keeps the memory that sent values point to.
class Outgoing {
  public:
    Outgoing() = default;
    Outgoing(const Outgoing&) = delete;
    Outgoing& operator=(const Outgoing&) = delete;

    /// Frees the memory of all values that were put.
    void clear() {
        kept_.clear();
        arrays_.clear();
    }
    fettle_value put(const property::Value& value);
    /// Valid until `clear`.
    const fettle_value* put(std::span<const property::Value> values);
    fettle_result put(const property::Result& result);

  private:
    std::vector<property::Value> kept_;
    // Moving the outer vector does not move the inner arrays.
    std::vector<std::vector<fettle_value>> arrays_;
};

/// Converts a received value. Throws Error(wrong_type) for an unknown type, a text or list with a
/// length but no memory, and lists nested more than 64 deep, such as a list that contains itself.
property::Value received(const fettle_value& value);
std::vector<property::Value> received(const fettle_value* values, std::size_t count);
/// `fields` must outlive the result.
property::Result received(const fettle_result& result, const std::vector<property::Field>& fields);

inline fettle_handle sent(property::Handle handle) {
    return {handle.index, handle.generation};
}
inline property::Handle received(fettle_handle handle) {
    return {handle.index, handle.generation};
}
/// Null becomes "".
inline std::string_view view(const char* text) {
    return text == nullptr ? std::string_view() : std::string_view(text);
}
inline std::string text_or_empty(const char* text) {
    return text == nullptr ? std::string() : std::string(text);
}

/// The flags of a property: its members that are true.
std::uint32_t flags_of(const property::Property& property);

fettle_status status_of(property::ErrorKind kind);
property::ErrorKind kind_of(fettle_status status);

/// Copies a structure that may have fewer or more fields on the sender's side. Missing fields
/// become zero.
template <class Struct>
Struct known_part(const void* from, std::size_t size) {
    Struct copy{};
    std::memcpy(static_cast<void*>(&copy), from, std::min(size, sizeof copy));
    return copy;
}

template <class Element>
std::vector<Element> elements(const fettle_array& array) {
    std::vector<Element> copies;
    if (array.count == 0) return copies;
    if (array.data == nullptr || array.size == 0)
        throw property::Error(property::ErrorKind::bad_structure,
                              "an array of " + std::to_string(array.count) +
                                  (array.data == nullptr ? " elements has no memory (`data`)"
                                                         : " elements of 0 bytes (`size`)"));
    for (std::size_t i = 0; i < array.count; ++i)
        copies.push_back(
            known_part<Element>(static_cast<const char*>(array.data) + i * array.size, array.size));
    return copies;
}

}  // namespace fettle::module
