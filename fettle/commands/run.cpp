#include <algorithm>
#include <chrono>

#include <fettle/app/error_screen.h>
#include <fettle/app/loudspeaker.h>
#include <fettle/app/screen.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/last_value.h>
#include <fettle/property/path.h>

#include <command_line/subcommand.h>
#include <commands/commands.h>
#include <commands/gallery.h>
#include <commands/replay_run.h>
#include <commands/run_arguments.h>
#include <commands/run_steps.h>
#include <ending/end_request.h>
#include <ending/exit_status.h>
#include <ending/turn_limit.h>
#include <files/archive.h>
#include <files/game_path.h>
#include <files/settings.h>
#include <session/game_window.h>
#include <session/session.h>

namespace fettle::program {

namespace {

int run_headless(const RunOptions& options, Gallery* gallery) {
    TurnLimit limit(longest_turn(options));
    Session session(options, nullptr, {});
    if (gallery != nullptr) gallery->connect(session);
    const EndRequest::Scripts scripts(session.runtime());
    limit_calls(session.runtime(), options);
    session.start();
    app::Loop& loop = session.loop();
    for (std::int64_t turn = 0; !session.failed() && !loop.stopped() && !loop.closing() &&
                                (!options.steps || turn < *options.steps);
         ++turn) {
        if (EndRequest::signal() != 0) close(session);
        session.follow_files();
        loop.turn();
        limit.turn_ends(loop.steps_made());
        if (gallery != nullptr && gallery->take_choice())
            session.note("open_game: a run without a window stays in the gallery");
    }
    // A signal may have arrived during the last turn, or while the game was loaded.
    if (EndRequest::signal() != 0 && !loop.closing() && !loop.stopped()) {
        close(session);
        loop.turn();
    }
    const std::unique_ptr<app::Screen> picture = picture_of(session, options);
    return finish(session, options, picture.get());
}

/// Picture for the list of saved games, at most 256 pixels wide.
property::Thumbnail thumbnail(app::Pixels pixels) {
    constexpr std::uint32_t widest = 256;
    return property::scaled_down({pixels.width, pixels.height, std::move(pixels.rgba)}, widest);
}

/// After this time in one call into the scripts, the window offers to stop it, s.
constexpr double patience = 2;

/// Runs a game in a window until the window is closed, the game quits or the number of steps is
/// reached. The key R on the error screen, or the command `restart`, restarts the game in the same
/// window. With a gallery, the run begins there, and comes back when another game ends or Escape is
/// held.
class WindowRun {
  public:
    WindowRun(const RunOptions& options, Gallery* gallery)
        : options_(options),
          record_(options.record),
          gallery_(gallery),
          limit_(longest_turn(options)),
          game_window_(options.game, read_settings(options.game)),
          error_screen_(
              {.reload = [this] { reload_ = true; },
               .go_on = [this] { session_->loop().resume(); },
               .copy = [this](const std::string& text) { window().clipboard().write(text); },
               .covered_below = [this] { return session_ ? session_->covered_below() : 0; },
               .free_area =
                   [this](const app::ClipRectangle& whole) {
                       return session_ ? session_->free_area(whole) : whole;
                   },
               .viewing_past = [this] { return session_ && session_->viewing_past(); },
               .travel =
                   [this](int steps) {
                       if (session_) session_->travel(steps);
                   },
               .console_is_open = [this] { return session_ && session_->console_is_open(); },
               .console_key =
                   [this] { return session_ ? session_->console_key() : std::string(); }}) {}

    int play() {
        start();
        for (bool last = false; !last;) {
            last = frame();
            limit_.turn_ends(session_->loop().steps_made());
            if (reload_ && may_start()) start();
        }
        return finish(*session_, options_, &window());
    }

  private:
    using Clock = std::chrono::steady_clock;

    app::Window& window() { return game_window_.screen(); }

    void show_over(const script::ScriptError& error) {
        if (!error_screen_.error()) return error_screen_.show_over(error);
        // A later error replaces the one that stopped the game.
        error_screen_.hide();
        error_screen_.show(error);
    }

