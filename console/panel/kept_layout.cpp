// The player's arrangement of the console, kept from run to run.

#include <array>
#include <string_view>
#include <utility>

#include <fettle/property/exception_text.h>

#include <observed/last_value.h>
#include <panel/state.h>
#include <text/utf8.h>

namespace fettle::console {

namespace {

constexpr std::array<std::string_view, 8> kept_settings = {
    "inspector", "time_bar",        "font_size",   "scale",
    "height",    "inspector_width", "plot_height", "opacity"};

std::vector<std::string> texts_of(const std::vector<Trace>& traces) {
    std::vector<std::string> texts;
    for (const Trace& trace : traces)
        if (!trace.what().is_function()) texts.push_back(trace.what().text);
    return texts;
}

std::string call_of(const char* function, const std::vector<std::string>& texts) {
    std::string command;
    for (const std::string& text : texts)
        command += (command.empty() ? "" : ", ") + lua_string(text);
    return std::string(function) + "(" + command + ")";
}

}  // namespace

/// A setting that does not fit, from another version, is left out.
void Console::State::take_settings(const Layout& layout) {
    for (const std::string_view name : kept_settings) {
        const auto found = layout.settings.find(std::string(name));
        if (found == layout.settings.end()) continue;
        try {
            settings.set(name, found->second);
        } catch (const property::Error& error) {
            log.note(std::string("the layout of the last run: ") + error.what());
        }
    }
}

/// Restores the pins and plots of the last run, and the breaks from before a restart, once the game
/// is loaded.
void Console::State::restore_observed() {
    if (std::exchange(status.restored, true) || !interpreter.evaluate || options.replay) return;
    std::vector<std::string> commands;
    for (const std::string& text : options.layout.pins) commands.push_back(call_of("pin", {text}));
    if (!options.layout.plots.empty()) commands.push_back(call_of("plot", options.layout.plots));
    for (const std::string& text : status.breaks) commands.push_back(call_of("break_when", {text}));
    observing.tells_problems = false;  // the game may not have made them yet
    for (const std::string& command : commands) {
        const script::Evaluation result = interpreter.evaluate(command);
        if (result.error) log.note("the layout of the last run: " + result.error->message);
    }
    observing.tells_problems = true;
}

Layout Console::State::layout() const {
    Layout made;
    const property::Handle own = tree.child(tree.root(), "console");
    for (const std::string_view name : kept_settings)
        if (const property::Property* const kept = own ? tree.find(own, name) : nullptr)
            made.settings.emplace(name, last_value(tree, own, *kept));
    made.pins = texts_of(observing.pins());
    made.plots = texts_of(observing.plots());
    return made;
}

void Console::State::keep_layout() {
    // Until the pins of the last run are restored, nothing is kept.
    if (!options.keep_layout || !status.restored) return;
    try {
        options.keep_layout(layout());
    } catch (const std::exception& error) {
        log.note("the layout is not kept: " + property::exception_text(error));
    }
}

}  // namespace fettle::console
