// The console as a layer: opening, closing, selection, and links in the log.

#include <fettle/console/console.h>
#include <observed/game_time.h>
#include <observed/last_value.h>

#include <algorithm>

#include <fettle/property/edits.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/explaining.h>
#include <fettle/property/path.h>

#include <inspector/multi_selection.h>
#include <panel/state.h>

namespace fettle::console {

using property::Handle;
using property::Value;

namespace {

/// The property of `view.show` for an overlay, and its instance in `show`; null if there is none.
const property::Property* overlay_property(const property::Tree& tree, std::string_view overlay,
                                           Handle& show) {
    const Handle view = tree.child(tree.root(), "view");
    show = view ? tree.child(view, "show") : Handle{};
    return show ? tree.find(show, overlay) : nullptr;
}

}  // namespace

Console::State::State(property::Tree& the_tree, Interpreter the_interpreter, Options the_options)
    : tree(the_tree),
      interpreter(std::move(the_interpreter)),
      options(std::move(the_options)),
      clipboard(options.clipboard != nullptr ? options.clipboard : &memory_clipboard),
      settings(tree),
      history(options.history_file),
      prompt(interpreter, log, history, clipboard),
      ui(clipboard),
      inspector(tree),
      context_menu(tree),
      observing(tree, log, prompt),
      views{.log_view = LogView(log),
            .prompt_view = PromptView(prompt),
            .time_bar = TimeBar(tree, interpreter, time_marks),
            .tweak_list = TweakList(options.tweaks),
            .overlay_bar = OverlayBar(tree)} {
    connect();
    serve_scripts();
    if (std::string problem = history.consume_problem(); !problem.empty()) log.note(problem);
    take_settings(options.layout);
    if (!options.first_commands.empty())
        observing.run_later({"autoexec.lua", options.first_commands});
}

void Console::State::connect() {
    connect_log();
    connect_inspector();
    connect_context_menu();
    connect_lists();
    connect_time();
}

void Console::State::connect_log() {
    views.log_view.is_link = [this](std::string_view path) { return is_link(path); };
    views.log_view.follow = [this](std::string_view path, bool insert) {
        follow_link(path, insert);
    };
    views.log_view.menu = [this](std::string_view path) { context_menu.open(std::string(path)); };
    views.log_view.take_file = [this](const std::string& file) {
        clipboard->write(file);
        log.note("its path is in the clipboard");
    };
    views.log_view.unfold = [this](std::size_t index) { log.unfold(index); };
}

void Console::State::connect_inspector() {
    inspector.is_of_game = interpreter.has_defined;
    inspector.chosen = [this](Handle instance) { instance ? choose(instance) : choose_all({}); };
    inspector.insert = [this](const std::string& text) { prompt.edit().insert(text); };
    inspector.run = [this](const std::string& command) { run(command); };
    inspector.report = [this](const std::string& problem) { log.error(problem); };
    inspector.menu =
        inspector.editor().menu = [this](const std::string& path) { context_menu.open(path); };
    inspector.editor().fields().calculate = [this](const std::string& expression) {
        return calculated(expression);
    };
    inspector.editor().define = [this](const std::string& path, const std::string& expression) {
        if (!interpreter.evaluate) return std::string("there is nothing that computes formulas");
        const script::Evaluation result = interpreter.evaluate(path + " is " + expression);
        if (result.error) return result.error->message;
        return result.incomplete ? std::string("the formula ends too early") : std::string();
    };
    inspector.editor().go_to_write = [this](const property::Cause& cause, const std::string& path) {
        go_to_write(cause, path);
    };
}

void Console::State::connect_context_menu() {
    context_menu.run = [this](const std::string& command) { run(command); };
    context_menu.insert = inspector.insert;
    context_menu.tweaks = options.tweaks;
    context_menu.copy = [this](const std::string& text) { clipboard->write(text); };
    context_menu.select_class = [this](const property::Class& wanted) {
        choose_all(all_of_class(tree, wanted));
    };
    context_menu.begin_formula = [this](const property::Place& place) {
        if (!settings.flag("inspector")) return false;
        if (inspector.selected() != place.instance) choose(place.instance);
        inspector.show(*place.property);
        inspector.editor().begin_formula(*place.property);
        return true;
    };
    context_menu.pinned = [this](const std::string& path) { return observing.pinned(path); };
    context_menu.breaks = [this](const std::string& path) {
        return observing.breaks().set_on(path);
    };
}

/// The lists of tweaks and of watched values.
void Console::State::connect_lists() {
    views.tweak_list.evaluate = interpreter.evaluate;
    views.tweak_list.report = [this](const std::string& line) { log.note(line); };
    views.tweak_list.follow = views.watch_list.follow = [this](std::string_view path) {
        if (is_link(path)) follow_link(path, false);
    };
    views.watch_list.menu = views.log_view.menu;
    views.watch_list.run = context_menu.run;
    observing.on_result = comparison.on_result = options.on_result;
    comparison.scripts_draw = options.scripts_draw;
    comparison.seen = [this] { return seen(); };
    waits.halted = options.halted;
    observing.toggle_key = [this] { return settings.text("key"); };
}

/// The time bar, plots, and the figures of frames.
void Console::State::connect_time() {
    views.time_bar.run = views.plot_view.run = context_menu.run;
    views.time_bar.report = [this](const std::string& problem) { log.error(problem); };
    views.time_bar.note = [this](const std::string& line) {
        log.note(line);
        if (options.on_result) options.on_result(line);
    };
    views.time_bar.halted = options.halted;
    views.time_bar.resume = options.resume;
    if (options.record) views.time_bar.records = options.records;
    views.time_bar.insert = [this](const std::string& before, const std::string& after) {
        TextEdit& edit = prompt.edit();
        edit.insert(before + after);
        edit.place(edit.cursor() - after.size(), false);
    };
    views.plot_view.go_to =
        views.frame_view.go_to = [this](std::int64_t step) { views.time_bar.go_to(step); };
    views.frame_view.close = [this] { show_overlay("timings", false); };
    views.compare_view.close = [this] { comparison.end(); };
    observing.on_break = [this](const std::string& line) { time_marks.stop(line); };
}

bool Console::State::shows(std::string_view overlay) const {
    Handle show;
    const property::Property* const flag = overlay_property(tree, overlay, show);
    return flag != nullptr && flag->type == property::Type::boolean &&
           last_value(tree, show, *flag).boolean();
}

/// Not an edit by a person, so undo does not revert it.
void Console::State::show_overlay(std::string_view overlay, bool on) {
    Handle show;
    const property::Property* const flag = overlay_property(tree, overlay, show);
    if (flag == nullptr) return;
    const property::Tree::CauseScope cause(tree, property::Writer::module);
    tree.set(show, *flag, Value(on));
}

void Console::State::run(const std::string& command) {
    prompt.run(command);
    status.edits_without_undo = property::edits_without_undo(tree);
    views.log_view.scroll_to_end();
    const bool printed = !log.lines().empty() && log.lines().back().kind != LineKind::command &&
                         log.lines().back().kind != LineKind::continuation;
    if (printed) show_log();
}

void Console::State::show_log() {
    if (settings.flag("tweaks")) settings.set("tweaks", Value(false));
    status.inspector_over_log = false;
}

void Console::State::open(bool opened) {
    settings.set("open", Value(opened));
    follow_settings();
}

/// Any code may set `console.open` and `console.pauses`, so the settings are read every time.
void Console::State::follow_settings() {
    bool opened = is_open();
    status.used = status.used || opened;
    if (opened && !status.was_open && !status.greeted) {
        status.greeted = true;
        log.note("any Lua · Tab completes · path? explains · click a body to edit it");
    }
    if (!opened && status.was_open) {
        status.drawn = false;
        keep_layout();
        prompt.close_menu();
        ui.release_all();
        input.fed_button = input.fed_key = input.fed_text = input.fed_move = false;
        screen.panel_rect = screen.inspector_rect = {};
        screen.height_edge = screen.width_edge = screen.plot_edge = {};
        views.time_bar.hide();
        views.watch_list.hide();
        views.plot_view.hide();
        views.frame_view.hide();
        views.compare_view.hide();
        ghosts.forget();
        inspector.editor().end_drag();
        screen.popup_open = false;
    }
    find_selected_again();
    status.was_open = opened;
    pause_time(opened && settings.flag("pauses"));
}

void Console::State::pause_time(bool paused) {
    if (paused == status.pausing) return;
    const Value now = time_value(tree, "paused");
    if (!now.is(property::Type::boolean)) return;
    if (paused) status.time_was_paused = now.boolean();
    if (!status.time_was_paused) set_time_flag(tree, "paused", paused);
    status.pausing = paused;
}

std::string Console::State::choose(Handle instance, bool logs) {
    if (!tree.alive(instance)) return {};
    bool fresh = inspector.selected() != instance;
    inspector.select(instance);
    status.selected_path = tree.path(instance);
    if (interpreter.set_selected) interpreter.set_selected(instance);
    std::string line = "it = " + tree.path(instance);
    fresh = fresh || log.lines().empty() || log.lines().back().text != line;
    if (fresh && logs) log.note(line);
    return line;
}

std::string Console::State::choose_all(const std::vector<Handle>& instances, bool logs) {
    std::string line = "nothing is selected";
    if (instances.empty()) {
        inspector.deselect();
        status.selected_path.clear();
        if (interpreter.set_selected) interpreter.set_selected({});
        if (logs) log.note(line);
        return line;
    }
    inspector.select(instances);
    const std::vector<Handle> all = inspector.selection();
    if (all.empty()) return {};
    if (all.size() == 1) return choose(all.front(), logs);
    status.selected_path = tree.path(all.back());
    if (interpreter.set_selected) interpreter.set_selected(all.back());
    line = std::to_string(all.size()) + " selected, it = " + status.selected_path;
    if (logs) log.note(line);
    return line;
}

void Console::State::find_selected_again() {
    if (tree.alive(inspector.selected())) {
        status.selected_path = tree.path(inspector.selected());
        return;
    }
    if (status.selected_path.empty()) return;
    try {
        const property::Place place = property::resolve(tree, status.selected_path);
        if (place.property != nullptr) return;
        inspector.select(place.instance);
        if (interpreter.set_selected) interpreter.set_selected(place.instance);
    } catch (const property::Error&) {
        // No instance has this path now; a later frame may find one.
    }
}

// Goes there by a command, so that a recording contains it and the log shows why it is refused.
void Console::State::look_at_step(std::uint64_t step) {
    set_time_flag(tree, "paused", true);
    run("time:go_to(" + std::to_string(step) + ")");
}

void Console::State::go_to_write(const property::Cause& cause, const std::string& path) {
    const auto [file, line] = script_place(cause.where);
    if (file.empty()) {
        const bool by_person = cause.writer == property::Writer::console ||
                               cause.writer == property::Writer::inspector;
        if (by_person)
            look_at_step(cause.step);
        else
            run((cause.writer == property::Writer::simulation ? "why " : "who ") + path);
        return;
    }
    std::string text;
    try {
        text = options.script ? options.script(file) : "";
    } catch (const std::exception& error) {
        return log.error(property::exception_text(error));
    }
    constexpr int around = 3;
    log.note(cause.text() + " wrote " + path);
    std::size_t begin = 0;
    for (int n = 1; begin < text.size() && n <= line + around; ++n) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        if (n >= line - around)
            log.printed((n == line ? "› " : "  ") + std::to_string(n) + "  " +
                        text.substr(begin, end - begin));
        begin = end + 1;
    }
    views.log_view.scroll_to_end();
}

