#pragma once
// A bound of the range of a property as text.

#include <string>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// As `number_text`, but "1e8" in place of "100000000", whose zeros are hard to count.
std::string bound_text(double bound, Precision precision = Precision::double_precision);

}  // namespace fettle::property

FETTLE_PROPERTY_END
