#include <attach/attached_game.h>

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include <ending/end_request.h>
#include <files/game_path.h>

namespace fettle::program {
namespace {

constexpr int poll_milliseconds = 100;  // between two checks for a signal
constexpr const char* game_has_ended = "the game has ended, or listens no longer";

}  // namespace

AttachedGame::AttachedGame(const RunningGame& running,
                           std::function<void(const std::string&)> print)
    : print_(std::move(print)), socket_(connected_to(running.socket)) {
    if (socket_ < 0) throw FileError(running.socket.string() + ": " + std::strerror(errno));
    send(greeting(running.token));
    const std::optional<Message> first = next(true);
    if (first && first->kind == Message::Kind::welcome) {
        name_ = first->text;
        return;
    }
    ::close(socket_);
    throw FileError("--attach: " + (first ? first->text : reason_));
}

AttachedGame::~AttachedGame() {
    ::close(socket_);
}

std::optional<Message> AttachedGame::request(const Request& request) {
    const std::string text = text_of(request);
    if (text.size() > longest_request) {
        Message refused{.kind = Message::Kind::answer};
        refused.lines.push_back("✗ a command for a game that runs has at most " +
                                std::to_string(longest_request) +
                                " bytes; exec(\"FILE\") runs more, from a file of the game");
        return refused;
    }
    send(text);
    stopped_ = false;
    while (std::optional<Message> message = next(true)) {
        if (message->kind == Message::Kind::answer || message->kind == Message::Kind::candidates)
            return message;
        handle(*message);
    }
    return std::nullopt;
}

void AttachedGame::print_received() {
    while (const std::optional<Message> message = next(false)) handle(*message);
}

void AttachedGame::handle(const Message& message) {
    if (message.kind == Message::Kind::print) print_(message.text);
    if (message.kind == Message::Kind::lost)
        print_("… " + std::to_string(message.count) + " more lines of the game");
    if (message.kind == Message::Kind::refusal) reason_ = message.text;
}

/// The next message; none if there is none yet, or if the connection has ended.
std::optional<Message> AttachedGame::next(bool waits) {
    while (connected()) {
        const std::size_t end = in_.find('\n');
        if (end != std::string::npos) {
            std::optional<Message> message = read_message(std::string_view(in_).substr(0, end));
            in_.erase(0, end + 1);
            if (message) return message;
            reason_ = "the game sent a message that this version of fettle does not understand";
        } else if (!receive(waits)) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

/// True if bytes were received.
bool AttachedGame::receive(bool waits) {
    for (;;) {
        pollfd ready{.fd = socket_, .events = POLLIN, .revents = 0};
        const int count = ::poll(&ready, 1, waits ? poll_milliseconds : 0);
        if (EndRequest::signal() != 0) return false;
        if (waits && EndRequest::Interrupts::arrived() && !std::exchange(stopped_, true))
            send(text_of({.kind = Request::Kind::stop}));
        if (count > 0) break;
        if (!waits) return false;
    }
    std::array<char, 16384> bytes;
    const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
    if (count > 0) {
        in_.append(bytes.data(), static_cast<std::size_t>(count));
        return true;
    }
    if (count < 0 && errno == EINTR) return false;
    reason_ = game_has_ended;
    return false;
}

void AttachedGame::send(const std::string& text) {
    for (std::size_t sent = 0; sent < text.size() && connected();) {
        const ssize_t count = ::send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
        if (count > 0) sent += static_cast<std::size_t>(count);
        if (count <= 0 && errno != EINTR) reason_ = game_has_ended;
    }
}

}  // namespace fettle::program
