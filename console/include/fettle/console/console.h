#pragma once
// The in-game console and inspector: a layer over the running game.
//
// The grave key opens and closes it. While it is open, it gets all keys, and the mouse over its
// windows; a click on a body of the game selects that body. Its settings are properties of the
// instance `console`: `console.open = true`, `console.pauses = true`.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/app/frame_log.h>
#include <fettle/app/layer.h>
#include <fettle/console/export.h>
#include <fettle/console/interpreter.h>
#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>

FETTLE_CONSOLE_BEGIN

namespace fettle::property {
class Tweaks;
}

namespace fettle::console {

/// How a player has arranged the console of a game.
struct Layout {
    std::map<std::string, property::Value> settings{};  // properties of `console`
    std::vector<std::string> pins{}, plots{};           // paths and expressions
};

/// The settings that a host gives to its console. Each may be left out.
struct Options {
    app::Clipboard* clipboard = nullptr;  // null: copied text stays inside the console
    /// File for the typed commands of all runs; empty: there is none. A file that cannot be read or
    /// written is reported in the console once and then ignored.
    std::filesystem::path history_file{};
    /// Converts pixels from the top left to world units, and back. Without these functions, bodies
    /// cannot be clicked.
    std::function<property::Vec2(float x, float y)> to_world{};
    std::function<property::Vec2(property::Vec2 world)> to_pixels{};
    /// Whether something covers the picture of the game, such as an error: then no marks are drawn
    /// over it.
    std::function<bool()> game_covered{};
    /// The part of the window that other layers leave free, such as an error at the lower edge.
    /// Marks are drawn there only.
    std::function<app::ClipRectangle(const app::ClipRectangle& whole)> free_of_others{};
    /// Tweaks to list, keep and drop; null: nothing of them is shown.
    property::Tweaks* tweaks = nullptr;
    /// Whether the game stands because a script failed. Without this function and `resume`, the
    /// buttons of the time bar know pauses only.
    std::function<bool()> halted{};
    /// Makes a game go on that stands because a script failed.
    std::function<void()> resume{};
    /// Shows the kept past: calls `visit` after each step from `from` to `to`, which may be later
    /// than the present one, with the tree as it was then (app::Timeline::review). Without it,
    /// plots begin when they are made, onion skins show only poses that the console has seen, and
    /// `last_time` is refused.
    std::function<void(std::int64_t from, std::int64_t to,
                       const std::function<void(std::int64_t step)>& visit)>
        review{};
    /// Repeats the kept past with a change at `from` (app::Timeline::repeat_with). Without it, `ab`
    /// is refused.
    std::function<void(std::int64_t from, const std::function<void()>& change,
                       const std::function<void(std::int64_t step)>& visit)>
        repeat_with{};
    /// As `review`, for the steps of another branch of the past (app::Timeline::review_branch).
    /// Without it, `compare_branch` is refused.
    std::function<void(const std::string& branch, std::int64_t from,
                       const std::function<void(std::int64_t step)>& visit)>
        review_branch{};
    /// Whether scripts draw by themselves (script::Runtime::draws), which a comparison of two runs
    /// leaves out, with a note.
    std::function<bool()> scripts_draw{};
    /// Writes this moment into a file, and returns a message about the file. Without it, `share` is
    /// refused.
    std::function<std::string(const std::string& file)> share{};
    /// Begins or ends a file with the recording of the run, and returns a message about it. Without
    /// it, `record` is refused.
    std::function<std::string(bool on)> record{};
    /// Whether such a file is being written. Without it, the time bar has no button for `record`.
    std::function<bool()> records{};
    /// Begins the game again after this frame. Without it, `restart` is refused.
    std::function<void()> restart{};
    /// Returns the text of a script of the game, "main.lua"; throws if it cannot be read. Without
    /// it, the lines that wrote a value are not shown.
    std::function<std::string(const std::string& file)> script{};
    /// The times of the last frames, which must outlive the console; null: they are not shown.
    const app::FrameLog* frames = nullptr;
    /// Receives the results of breaks and of searches of the past, in addition to the log.
    std::function<void(const std::string& line)> on_result{};
    /// Writes a new file for the player, and returns its path; `kind`: "csv". Throws if it cannot.
    std::function<std::string(const std::string& kind, const std::string& content)> write_file{};
    /// The same for a picture of that size in pixels, which `draw` draws.
    std::function<std::string(float width, float height,
                              const std::function<void(app::Surface&)>& draw)>
        write_picture{};
    /// The layout that the player left in an earlier run. Settings of a script replace it.
    Layout layout{};
    /// Receives the layout whenever the console is closed, and at the end.
    std::function<void(const Layout&)> keep_layout{};
    /// Commands of the player, which are run before the first frame as if they were typed. Errors
    /// say that they are in `autoexec.lua`.
    std::string first_commands{};
    /// True in a replay. The recording contains the commands that `exec` ran, so `exec` runs none.
    bool replay = false;
};

/// `console_history` in `$XDG_STATE_HOME/fettle`, or in `~/.local/state/fettle`; empty if neither
/// XDG_STATE_HOME nor HOME is set.
std::filesystem::path default_history_file();

/// `autoexec.lua` in `$XDG_CONFIG_HOME/fettle`, or in `~/.config/fettle`; empty if neither
/// XDG_CONFIG_HOME nor HOME is set.
std::filesystem::path default_autoexec_file();

/// What the console of the next run in the same window goes on with: the log, and whether the
/// player sees it.
struct FETTLE_CONSOLE_PRIVATE Continuation;

/// The console and the inspector, as a layer over a game. The grave key opens it.
class Console : public app::Layer {
  public:
    /// Registers the class `Console` (once per tree) and creates the instance `game.console`. Tree,
    /// runtime and clipboard must outlive the console.
    Console(property::Tree& tree, script::Runtime& runtime, Options options = {});
    Console(property::Tree& tree, Interpreter interpreter, Options options = {});
    ~Console() override;

