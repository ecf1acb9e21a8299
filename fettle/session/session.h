#pragma once
// A running game. Its tree, modules, services, scripts, console and loop are made in this order.

#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <fettle/app/layer.h>
#include <fettle/app/loop.h>
#include <fettle/app/recording.h>
#include <fettle/app/services.h>
#include <fettle/interface/interface.h>
#include <fettle/property/storage/assets.h>
#include <fettle/property/storage/game_files.h>
#include <fettle/property/storage/game_saves.h>
#include <fettle/property/storage/game_settings.h>
#include <fettle/property/storage/store.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>
#include <fettle/visuals/visuals.h>

#include <attach/listener.h>
#include <files/file_watch.h>
#include <files/recorded_files.h>
#include <game/game_modules.h>
#include <game/repeated_errors.h>
#include <game/run_options.h>

namespace fettle::console {
struct Continuation;
struct Options;
}  // namespace fettle::console

namespace fettle::program {

class Session {
  public:
    /// `clipboard` is that of the window, or null without a window. `errors` is called for every
    /// uncaught error after it was written to stderr. With `replayed`, the run is a replay of it.
    Session(const RunOptions& options, app::Clipboard* clipboard,
            std::function<void(const script::ScriptError&)> errors,
            const app::Recording* replayed = nullptr);
    ~Session();
    Session(const Session&) = delete;

    /// Loads the game and runs the chunks of --eval. Throws property::FileError if the game cannot
    /// be read.
    void start();

    property::Tree& tree() { return tree_; }
    app::Loop& loop() { return *loop_; }
    app::Services& services() { return *services_; }
    script::Runtime& runtime() { return *runtime_; }
    property::GameSaves& saves() { return *saves_; }
    const property::GameSettings& settings() const { return settings_; }
    /// Sets the size of the screen, and that of the window unless it is fullscreen.
    void set_screen(const property::Vec2& size);
    /// Content of the file that view.window.icon names; "" if it names none. Throws
    /// property::Error.
    std::string icon();
    /// Reports something that a person should know and that is not an error of the game.
    void note(const std::string& text);
    bool console_is_open() const;
    /// The key that opens the console, as it is shown to the player; "": there is no console.
    std::string console_key() const;
    /// For the console of the next run in the same window; null without a console.
    std::shared_ptr<const console::Continuation> console_continuation() const;
    /// To be called before `start`. Does nothing for null, or without a console.
    void continue_console(const std::shared_ptr<const console::Continuation>& earlier);
    /// For the next run in the same window: the terminals that are attached. Null if the game does
    /// not listen.
    std::unique_ptr<Listener> release_listener();
    /// To be called before `start`. Does nothing for null, or without a console.
    void continue_listening(std::unique_ptr<Listener> earlier);
    /// Evaluates a command of a terminal, as the console does. `who`: the name of the terminal, for
    /// the console's log; "": the log gets nothing.
    script::Evaluation evaluate(std::string_view command, std::string_view who = {});
    /// Whether that terminal waits, and how its wait has ended (console::Console::waited).
    std::optional<std::vector<std::string>> waited(std::string_view who = {});
    void stop_waiting(std::string_view who = {});
    /// Selects instances in the console; the last one becomes `it`.
    void select(const std::vector<property::Handle>& instances);
    /// The test, if the run is one; null otherwise.
    TestDriver* test() { return test_.get(); }
    /// Sets the receiver of the lines that the game prints, and of notes, in place of the terminal.
    /// Errors are then passed to `errors` only.
    void on_output(std::function<void(std::string_view)> sink) {
        receivers_.output = std::move(sink);
    }
    /// Pixels at the lower edge of the window that the console covers.
    float covered_below() const;
    /// The part of the window, in pixels, that the console does not cover.
    app::ClipRectangle free_area(const app::ClipRectangle& whole) const;
    /// Whether a restart of the game was requested since the last call.
    bool restart_requested() { return std::exchange(run_.restart, false); }
    /// Whether the game is at an earlier step than the newest, or, while it stands after an error,
    /// in another branch than that of the error.
    bool viewing_past() const;
    /// Goes forward by `steps` in the kept past (below 0: back), at the next barrier.
    void travel(int steps);
    /// Adds a layer below the console.
    void add_layer(app::Layer& layer);
    /// The exit status; it depends on errors and quit().
    int exit_status() const;
    /// The last step before which chunks of --at were run; the same for commands of --console.
    std::uint64_t chunks_until() const { return run_.chunks_until; }
    std::uint64_t typed_until() const { return run_.typed; }
    bool failed() const { return run_.failed; }

