// What the console does for scripts and for terminals: the functions that scripts call, and the
// answers to commands that were not typed here.

#include <algorithm>
#include <utility>

#include <fettle/property/error.h>

#include <observed/game_time.h>
#include <panel/state.h>
#include <text/utf8.h>

namespace fettle::console {

using property::Handle;
using property::Value;

/// Gives the interpreter the functions of the console and the limit of memory.
void Console::State::serve_scripts() {
    if (interpreter.limit_memory)
        interpreter.limit_memory(
            [this] {
                constexpr double megabyte = 1 << 20;
                return static_cast<std::size_t>(
                    static_cast<double>(settings.number("memory_limit")) * megabyte);
            },
            "console.memory_limit");
    if (interpreter.serve_console) {
        script::ConsoleFunctions functions = observing.functions();
        functions.selection = [this] { return inspector.selection(); };
        functions.select = [this](const std::vector<Handle>& all) {
            const bool terminal = observing.in_terminal;  // its answers are logged
            return observing.unseen(choose_all(all, !terminal));
        };
        functions.ab = [this](const std::string& path, const Value& value, double seconds) {
            if (!path.empty()) {
                comparison.request_change(path, value, seconds);
                return std::string();  // the result comes with the next frame
            }
            const bool shown = comparison.shown();
            comparison.end();
            return observing.unseen(shown ? "the comparison is ended" : "nothing is compared");
        };
        functions.listed = [this, others = functions.listed](script::Listed what) {
            return what == script::Listed::bookmarks ? bookmark_lines() : others(what);
        };
        functions.compare_branch = [this](const std::string& name) {
            comparison.request_branch(name);
        };
        functions.bookmark = [this](const std::string& name, std::optional<std::int64_t> step) {
            const auto [marked, at] = time_marks.bookmark(name, step);
            return observing.unseen("bookmark \"" + marked + "\" is at step " + std::to_string(at));
        };
        functions.unbookmark = [this](const std::string& name) {
            if (time_marks.unbookmark(name) > 0)
                return observing.unseen(name.empty() ? "all bookmarks are removed"
                                                     : "bookmark \"" + name + "\" is removed");
            return name.empty() ? std::string("there is no bookmark")
                                : property::message_text("there is no bookmark \"" + name + "\"");
        };
        functions.bookmarks = [this] { return time_marks.bookmarks(); };
        functions.play_back = [this](double seconds) {
            // A recording contains the steps to which it goes.
            if (options.replay) return std::string();
            return observing.unseen(views.time_bar.play_back(seconds));
        };
        functions.go_on = [this] { return observing.unseen(go_on()); };
        functions.wait = [this](script::Wait wait) {
            if (!status.terminal) return false;
            waits.begin(*status.terminal, std::move(wait));
            return true;
        };
        functions.share = options.share;
        functions.record = options.record;
        functions.restart = options.restart;
        if (options.replay) functions.exec = {};
        interpreter.serve_console(std::move(functions));
    }
}

/// Not an edit: undo does not take it back. So the pause ends after the command, which is one.
std::string Console::State::go_on() {
    const TimeBar::Times now = views.time_bar.times();
    if (now.halted && options.resume) options.resume();
    status.goes_on = true;
    if (!now.stands()) return "the game runs already";
    return "the game goes on from step " + std::to_string(now.step) +
           (now.in_past() ? "; what came later becomes another branch" : "");
}

std::vector<std::string> Console::State::bookmark_lines() const {
    std::vector<std::string> lines;
    for (const auto& [name, step] : time_marks.bookmarks())
        lines.push_back("step " + std::to_string(step) + "  " + name);
    if (lines.empty()) lines.emplace_back("there is no bookmark");
    return lines;
}

namespace {

/// The beginning of an answer, with the tables in it.
script::Evaluation first_lines(const script::Evaluation& all, std::size_t count) {
    script::Evaluation some;
    some.lines.assign(all.lines.begin(), all.lines.begin() + static_cast<std::ptrdiff_t>(count));
    for (script::TableLines table : all.tables) {
        if (table.first >= count) break;
        table.cells.resize(std::min(table.cells.size(), count - table.first));
        some.tables.push_back(std::move(table));
    }
    for (const script::FoldedLines& each : all.folded)
        if (each.line < count) some.folded.push_back(each);
    for (const std::size_t line : all.printed)
        if (line < count) some.printed.push_back(line);
    return some;
}

}  // namespace

script::Evaluation Console::State::answer_terminal(std::string_view command, std::string_view who) {
    constexpr std::size_t longest = 200;  // bytes of a command in the log
    constexpr std::size_t most_lines = 8;
    if (!interpreter.evaluate) return {};
    const std::uint64_t before = log.end();
    observing.in_terminal = true;
    status.terminal = who;
    script::Evaluation result = prompt.evaluate(std::string(command));
    status.terminal.reset();
    observing.in_terminal = false;
    prompt.clear_log_if_wanted();
    if (who.empty() || result.incomplete) return result;
    std::string typed(command.substr(0, command.find('\n')));
    if (typed.size() > longest) typed.resize(code_point_boundary(typed, longest));
    if (typed.size() < command.size()) typed += " …";
    log.note(std::string(who) + "› " + typed, before);
    const std::size_t shown = std::min(result.lines.size(), most_lines);
    log.output(first_lines(result, shown));
    if (shown < result.lines.size())
        log.note("… " + std::to_string(result.lines.size() - shown) +
                 " more lines in the terminal");
    if (result.error) log.error(*result.error);
    return result;
}

}  // namespace fettle::console