    /// False, with a message, if the settings of the game have an error. Then the window stays open
    /// and shows what it showed before.
    bool may_start() {
        try {
            (void)read_settings(options_.game);
            return true;
        } catch (const std::exception& error) {
            reload_ = false;
            options_.game = game_;
            script::ScriptError report;
            report.message = property::exception_text(error);
            report.context = "files";
            session_->report_error(report);
            show_over(report);
            return false;
        }
    }

    void start() {
        reload_ = false;
        error_screen_.hide();
        loudspeaker_.silence();
        scripts_.reset();
        // Another game may have been opened from the gallery.
        const bool again = session_ && game_ == options_.game;
        const auto console = again ? session_->console_continuation() : nullptr;
        std::unique_ptr<Listener> listener = again ? session_->release_listener() : nullptr;
        game_ = options_.game;
        session_.reset();
        if (again && !options_.record.empty()) options_.record = next_recording(record_);
        window().release_textures();
        window().report_gamepads();
        session_ = std::make_unique<Session>(
            options_, &window().clipboard(),
            [this](const script::ScriptError& error) { error_screen_.show(error); });
        session_->continue_console(console);
        session_->continue_listening(std::move(listener));
        if (again && !options_.record.empty())
            session_->note("this run is recorded in " + options_.record.string());
        session_->on_error_over([this](const script::ScriptError* error) {
            if (error == nullptr) return error_screen_.hide();
            show_over(*error);
        });
        if (in_gallery()) {
            gallery_->connect(*session_);
            session_->add_layer(*gallery_);
        }
        session_->add_layer(error_screen_);
        game_window_.before_start(*session_);
        scripts_.emplace(session_->runtime());
        if (!limit_calls(session_->runtime(), options_))
            session_->runtime().limit_calls(
                patience, [this](const script::LongCall& call) { return may_go_on(call); });
        session_->start();
        game_window_.started(*session_);
        error_screen_.script_returned();
        idle_steps_ = 0;
        last_frame_ = Clock::now();
    }

    /// Returns true if the run ends with this frame.
    bool frame() {
        app::Loop& loop = session_->loop();
        const app::Clock& clock = session_->services().clock;
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - last_frame_).count();
        last_frame_ = now;
        for (app::InputEvent event; window().poll(event);) {
            track_escape(event, now);
            if (!game_window_.handle(event, *session_)) loop.handle(event);
        }
        track_back_button(now);
        if (is_held_long(escape_since_, now) || is_held_long(back_since_, now))
            open(gallery_->game());
        if (EndRequest::signal() != 0 && !loop.closing()) close(*session_);
        follow_files();
        if (reload_) return false;
        loop.frame(seconds, options_.steps.value_or(INT64_MAX));
        if (session_->restart_requested()) reload_ = true;
        error_screen_.script_returned();
        // The time bar of the console lets the game go on, too.
        if (error_screen_.error() && !loop.halted()) error_screen_.hide();
        play_sounds(loudspeaker_, *session_);
        if (clock.paused) idle_steps_ += seconds / clock.dt;
        game_window_.follow(*session_);
        // A run with a given number of steps is not interactive: it also ends if the game is
        // halted.
        const bool made = options_.steps &&
                          (loop.halted() || static_cast<double>(loop.steps_made()) + idle_steps_ >=
                                                static_cast<double>(*options_.steps));
        const bool quits = session_->runtime().quit_status().has_value();
        if (quits && may_go_back()) open(gallery_->game());
        const bool last = made || loop.closing() || (quits && !reload_);
        if (in_gallery()) {
            gallery_->make_picture();
            if (const auto choice = gallery_->take_choice()) open(*choice);
        }
        const bool saves = session_->saves().waits();
        if (saves || (last && !options_.screenshot.empty())) window().keep_frame();
        loop.draw(window(), seconds);
        error_screen_.script_returned();
        window().present();
        if (saves) session_->saves().finish(thumbnail(window().pixels()));
        return last;
    }

    void follow_files() {
        if (session_->follow_files() == Session::Followed::restart) reload_ = true;
    }