bool Console::State::is_link(std::string_view path) const {
    try {
        property::resolve(tree, path);
        return true;
    } catch (const property::Error&) {
        return false;
    }
}

void Console::State::follow_link(std::string_view path, bool insert) {
    try {
        property::Place place = property::resolve(tree, path);
        if (insert) {
            prompt.edit().insert(path);
            return;
        }
        choose(place.instance);
        if (place.property != nullptr) inspector.select(place.instance, place.property->name);
    } catch (const property::Error&) {
        // The text is not a path (any more).
    }
}

// --- The layer

Console::Console(property::Tree& tree, Interpreter interpreter, Options options)
    : state_(std::make_unique<State>(tree, std::move(interpreter), std::move(options))) {}

Console::~Console() {
    state_->keep_layout();
    if (state_->interpreter.limit_memory) state_->interpreter.limit_memory({}, {});
    if (state_->interpreter.serve_console) state_->interpreter.serve_console({});
}

void Console::after_step() {
    state_->observing.after_step();
    state_->onion_skins.after_step();
    state_->waits.after_step();
}
void Console::between_frames() {
    State& s = *state_;
    s.restore_observed();
    if (std::exchange(s.status.goes_on, false)) set_time_flag(s.tree, "paused", false);
    s.views.time_bar.play_on(s.inspector.editor().drags());
    if (s.status.was_open) property::prepare_explanations(s.tree, s.inspector.selected());
    s.observing.between_frames(s.options.review);
    s.export_plots();
    s.ghosts.watch(s.settings.flag("ghosts"));
    s.comparison.between_frames(s.options.review, s.options.repeat_with, s.options.review_branch);
    s.onion_skins.follow(s.shows("onion_skins") ? s.inspector.selected() : Handle{});
    s.onion_skins.between_frames(s.options.review);
    s.waits.between_frames();
}
float Console::covered_below() const {
    const State& s = *state_;
    float top = s.screen.height;
    if (s.status.was_open && !s.views.time_bar.rect().empty())
        top = s.views.time_bar.rect().low.y - s.views.time_bar.tip_room();
    for (const Rect& rect :
         {s.views.watch_list.rect(), s.views.plot_view.rect(), s.views.frame_view.rect()})
        if (s.status.was_open && !rect.empty()) top = std::min(top, rect.low.y);
    return std::max(0.0f, s.screen.height - top);
}

