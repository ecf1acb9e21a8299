#include <attach/listener.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include <attach/protocol.h>
#include <attach/socket_address.h>
#include <files/game_path.h>
#include <terminal/terminal.h>

namespace fettle::program {
namespace {

constexpr int backlog = 16;

std::string name_of(int terminal) {
    return "terminal " + std::to_string(terminal);
}

/// Whether the process at the other end belongs to this user.
bool is_own(int socket) {
    ucred other{};
    socklen_t size = sizeof other;
    return ::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &other, &size) == 0 &&
           other.uid == ::geteuid();
}

int listening_socket(const std::filesystem::path& path) {
    const auto fail = [&](const char* why) {
        throw FileError("console.listen: " + path.string() + ": " + why);
    };
    const std::optional<SocketAddress> address = SocketAddress::of(path);
    if (!address) fail("this path is too long for a socket; set XDG_RUNTIME_DIR to a shorter one");
    const int made = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (made < 0) fail(std::strerror(errno));
    ::fchmod(made, 0600);  // of the file that bind() makes
    if (::bind(made, address->any(), address->size()) == 0 && ::listen(made, backlog) == 0)
        return made;
    const int problem = errno;
    ::close(made);
    fail(std::strerror(problem));
    return -1;
}

}  // namespace

Listener::Listener(const std::filesystem::path& game, Callbacks answers, ListenLimits limits)
    : place_(named_for(game)),
      callbacks_(std::move(answers)),
      limits_(limits),
      socket_(listening_socket(place_.socket)) {
    try {
        announce(place_);
    } catch (...) {
        ::close(socket_);
        withdraw(place_);
        throw;
    }
}

Listener::~Listener() {
    withdraw(place_);
    ::close(socket_);
    for (const Connection& each : connections_) ::close(each.socket);
}

std::size_t Listener::terminals() const {
    return static_cast<std::size_t>(std::ranges::count(connections_, true, &Connection::greeted));
}

std::size_t Listener::largest_buffer() const {
    std::size_t largest = 0;
    for (const Connection& each : connections_)
        largest = std::max({largest, each.in.size(), each.out.size()});
    return largest;
}

double Listener::now() const {
    if (callbacks_.now) return callbacks_.now();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void Listener::frame() {
    printed_lines_ = printed_bytes_ = 0;
    began_ = now();
    accept_connections();
    if (connections_.empty()) return;
    receive_all();
    end_waits();
    answer();
    send_all();
    drop_ungreeted();
    remove_gone();
}

void Listener::in_turns(std::size_t& first, const std::function<bool(std::size_t)>& handle) const {
    const std::size_t count = connections_.size(), begin = first;
    bool some = false;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (begin + i) % count;
        if (some && is_late()) {
            first = next;
            return;
        }
        some = handle(next) || some;
    }
}

void Listener::receive_all() {
    std::vector<pollfd> ready;
    ready.reserve(connections_.size());
    for (const Connection& each : connections_)
        ready.push_back({.fd = each.socket, .events = POLLIN, .revents = 0});
    ::poll(ready.data(), ready.size(), 0);
    in_turns(first_received_, [&](std::size_t each) {
        const bool has = (ready[each].revents & (POLLIN | POLLHUP | POLLERR)) != 0;
        if (has) receive(connections_[each]);
        return has;
    });
}

void Listener::send_all() {
    in_turns(first_sent_, [&](std::size_t each) {
        Connection& to = connections_[each];
        const bool has = !to.out.empty() || to.lost > 0;
        send(to);
        return has;
    });
}

// --- Connections

