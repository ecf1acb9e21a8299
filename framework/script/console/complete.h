#pragma once
// Completes paths, keys, methods, enumerators and globals in the console.

#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

namespace fettle::script {

struct Machine;

std::vector<Completion> complete(Machine& machine, std::string_view input, std::size_t cursor,
                                 std::size_t most);

}  // namespace fettle::script