    bool in_gallery() const { return gallery_ != nullptr && options_.game == gallery_->game(); }
    bool may_go_back() const { return gallery_ != nullptr && !in_gallery(); }
    /// Starts another game after this frame.
    void open(const std::filesystem::path& game) {
        options_.game = game;
        reload_ = true;
        escape_since_.reset();
        back_since_.reset();
    }
    static bool is_held_long(const std::optional<Clock::time_point>& since, Clock::time_point now) {
        return since && now - *since > escape_time;
    }
    /// Stores the time since which the back button of a gamepad is held.
    void track_back_button(Clock::time_point now) {
        const property::Tree& tree = session_->tree();
        bool held = false;
        for (int n = 1; n <= 4 && may_go_back(); ++n) {
            const std::string path = "input.gamepad_" + std::to_string(n) + ".back";
            const property::Place place = property::resolve(tree, path);
            held =
                held || last_value(tree, place.instance, *place.property) == property::Value(true);
        }
        if (!held)
            back_since_.reset();
        else if (!back_since_)
            back_since_ = now;
    }
    /// Stores the time since which Escape is held. The game gets the key too, since its menus use
    /// it; it does not count while the console or the error screen uses it.
    void track_escape(const app::InputEvent& event, Clock::time_point now) {
        if (event.name != "escape") return;
        if (event.kind == app::EventKind::key_released) escape_since_.reset();
        if (event.kind == app::EventKind::key_pressed && !escape_since_ && may_go_back() &&
            !session_->console_is_open() && !error_screen_.visible())
            escape_since_ = now;
    }

    /// Keeps the window responsive while a script call takes long. While the console is open, the
    /// script is paused.
    bool may_go_on(const script::LongCall& call) {
        app::Loop& loop = session_->loop();
        error_screen_.show_running(call);
        const auto ends = [&] {
            return error_screen_.stop_wanted() || loop.closing() || EndRequest::signal() != 0;
        };
        do {
            for (app::InputEvent event; window().poll(event);) loop.handle(event);
            loop.draw_layers(window(), 0);
            window().present();
        } while (session_->console_is_open() && !ends());
        return !ends();
    }

    RunOptions options_;
    std::filesystem::path game_;          // the game of the session
    const std::filesystem::path record_;  // of the first run; each further run has its own file
    Gallery* gallery_;                    // null: without one
    TurnLimit limit_;
    GameWindow game_window_;
    app::ErrorScreen error_screen_;
    app::Loudspeaker loudspeaker_;
    std::unique_ptr<Session> session_;
    std::optional<EndRequest::Scripts> scripts_;
    Clock::time_point last_frame_{};
    double idle_steps_ = 0;
    bool reload_ = false;
    /// Escape, or the back button of a gamepad, held for this time leads back to the gallery.
    static constexpr std::chrono::milliseconds escape_time{800};
    std::optional<Clock::time_point> escape_since_{}, back_since_{};
};

constexpr std::uint64_t max_milliseconds = 1'000'000'000;
constexpr std::uint64_t max_megabytes = property::GameSettings::most_memory;

int run(const RunOptions& given) {
    RunOptions options = given;
    const EndRequest end_request;
    for (const std::filesystem::path& file : {options.screenshot, options.record})
        if (!file.empty()) require_file(file, "a file to write");
    if (!options.record.empty()) require_recording_or_nothing(options.record);
    if (!options.replay.empty()) return run_replay(options);
    if (!options.record.empty() && is_archive(options.game))
        return complain(bad_usage, "--record needs a game that is not an archive");
    options.follow = options.reload.value_or(!options.headless);
    const bool in_gallery = options.game.empty();
    if (in_gallery && !options.record.empty())
        return complain(bad_usage, "--record needs the path of a game");
    options.game = in_gallery ? gallery() : found_game(options.game);
    std::vector<std::string> chunks = options.evals;
    for (const auto& [step, chunk] : options.at) chunks.push_back(chunk);
    for (const auto& [step, command] : options.console) chunks.push_back(command);
    if (options.headless && !options.steps && !mentions_quit(options.game, chunks))
        return complain(bad_usage,
                        "a headless run needs --steps N, since this game never calls quit()");
    const bool draws = !options.headless || !options.screenshot.empty();
    if (draws && !app::display_available())
        return complain(bad_usage,
                        options.headless
                            ? "--screenshot needs a display to draw on: set DISPLAY, or use "
                              "xvfb-run"
                            : "there is no display for a window: set DISPLAY, use xvfb-run, or "
                              "run with --headless (fettle --help tells more)");
    std::optional<Gallery> games;
    if (in_gallery) games.emplace(options.game);
    Gallery* const shown = games ? &*games : nullptr;
    return options.headless ? run_headless(options, shown) : WindowRun(options, shown).play();
}

}  // namespace

