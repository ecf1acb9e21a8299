#pragma once
// The console of a session; it has none in a build without the console.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#ifdef FETTLE_WITH_CONSOLE
#include <fettle/console/console.h>
#endif

#include <session/session.h>

namespace fettle::program {

#ifdef FETTLE_WITH_CONSOLE
struct Session::ConsoleLayer : console::Console {
    using Console::Console;
};
#else
struct Session::ConsoleLayer {
    void print(std::string_view) {}
    void output(std::string_view) {}
    void note(std::string_view) {}
    void report(const script::ScriptError&) {}
    script::Evaluation evaluate(std::string_view) { return {}; }
    script::Evaluation answer_terminal(std::string_view, std::string_view) { return {}; }
    std::optional<std::vector<std::string> > waited(std::string_view) {
        return std::vector<std::string>();
    }
    void stop_waiting(std::string_view) {}
    void show_pause() {}
    void select(const std::vector<property::Handle>&) {}
    std::vector<property::Handle> selection() const { return {}; }
};
#endif

}  // namespace fettle::program
