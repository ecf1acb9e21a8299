#pragma once
// The field of an integer whose bits have a meaning each, such as the categories of a shape.

#include <cstdint>
#include <optional>
#include <string>

namespace fettle::console {

/// The bits that are set, in words: "none", "all", "bits 0, 2 to 5", "all but bit 3".
std::string bits_text(std::int64_t value);
/// A list that pops up with a box for each bit. Returns the new value when one is clicked.
std::optional<std::int64_t> bit_field(std::int64_t value, float width);

}  // namespace fettle::console
