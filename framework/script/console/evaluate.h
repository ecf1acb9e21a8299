#pragma once
// Evaluates console commands.

#include <string_view>

#include <fettle/script/runtime.h>

namespace fettle::script {

struct Machine;

Evaluation evaluate(Machine& machine, std::string_view command);

}  // namespace fettle::script
