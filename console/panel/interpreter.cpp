// Connects the console to a Lua runtime; only this file calls the runtime. Expressions in fields.

#include <fettle/console/interpreter.h>

#include <utility>

#include <fettle/console/console.h>
#include <fettle/property/error.h>

#include <panel/state.h>

namespace fettle::console {

Interpreter interpreter_of(script::Runtime& runtime) {
    Interpreter interpreter;
    interpreter.evaluate = [&runtime](std::string_view command) {
        return runtime.evaluate(command);
    };
    interpreter.complete = [&runtime](std::string_view input, std::size_t cursor) {
        return runtime.complete(input, cursor);
    };
    interpreter.set_selected = [&runtime](property::Handle instance) {
        runtime.set_selected(instance);
    };
    interpreter.has_defined = [&runtime](const property::Class& of) {
        return runtime.has_defined(of);
    };
    interpreter.limit_memory = [&runtime](std::function<std::size_t()> bytes,
                                          std::string property) {
        runtime.on_command_memory(std::move(bytes), std::move(property));
    };
    interpreter.serve_console = [&runtime](script::ConsoleFunctions functions) {
        runtime.serve_console(std::move(functions));
    };
    return interpreter;
}

std::optional<double> Console::State::calculated(const std::string& expression) {
    if (!interpreter.evaluate) return std::nullopt;
    const script::Evaluation evaluation = interpreter.evaluate(expression);
    const auto wrong = [](const std::string& why) {
        return property::Error(property::ErrorKind::wrong_type, why);
    };
    if (evaluation.error) throw wrong(evaluation.error->message);
    if (evaluation.incomplete) throw wrong("the expression ends too early");
    if (!evaluation.ok || !evaluation.result.is_numeric()) return std::nullopt;
    return evaluation.result.as_double();
}

Console::Console(property::Tree& tree, script::Runtime& runtime, Options options)
    : Console(tree, interpreter_of(runtime), std::move(options)) {}

}  // namespace fettle::console
