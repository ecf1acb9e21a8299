// `fettle run --replay`: a run made again from its recording.

#include <commands/replay_run.h>

#include <cinttypes>
#include <cstdio>

#include <fettle/app/error_screen.h>
#include <fettle/app/loudspeaker.h>
#include <fettle/app/recording.h>
#include <fettle/app/screen.h>

#include <command_line/joined.h>
#include <commands/run_steps.h>
#include <ending/end_request.h>
#include <ending/exit_status.h>
#include <files/game_path.h>
#include <files/recorded_files.h>
#include <files/settings.h>
#include <session/game_window.h>
#include <session/session.h>

namespace fettle::program {

namespace {

/// Lists at most five entries.
std::string join_first(const std::vector<std::string>& all) {
    constexpr std::size_t limit = 5;
    if (all.size() <= limit) return joined(all);
    return joined({all.begin(), all.begin() + limit}) + " and " +
           std::to_string(all.size() - limit) + " more";
}

/// A replay of a test in a window shows this number of steps, the last ones, and skips the others.
constexpr std::uint64_t last_steps = 180;

/// The options with what the recording says about the run.
RunOptions with_start(RunOptions options, const app::RunStart& start) {
    options.modules = start.modules;
    options.seed = start.seed;
    options.evals = start.evals;
    options.at = start.at;
    if (!start.test.empty()) options.test = {.file = start.test[0], .name = start.test[1]};
    return options;
}

/// The window of a replay. Without one, nothing is shown.
class ReplayWindow {
  public:
    ReplayWindow(app::Window* window, Session& session) : window_(window), session_(session) {}

    /// Shows and plays the present state of the game.
    void show() {
        if (window_ == nullptr) return;
        for (app::InputEvent event; window_->poll(event);)
            closed_ = closed_ || event.kind == app::EventKind::closing;
        play_sounds(loudspeaker_, session_);
        session_.loop().draw(*window_, 0);
        window_->present();
    }
    /// True if the window was closed or a signal ends the program.
    bool ended() const { return closed_ || EndRequest::signal() != 0; }

  private:
    app::Window* window_;
    Session& session_;
    app::Loudspeaker loudspeaker_;
    bool closed_ = false;
};

}  // namespace

int run_replay(RunOptions options) {
    require_file(options.replay, "a recording");
    const app::Recording recording(options.replay);
    const app::RunStart& start = recording.start();
    options.game = found_game(options.game.empty() ? start.game : options.game);
    if (const auto changed = changed_since(recording, options.game); !changed.empty())
        return complain(file_error, options.replay.string() +
                                        ": was recorded of another game, or of another version "
                                        "of " +
                                        options.game.string() + ": " + join_first(changed));
    options = with_start(std::move(options), start);
    const bool seen = !options.headless || !options.screenshot.empty();
    if (seen && !app::display_available())
        return complain(bad_usage,
                        "there is no display for a window: set DISPLAY, use xvfb-run, "
                        "or replay with --headless");
    std::unique_ptr<app::Window> window;
    if (!options.headless) window = app::open_window(window_state(read_settings(options.game)));
    // The strip with the error that ended the run; a replay has no actions for the user.
    app::ErrorScreen error_screen({});
    std::optional<script::ScriptError> failure;
    Session session(
        options, nullptr,
        [&](const script::ScriptError& error) {
            if (!failure) failure = error;
        },
        &recording);
    session.add_layer(error_screen);
    session.set_screen({start.width, start.height});
    const EndRequest::Scripts scripts(session.runtime());
    session.start();
    app::Replay replay(recording, session.tree(), session.runtime(), session.loop());
    replay.on_selected([&](const std::vector<property::Handle>& all) { session.select(all); });
    ReplayWindow shown(window.get(), session);
    const bool test = window != nullptr && !start.test.empty();
    while (!shown.ended() && replay.frame()) {
        const bool skipped = test && replay.steps() + last_steps < recording.steps();
        if (!skipped) shown.show();
    }
    // The game's drawing functions run for the last picture, too: most errors do not come from
    // them, and if one does, it halts the loop again.
    if (failure) {
        error_screen.show_over(*failure, start.test.empty() ? "The run ended with this error"
                                                            : "The test failed here");
        session.loop().resume();
    }
    // The picture in which a test failed stays until the window is closed.
    while (test && options.screenshot.empty() && !shown.ended()) shown.show();
    if (EndRequest::signal() != 0) return status_of_signal(EndRequest::signal());
    if (!replay.difference().empty()) return complain(script_error, replay.difference());
    std::unique_ptr<app::Screen> picture;
    if (window == nullptr) {
        picture = picture_of(session, options);
    } else if (!options.screenshot.empty()) {
        window->keep_frame();
        shown.show();
    }
    std::printf("%" PRIu64 " steps, each as it was recorded\n", replay.steps());
    return finish(session, options, window != nullptr ? window.get() : picture.get());
}

}  // namespace fettle::program
