#include "run.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>

#include <fettle/app/error_screen.h>
#include <fettle/app/recording.h>
#include <fettle/app/screen.h>

#include "exit_status.h"
#include "game_path.h"
#include "recorded_files.h"
#include "session.h"

namespace fettle::program {

namespace {

int complain(ExitStatus status, const std::string& message) {
    std::fflush(stdout);
    std::fprintf(stderr, "fettle: %s\n", message.c_str());
    return status;
}

/// What is asked for at the end: the hash on stdout, the picture of the last frame.
int finish(Session& session, const RunOptions& options, app::Screen* screen) {
    int status = session.exit_status();
    if (options.hash) std::printf("%016" PRIx64 "\n", session.loop().hash());
    if (!options.screenshot.empty() && screen != nullptr) {
        try {
            screen->save(options.screenshot);
        } catch (const std::runtime_error& error) {
            status = complain(file_error, error.what());
        }
    }
    if (status != success || session.runtime().quit_status()) return status;
    const auto tell_unreached = [&](const char* option, const auto& all) {
        for (const auto& [step, chunk] : all)
            if (step > session.loop().lived())
                std::fprintf(stderr,
                             "fettle: %s %" PRIu64
                             " was never reached: the run ended with its step %" PRIu64 "\n",
                             option, step, session.loop().lived());
    };
    tell_unreached("--at", options.at);
    tell_unreached("--console", options.console);
    return status;
}

int run_headless(const RunOptions& options) {
    Session session(options, nullptr, {});
    session.start();
    for (std::int64_t turn = 0; !session.failed() && !session.loop().stopped() &&
                                (!options.steps || turn < *options.steps);
         ++turn)
        session.loop().turn();
    std::unique_ptr<app::Screen> picture;
    if (!options.screenshot.empty()) {
        const property::Vec2 size = session.services().view.screen;
        picture =
            app::make_picture(static_cast<unsigned>(size.x()), static_cast<unsigned>(size.y()));
        session.loop().draw(*picture, 0);
        picture->present();
    }
    return finish(session, options, picture.get());
}

/// For a saved game, as wide as a list of them shows it.
property::Thumbnail thumbnail(app::Pixels pixels) {
    constexpr std::uint32_t widest = 256;
    return property::scaled_down({pixels.width, pixels.height, std::move(pixels.rgba)}, widest);
}

/// Plays in a window until it is closed, the game quits or its steps are made. R on the error
/// screen starts the game anew in the same window.
class WindowRun {
  public:
    explicit WindowRun(const RunOptions& options)
        : options_(options),
          window_(app::open_window({})),
          error_screen_(
              {.reload = [this] { reload_ = true; },
               .go_on = [this] { session_->loop().resume(); },
               .copy = [this](const std::string& text) { window_->clipboard().write(text); }}) {}

    int play() {
        start();
        for (bool last = false; !last;) {
            last = frame();
            if (reload_) start();
        }
        return finish(*session_, options_, window_.get());
    }

  private:
    using Clock = std::chrono::steady_clock;

    void start() {
        reload_ = false;
        error_screen_.hide();
        session_.reset();
        window_->release_textures();
        session_ = std::make_unique<Session>(
            options_, &window_->clipboard(),
            [this](const script::ScriptError& error) { error_screen_.show(error); });
        session_->add_layer(error_screen_);
        session_->services().view.screen = window_->size();
        session_->start();
        idle_steps_ = 0;
        last_frame_ = Clock::now();
    }

    /// True: the run ends with this frame.
    bool frame() {
        app::Loop& loop = session_->loop();
        const app::Clock& clock = session_->services().clock;
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - last_frame_).count();
        last_frame_ = now;
        for (app::InputEvent event; window_->poll(event);) loop.handle(event);
        if (reload_) return false;
        loop.frame(seconds, options_.steps.value_or(INT64_MAX));
        if (clock.paused) idle_steps_ += seconds / clock.dt;
        window_->set_title(session_->services().view.title);
        window_->set_vsync(session_->services().view.vsync);
        // A run of so many steps is nobody's to look at: it also ends when nothing moves any more.
        const bool made =
            options_.steps && (loop.halted() || static_cast<double>(loop.lived()) + idle_steps_ >=
                                                    static_cast<double>(*options_.steps));
        const bool last = made || loop.closing() || session_->runtime().quit_status().has_value();
        const bool saves = session_->saves().waits();
        if (saves || (last && !options_.screenshot.empty())) window_->keep_frame();
        loop.draw(*window_, seconds);
        window_->present();
        if (saves) session_->saves().finish(thumbnail(window_->pixels()));
        return last;
    }

