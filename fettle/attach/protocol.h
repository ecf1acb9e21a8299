#pragma once
// The protocol between a terminal and a running game: lines of text. The first line of a terminal
// is a greeting with the token; all others are JSON objects.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/script/runtime.h>

namespace fettle::program {

/// Bytes. A longer line ends the connection.
constexpr std::size_t longest_greeting = 128;
/// So short that the frame waits for less than a millisecond while Lua looks for the error in it:
/// a wrong command is compiled up to five times.
constexpr std::size_t longest_request = 4096;
/// Bytes of text in one answer. A longer text is cut, and the number of missing lines is added.
constexpr std::size_t longest_answer = 65536;
constexpr std::size_t most_candidates = 100;
/// Members of a request. A request with more is none.
constexpr std::size_t most_members = 16;

std::string greeting(std::string_view token);
/// Whether the line is the greeting with this token. The time that it takes does not depend on
/// which characters are wrong.
bool is_greeting(std::string_view line, std::string_view token);

struct Request {
    /// `stop`: the wait of the last command ends; it has no answer.
    enum class Kind : std::uint8_t { run, complete, stop } kind = Kind::run;
    std::string text{};      // a command, or the beginning of one
    std::size_t cursor = 0;  // byte of the text, for completion
};

std::string text_of(const Request& request);
/// None if the line is not a request. Reading ends at the first list or object inside the request,
/// and after `most_members`, so a line that is made to take long takes no longer than a command.
std::optional<Request> read_request(std::string_view line);

/// Messages of the game. All have a line end.
std::string welcome_text(std::string_view game);
std::string refusal_text(std::string_view why);
std::string print_text(std::string_view line);
std::string lost_text(std::size_t lines);
std::string answer_text(const script::Evaluation& said);
std::string candidates_text(const std::vector<script::Completion>& found);

/// A message of the game as a terminal reads it. Of the fields, those of its kind are set.
struct Message {
    enum class Kind : std::uint8_t { welcome, refusal, print, lost, answer, candidates };
    Kind kind = Kind::print;
    std::string text{};                // welcome: the game; refusal: the reason; print: a line
    std::size_t count = 0;             // lost: lines
    std::vector<std::string> lines{};  // answer
    bool incomplete = false;           // answer: the command goes on in the next line
    std::vector<script::Completion> found{};
};

/// None if the line is not a message of a game.
std::optional<Message> read_message(std::string_view line);

}  // namespace fettle::program
