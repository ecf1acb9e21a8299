#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <fettle/app/error_screen.h>

#include <command_line/answer.h>
#include <command_line/command_lines.h>
#include <command_line/subcommand.h>
#include <commands/commands.h>
#include <ending/end_request.h>
#include <ending/exit_status.h>
#include <files/game_path.h>
#include <session/session.h>
#include <terminal/terminal.h>

namespace fettle::program {
namespace {

namespace fs = std::filesystem;

/// The longest time of one call of `advance`, s.
constexpr double longest_advance = 3600;
/// After a long pause, the game advances by at most this time at once, s.
constexpr double longest_frame = 0.25;

class Repl : private CommandRunner {
  public:
    explicit Repl(const RunOptions& options)
        : session_(options, nullptr, [this](const script::ScriptError& error) { report(error); }),
          scripts_(session_.runtime()) {
        if (session_.settings().console == property::ConsoleUse::off)
            throw FileError("repl: this game has no console, as its game.json says");
        session_.on_output([this](std::string_view text) {
            lines_.erase_typed_line();
            print_line(text);
        });
        session_.runtime().add_function(
            "advance", [this](auto arguments) { return property::Value(asked_steps(arguments)); });
    }

    int run() {
        session_.start();
        last_ = Clock::now();
        lines_.read("Type any Lua, or help(). Tab completes, Ctrl+C stops, Ctrl+D ends.");
        const int signal = EndRequest::signal();
        return signal != 0 ? status_of_signal(signal) : session_.exit_status();
    }

  private:
    using Clock = std::chrono::steady_clock;

    void report(const script::ScriptError& error) {
        lines_.erase_typed_line();
        print_error_lines(app::error_text(error));
    }

    bool ended() override {
        return EndRequest::signal() != 0 || session_.runtime().quit_status().has_value();
    }

    /// In a terminal, the game goes on while the next command is typed; otherwise it stands still
    /// between the commands.
    void idle() override {
        const Clock::time_point now = Clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        if (!session_.loop().halted()) session_.loop().frame(std::min(seconds, longest_frame));
    }

    bool run(const std::string& command) override {
        const script::Evaluation said = evaluate(command);
        if (said.incomplete) return false;
        print_answer(lines_of(said));
        std::fflush(stdout);
        app::Loop& loop = session_.loop();
        if (!loop.stopped()) loop.frame(0);
        while (turns_ > 0 && !loop.stopped() && !ended() && !EndRequest::Interrupts::arrived()) {
            loop.turn();
            --turns_;
        }
        if (turns_ > 0 && EndRequest::Interrupts::arrived())
            print_line("✗ stopped: " + std::to_string(turns_) + " steps of advance were not made");
        turns_ = 0;
        make_awaited_steps();
        last_ = Clock::now();
        return true;
    }

    /// Makes steps until what the command waits for has come, or the user stops that.
    void make_awaited_steps() {
        app::Loop& loop = session_.loop();
        std::optional<std::vector<std::string>> lines = session_.waited();
        for (; !lines; lines = session_.waited()) {
            if (loop.stopped() || ended() || EndRequest::Interrupts::arrived()) {
                session_.stop_waiting();
                return print_line("✗ wait: stopped");
            }
            loop.turn();
        }
        for (const std::string& line : *lines) print_line(line_after_answer(line));
    }

    /// In a terminal, Ctrl+C stops the command with an error.
    script::Evaluation evaluate(const std::string& command) {
        const EndRequest::Command stoppable;
        return session_.evaluate(command);
    }

    std::vector<script::Completion> complete(const std::string& command,
                                             std::size_t cursor) override {
        return session_.runtime().complete(command, cursor);
    }

    /// Returns the number of steps. They are made after the command, since none can begin within
    /// one.
    std::int64_t asked_steps(std::span<const property::Value> arguments) {
        const double seconds =
            arguments.size() == 1 && arguments[0].is_numeric() ? arguments[0].as_double() : -1;
        if (!(seconds >= 0 && seconds <= longest_advance))
            throw std::invalid_argument(
                "advance: expected a time from 0 to 3600 s, as in advance(1.5)");
        const std::int64_t steps = std::llround(seconds / session_.services().clock.dt);
        turns_ += steps;
        return steps;
    }

    CommandLines lines_{*this};
    Session session_;
    const EndRequest::Scripts scripts_;
    Clock::time_point last_;  // of the last frame
    std::int64_t turns_ = 0;  // still to be made
};

struct ReplOptions {
    fs::path game{};  // empty: none
    bool attaches = false;
};

int repl(const ReplOptions& given) {
    const fs::path& named = given.game;
    if (given.attaches) return attach(named.string());
    const EndRequest end_request;
    RunOptions options{.headless = true};
    options.game = named.empty() ? assets() / "templates" / "empty" : found_game(named);
    options.developer = true;
    // A run without a path has no folder, so it reads and writes no files of a game.
    options.isolated = named.empty();
    return Repl(options).run();
}

}  // namespace

Command add_repl(CLI::App& app) {
    Subcommand<ReplOptions> command(
        app, "repl",
        "Type commands of the console in the terminal, to a game without a window or to a game "
        "that runs already.");
    command.flag("--attach", &ReplOptions::attaches,
                 "To the running game with that name, path or process; it must listen (fettle run "
                 "--listen, or console.listen = true)");
    command.text("path", &ReplOptions::game, path_of_game,
                 "A folder with main.lua, or one .lua file; without it, a game with nothing in it");
    return command.runs(repl);
}

}  // namespace fettle::program
