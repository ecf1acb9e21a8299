#pragma once
// The global variables of the game and the console. The numbers are references in Lua's registry.

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::script {

struct Environment {
    int table = 0;
    int declared = 0;                  // names of all globals that were ever assigned
    int loaded = 0;                    // loaded modules by name
    int store = 0;                     // the value of the global of this name
    std::vector<std::string> loading;  // modules whose files run now, the innermost last
    // Table with the value of `_` at index 1, because the reference itself must not be nil.
    int last_result = 0;
    std::vector<std::string> assigned;  // globals assigned by the game and the console
    /// Variables that are properties of `game`, with the values that `state` gives them.
    std::map<std::string, property::Value, std::less<>> stated;
    /// While `enter` runs: what it begins ends with this scene.
    property::Handle entering{};
    int in_restored = 0;  // handlers of the event `restored` that run now
    property::Handle it;  // the selected instance
    /// The children that `game` had when the game was loaded, such as `world`, and their names
    /// then.
    std::vector<std::pair<std::string, property::Handle>> first_children;
};

}  // namespace fettle::script
