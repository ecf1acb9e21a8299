// A game with a listener, and terminals of all kinds on real sockets. All is in one thread: a
// terminal sends, then the game makes a frame.

#include <attach/listener.h>
#include <attach/protocol.h>
#include <catch.h>
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <temporary_folder.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <random>
#include <utility>

#include <attach/socket_address.h>
#include <files/game_path.h>

namespace listener_test {

using namespace fettle;
using namespace fettle::program;

namespace {

/// A terminal or another program that connects. Its socket never blocks.
class Visitor {
  public:
    explicit Visitor(const RunningGame& to) {
        socket_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        const auto address = SocketAddress::of(to.socket);
        REQUIRE(address);
        connected_ = ::connect(socket_, address->any(), address->size()) == 0;
    }
    Visitor(Visitor&& other) noexcept
        : socket_(std::exchange(other.socket_, -1)), connected_(other.connected_) {}
    ~Visitor() {
        if (socket_ >= 0) ::close(socket_);
    }

    bool connected() const { return connected_; }
    /// Returns how many bytes were taken.
    std::size_t say(std::string_view text) const {
        const ssize_t count = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
        return count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    /// The messages that have come.
    std::vector<Message> hear() {
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
        hear();
        return ended_;
    }

  private:
    int socket_ = -1;
    bool connected_ = false, ended_ = false;
    std::string in_;
};

double cpu_seconds() {
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
            Listener::Answers{.evaluate =
                                  [this](std::string_view command) {
                                      commands.emplace_back(command);
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
    Visitor visitor() const { return Visitor(place()); }
    Visitor terminal() {
        Visitor made = visitor();
        REQUIRE(made.connected());
        made.say(greeting(place().token));
        frames();
        const auto heard = made.hear();
        REQUIRE(!heard.empty());
        REQUIRE(heard[0].kind == Message::Kind::welcome);
        return made;
    }
    void stop() { listener_.reset(); }

    std::vector<std::string> commands, notes;
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
std::string answer_to(Game& game, Visitor& terminal, const std::string& command) {
    terminal.say(text_of({.text = command}));
    for (int i = 0; i < 5; ++i) {
        game.frames();
        for (const Message& each : terminal.hear())
            if (each.kind == Message::Kind::answer) return each.lines.at(0);
    }
    return "no answer";
}

mode_t mode_of(const std::filesystem::path& file) {
    struct stat info {};
    REQUIRE(::stat(file.c_str(), &info) == 0);
    return info.st_mode & 0777;
}

}  // namespace

TEST_CASE("several terminals send commands and receive what the game prints") {
    Game game;
    Visitor one = game.terminal(), two = game.terminal();
    CHECK(answer_to(game, one, "1") == "  said 1");
    CHECK(answer_to(game, two, "2") == "  said 2");
    CHECK(game.commands == std::vector<std::string>{"1", "2"});
    one.say(text_of({.kind = Request::Kind::complete, .text = "wor", .cursor = 3}));
    game.frames();
    const auto found = one.hear();
    REQUIRE(found.size() == 1);
    CHECK(found[0].found.at(0).text == "word");
    game.listener().print("a line");
    game.frames();
    CHECK(one.hear().at(0).text == "a line");
    CHECK(two.hear().at(0).text == "a line");
    CHECK(game.notes == std::vector<std::string>(2, "a terminal is attached"));
    { const Visitor goes = std::move(one); }
    game.frames();
    CHECK(game.listener().connections() == 1);
    CHECK(game.notes.back() == "a terminal is no longer attached");
}

TEST_CASE("only this user can read the token and enter the folder") {
    Game game;
    CHECK(mode_of(game.place().file) == 0600);
    CHECK(mode_of(game.place().socket) == 0600);
    CHECK(mode_of(game.place().file.parent_path()) == 0700);
    CHECK(game.place().token.size() == 64);
    CHECK(running_games().size() == 1);
    CHECK(running_game("").token == game.place().token);
    CHECK(running_game("drop").token == game.place().token);
    CHECK(running_game(std::to_string(::getpid())).token == game.place().token);
    CHECK(running_game(game.place().game.string()).token == game.place().token);
    CHECK_THROWS_AS(running_game("drip"), FileError);
    {
        const Listener other(game.place().game, {});
        CHECK(other.place().token != game.place().token);
        CHECK_THROWS_AS(running_game("drop"), FileError);
    }
    const RunningGame place = game.place();
    game.stop();
    CHECK(!std::filesystem::exists(place.file));
    CHECK(!std::filesystem::exists(place.socket));
    CHECK_THROWS_AS(running_game(""), FileError);
    // A game that was killed leaves its files.
    std::ofstream(place.file) << place.token << "\n1\n/nothing\n";
    CHECK(running_games().empty());
    CHECK(!std::filesystem::exists(place.file));
    ::chmod(place.file.parent_path().c_str(), 0755);
    CHECK_THROWS_AS(runtime_folder(), FileError);
}

TEST_CASE("without the token nothing is answered") {
    Game game;
    for (const std::string& first :
         {std::string("fettle 1 ") + std::string(64, '0') + "\n", text_of({.text = "1"}),
          std::string("GET / HTTP/1.1\r\n\r\n"), std::string(1000, 'x'), std::string("\n"),
          std::string(200, '\0')}) {
        INFO(first);
        Visitor visitor = game.visitor();
        visitor.say(first + text_of({.text = "1"}));
        game.frames(2);
        CHECK(visitor.ended());
    }
    CHECK(game.commands.empty());
    CHECK(game.notes.empty());
    CHECK(game.listener().connections() == 0);
}

TEST_CASE("a greeting and a request may come in any pieces") {
    Game game;
    Visitor slow = game.visitor();
    const std::string all = greeting(game.place().token) + text_of({.text = "1"});
    for (const char each : all) {
        CHECK(game.commands.empty());
        slow.say(std::string_view(&each, 1));
        game.frames();
    }
    CHECK(game.commands.size() == 1);
    Visitor fast = game.visitor();
    fast.say(all + text_of({.text = "2"}));
    game.frames(2);
    CHECK(game.commands.size() == 3);
}

TEST_CASE("a connection that never sends a greeting is closed") {
    Game game({.greeting_seconds = 0});
    Visitor silent = game.visitor();
    game.frames(2);
    CHECK(silent.ended());
    CHECK(game.listener().connections() == 0);
}

TEST_CASE("there are no more terminals than the limit") {
    Game game({.terminals = 2});
    Visitor one = game.terminal(), two = game.terminal(), three = game.visitor();
    three.say(greeting(game.place().token));
    game.frames();
    const auto heard = three.hear();
    REQUIRE(heard.size() == 1);
    CHECK(heard[0].kind == Message::Kind::refusal);
    CHECK(three.ended());
    CHECK(answer_to(game, one, "1") == "  said 1");
    CHECK(game.listener().connections() == 2);
}

TEST_CASE("a completion has a frame of its own and the next one after other requests") {
    Game game;
    Visitor one = game.terminal(), two = game.terminal();
    const std::string run = text_of({.text = "1"}), complete = text_of({Request::Kind::complete});
    for (int i = 0; i < 10; ++i) {
        one.say(run + run + complete + run);
        two.say(complete + run);
    }
    for (int i = 0; i < 60; ++i) {
        const std::size_t commands = game.commands.size(), completions = game.completions;
        game.frames();
        const bool others = game.commands.size() > commands;
        CHECK(game.completions - completions <= (others ? 0U : 1U));
    }
    CHECK(one.hear().size() == 40);
    CHECK(two.hear().size() == 20);
}

// --- Hostile connections. A terminal keeps its place and its answers meanwhile.

namespace {

/// Prints the time of the longest frame and does not check it: a test must not depend on the
/// machine.
void tell_cost(const char* who, const Game& game) {
    std::printf("listener: %s: the longest frame took %.3f ms of CPU time\n", who,
                game.longest_frame * 1000);
}

}  // namespace

TEST_CASE("hundreds of connections take no place from a terminal") {
    Game game;
    Visitor terminal = game.terminal();
    std::vector<Visitor> crowd;
    std::size_t entered = 0;
    for (int i = 0; i < 600; ++i) {
        crowd.push_back(game.visitor());
        entered += crowd.back().connected() ? 1 : 0;
        if (i % 3 == 0) game.frames();
        if (i % 100 == 99) CHECK(answer_to(game, terminal, "1") == "  said 1");
    }
    CHECK(entered > 100);
    CHECK(game.most_connections <= 9);
    // A terminal with the token still gets a place.
    crowd.clear();
    game.frames(10);
    Visitor late = game.terminal();
    CHECK(answer_to(game, late, "2") == "  said 2");
    tell_cost("600 silent connections", game);
}

TEST_CASE("garbage and lines without an end are not kept") {
    Game game;
    Visitor terminal = game.terminal();
    std::minstd_rand random(3);
    std::string garbage(std::size_t{1} << 20, ' ');
    for (char& each : garbage) each = static_cast<char>(random() & 0xff);
    for (int i = 0; i < 50; ++i) {
        Visitor stranger = game.visitor();
        stranger.say(garbage);
        Visitor known = game.terminal();
        std::size_t said = known.say(i % 2 == 0 ? garbage : std::string(garbage.size(), 'x'));
        for (int j = 0; j < 20; ++j) {
            game.frames();
            said += known.say(std::string_view(garbage).substr(said % garbage.size()));
        }
        CHECK(stranger.ended());
        const auto heard = known.hear();
        CHECK(std::ranges::count(heard, Message::Kind::refusal, &Message::kind) == 1);
        CHECK(known.ended());
    }
    CHECK(game.commands.empty());
    CHECK(game.largest_buffer <= longest_request + 4096);
    CHECK(answer_to(game, terminal, "1") == "  said 1");
    tell_cost("garbage", game);
}

TEST_CASE("deep nesting costs no more than other lines") {
    Game game;
    for (const char bracket : {'[', '{'}) {
        Visitor known = game.terminal();
        known.say(std::string(longest_request - 1, bracket) + "\n");
        game.frames(6);
        CHECK(known.ended());
    }
    CHECK(game.commands.empty());
    tell_cost("a line of brackets", game);
}

TEST_CASE("a flood of requests waits for its turn") {
    Game game({.busy_seconds = 1e9});
    Visitor flood = game.terminal(), terminal = game.terminal();
    std::string many;
    for (int i = 0; i < 2000; ++i) many += text_of({.text = "1"});
    std::size_t said = 0;
    for (int i = 0; i < 100; ++i) {
        said += flood.say(std::string_view(many).substr(said % many.size()));
        const std::size_t before = game.commands.size();
        terminal.say(text_of({.text = "mine"}));
        game.frames();
        CHECK(game.commands.size() - before <= ListenLimits{}.requests);
        // The flood does not delay the other terminal by a single frame.
        const auto mine = terminal.hear();
        CHECK(std::ranges::count(mine, Message::Kind::answer, &Message::kind) == 1);
        flood.hear();
    }
    CHECK(std::ranges::count(game.commands, "1") > 500);
    tell_cost("a flood of requests", game);
}

TEST_CASE("a frame answers as many bytes as the limit allows for all terminals together") {
    // The limit of time is off, so only the number of bytes ends a turn.
    Game game({.busy_seconds = 1e9});
    std::vector<Visitor> crowd;
    for (int i = 0; i < 4; ++i) crowd.push_back(game.terminal());
    const std::string large = text_of({.text = std::string(longest_request - 100, 'x')});
    std::size_t most = 0;
    for (int i = 0; i < 20; ++i) {
        for (Visitor& each : crowd) each.say(large);
        const std::size_t before = game.commands.size();
        game.frames();
        most = std::max(most, game.commands.size() - before);
        for (Visitor& each : crowd) each.hear();
    }
    // A request and its answer are nearly the limit, so a second one is the last.
    CHECK(most == 2);
    CHECK(game.commands.size() >= 20);
    tell_cost("large requests of several", game);
}

TEST_CASE("a frame serves as many terminals as its time allows and the next one the others") {
    Game game;
    std::vector<Visitor> crowd;
    for (int i = 0; i < 8; ++i) crowd.push_back(game.terminal());
    game.frames(2);
    for (Visitor& each : crowd) each.hear();
    game.tick = ListenLimits{}.busy_seconds / 3;
    const std::string run = text_of({.text = "1"});
    std::vector<std::size_t> heard(crowd.size());
    std::size_t most_heard = 0, most_commands = 0;
    for (int frame = 0; frame < 80; ++frame) {
        if (frame % 8 == 0) game.listener().print("a line");
        for (Visitor& each : crowd) each.say(run);
        const std::size_t before = game.commands.size();
        game.frames();
        most_commands = std::max(most_commands, game.commands.size() - before);
        std::size_t now = 0;
        for (std::size_t i = 0; i < crowd.size(); ++i) {
            const std::size_t messages = crowd[i].hear().size();
            heard[i] += messages;
            now += messages > 0 ? 1 : 0;
        }
        most_heard = std::max(most_heard, now);
    }
    CHECK(most_commands <= 2);
    CHECK(most_heard <= 2);
    // Nobody waits for ever.
    for (const std::size_t each : heard) CHECK(each >= 18);
}

TEST_CASE("a frame takes at least one connection however little time it has") {
    Game game;
    game.tick = 0.1;
    Visitor one = game.visitor(), two = game.visitor();
    one.say(greeting(game.place().token));
    two.say(greeting(game.place().token));
    game.frames(1);
    CHECK(game.listener().connections() == 1);
}

TEST_CASE("a frame answers one completion") {
    Game game({.busy_seconds = 1e9});
    std::vector<Visitor> crowd;
    for (int i = 0; i < 3; ++i) crowd.push_back(game.terminal());
    for (const Visitor& each : crowd)
        each.say(text_of({.kind = Request::Kind::complete, .text = "wor", .cursor = 3}) +
                 text_of({.text = "1"}));
    std::vector<std::size_t> heard;
    for (int i = 0; i < 4; ++i) {
        game.frames();
        std::size_t answers = 0;
        for (Visitor& each : crowd) answers += each.hear().size();
        heard.push_back(answers);
    }
    // A completion in each of three frames; the commands behind them do not wait for the last one.
    CHECK(heard[0] == 1);
    CHECK(heard[1] + heard[2] + heard[3] == 5);
    CHECK(game.commands.size() == 3);
}

TEST_CASE("a terminal that does not read its answers gets no more of them") {
    Game game({.busy_seconds = 1e9});
    game.lines_of_answer = 400;
    Visitor slow = game.terminal(), terminal = game.terminal();
    std::string many;
    for (int i = 0; i < 500; ++i) many += text_of({.text = std::string(100, 'y')});
    std::size_t said = 0;
    for (int i = 0; i < 300; ++i) {
        said += slow.say(std::string_view(many).substr(said % many.size()));
        game.listener().print("a line of the game");
        game.frames();
        terminal.hear();
    }
    const std::size_t answered = game.commands.size();
    CHECK(answered < 50);
    CHECK(game.largest_buffer <= ListenLimits{}.kept + 3 * longest_answer);
    CHECK(answer_to(game, terminal, "1").starts_with("  said 1"));
    // When it reads again, it gets its answers and the number of lines that it has missed.
    std::size_t lost = 0;
    for (int i = 0; i < 30; ++i) {
        for (const Message& each : slow.hear()) lost += each.count;
        game.frames();
    }
    CHECK(lost > 100);
    CHECK(game.commands.size() > answered);
    tell_cost("a slow reader", game);
}

TEST_CASE("a terminal that disconnects during an answer is removed") {
    Game game;
    game.lines_of_answer = 400;
    for (int i = 0; i < 100; ++i) {
        Visitor leaver = game.terminal();
        leaver.say(text_of({.text = std::string(100, 'y')}) + "{\"run\": \"ha");
        if (i % 2 == 0) game.frames();
    }
    game.frames(3);
    CHECK(game.listener().connections() == 0);
    Visitor terminal = game.terminal();
    CHECK(answer_to(game, terminal, "1").starts_with("  said 1"));
    tell_cost("those who leave", game);
}

TEST_CASE("lines that the game prints too fast are counted") {
    Game game;
    Visitor terminal = game.terminal();
    for (int i = 0; i < 5000; ++i) game.listener().print("line");
    game.frames(3);
    std::size_t printed = 0, lost = 0;
    for (const Message& each : terminal.hear()) {
        printed += each.kind == Message::Kind::print ? 1 : 0;
        lost += each.count;
    }
    CHECK(printed == ListenLimits{}.lines_a_frame);
    CHECK(printed + lost == 5000);
    // Long lines count by their bytes.
    const std::string long_line(ListenLimits{}.printed / 2 + 1, 'x');
    for (int i = 0; i < 100; ++i) game.listener().print(long_line);
    printed = lost = 0;
    for (int i = 0; i < 3; ++i) {
        game.frames();
        for (const Message& each : terminal.hear()) {
            printed += each.kind == Message::Kind::print ? 1 : 0;
            lost += each.count;
        }
    }
    CHECK(printed == 2);
    CHECK(printed + lost == 100);
}

}  // namespace listener_test
