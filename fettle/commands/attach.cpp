#include <commands/attach.h>

#include <poll.h>
#include <unistd.h>

#include <iostream>
#include <optional>

#include <attach/attached_game.h>
#include <command_line/end_request.h>
#include <command_line/exit_status.h>
#include <command_line/line_editor.h>
#include <command_line/repl_lines.h>
#include <command_line/terminal.h>
#include <files/game_path.h>

namespace fettle::program {
namespace {

class Attached {
  public:
    explicit Attached(const RunningGame& running)
        : game_(running, [this](const std::string& line) {
              if (editor_) editor_->make_room();
              print_line(line);
          }) {}

    int run() {
        if (::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1)
            talk();
        else
            read_all();
        std::fflush(stdout);
        const int asked = EndRequest::asked();
        if (asked != 0) return status_of_signal(asked);
        if (game_.connected()) return success;
        tell(game_.reason());
        return file_error;
    }

  private:
    bool ended() { return EndRequest::asked() != 0 || !game_.connected(); }

    void talk() {
        print_line("Attached to " + game_.name() + ". Ctrl+D ends; the game goes on.");
        editor_.emplace(repl_history(), [this](std::string_view line, std::size_t cursor) {
            return candidates(line, cursor);
        });
        const auto idle = [&] {
            game_.look();
            std::fflush(stdout);
            return !ended();
        };
        while (!ended()) {
            const std::optional<std::string> line =
                editor_->read(pending_.empty() ? "› " : "… ", idle);
            if (!line) break;
            take(*line);
        }
        print_line("");
        editor_.reset();
    }

    void read_all() {
        for (std::string line; !ended() && std::getline(std::cin, line);) take(line);
        if (!pending_.empty() && !ended()) print_line("✗ the command ends too early");
    }

    /// Sends the command, unless it goes on in the next line, and waits for the answer.
    void take(const std::string& line) {
        pending_ += pending_.empty() ? line : "\n" + line;
        const std::optional<Message> answer =
            game_.ask({.kind = Request::Kind::run, .text = pending_});
        if (!answer) return;
        if (answer->incomplete && !line.empty()) return;
        if (answer->incomplete) print_line("✗ the command ends too early");
        pending_.clear();
        print_answer(answer->lines);
        std::fflush(stdout);
    }

    std::vector<LineEditor::Candidate> candidates(std::string_view line, std::size_t cursor) {
        return candidates_of(
            pending_, line, cursor, [this](const std::string& all, std::size_t at) {
                std::optional<Message> answer =
                    game_.ask({.kind = Request::Kind::complete, .text = all, .cursor = at});
                return answer ? std::move(answer->found) : std::vector<script::Completion>();
            });
    }

    std::optional<LineEditor> editor_;
    AttachedGame game_;
    std::string pending_;  // the lines of a command that is not complete
};

}  // namespace

int attach(const std::string& wanted) {
    const EndRequest end_request;
    return Attached(running_game(wanted)).run();
}

}  // namespace fettle::program
