#pragma once
// Functions of the host, and values that scripts set for the host.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <fettle/script/observed.h>
#include <fettle/script/runtime.h>

namespace fettle::script {

/// A function may replace itself while it runs, so call a copy.
struct Host {
    std::function<void(const ScriptError&)> on_error;
    std::function<void(std::string_view)> on_print;
    std::function<void(std::string_view)> on_note;
    std::function<void(std::string_view)> on_command;
    std::function<std::size_t()> command_memory;  // bytes; empty: as in the options
    std::string memory_property;                  // path of the property with this limit
    std::function<void(double)> on_rewind;        // empty: there is no timeline
    std::optional<int> quit_status;
    std::size_t printed = 0;                        // bytes
    std::map<std::string, HostFunction> functions;  // Lua holds the addresses
    std::shared_ptr<ConsoleFunctions> console = std::make_shared<ConsoleFunctions>();
};

}  // namespace fettle::script