void Listener::accept_connections() {
    for (std::size_t i = 0; i < limits_.accepted && (i == 0 || !is_late()); ++i) {
        const int socket = ::accept4(socket_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (socket < 0) return;
        if (!is_own(socket)) {
            ::close(socket);
            continue;
        }
        drop_oldest_ungreeted();
        connections_.push_back({.socket = socket, .since = now()});
    }
}

/// Closes the connection that has been longest without giving the token, so that silent ones cannot
/// take all places.
void Listener::drop_oldest_ungreeted() {
    if (connections_.size() - terminals() < limits_.waiting) return;
    const auto oldest = std::ranges::find(connections_, false, &Connection::greeted);
    ::close(oldest->socket);
    connections_.erase(oldest);
}

void Listener::refuse(Connection& connection, std::string_view why) {
    connection.out += refusal_text(why);
    connection.ending = true;
    connection.in.clear();
}

void Listener::drop_ungreeted() {
    const double present = now();
    for (Connection& each : connections_)
        if (!each.greeted && present - each.since > limits_.greeting_seconds) each.gone = true;
}

/// Removes one at least, and as many as the time of the frame allows: closing a socket takes time,
/// since the system frees the bytes that the terminal has not read.
void Listener::remove_gone() {
    std::size_t removed = 0;
    std::erase_if(connections_, [&](const Connection& each) {
        const bool ends = each.gone || (each.ending && each.out.empty());
        if (!ends || (removed > 0 && is_late())) return false;
        ::close(each.socket);
        ++removed;
        return true;
    });
}

// --- Requests

void Listener::receive(Connection& from) {
    // While the terminal does not read its answers, no more of its requests are received.
    if (from.gone || from.ending || from.out.size() > limits_.kept ||
        from.in.size() > longest_request)
        return;
    std::array<char, 4096> bytes;
    for (std::size_t have = 0; have < limits_.received;) {
        const ssize_t count = ::recv(from.socket, bytes.data(), bytes.size(), 0);
        if (count <= 0) {
            const bool nothing = count < 0 && (errno == EAGAIN || errno == EINTR);
            from.gone = from.gone || !nothing;
            break;
        }
        from.in.append(bytes.data(), static_cast<std::size_t>(count));
        have += static_cast<std::size_t>(count);
        if (from.in.size() > longest_request || is_late()) break;
    }
    if (from.greeted) return;
    const std::size_t end = from.in.find('\n');
    if (end < longest_greeting) {  // npos is greater
        const std::string line = from.in.substr(0, end);
        from.in.erase(0, end + 1);
        greet(from, line);
    } else if (from.in.size() >= longest_greeting) {
        from.gone = true;
    }
}

void Listener::greet(Connection& connection, std::string_view line) {
    if (!is_greeting(line, place_.token)) {
        connection.gone = true;
        return;
    }
    if (terminals() == limits_.terminals)
        return refuse(connection, "a game has at most " + std::to_string(limits_.terminals) +
                                      " terminals, and there are as many");
    // Before this terminal counts as greeted, so that the line goes to the others only: a program
    // that attaches for one command receives nothing but the answer.
    const int number = free_number();
    callbacks_.note(name_of(number) + " is attached");
    connection.number = number;
    connection.greeted = true;
    connection.out += welcome_text(place_.game.string());
}

/// The smallest number that no terminal has.
int Listener::free_number() const {
    int number = 1;
    while (std::ranges::count(connections_, number, &Connection::number) > 0) ++number;
    return number;
}

/// Answers the requests of this frame. All terminals take turns. In the next frame, another one is
/// the first.
void Listener::answer() {
    Turn turn;
    const std::size_t count = connections_.size();
    first_ = (first_ + 1) % count;
    for (bool some = true; some && !turn.ends;) {
        some = false;
        for (std::size_t i = 0; i < count && !turn.ends; ++i) {
            const std::size_t next = (first_ + i) % count;
            if (!answer_next(connections_[next], turn)) {
                if (turn.ends) first_ = (next + count - 1) % count;  // the first of the next frame
                continue;
            }
            some = true;
            turn.ends = turn.ends || ++turn.requests >= limits_.requests ||
                        turn.bytes >= limits_.answered || is_late();
        }
    }
}

/// Sends the answers whose results have come. A terminal that waits may stop that.
void Listener::end_waits() {
    for (Connection& each : connections_) {
        if (each.answer.empty()) continue;
        const std::string who = name_of(each.number);
        if (const std::string stop = text_of({.kind = Request::Kind::stop});
            each.in.starts_with(stop)) {
            each.in.erase(0, stop.size());
            if (callbacks_.stop_waiting) callbacks_.stop_waiting(who);
        }
        std::optional<std::vector<std::string>> lines{std::in_place};
        if (callbacks_.waited) lines = callbacks_.waited(who);
        if (!lines) continue;
        for (const std::string& line : *lines) each.out += print_text(line_after_answer(line));
        each.out += std::exchange(each.answer, {});
    }
}

/// Answers the next request, if there is a whole one, and one that may be begun in this frame.
bool Listener::answer_next(Connection& to, Turn& turn) {
    if (!to.greeted || to.ending || to.gone || to.out.size() > limits_.kept || !to.answer.empty())
        return false;
    const std::size_t end = to.in.find('\n');
    if (end > longest_request) {  // so is npos
        if (to.in.size() <= longest_request) return false;
        refuse(to, "a request has at most " + std::to_string(longest_request) + " bytes");
        return true;
    }
    report_lost(to);
    turn.bytes += end;
    const std::optional<Request> request = read_request(std::string_view(to.in).substr(0, end));
    // A completion takes as long as many commands, so it has a frame of its own.
    if (request && request->kind == Request::Kind::complete && turn.requests > 0) {
        turn.ends = true;
        return false;
    }
    to.in.erase(0, end + 1);
    if (!request) {
        refuse(to, "expected a line with {\"run\": …} or {\"complete\": …, \"cursor\": …}");
        return true;
    }
    if (request->kind == Request::Kind::stop) return true;  // nothing waits
    std::string answer = answer_to(*request, to, turn);
    turn.bytes += answer.size();
    // Its results come before the next command, also in a replay.
    const bool later = request->kind == Request::Kind::run && callbacks_.answers_later &&
                       callbacks_.answers_later(name_of(to.number));
    turn.ends = turn.ends || later;
    (later ? to.answer : to.out) += answer;
    return true;
}

std::string Listener::answer_to(const Request& request, const Connection& from, Turn& turn) {
    if (request.kind == Request::Kind::run)
        return answer_text(callbacks_.evaluate(request.text, name_of(from.number)));
    // A completion takes longer than its few bytes suggest, and no person types faster than one
    // completion a frame.
    turn.ends = true;
    return candidates_text(callbacks_.complete(request.text, request.cursor));
}

// --- Answers and prints

void Listener::print(std::string_view line) {
    if (connections_.empty()) return;
    const bool enough =
        printed_lines_ >= limits_.lines_a_frame || printed_bytes_ >= limits_.printed;
    std::string text;
    for (Connection& each : connections_) {
        if (!each.greeted || each.ending) continue;
        if (enough || each.out.size() > limits_.kept) {
            ++each.lost;
            continue;
        }
        if (text.empty()) text = print_text(line);
        each.out += text;
    }
    if (text.empty()) return;
    ++printed_lines_;
    printed_bytes_ += text.size();
}

void Listener::report_lost(Connection& to) {
    if (to.lost > 0 && to.out.size() <= limits_.kept)
        to.out += lost_text(std::exchange(to.lost, 0));
}

void Listener::send(Connection& to) {
    report_lost(to);
    if (to.out.empty() || to.gone) return;
    const ssize_t count =
        ::send(to.socket, to.out.data(), std::min(to.out.size(), limits_.kept), MSG_NOSIGNAL);
    if (count > 0) to.out.erase(0, static_cast<std::size_t>(count));
    const bool waits = count < 0 && (errno == EAGAIN || errno == EINTR);
    to.gone = to.gone || (count <= 0 && !waits);
}

}  // namespace fettle::program
