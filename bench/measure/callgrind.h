#pragma once
// Instructions, counted by valgrind: a clock on a busy machine is too noisy for differences of a
// percent.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fettle::bench {

/// Whether valgrind can be started here.
bool callgrind_available();

/// Runs this program again with `arguments` under callgrind and returns the instructions spent in
/// `measured_steps` and what it calls; nothing when valgrind did not say.
std::optional<std::uint64_t> count_instructions(const std::vector<std::string>& arguments);

}  // namespace fettle::bench
