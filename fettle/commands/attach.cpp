#include <optional>
#include <utility>

#include <attach/attached_game.h>
#include <command_line/command_lines.h>
#include <commands/commands.h>
#include <ending/end_request.h>
#include <ending/exit_status.h>
#include <files/game_path.h>
#include <terminal/terminal.h>

namespace fettle::program {
namespace {

class Attached : private CommandRunner {
  public:
    explicit Attached(const RunningGame& running)
        : game_(running, [this](const std::string& line) {
              lines_.erase_typed_line();
              print_line(line);
          }) {}

    int run() {
        lines_.read("Attached to " + game_.name() + ". Ctrl+D ends; the game goes on.");
        const int signal = EndRequest::signal();
        if (signal != 0) return status_of_signal(signal);
        if (game_.connected()) return success;
        print_error(game_.reason());
        return file_error;
    }

  private:
    bool ended() override { return EndRequest::signal() != 0 || !game_.connected(); }
    void idle() override { game_.print_received(); }

    /// Sends the command and waits for the answer.
    bool run(const std::string& command) override {
        const std::optional<Message> answer =
            game_.request({.kind = Request::Kind::run, .text = command});
        if (!answer) return true;
        if (answer->incomplete) return false;
        print_answer(answer->lines);
        return true;
    }

    std::vector<script::Completion> complete(const std::string& command,
                                             std::size_t cursor) override {
        std::optional<Message> answer =
            game_.request({.kind = Request::Kind::complete, .text = command, .cursor = cursor});
        return answer ? std::move(answer->found) : std::vector<script::Completion>();
    }

    CommandLines lines_{*this};
    AttachedGame game_;
};

}  // namespace

int attach(const std::string& wanted) {
    const EndRequest end_request;
    return Attached(running_game(wanted)).run();
}

}  // namespace fettle::program