float Console::text_size() const {
    return state_->screen.width > 0 ? state_->text_size() : 0;
}

app::ClipRectangle Console::free_area(const app::ClipRectangle& whole) const {
    return state_->free_area(whole);
}

bool Console::handle(const app::InputEvent& event) {
    return state_->handle(event);
}

void Console::draw(app::Surface& surface, double seconds) {
    State& s = *state_;
    constexpr float largest = 32768;  // px; a layout of infinite size has no place for anything
    s.screen.width = std::min(surface.width(), largest);
    s.screen.height = std::min(surface.height(), largest);
    s.follow_settings();
    if (!s.status.was_open) return s.draw_paused_sign(surface);
    s.screen.paused_sign = {};
    s.frame(seconds);
    s.ui.draw(surface);
}

script::Evaluation Console::evaluate(std::string_view command) {
    const State& s = *state_;
    if (!s.interpreter.evaluate) return {};
    return s.prompt.evaluate(std::string(command));
}

script::Evaluation Console::answer_terminal(std::string_view command, std::string_view who) {
    return state_->answer_terminal(command, who);
}

bool Console::answers_later(std::string_view who) const {
    const State& s = *state_;
    return s.observing.waits() || s.comparison.waits() || s.waits.has(who);
}

std::optional<std::vector<std::string>> Console::waited(std::string_view who) {
    return state_->waits.result(who);
}

void Console::stop_waiting(std::string_view who) {
    state_->waits.stop(who);
}

bool Console::is_open() const {
    return state_->is_open();
}
void Console::open(bool open) {
    state_->open(open);
}
bool Console::listens() const {
    return state_->settings.flag("listen");
}
void Console::listen(bool listens) {
    state_->settings.set("listen", Value(listens));
}
void Console::select(Handle instance) {
    state_->choose(instance);
}

void Console::select(const std::vector<Handle>& instances) {
    if (instances.size() == 1)
        state_->choose(instances.front());
    else
        state_->choose_all(instances);
}

std::vector<Handle> Console::selection() const {
    return state_->inspector.selection();
}

Handle Console::selected() const {
    Handle instance = state_->inspector.selected();
    return state_->tree.alive(instance) ? instance : Handle{};
}

void Console::print(std::string_view text) {
    state_->log.game(text);
}
void Console::output(std::string_view text) {
    state_->log.output(text);
}
void Console::note(std::string_view text) {
    state_->log.note(text);
}
void Console::report(const script::ScriptError& error) {
    state_->log.error(error);
    state_->time_marks.error(error.message);
}

}  // namespace fettle::console