Command add_run(CLI::App& app) {
    Subcommand<RunOptions> command(app, "run", "Play a game.");
    command.text("path", &RunOptions::game, path_of_game,
                 "A folder with main.lua, or one .lua file; without it, the gallery of all games");
    command.flag("--reload",
                 "Read files again that change while the game runs, also without a window",
                 [](RunOptions& to) { to.reload = true; });
    command.flag("--no-reload", "Go on with the files as they were when the game began",
                 [](RunOptions& to) { to.reload = false; });
    command.flag("--headless", &RunOptions::headless,
                 "No window; fixed steps as fast as they go; print() goes to stdout");
    command.number("--steps", &RunOptions::steps, 0, max_steps,
                   "Stop after so many fixed steps, those made again after going back in time "
                   "included; headless, a turn in which the game is paused counts too (needed with "
                   "--headless unless the game calls quit())");
    command.text("--eval", &RunOptions::evals, "a chunk of Lua",
                 "Run this after main.lua is loaded (repeatable)");
    command
        .option("--at",
                "Run it before step N (repeatable): N:LUA. Steps are counted as the run goes on: "
                "going back in time does not turn the count back",
                [](RunOptions& to, const std::string& text) {
                    to.at.push_back(parse_at("--at", text));
                })
        ->trigger_on_parse();
    command
        .option("--console",
                "Type it into the console before step N, and print it and what it says "
                "(repeatable): N:COMMAND",
                [](RunOptions& to, const std::string& text) {
                    to.console.push_back(parse_at("--console", text));
                })
        ->trigger_on_parse();
    command.text("--module", &RunOptions::modules, "a file or a name",
                 "Plug in a module: a shared object, or the name of an installed one (repeatable)");
    command.number("--budget", &RunOptions::budget, 1, max_milliseconds,
                   "Stop a call into the game's scripts that takes longer than so many "
                   "milliseconds; without it a window asks after two seconds, and a headless run "
                   "waits");
    command.flag("--sandbox", &RunOptions::sandbox,
                 "Do not trust the game: limits for memory, time, instances, handlers, timers, "
                 "output and files; no native modules");
    command.number("--memory", &RunOptions::memory, 1, max_megabytes,
                   "Stop scripts that use more than so many MB, or add more to the game (unless "
                   "given: \"memory\" in game.json, else 512 and 2048; with --sandbox 512 for "
                   "both together)");
    command.number("--seed", &RunOptions::seed, 0, UINT64_MAX,
                   "Of random(); without it that of game.json, or 0");
    command.flag("--developer", &RunOptions::developer,
                 "Have the console in a game that has it for developers only");
    command.flag("--listen", &RunOptions::listen,
                 "Let \"fettle repl --attach\" of this user attach to the game's console");
    command.option(
        "--screenshot", "Write the last frame there (png, jpg, bmp or tga)",
        [](RunOptions& to, const std::string& text) { to.screenshot = parse_picture(text); });
    command.text("--record", &RunOptions::record, "a file",
                 "Write there what comes into the run, to be replayed: not the computer's clock, "
                 "no saved games");
    command
        .text("--replay", &RunOptions::replay, "a file",
              "Make a recorded run again; exit status 1 when it is not the same")
        ->excludes("--record")
        ->excludes("--console");
    command.flag("--hash", &RunOptions::hash, "Print the state hash at the end");
    return command.runs(run);
}

}  // namespace fettle::program
