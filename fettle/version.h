#pragma once

#include <string>

namespace fettle::program {

/// What `fettle --version` says: the program, the interface of its modules, and every part it is
/// made of with its version, a line each.
std::string version_text();

}  // namespace fettle::program
