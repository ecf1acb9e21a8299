// The player's arrangement of the console, kept from run to run, and what stays when the game
// begins again.

#include <array>
#include <string_view>
#include <utility>

#include <fettle/property/exception_text.h>
#include <fettle/property/history.h>
#include <fettle/property/path.h>

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

/// The overlays that a person has switched on. The scripts of the game switch their own again.
std::vector<std::string> Console::State::chosen_overlays() const {
    std::vector<std::string> names;
    const property::Handle view = tree.child(tree.root(), "view");
    const property::Handle show = view ? tree.child(view, "show") : property::Handle{};
    if (!show) return names;
    for (const property::Property* flag : tree.properties(show)) {
        if (!shows(flag->name)) continue;
        const property::Provenance written = tree.last_writer(show, *flag);
        const bool by_game = written.cause.writer == property::Writer::script ||
                             written.cause.writer == property::Writer::load;
        if (written.known && !by_game) names.push_back(flag->name);
    }
    return names;
}

/// Restores the pins and plots of the last run, and the breaks and overlays from before a restart,
/// once the game is loaded.
void Console::State::restore_observed() {
    if (std::exchange(status.restored, true) || !interpreter.evaluate || options.replay) return;
    std::vector<std::string> commands;
    for (const std::string& text : options.layout.pins) commands.push_back(call_of("pin", {text}));
    if (!options.layout.plots.empty()) commands.push_back(call_of("plot", options.layout.plots));
    for (const std::string& text : status.breaks) commands.push_back(call_of("break_when", {text}));
    for (const std::string& name : status.overlays)
        if (!shows(name)) commands.push_back("view.show" + property::path_suffix(name) + " = true");
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

std::shared_ptr<const Continuation> Console::continuation() const {
    return std::make_shared<const Continuation>(
        Continuation{.lines = state_->log.lines(),
                     .open = state_->is_open(),
                     .selected_path = state_->status.selected_path,
                     .keys = state_->observing.keys(),
                     .aliases = state_->prompt.aliases(),
                     .breaks = state_->observing.breaks().texts_to_keep(),
                     .overlays = state_->chosen_overlays()});
}

void Console::continue_from(const Continuation& earlier) {
    State& s = *state_;
    s.log.put_first(earlier.lines);
    if (!earlier.lines.empty()) s.log.note("the game begins again");
    s.status.greeted = s.status.greeted || !earlier.lines.empty();
    // The next frame selects it, if there is one with this path.
    s.status.selected_path = earlier.selected_path;
    s.observing.take_keys(earlier.keys);
    s.prompt.take_aliases(earlier.aliases);
    s.status.breaks = earlier.breaks;
    s.status.overlays = earlier.overlays;
    if (earlier.open) s.open(true);
}
}  // namespace fettle::console
