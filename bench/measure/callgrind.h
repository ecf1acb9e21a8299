#pragma once
// Counting of instructions with valgrind. On a machine with other load, a clock is too noisy for
// differences of a percent.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fettle::bench {

/// Whether valgrind can be started here.
bool callgrind_available();

/// Runs this program again with `arguments` under callgrind. Returns the instructions in
/// `measured_steps` and its callees; nullopt if valgrind printed no number.
std::optional<std::uint64_t> count_instructions(const std::vector<std::string>& arguments);

}  // namespace fettle::bench
