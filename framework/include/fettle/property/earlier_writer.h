#pragma once
// Who wrote a value before a moment.

#include <cstdint>
#include <string>
#include <unordered_map>

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

/// The last writer for people: "console, step 412". Of writes of scripts, modules and loading it is
/// not known which value they left, so it cannot be said whether the simulation has changed it
/// since: "main.lua:3, step 0; later steps may have changed it". "": none is known. Throws
/// Error(deleted).
std::string last_writer_text(const Tree& tree, Handle instance, const Property& property);

/// The latest of the last writes of the properties of each instance, by its key. Properties that
/// are read-only or transient, and values that a simulation has changed since, do not count. As
/// fast as a look at each kept write; `Tree::last_writer` is slower for all properties of many
/// instances.
std::unordered_map<std::uint64_t, Provenance> latest_writes(const Tree& tree);

}  // namespace fettle::property

FETTLE_PROPERTY_END
