#pragma once
// Lists of fields that live as long as the program, for records that outlive the tree of their
// class.

#include <vector>

#include <fettle/property/class.h>

namespace fettle::property {

/// A list with the same fields. Equal lists are stored once for the whole program and, like
/// symbols, never given back, so a record needs no share of them and costs nothing more.
const std::vector<Field>& lasting(const std::vector<Field>& fields);

}  // namespace fettle::property