    /// The result of reading changed files. `restart`: main.lua had failed
    /// when the game began, so the game must begin again.
    enum class Followed : std::uint8_t { nothing, changed, failed, restart };
    /// Reads files again that have changed. Call between frames. Does nothing unless the options
    /// ask for it, and not in a recorded run: a recording is of one version of the files.
    Followed follow_files();
    /// Sets the receiver of the error of changed files; it gets null when they have none.
    void on_error_over(std::function<void(const script::ScriptError*)> sink) {
        receivers_.error_over = std::move(sink);
    }
    /// Reports an error where those of the game are reported.
    void report_error(const script::ScriptError& error);
    /// Why the recording of the run is incomplete; "" if it is complete or if there is none.
    std::string recording_problem() const;

  private:
    bool follows_files() const;
    std::vector<std::filesystem::path> watched_files() const;
    /// A scene file that was saved while the game runs.
    struct ChangedScene {
        std::size_t times_read = 0;  // how often the file was read before the game could load it
        std::vector<std::string> warnings{};
    };
    std::optional<ChangedScene> scene_in(const std::filesystem::path& file,
                                         const std::string& name);
    Followed apply_changes(const std::vector<std::filesystem::path>& changed);
    script::Reloaded reload_code(const std::vector<std::string>& names);
    script::Reloaded reload_media(const std::vector<std::string>& names);
    void renew(const std::string& name);
    void report_file_problem(const std::string& problem, const std::string& file);
    void show_problems();
    void renew_settings();
    std::string share(const std::string& name);
    bool keeps_recording() const;
    std::string record(bool on);
    void restart();
    void end_recording(const std::string& changed);
    void check_recording();
    void open_moment();
    void add_modules();
    void make_console(app::Clipboard* clipboard);
    void print(std::string_view text);
    void print_from_option(const std::string& text);
    void print_result(const std::string& line);
    void print_outside_console(std::string_view text);
    void run_at(std::uint64_t step);
    void run_due_commands();
    void listen();
    void load_players_console(console::Options& options);
    void begin_to_listen();
    Listener::Callbacks answers_of_terminals();
    std::filesystem::path new_export(const std::string& kind) const;
    std::string reason_not_to_listen() const;
    void make_files();
    void read_settings();
    bool has_console() const;
    bool isolated() const;
    std::uint64_t seed() const;
    void make_storage();
    void receive_errors_of_tree();
    std::unique_ptr<property::Store> new_store(KeptFile which, const std::filesystem::path& folder);
    void make_recorder();
    void fail(const script::ScriptError& error);
    void module_failed(const std::string& module, const std::string& message);
    /// In the log, and in the terminal unless it has another receiver.
    void show_error(const script::ScriptError& error);
    void report_repeated_errors();

    /// Functions that receive the messages of the session.
    struct Receivers {
        std::function<void(const script::ScriptError&)> errors{};
        std::function<void(std::string_view)> output{};
        std::function<void(const script::ScriptError*)> error_over{};
    };
    /// Events of the run so far.
    struct Run {
        bool loaded = false;                   // main.lua and start() had no error
        std::vector<std::string> early_notes;  // notes from before the console existed
        std::uint64_t typed = 0;               // the last step whose --console commands were run
        std::uint64_t chunks_until = 0;        // the last step whose --at chunks were run
        bool restart = false;                  // wanted by a command
        bool stepped = false;  // the modules have made a step, which is not delivered yet
        bool failed = false;
        bool ending = false;
        std::string renewed;          // the changed file that is being read
        std::string interruption;     // the last message about stopped scripts
        std::string failed_branch{};  // the branch of the past in which the game has halted
    };

    const RunOptions& options_;
    Receivers receivers_;
    const app::Recording* replayed_;  // null unless the run is a replay
    property::GameFiles files_;
    property::Assets assets_;
    property::GameSettings settings_;
    // Modules must outlive the tree, which calls them when its instances are deleted.
    GameModules modules_;
    visuals::Visuals visuals_;
    interface::Interface interface_;
    property::Tree tree_;
    std::unique_ptr<app::Services> services_;
    std::unique_ptr<property::Tweaks> tweaks_;
    std::unique_ptr<property::GameSaves> saves_;
    std::unique_ptr<property::Store> store_;
    std::unique_ptr<property::Store> preferences_;  // settings of the player, by path
    std::unique_ptr<script::Runtime> runtime_;
    std::unique_ptr<app::Loop> loop_;
    struct ConsoleLayer;
    std::unique_ptr<ConsoleLayer> console_;
    std::unique_ptr<Listener> listener_;  // while console.listen is set
    std::unique_ptr<TestDriver> test_;
    std::unique_ptr<app::Recorder> recorder_;
    FileWatch watch_;
    std::map<std::string, script::ScriptError>
        problems_;  // by changed file; "": found later, in no file that changed
    RepeatedErrors repeated_;
    Run run_;
};

}  // namespace fettle::program