    const RunOptions& options_;
    std::unique_ptr<app::Window> window_;
    app::ErrorScreen error_screen_;
    std::unique_ptr<Session> session_;
    Clock::time_point last_frame_{};
    double idle_steps_ = 0;
    bool reload_ = false;
};

/// As many as a person reads.
std::string listed(const std::vector<std::string>& all) {
    constexpr std::size_t most = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
        text += (i == 0 ? "" : ", ") + all[i];
    if (all.size() > most) text += " and " + std::to_string(all.size() - most) + " more";
    return text;
}

/// Makes the run of a recording again, in a window or not, and sees whether it is the same.
int run_replay(RunOptions options) {
    const app::Recording recording(options.replay);
    const app::RunStart& start = recording.start();
    if (options.game.empty()) options.game = start.game;
    require_game(options.game);
    if (const auto changed = changed_since(recording, options.game); !changed.empty())
        return complain(file_error, options.replay.string() +
                                        ": was recorded of another game, or of another version "
                                        "of " +
                                        options.game.string() + ": " + listed(changed));
    options.modules = start.modules;
    options.seed = start.seed;
    options.evals = start.evals;
    options.at = start.at;
    const bool seen = !options.headless || !options.screenshot.empty();
    if (seen && !app::display_available())
        return complain(bad_usage,
                        "there is no display for a window: set DISPLAY, use xvfb-run, "
                        "or replay with --headless");
    std::unique_ptr<app::Window> window;
    if (!options.headless) window = app::open_window({});
    Session session(options, nullptr, {}, &recording);
    session.services().view.screen = {start.width, start.height};
    session.start();
    app::Replay replay(recording, session.tree(), session.runtime(), session.loop());
    bool closed = false;
    while (!closed && replay.frame()) {
        if (window == nullptr) continue;
        for (app::InputEvent event; window->poll(event);)
            closed = closed || event.kind == app::EventKind::closing;
        session.loop().draw(*window, 0);
        window->present();
    }
    if (!replay.difference().empty()) return complain(script_error, replay.difference());
    std::printf("%" PRIu64 " steps, each as it was recorded\n", replay.steps());
    return finish(session, options, window.get());
}

/// "N:LUA"
std::pair<std::uint64_t, std::string> parse_at(const char* option, const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::string number = text.substr(0, colon);
    if (colon == std::string::npos || number.empty() || number.size() > 18 ||
        number.find_first_not_of("0123456789") != std::string::npos || std::stoull(number) == 0)
        throw CLI::ValidationError(
            option, "\"" + text + "\" is not a step from 1 and a chunk, as in 60:print(time.now)");
    return {std::stoull(number), text.substr(colon + 1)};
}

}  // namespace

int run(const RunOptions& given) {
    RunOptions options = given;
    try {
        if (!options.replay.empty()) return run_replay(options);
        if (options.game.empty()) options.game = showcase();
        require_game(options.game);
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
                                  "run with --headless");
        return options.headless ? run_headless(options) : WindowRun(options).play();
    } catch (const FileError& error) {
        return complain(file_error, error.what());
    } catch (const app::RecordingError& error) {
        return complain(file_error, error.what());
    } catch (const module::LoadError& error) {
        return complain(file_error, error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        return complain(file_error, error.path1().string() + ": " + error.code().message());
    }
}

void add_run(CLI::App& app, int& status) {
    CLI::App& command = *app.add_subcommand("run", "Play a game.");
    const auto options = std::make_shared<RunOptions>();
    command.add_option("path", options->game,
                       "A folder with main.lua, or one .lua file; without it, the showcase");
    command.add_flag("--headless", options->headless,
                     "No window; fixed steps as fast as they go; print() goes to stdout");
    command
        .add_option("--steps", options->steps,
                    "Stop after so many fixed steps, those made again after going back in time "
                    "included (needed with --headless unless the game calls "
                    "quit())")
        ->check(CLI::NonNegativeNumber);
    // Each occurrence by itself: a chunk of Lua may hold commas and brackets.
    command
        .add_option_function<std::string>(
            "--eval", [options](const std::string& chunk) { options->evals.push_back(chunk); },
            "Run this after main.lua is loaded (repeatable)")
        ->trigger_on_parse();
    command
        .add_option_function<std::string>(
            "--at",
            [options](const std::string& text) { options->at.push_back(parse_at("--at", text)); },
            "Run it before step N (repeatable): N:LUA. Steps are counted as the run goes on: going "
            "back in time does not turn the count back")
        ->trigger_on_parse();
    command
        .add_option_function<std::string>(
            "--console",
            [options](const std::string& text) {
                options->console.push_back(parse_at("--console", text));
            },
            "Type it into the console before step N, and print it and what it says (repeatable): "
            "N:COMMAND")
        ->trigger_on_parse();
    command
        .add_option_function<std::string>(
            "--module", [options](const std::string& name) { options->modules.push_back(name); },
            "Plug in a module: a shared object, or the name of an installed one (repeatable)")
        ->trigger_on_parse();
    command.add_option("--seed", options->seed, "Of random(); 0 unless given");
    command.add_option("--screenshot", options->screenshot,
                       "Write the last frame there (png, jpg, bmp or tga)");
    command.add_option("--record", options->record,
                       "Write everything that comes into the run there, to be replayed");
    command
        .add_option("--replay", options->replay,
                    "Make a recorded run again; exit status 1 when it is not the same")
        ->excludes("--record")
        ->excludes("--console");
    command.add_flag("--hash", options->hash, "Print the state hash at the end");
    command.callback([options, &status] { status = run(*options); });
}

}  // namespace fettle::program
