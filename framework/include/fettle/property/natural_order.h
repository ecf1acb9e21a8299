#pragma once
// The order of names in lists for people: numbers count as numbers, so brick_2 is before brick_10.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// For algorithms that sort. Rows of a table are compared cell by cell.
struct NaturalOrder {
    bool operator()(std::string_view a, std::string_view b) const;  ///< whether `a` is before `b`
    /// Whether the row `a` is before the row `b`.
    bool operator()(const std::vector<std::string>& a, const std::vector<std::string>& b) const;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
