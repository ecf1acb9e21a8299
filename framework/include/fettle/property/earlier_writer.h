#pragma once
// Who wrote a value before a moment.

#include <cstdint>

#include <fettle/property/export.h>
#include <fettle/property/history.h>
#include <fettle/property/tree.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The last writer of the property among the writes up to that step, the present one at most. Not
/// known if nothing has written it, or so many others since that the write is not remembered. What
/// a simulation writes is not among the writes. Throws Error(deleted).
Provenance last_writer_until(Tree& tree, Handle instance, const Property& property,
                             std::uint64_t step);

}  // namespace fettle::property

FETTLE_PROPERTY_END
