#pragma once
// Completion in the console: paths, keys, methods, enumerators, globals.

#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

namespace fettle::script {

struct Machine;

std::vector<Completion> complete(Machine& machine, std::string_view input, std::size_t cursor);

}  // namespace fettle::script
