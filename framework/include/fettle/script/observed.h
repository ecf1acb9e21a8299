#pragma once
// Values that a person observes (pinned, plotted, awaited), and the functions of scripts that a
// console carries out.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/value.h>
#include <fettle/script/export.h>

FETTLE_SCRIPT_BEGIN

namespace fettle::script {

/// For an observed value without formulas. A lambda in its place would be exported.
inline void compute_nothing() {}

/// A path or an expression given as text, or a function.
struct Observed {
    std::string text;  // "world.ball.mass > 5"; the source of a function, as far as it is known
    std::string path;  // of the property, if the text is one; "" otherwise
    std::string unit;  // of that property
    /// Computes the value. It may change nothing, and is stopped after the instructions of a
    /// formula. Throws Error with the reason if there is no value.
    std::function<property::Value()> value;
    /// Computes the formulas of the properties that the text names, which `value` must not do: it
    /// would read their last results. Not to be called while the past is shown.
    std::function<void()> compute_formulas = compute_nothing;
    /// Whether it was given as a function: its text does not contain the variables that it uses, so
    /// the text alone does not mean the same.
    bool is_function() const { return text.starts_with("function"); }
};

/// What a terminal waits for before its next command.
struct Wait {
    std::optional<Observed> condition{};  // until it is true; one that is no boolean: has changed
    bool until_pause = false;             // until the game is paused
    double seconds = 60;                  // at most; all of them without the two above
};

/// What a console can list.
enum class Listed : std::uint8_t { pins, plots, breaks, bookmarks, binds, aliases };

/// What a console observes and selects.
struct ObservingFunctions {
    std::function<std::string(Observed)> pin{};
    /// The text "" is all of them.
    std::function<std::string(const std::string& text)> unpin{};
    /// The texts of what is pinned, and the present values.
    std::function<std::vector<std::pair<std::string, property::Value>>()> pins{};
    /// Lines for a person, at least one.
    std::function<std::vector<std::string>(Listed what)> listed{};
    /// Shows the values over time; an empty list ends it.
    std::function<std::string(std::vector<Observed>)> plot{};
    /// Writes the plot to a file; `kind` is "csv" or "png".
    std::function<void(const std::string& kind)> export_plot{};
    /// Pauses the game after the step in which the condition becomes true. Without a condition:
    /// forgets all of them. Returns a message: what it waits for, and the present value.
    std::function<std::string(Observed)> break_when{};
    /// Returns how many were forgotten; "" is all of them.
    std::function<std::size_t(const std::string& text)> unbreak{};
    /// The texts of the conditions.
    std::function<std::vector<std::string>()> breaks{};
    /// The selected instances, `it` last; and selects others.
    std::function<std::vector<property::Handle>()> selection{};
    std::function<std::string(const std::vector<property::Handle>&)> select{};
};

/// The past of the game, and how the game goes on.
struct TimeFunctions {
    /// Searches the kept past for the last step at which the condition was true, and goes there.
    std::function<void(Observed)> last_time{};
    /// Shows the last seconds twice: as they passed, and with that value of the property from their
    /// beginning on. Without a path: ends that.
    std::function<std::string(const std::string& path, const property::Value& value,
                              double seconds)>
        ab{};
    /// Shows the present branch of the past and another one, and their differences; "" is the
    /// branch that was left last.
    std::function<void(const std::string& branch)> compare_branch{};
    /// Marks a step on the time bar, the present one if there is none; "" gets a name.
    std::function<std::string(const std::string& name, std::optional<std::int64_t> step)>
        bookmark{};
    /// The name "" is all of them.
    std::function<std::string(const std::string& name)> unbookmark{};
    /// The names with their steps.
    std::function<std::vector<std::pair<std::string, std::int64_t>>()> bookmarks{};
    /// Shows these seconds of the past once more, as they were.
    std::function<std::string(double seconds)> play_back{};
    /// Writes this moment of the game into a file; returns a message about the file.
    std::function<std::string(const std::string& file)> share{};
    /// Begins or ends a file with the recording of the run; returns a message about the file.
    std::function<std::string(bool on)> record{};
    /// Lets the game go on after an error or a pause; returns an answer.
    std::function<std::string()> go_on{};
    /// Begins the game again.
    std::function<void()> restart{};
};

/// Commands that are typed.
struct CommandFunctions {
    /// The terminal of the present command waits before its next one. False if the command was
    /// typed in no terminal.
    std::function<bool(Wait)> wait{};
    /// Runs the command when the key goes down; an empty command ends it.
    std::function<std::string(const std::string& key, const std::string& command)> bind{};
    /// The word stands for the command; an empty command ends it.
    std::function<std::string(const std::string& word, const std::string& command)> alias{};
    /// The keys with their commands, and the words with what they stand for.
    std::function<std::map<std::string, std::string>()> binds{}, aliases{};
    /// Runs the commands of a text after the present one, as if they were typed. Errors name the
    /// file.
    std::function<void(const std::string& file, const std::string& text)> exec{};
    std::function<void()> clear{};
};

/// Called in the middle of a command or of a script; must not throw. Missing functions are refused.
/// Those that return a text answer a command with it; "" if the person sees what has happened.
struct ConsoleFunctions : ObservingFunctions, TimeFunctions, CommandFunctions {};

}  // namespace fettle::script

FETTLE_SCRIPT_END
