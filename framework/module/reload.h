#pragma once
// Replacing a module by a newer one in a tree.

#include <filesystem>
#include <functional>
#include <string_view>

#include <fettle/module/plugin.h>

namespace fettle::module {

/// Opens the file, ends the module of the state and lets the new one take over its classes and
/// instances. `now` gets each phase. Throws LoadError, or an exception of the tree or the module;
/// if the old module has been ended by then, its plugin has given up.
Reloaded reload(Plugin::State& state, const std::filesystem::path& copy,
                const std::function<void(std::string_view)>& now);

}  // namespace fettle::module
