#include <commands/run_steps.h>

#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <exception>
#include <optional>

#include <fettle/property/exception_text.h>

#include <ending/end_request.h>
#include <game/game_modules.h>
#include <terminal/terminal.h>

namespace fettle::program {

namespace {

/// Time limit of the game's `closing()` after a signal, s.
constexpr unsigned closing_time = 5;

/// The longest call into the scripts of a game in a sandbox, ms.
constexpr std::uint64_t longest_call_in_sandbox = 2000;

}  // namespace

int complain(ExitStatus status, const std::string& message) {
    print_error(message);
    return status;
}

void close(Session& session) {
    EndRequest::limit_scripts(closing_time);
    session.runtime().go_on();
    app::InputEvent event;
    event.kind = app::EventKind::closing;
    session.loop().handle(event);
}

int finish(Session& session, const RunOptions& options, app::Screen* screen) {
    EndRequest::limit_scripts(0);
    // A module may fail to compute its hash.
    const std::uint64_t hash = options.hash ? session.loop().hash() : 0;
    int status = session.exit_status();
    if (EndRequest::signal() != 0) status = status_of_signal(EndRequest::signal());
    if (const std::string problem = session.recording_problem(); !problem.empty())
        status = complain(file_error, problem);
    if (options.hash) std::printf("%016" PRIx64 "\n", hash);
    if (!options.screenshot.empty() && screen != nullptr) {
        try {
            screen->save(options.screenshot);
        } catch (const std::exception& error) {
            status = complain(file_error, property::exception_text(error));
        }
    }
    if (status != success || session.runtime().quit_status()) return status;
    const auto print_unreached = [&](const char* option, const auto& all, std::uint64_t reached) {
        for (const auto& [step, chunk] : all)
            if (step > reached)
                print_error(option + (" " + std::to_string(step)) +
                            " was never reached: the run ended with its step " +
                            std::to_string(session.loop().steps_made()));
    };
    // A chunk runs before its step, which is never made if the chunk pauses the game.
    print_unreached("--at", options.at, session.chunks_until());
    print_unreached("--console", options.console, session.typed_until());
    return status;
}

std::unique_ptr<app::Screen> picture_of(Session& session, const RunOptions& options) {
    if (options.screenshot.empty()) return nullptr;
    const property::Vec2 size = session.services().view.screen;
    auto picture = app::make_picture(static_cast<unsigned>(size.x), static_cast<unsigned>(size.y));
    // The console arranges its lists by the sizes of its last picture, so the second picture is
    // right.
    for (int i = 0; i < 2; ++i) {
        session.loop().draw(*picture, 0);
        picture->present();
    }
    return picture;
}

bool limit_calls(script::Runtime& runtime, const RunOptions& options) {
    const auto limit = options.budget    ? options.budget
                       : options.sandbox ? std::optional(longest_call_in_sandbox)
                                         : std::nullopt;
    if (limit) runtime.limit_calls(static_cast<double>(*limit) / 1000, {});
    return limit.has_value();
}

double longest_turn(const RunOptions& options) {
    // Scripts are stopped by the limit of their calls, native modules are not.
    const bool native = !options.modules.empty() || !manifest(options.game).empty();
    if (!options.sandbox && !(options.budget && native)) return 0;
    // A turn has many calls, and a sandbox with a small budget may have large images.
    constexpr double calls = 15, shortest = 5;
    return std::max(
        shortest,
        calls * static_cast<double>(options.budget.value_or(longest_call_in_sandbox)) / 1000);
}

void play_sounds(app::Loudspeaker& loudspeaker, Session& session) {
    loudspeaker.follow(session.services(), session.loop().halted());
    if (const std::string problem = loudspeaker.consume_problem(); !problem.empty())
        session.note("note: " + problem);
}

}  // namespace fettle::program