    bool handle(const app::InputEvent& event) override;
    void draw(app::Surface& surface, double seconds) override;
    app::ClipRectangle free_area(const app::ClipRectangle& whole) const override;
    float text_size() const override;

    /// To be called when the modules have made a step and its changes are delivered: breaks and
    /// plots look at each step.
    void after_step();
    /// To be called between two frames: commands that wait are run, and the past is searched.
    void between_frames();

    /// Evaluates a command that was not typed here, for example in a terminal. Its first word may
    /// be an alias, as in a command that is typed. Nothing is added to the log.
    script::Evaluation evaluate(std::string_view command);
    /// The same for a command of a terminal, which does not show the views of the console: the
    /// answer says what `pin`, `plot` and others have done. `who` is the name of the terminal, for
    /// the log, which then gets the command and the beginning of its answer; "": it gets nothing.
    script::Evaluation answer_terminal(std::string_view command, std::string_view who = {});
    /// Whether a command of the terminal has begun something, such as a search of the past, whose
    /// result comes in the next call of `between_frames`, or waits.
    bool answers_later(std::string_view who = {}) const;
    /// None while the terminal waits, as `wait` has told it. Otherwise lines for it about the end
    /// of the wait, which are returned once.
    std::optional<std::vector<std::string>> waited(std::string_view who);
    /// Ends the wait of a terminal, if it waits: `waited` then returns the lines about its end.
    void stop_waiting(std::string_view who);

    bool is_open() const;         ///< whether the player sees it
    void open(bool open = true);  ///< opens or closes it
    /// The key that opens and closes it, as a text for players: "`" for the grave key.
    std::string shown_key() const;
    /// The state of this console for that of the next run.
    std::shared_ptr<const Continuation> continuation() const;
    /// Goes on where the console of an earlier run ended. To be called before the first frame.
    void continue_from(const Continuation& earlier);
    /// Call when the program has paused the game: while the console is closed, a sign says so.
    void show_pause();
    /// Whether terminals may attach (`console.listen`). The host listens then; if it cannot, it
    /// calls `listen(false)`.
    bool listens() const;
    void listen(bool listens);  ///< sets `listens`
    /// Pixels at the lower edge of the window that the console covers now, with the tooltips of its
    /// time bar.
    float covered_below() const;
    /// Selects an instance: it becomes `it`, the inspector shows it, and it gets an outline in the
    /// game.
    void select(property::Handle instance);
    /// The same for several instances; the last one becomes `it`.
    void select(const std::vector<property::Handle>& instances);
    /// A null handle if nothing is selected, or the selected instance is deleted.
    property::Handle selected() const;
    /// All selected instances that are alive; `selected` is the last one.
    std::vector<property::Handle> selection() const;

    /// `print`: text of the game's own `print`. `output`: what a command printed. `note`: what a
    /// person should know. `report`: an error of the game.
    void print(std::string_view text);
    /// Adds text that a command printed.
    void output(std::string_view text);
    /// Adds a note for the user.
    void note(std::string_view text);
    /// An error of the game.
    void report(const script::ScriptError& error);

    struct FETTLE_CONSOLE_PRIVATE State;
    /// For the library itself.
    State& state() { return *state_; }

  private:
    std::unique_ptr<State> state_;
};

}  // namespace fettle::console

FETTLE_CONSOLE_END
