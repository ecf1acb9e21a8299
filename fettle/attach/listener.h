#pragma once
// The server in a game: terminals attach to it and type commands. The work of a frame,
// the memory of each connection and the number of connections have limits, so that no connection
// can delay the game. Sockets never wait.

#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/script/runtime.h>

#include <attach/protocol.h>
#include <attach/running_games.h>

namespace fettle::program {

/// The limits; documented in docs/guide/all-of-the-console.md.
struct ListenLimits {
    std::size_t terminals = 8;  // that have sent the token
    std::size_t waiting = 8;    // that have not sent it; beyond it, the oldest is disconnected
    double greeting_seconds = 2;
    std::size_t accepted = 4;  // connections of a frame
    // All that a frame does for all connections ends after this time, and goes on in the next
    // frame. What has begun is finished: a command takes as long as a typed one.
    double busy_seconds = 0.00025;
    // A frame begins no further request after this number of requests, after a completion, or after
    // this number of bytes of requests and answers; and no completion after another request.
    std::size_t requests = 8, answered = 32768;
    std::size_t received = 16384;  // bytes of a frame and connection
    std::size_t kept = 65536;      // bytes of unsent answers; beyond it, no more requests are read
    // What a frame sends of the game's output: lines, and bytes after which no more lines are sent.
    std::size_t lines_a_frame = 200, printed = 65536;
};

class Listener {
  public:
    struct Callbacks {
        /// `who`: the name of the terminal.
        std::function<script::Evaluation(std::string_view command, std::string_view who)> evaluate;
        std::function<std::vector<script::Completion>(std::string_view input, std::size_t cursor)>
            complete;
        /// A terminal has attached.
        std::function<void(const std::string& what)> note;
        /// Whether the last command, of this terminal, has begun something whose results are
        /// printed before the next frame, such as a search of the past, or lets the terminal wait.
        /// Its answer is sent then, after the results. May be missing.
        std::function<bool(std::string_view who)> answers_later{};
        /// None while the terminal waits; then lines about the end of the wait. May be missing.
        std::function<std::optional<std::vector<std::string>>(std::string_view who)> waited{};
        std::function<void(std::string_view who)> stop_waiting{};  // may be missing
        /// The present time in seconds, from any origin. Without it, the clock of the system is
        /// read.
        std::function<double()> now{};
    };

    /// Begins to listen for `game`. Throws FileError.
    Listener(const std::filesystem::path& game, Callbacks callbacks, ListenLimits limits = {});
    ~Listener();
    /// Replaces the receivers of requests. The terminals stay attached.
    void answer_with(Callbacks callbacks) { callbacks_ = std::move(callbacks); }
    Listener(const Listener&) = delete;

    /// Call between two frames: accepts connections, answers requests, and sends.
    void frame();
    /// Sends a line that the game printed to all terminals. A terminal that reads too slowly gets
    /// the number of dropped lines instead.
    void print(std::string_view line);

    const RunningGame& place() const { return place_; }
    /// For tests.
    std::size_t connections() const { return connections_.size(); }
    std::size_t largest_buffer() const;

  private:
    struct Connection {
        int socket = -1;
        double since = 0;
        bool greeted = false;
        bool ending = false;  // when everything is sent
        bool gone = false;
        int number = 0;  // of the terminal, from 1; 0 before it is greeted
        std::string in{}, out{};
        std::string answer{};  // of a command whose results are not printed yet
        std::size_t lost = 0;  // lines of the game since the last that was sent
    };

    /// What the requests of this frame have taken so far.
    struct Turn {
        std::size_t requests = 0, bytes = 0;
        bool ends = false;  // no more of them in this frame
    };

    double now() const;
    /// Whether the time of this frame is over.
    bool is_late() const { return now() - began_ > limits_.busy_seconds; }
    /// Calls `handle` with the connections, beginning where the last frame had no more time; each
    /// frame handles one at least. `handle` says whether it had anything to do.
    void in_turns(std::size_t& first, const std::function<bool(std::size_t)>& handle) const;
    void accept_connections();
    void receive_all();
    void drop_oldest_ungreeted();
    void receive(Connection& from);
    void greet(Connection& connection, std::string_view line);
    void end_waits();
    void answer();
    bool answer_next(Connection& to, Turn& turn);
    std::string answer_to(const Request& request, const Connection& from, Turn& turn);
    int free_number() const;
    void report_lost(Connection& to);
    void send_all();
    void send(Connection& to);
    void refuse(Connection& connection, std::string_view why);
    void drop_ungreeted();
    void remove_gone();
    std::size_t terminals() const;

    RunningGame place_;
    Callbacks callbacks_;
    ListenLimits limits_;
    int socket_ = -1;
    std::deque<Connection> connections_;
    double began_ = 0;       // the frame
    std::size_t first_ = 0;  // whose requests are answered first in this frame
    std::size_t first_received_ = 0, first_sent_ = 0;
    std::size_t printed_lines_ = 0, printed_bytes_ = 0;  // of this frame
};

}  // namespace fettle::program
