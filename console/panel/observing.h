#pragma once
// The means of observation: pinned values, plots, conditions that break, searches of the past. Also
// commands that wait, and commands with a key or a word for them.

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/observed.h>

#include <branches/present_branch.h>
#include <observed/breaks.h>
#include <observed/review.h>
#include <observed/trace.h>
#include <prompt/prompt.h>
#include <text/log.h>

namespace fettle::console {

class Observing {
  public:
    Observing(property::Tree& tree, Log& log, Prompt& prompt)
        : tree_(tree), log_(log), prompt_(prompt), breaks_(tree), branch_(tree) {}

    /// Receives the line of a break; optional.
    std::function<void(const std::string& line)> on_break{};
    /// Receives the results of breaks and searches, and errors, in addition to the log; optional.
    std::function<void(const std::string& line)> on_result;

    /// The functions of the console that this class implements for scripts.
    script::ConsoleFunctions functions();
    /// Commands from a file; errors name it.
    struct Commands {
        std::string file, text;
    };
    /// Runs the commands before the next frame, as if they were typed.
    void run_later(Commands commands) { waiting_.push_back(std::move(commands)); }
    void after_step();
    /// `review` shows the kept past; may be empty.
    void between_frames(const Review& review);
    /// Computes the pinned values for a picture.
    void update();

    /// The key that opens the console, which no command can have; optional.
    std::function<std::string()> toggle_key{};
    /// Whether the log gets a note when a requested value cannot be computed now.
    bool tells_problems = true;
    /// Whether the answer of the present command is read in a terminal, which does not show the
    /// pins, the plot and the time bar.
    bool in_terminal = false;
    /// The answer where the person does not see what has happened, "" elsewhere.
    std::string unseen(const std::string& answer) const {
        return in_terminal ? answer : std::string();
    }
    /// Whether a search or commands wait for `between_frames`.
    bool waits() const { return !searched_.empty() || !waiting_.empty() || !exports_.empty(); }

    /// The command of a key, "" if it has none.
    std::string command_of_key(const std::string& key) const;
    /// The commands of all keys.
    const std::map<std::string, std::string>& keys() const { return keys_; }
    void take_keys(std::map<std::string, std::string> keys) { keys_ = std::move(keys); }

    /// Kinds of files that the plot is to be written as.
    std::vector<std::string>& exports() { return exports_; }
    std::vector<Trace>& pins() { return pins_; }
    std::vector<Trace>& plots() { return plots_; }
    const std::vector<Trace>& pins() const { return pins_; }
    const std::vector<Trace>& plots() const { return plots_; }
    /// The text with which the value of that path was pinned; "" if it is not.
    std::string pinned(const std::string& path) const;
    const Breaks& breaks() const { return breaks_; }

  private:
    std::vector<std::string> listed(script::Listed what);
    std::vector<std::string> values_of(std::vector<Trace>& traces);
    std::string pin(script::Observed what);
    std::size_t unpin(const std::string& text);
    std::string plot(std::vector<script::Observed> all);
    std::string break_when(script::Observed condition);
    void note_problem(const char* request, const Trace& trace);
    std::string bind(const std::string& key, const std::string& command);
    std::string alias(const std::string& word, const std::string& command);
    void run_waiting();
    void run_commands(const Commands& commands);
    void follow_branch(std::int64_t next);
    void read_past(const Review& review);
    std::int64_t first_to_read(bool plotted) const;
    void search_past(const Review& review, const script::Observed& condition);
    void report(const std::string& line);
    void report_error(const std::string& problem);
    void pause();
    std::int64_t time_step(const char* name, std::int64_t otherwise) const;
    void go_to(std::int64_t step);

    property::Tree& tree_;
    Log& log_;
    Prompt& prompt_;
    Breaks breaks_;
    PresentBranch branch_;
    std::vector<Trace> pins_, plots_;
    std::vector<script::Observed> searched_;
    std::deque<Commands> waiting_;
    std::vector<std::string> exports_;
    bool executing_ = false;
    int executed_ = 0;  // by such files, since they began
    std::map<std::string, std::string> keys_;
};

}  // namespace fettle::console
