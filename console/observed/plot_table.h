#pragma once
// Plotted values as a table: text with commas (CSV, RFC 4180).

#include <string>
#include <vector>

#include <observed/trace.h>

namespace fettle::console {

/// A row for each step that has a value, with the step and its time in seconds; a vector has two
/// columns. Numbers can be read back without loss. A value that is missing is empty.
std::string csv_of(const std::vector<Trace>& plots, double dt);

}  // namespace fettle::console
