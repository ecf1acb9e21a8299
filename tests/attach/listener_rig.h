#pragma once
// A game with a listener, and terminals of all kinds on real sockets. All is in one thread: a
// terminal sends, then the game makes a frame.

#include <attach/listener.h>
#include <attach/protocol.h>
#include <catch.h>
#include <sys/socket.h>
#include <temporary_folder.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <optional>
#include <utility>

#include <attach/socket_address.h>

namespace fettle::program::test {

/// A terminal or another program that connects. Its socket never blocks.
class Client {
  public:
    explicit Client(const RunningGame& to) {
        socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        const auto address = SocketAddress::of(to.socket);
        REQUIRE(address);
        connected_ = ::connect(socket_, address->any(), address->size()) == 0;
    }
    Client(Client&& other) noexcept
        : socket_(std::exchange(other.socket_, -1)), connected_(other.connected_) {}
    ~Client() {
        if (socket_ >= 0) ::close(socket_);
    }

    bool connected() const { return connected_; }
    /// Returns how many bytes were taken.
    std::size_t send(std::string_view text) const {
        const ssize_t count = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
        return count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    /// The messages that have come.
    std::vector<Message> receive() {
        std::array<char, 65536> bytes;
        for (;;) {
            const ssize_t count = ::recv(socket_, bytes.data(), bytes.size(), 0);
            ended_ = ended_ || count == 0 || (count < 0 && errno == ECONNRESET);
            if (count <= 0) break;
            in_.append(bytes.data(), static_cast<std::size_t>(count));
        }
        std::vector<Message> all;
        for (std::size_t end; (end = in_.find('\n')) != std::string::npos; in_.erase(0, end + 1)) {
            auto message = read_message(std::string_view(in_).substr(0, end));
            REQUIRE(message);
            all.push_back(std::move(*message));
        }
        return all;
    }
    /// Whether the game has ended the connection.
    bool ended() {
        receive();
        return ended_;
    }

  private:
    int socket_ = -1;
    bool connected_ = false, ended_ = false;
    std::string in_;
};

inline double cpu_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A game that listens in a runtime folder of its own.
class Game {
  public:
    explicit Game(ListenLimits limits = {}) {
        std::filesystem::create_directories(folder_.path / "run");
        std::filesystem::create_directories(folder_.path / "drop");
        ::setenv("XDG_RUNTIME_DIR", (folder_.path / "run").c_str(), 1);
        listener_ = std::make_unique<Listener>(
            folder_.path / "drop",
            Listener::Callbacks{.evaluate =
                                    [this](std::string_view command, std::string_view who) {
                                        commands.emplace_back(command);
                                        asked.emplace_back(who);
                                        return script::Evaluation{
                                            .ok = true,
                                            .lines = std::vector<std::string>(
                                                lines_of_answer, "said " + std::string(command)),
                                            .error = {},
                                            .result = {}};
                                    },
                                .complete =
                                    [this](std::string_view input, std::size_t) {
                                        ++completions;
                                        return std::vector<script::Completion>(
                                            1, {.text = std::string(input) + "d",
                                                .label = {},
                                                .detail = {},
                                                .doc = {}});
                                    },
                                .note = [this](const std::string& what) { notes.push_back(what); },
                                .answers_later = [this](std::string_view) { return later; },
                                .waited = [this](std::string_view) { return waited; },
                                .stop_waiting =
                                    [this](std::string_view who) {
                                        stopped.emplace_back(who);
                                        waited.emplace();
                                    },
                                .now = [this] { return clock += tick; }},
            limits);
    }
    Listener& listener() { return *listener_; }
    const RunningGame& place() const { return listener_->place(); }
    void frames(int count = 1) {
        for (int i = 0; i < count; ++i) {
            const double begin = cpu_seconds();
            listener_->frame();
            longest_frame = std::max(longest_frame, cpu_seconds() - begin);
            most_connections = std::max(most_connections, listener_->connections());
            largest_buffer = std::max(largest_buffer, listener_->largest_buffer());
        }
    }
    Client client() const { return Client(place()); }
    Client terminal() {
        Client made = client();
        REQUIRE(made.connected());
        made.send(greeting(place().token));
        frames();
        const auto messages = made.receive();
        REQUIRE(!messages.empty());
        REQUIRE(messages[0].kind == Message::Kind::welcome);
        return made;
    }
    void stop() { listener_.reset(); }

    std::vector<std::string> commands, notes, asked;  // asked: the terminals, by their names
    bool later = false;                               // whether answers come in the next frame
    // Lines about the end of a wait; none: the terminals wait.
    std::optional<std::vector<std::string>> waited{std::in_place};
    std::vector<std::string> stopped;  // terminals whose waits were stopped
    std::size_t completions = 0, lines_of_answer = 1;
    // A test must not depend on the time that the machine needs, so each look at the clock takes
    // the same time.
    double clock = 0, tick = 1e-9;
    double longest_frame = 0;
    std::size_t most_connections = 0, largest_buffer = 0;

  private:
    TemporaryFolder folder_;
    std::unique_ptr<Listener> listener_;
};

/// The line of the one answer that a terminal gets to a command.
inline std::string answer_to(Game& game, Client& terminal, const std::string& command) {
    terminal.send(text_of({.text = command}));
    for (int i = 0; i < 5; ++i) {
        game.frames();
        for (const Message& each : terminal.receive())
            if (each.kind == Message::Kind::answer) return each.lines.at(0);
    }
    return "no answer";
}

}  // namespace fettle::program::test
