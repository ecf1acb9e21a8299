#pragma once
// What the host is told and asked, and what it learns from the scripts.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <fettle/script/runtime.h>

namespace fettle::script {

/// A function may put another in its own place while it runs: call a copy.
struct Host {
    std::function<void(const ScriptError&)> on_error;
    std::function<void(std::string_view)> on_print;
    std::function<void(std::string_view)> on_note;
    std::function<void(std::string_view)> on_command;
    std::function<std::size_t()> command_memory;  // bytes; empty: as the options say
    std::string memory_property;                  // path of the property that says so
    std::function<void(double)> on_rewind;        // by seconds; empty: there is no timeline
    std::optional<int> quit_status;
};

}  // namespace fettle::script
