#pragma once
// The client of a running game: a terminal that sends requests through the game's socket.

#include <functional>
#include <optional>
#include <string>

#include <attach/protocol.h>
#include <attach/running_games.h>

namespace fettle::program {

class AttachedGame {
  public:
    /// Connects. `print` receives the lines that the game prints, whenever one of the other
    /// functions is called. Throws FileError if the game refuses.
    AttachedGame(const RunningGame& running, std::function<void(const std::string&)> print);
    ~AttachedGame();
    AttachedGame(const AttachedGame&) = delete;

    bool connected() const { return reason_.empty(); }
    /// Why it is not connected any more.
    const std::string& reason() const { return reason_; }
    /// The game's path.
    const std::string& name() const { return name_; }

    /// Sends a request and waits for its answer; none if the connection ends, or a signal asks the
    /// program to end. An interrupt ends a wait in the game.
    std::optional<Message> request(const Request& request);
    /// Prints the lines that the game has sent. Does not wait.
    void print_received();

  private:
    std::optional<Message> next(bool waits);
    bool receive(bool waits);
    void send(const std::string& text);
    void handle(const Message& message);

    std::function<void(const std::string&)> print_;
    int socket_;
    bool stopped_ = false;  // the wait of the present request
    std::string in_, name_, reason_;
};

}  // namespace fettle::program
