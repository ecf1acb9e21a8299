#include <observed/game_time.h>
#include <panel/observing.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>

#include <fettle/app/input.h>
#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <text/utf8.h>

namespace fettle::console {

using property::Handle;
using property::Type;
using property::Value;

namespace {

constexpr std::size_t max_pins = 50, max_plots = 12;
constexpr int most_executed = 100;         // files run by such files, between two frames
constexpr std::size_t most_exports = 4;    // between two frames
constexpr std::int64_t pinned_past = 240;  // steps
constexpr double longest_reading = 2000;   // ms

}  // namespace

script::ConsoleFunctions Observing::functions() {
    script::ConsoleFunctions f;
    f.pin = [this](script::Observed what) { return pin(std::move(what)); };
    f.unpin = [this](const std::string& text) {
        if (unpin(text) == 0) return std::string("nothing like that is pinned");
        return unseen(text.empty() ? "nothing is pinned any more" : text + " is no longer pinned");
    };
    f.pins = [this] {
        std::vector<std::pair<std::string, Value>> all;
        for (Trace& pin : pins_) {
            pin.sample_at_once(tree_);
            all.emplace_back(pin.what().text,
                             pin.problem().empty() ? pin.value() : Value(pin.short_problem(tree_)));
        }
        return all;
    };
    f.listed = [this](script::Listed what) { return listed(what); };
    f.plot = [this](std::vector<script::Observed> all) { return plot(std::move(all)); };
    f.break_when = [this](script::Observed condition) { return break_when(std::move(condition)); };
    f.unbreak = [this](const std::string& text) { return breaks_.remove(text); };
    f.breaks = [this] { return breaks_.texts(); };
    f.last_time = [this](script::Observed condition) {
        constexpr std::size_t most = 20;
        if (searched_.size() == most)
            throw property::Error(property::ErrorKind::rejected,
                                  "last_time: at most 20 searches in one frame");
        searched_.push_back(std::move(condition));
    };
    f.bind = [this](const std::string& key, const std::string& command) {
        return bind(key, command);
    };
    f.binds = [this] { return keys_; };
    f.aliases = [this] { return prompt_.aliases(); };
    f.alias = [this](const std::string& word, const std::string& command) {
        return alias(word, command);
    };
    f.exec = [this](const std::string& file, const std::string& text) {
        if (executing_ && ++executed_ > most_executed)
            throw property::Error(property::ErrorKind::rejected,
                                  "exec: files of commands have run " +
                                      std::to_string(most_executed) + " others: no more are run");
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        run_later(
            {file, text.starts_with(byte_order_mark) ? text.substr(byte_order_mark.size()) : text});
    };
    f.export_plot = [this](const std::string& kind) {
        if (exports_.size() < most_exports) exports_.push_back(kind);
    };
    f.clear = [this] { prompt_.clear_log_afterwards(); };
    return f;
}

// --- Lists

namespace {

/// Lines with the second texts in a column.
std::vector<std::string> in_columns(const std::vector<std::pair<std::string, std::string>>& rows) {
    std::size_t widest = 0;
    for (const auto& [first, second] : rows) widest = std::max(widest, code_point_count(first));
    std::vector<std::string> lines;
    lines.reserve(rows.size());
    for (const auto& [first, second] : rows)
        lines.push_back(first + std::string(widest - code_point_count(first) + 2, ' ') + second);
    return lines;
}

/// Whether it reads how long frames took: that is no part of the kept past, in which the present
/// times would be read for every step.
bool reads_timings(const Trace& trace) {
    return trace.what().text.find("time.timings") != std::string::npos;
}

}  // namespace

std::vector<std::string> Observing::values_of(std::vector<Trace>& traces) {
    std::vector<std::pair<std::string, std::string>> rows;
    for (Trace& trace : traces) {
        trace.sample_at_once(tree_);
        std::string text = trace.short_problem(tree_);
        if (trace.problem().empty()) {
            text = breaks_.text_of(trace.value());
            if (!trace.what().unit.empty() && !trace.value().is_nil())
                text += " " + trace.what().unit;
        }
        rows.emplace_back(trace.what().text, text);
    }
    return in_columns(rows);
}

std::vector<std::string> Observing::listed(script::Listed what) {
    std::vector<std::string> lines;
    const char* none = "";
    switch (what) {
        case script::Listed::pins:
            lines = values_of(pins_);
            none = "nothing is pinned";
            break;
        case script::Listed::plots:
            lines = values_of(plots_);
            none = "nothing is plotted";
            break;
        case script::Listed::breaks:
            lines = breaks_.texts();
            none = "no break is set";
            break;
        case script::Listed::binds:
            lines = in_columns({keys_.begin(), keys_.end()});
            none = "no key runs a command";
            break;
        case script::Listed::aliases:
            lines = in_columns({prompt_.aliases().begin(), prompt_.aliases().end()});
            none = "no word is an alias";
            break;
        case script::Listed::bookmarks:
            return {};
    }
    if (lines.empty()) lines.emplace_back(none);
    return lines;
}

// --- Requests

std::string Observing::pin(script::Observed what) {
    unpin(what.text);
    if (pins_.size() == max_pins)
        throw property::Error(
            property::ErrorKind::rejected,
            "pin: there are " + std::to_string(max_pins) + " pinned values already; unpin one");
    pins_.emplace_back(std::move(what));
    pins_.back().sample(tree_);
    note_problem("pin", pins_.back());
    return unseen(pins_.back().what().text + " is pinned; `pins` lists what is");
}

std::size_t Observing::unpin(const std::string& text) {
    return std::erase_if(pins_,
                         [&](const Trace& pin) { return text.empty() || pin.what().text == text; });
}

std::string Observing::pinned(const std::string& path) const {
    const auto pin =
        std::ranges::find_if(pins_, [&](const Trace& each) { return each.what().path == path; });
    return pin == pins_.end() ? std::string() : pin->what().text;
}

std::string Observing::plot(std::vector<script::Observed> all) {
    if (all.size() > max_plots)
        throw property::Error(property::ErrorKind::rejected,
                              "plot: at most " + std::to_string(max_plots) + " values at once");
    plots_.clear();
    for (script::Observed& what : all) {
        plots_.emplace_back(std::move(what));
        plots_.back().sample(tree_);
        const Trace& added = plots_.back();
        const bool drawn = added.value().is_numeric() || added.value().is(Type::vec2) ||
                           added.value().is(Type::boolean);
        if (added.problem().empty() && !added.value().is_nil() && !drawn) {
            const std::string text = added.what().text;
            plots_.clear();
            throw property::Error(property::ErrorKind::wrong_type,
                                  "plot: " + text + " is neither a number, a vector nor a boolean");
        }
    }
    std::string texts;
    for (const Trace& trace : plots_) {
        note_problem("plot", trace);
        texts += (texts.empty() ? "" : ", ") + trace.what().text;
    }
    return unseen(plots_.empty() ? "nothing is plotted any more"
                                 : "the window plots " + texts +
                                       "; export_plot() writes the values into a file");
}

std::string Observing::break_when(script::Observed condition) {
    if (!condition.value) {
        breaks_.remove("");
        return "no break is set any more";
    }
    return breaks_.add(std::move(condition));
}

/// It may be a wrong name, or the name of something that the game has not made yet.
void Observing::note_problem(const char* request, const Trace& trace) {
    if (trace.problem().empty() || !tells_problems) return;
    report(std::string(request) + ": " + without_advice(trace.problem()) +
           "; it is shown when it has a value");
}

std::string Observing::bind(const std::string& key, const std::string& command) {
    const auto names = app::key_names();
    if (std::find(names.begin(), names.end(), key) == names.end()) {
        const std::vector<std::string> all(names.begin(), names.end());
        throw property::Error(
            property::ErrorKind::unknown_name,
            "bind: there is no key \"" + key + "\"" + property::suggestion(key, all));
    }
    if (toggle_key && key == toggle_key())
        throw property::Error(property::ErrorKind::rejected,
                              "bind: " + key +
                                  " opens and closes the console; console.key chooses another key "
                                  "for that");
    if (command.empty())
        return keys_.erase(key) == 0 ? key + " had no command" : key + " has no command any more";
    keys_[key] = command;
    return executing_ ? std::string() : key + " runs " + command;
}

std::string Observing::alias(const std::string& word, const std::string& command) {
    const bool known = prompt_.aliases().contains(word);
    prompt_.alias(word, command);
    if (command.empty())
        return known ? word + " is no alias any more" : "there is no alias " + word;
    return executing_ ? std::string() : word + " stands for " + command;
}

std::string Observing::command_of_key(const std::string& key) const {
    const auto bound = keys_.find(key);
    return bound == keys_.end() ? std::string() : bound->second;
}

// --- Each step, each frame

/// After a change of the branch, values of steps of the former one are dropped. If there
/// are others before `next`, the step that is taken next, the past is read.
void Observing::follow_branch(std::int64_t next) {
    const std::optional<std::int64_t> common = branch_.left_after();
    if (!common) return;
    breaks_.begin_again();
    for (auto* all : {&pins_, &plots_})
        for (Trace& trace : *all) {
            trace.forget_after(*common);
            trace.needs_past = trace.needs_past || next > *common + 1;
        }
}

void Observing::after_step() {
    const auto step = static_cast<std::int64_t>(tree_.step());
    follow_branch(step);
    for (auto* all : {&pins_, &plots_})
        for (Trace& trace : *all) trace.take(tree_, step);
    const std::vector<std::string> lines = breaks_.check();
    if (lines.empty()) return;
    for (const std::string& line : lines) report(line);
    if (on_break) on_break(lines.front());
    pause();
}

void Observing::update() {
    for (auto* all : {&pins_, &plots_})
        for (Trace& trace : *all) trace.sample(tree_);
}

void Observing::between_frames(const Review& review) {
    run_waiting();
    follow_branch(static_cast<std::int64_t>(tree_.step()) + 1);
    read_past(review);
    for (const script::Observed& condition : std::exchange(searched_, {}))
        search_past(review, condition);
}

/// Runs the files of commands that wait. A command may add others.
void Observing::run_waiting() {
    executed_ = 0;
    executing_ = true;
    while (!waiting_.empty()) {
        const Commands commands = std::move(waiting_.front());
        waiting_.pop_front();
        run_commands(commands);
    }
    executing_ = false;
}

/// Runs the lines of a file of commands. A command may have several lines.
void Observing::run_commands(const Commands& commands) {
    std::istringstream lines(commands.text);
    std::string command;
    bool more = true;
    int first_line = 1;  // of the command
    for (int next_line = 2; more; ++next_line) {
        std::string line;  // the last one is empty: it ends a command that is not complete
        more = static_cast<bool>(std::getline(lines, line));
        command += (command.empty() ? "" : "\n") + line;
        const bool blank = command.find_first_not_of(" \t\r\n") == std::string::npos;
        const bool comment = !blank && command.find('\n') == std::string::npos &&
                             command.compare(command.find_first_not_of(' '), 2, "--") == 0;
        script::Evaluation result;
        if (!blank && !comment && !prompt_.run(command, !more, &result)) continue;
        command.clear();
        const std::string place = commands.file + ":" + std::to_string(first_line);
        first_line = next_line;
        if (on_result) {
            for (const std::string& each : result.lines) on_result(each);
            if (result.error) on_result("✗ " + result.error->message);
        }
        if (result.error) report("this command is in " + place);
    }
}

/// The first step that is read: the steps are made again, which must not take long.
std::int64_t Observing::first_to_read(bool plotted) const {
    const std::int64_t oldest = time_step("oldest", 0), here = time_step("step", 0);
    if (!plotted) return std::max(oldest, here - pinned_past);
    // The time is estimated and not measured, so that a replay reads the same steps.
    const double each = 0.02 + 0.001 * static_cast<double>(tree_.size());  // ms, on common machines
    const double steps = longest_reading / each;
    return std::max(oldest, here - static_cast<std::int64_t>(steps));
}

/// Fills new plots and pins with the past.
void Observing::read_past(const Review& review) {
    std::vector<Trace*> wanting;
    bool plotted = false;
    for (auto* all : {&pins_, &plots_})
        for (Trace& trace : *all)
            if (std::exchange(trace.needs_past, false) && !reads_timings(trace)) {
                wanting.push_back(&trace);
                plotted = plotted || all == &plots_;
            }
    if (wanting.empty() || !review) return;
    try {
        review(first_to_read(plotted), static_cast<std::int64_t>(tree_.step()),
               [&](std::int64_t step) {
                   for (Trace* trace : wanting) trace->take(tree_, step, true);
               });
    } catch (const std::exception& error) {
        report_error(property::exception_text(error));
    }
}

void Observing::search_past(const Review& review, const script::Observed& condition) {
    if (!review) return report_error("last_time: this game keeps no past");
    const auto here = static_cast<std::int64_t>(tree_.step());
    std::int64_t first = -1, last_true = -1, became = -1;
    bool now = false;
    std::string problem;
    try {
        review(time_step("oldest", 0), here, [&](std::int64_t step) {
            if (first < 0) first = step;
            bool holds = false;
            try {
                holds = is_true(condition.value());
            } catch (const std::exception& error) {
                problem = property::exception_text(error);
            }
            if (holds && !now) became = step;
            if (holds) last_true = step;
            now = holds;
        });
    } catch (const std::exception& error) {
        return report_error(property::exception_text(error));
    }
    const std::string what = property::message_text("last_time " + condition.text + ": ");
    if (first < 0) return report(what + "no step is kept");
    if (last_true < 0)
        return problem.empty() ? report(what + "never since step " + std::to_string(first))
                               : report_error(what + without_advice(problem));
    if (now && became == first)
        return report(what + "true now, and ever since step " + std::to_string(first));
    const std::int64_t to = now ? became : last_true;
    report(what + (now ? "true since step " : "true at step ") + std::to_string(to) + ", " +
           std::to_string(here - to) + (here - to == 1 ? " step ago" : " steps ago"));
    go_to(to);
}

void Observing::report(const std::string& line) {
    log_.note(line);
    if (on_result) on_result(line);
}

void Observing::report_error(const std::string& problem) {
    log_.error(problem);
    if (on_result) on_result("✗ " + problem);
}

// --- Time

std::int64_t Observing::time_step(const char* name, std::int64_t otherwise) const {
    const Value value = time_value(tree_, name);
    return value.is(Type::integer) ? value.integer() : otherwise;
}

// As in the time bar: pausing is not an edit by a person.
void Observing::pause() {
    set_time_flag(tree_, "paused", true);
}

void Observing::go_to(std::int64_t step) {
    pause();
    const Handle time = tree_.child(tree_.root(), "time");
    if (!time || tree_.class_of(time).method("go_to") == nullptr) return;
    try {
        tree_.call(time, "go_to", {Value(step)});
    } catch (const std::exception& error) {
        report_error(property::exception_text(error));
    }
}

}  // namespace fettle::console
