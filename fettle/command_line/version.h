#pragma once
// The version text of the program.

#include <string>

namespace fettle::program {

/// The text of `fettle --version`: the program, the module interface and every library, one line
/// each with its version.
std::string version_text();

}  // namespace fettle::program
