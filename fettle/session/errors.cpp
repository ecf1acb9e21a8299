// Errors of a run: where they are reported, and which of them end it.

#include <string>
#include <utility>

#include <fettle/app/error_screen.h>

#include <session/console_layer.h>
#include <session/session.h>
#include <terminal/terminal.h>

namespace fettle::program {

void Session::fail(const script::ScriptError& error) {
    // Not an error of the game: its scripts were stopped to end the run.
    if (runtime_->interrupted()) {
        if (std::exchange(run_.interruption, error.message) != error.message)
            print_error("in " + error.context + ": " + error.message);
        return;
    }
    run_.failed = true;
    if (repeated_.first(error)) show_error(error);
    if (!loop_->halted()) {
        run_.failed_branch = services_->clock.branch;
        if (listener_)
            listener_->print("the game stands at step " + std::to_string(services_->clock.step) +
                             ": go_on() lets it go on, also after rewind(2)");
    }
    loop_->halt();
    if (receivers_.errors) receivers_.errors(error);
}

/// An error of a native module is one of the game. A function that draws is called again while the
/// game is halted, and after the end of the run modules delete their instances.
void Session::module_failed(const std::string& module, const std::string& message) {
    script::ScriptError error;
    error.message = module + ": " + message;
    error.context = "native module";
    if (run_.ending) return note("error in " + error.context + ": " + error.message);
    if (loop_->halted()) return report_error(error);
    fail(error);
}

/// A method that fails for each of a hundred instances is reported once, with the count.
void Session::report_error(const script::ScriptError& error) {
    if (!repeated_.first(error)) return;
    show_error(error);
    if (receivers_.output && receivers_.errors) receivers_.errors(error);
}

void Session::show_error(const script::ScriptError& error) {
    if (!receivers_.output) print_error_lines(app::error_text(error));
    if (listener_) listener_->print(app::error_text(error));
    if (console_) console_->report(error);
}

void Session::report_repeated_errors() {
    for (const std::string& sentence : repeated_.take()) note(sentence);
}

}  // namespace fettle::program
