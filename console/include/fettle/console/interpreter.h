#pragma once
// Interface between the console and the interpreter of its commands.

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/console/export.h>
#include <fettle/property/value.h>
#include <fettle/script/observed.h>
#include <fettle/script/runtime.h>

FETTLE_CONSOLE_BEGIN

namespace fettle::console {

/// Missing functions do nothing. script::Runtime documents each of them.
struct Interpreter {
    std::function<script::Evaluation(std::string_view command)> evaluate{};
    std::function<std::vector<script::Completion>(std::string_view input, std::size_t cursor)>
        complete{};
    std::function<void(property::Handle instance)> set_selected{};
    std::function<bool(const property::Class& of)> has_defined{};
    std::function<void(std::function<std::size_t()> bytes, std::string property)> limit_memory{};
    std::function<void(script::ConsoleFunctions functions)> serve_console{};
};

/// The runtime must outlive it.
Interpreter interpreter_of(script::Runtime& runtime);

}  // namespace fettle::console

FETTLE_CONSOLE_END
