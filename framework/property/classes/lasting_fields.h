#pragma once
// Lists of fields that live as long as the program, for records that outlive the tree of their
// class.

#include <vector>

#include <fettle/property/class.h>

namespace fettle::property {

/// A list with the same fields that is never freed. Equal lists are stored once for the whole
/// program, as symbols are. So a record can refer to the list without owning a share of it.
const std::vector<Field>& lasting(const std::vector<Field>& fields);

}  // namespace fettle::property
