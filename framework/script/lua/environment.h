#pragma once
// The global variables of the game and the console. Numbers are references in Lua's registry.

#include <string>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::script {

struct Environment {
    int table = 0;
    int declared = 0;                   // names of globals ever assigned
    int loaded = 0;                     // modules by name
    int last_result = 0;                // `_` is element 1: a reference itself must never be nil
    std::vector<std::string> assigned;  // globals that the game and the console made
    property::Handle it;                // what is selected
};

}  // namespace fettle::script
