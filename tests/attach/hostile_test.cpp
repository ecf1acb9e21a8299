// Hostile connections. A terminal keeps its place and its answers meanwhile.

#include <attach/listener.h>
#include <attach/protocol.h>
#include <catch.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "listener_rig.h"

namespace hostile_test {

using namespace fettle;
using namespace fettle::program;
using test::answer_to;
using test::Client;
using test::Game;

namespace {

/// Prints the time of the longest frame and does not check it: a test must not depend on the
/// machine.
void print_cost(const char* attack, const Game& game) {
    std::printf("listener: %s: the longest frame took %.3f ms of CPU time\n", attack,
                game.longest_frame * 1000);
}

}  // namespace

TEST_CASE("hundreds of silent connections keep no terminal out") {
    Game game;
    Client terminal = game.terminal();
    std::vector<Client> crowd;
    std::size_t entered = 0;
    for (int i = 0; i < 600; ++i) {
        crowd.push_back(game.client());
        entered += crowd.back().connected() ? 1 : 0;
        if (i % 3 == 0) game.frames();
        if (i % 100 == 99) CHECK(answer_to(game, terminal, "1") == "  said 1");
    }
    CHECK(entered > 100);
    CHECK(game.most_connections <= 9);
    // A terminal with the token still gets a place.
    crowd.clear();
    game.frames(10);
    Client late = game.terminal();
    CHECK(answer_to(game, late, "2") == "  said 2");
    print_cost("600 silent connections", game);
}

TEST_CASE(
    "a connection that sends garbage or an endless line is closed and its bytes are dropped") {
    Game game;
    Client terminal = game.terminal();
    std::minstd_rand random(3);
    std::string garbage(std::size_t{1} << 20, ' ');
    for (char& each : garbage) each = static_cast<char>(random() & 0xff);
    for (int i = 0; i < 50; ++i) {
        Client stranger = game.client();
        stranger.send(garbage);
        Client known = game.terminal();
        std::size_t sent = known.send(i % 2 == 0 ? garbage : std::string(garbage.size(), 'x'));
        for (int j = 0; j < 20; ++j) {
            game.frames();
            sent += known.send(std::string_view(garbage).substr(sent % garbage.size()));
        }
        CHECK(stranger.ended());
        const auto messages = known.receive();
        CHECK(std::ranges::count(messages, Message::Kind::refusal, &Message::kind) == 1);
        CHECK(known.ended());
    }
    CHECK(game.commands.empty());
    CHECK(game.largest_buffer <= longest_request + 4096);
    CHECK(answer_to(game, terminal, "1") == "  said 1");
    print_cost("garbage", game);
}

TEST_CASE("deep nesting costs no more than other lines") {
    Game game;
    for (const char bracket : {'[', '{'}) {
        Client known = game.terminal();
        known.send(std::string(longest_request - 1, bracket) + "\n");
        game.frames(6);
        CHECK(known.ended());
    }
    CHECK(game.commands.empty());
    print_cost("a line of brackets", game);
}

TEST_CASE("many requests of one terminal do not delay another terminal") {
    Game game({.busy_seconds = 1e9});
    Client flood = game.terminal(), terminal = game.terminal();
    std::string many;
    for (int i = 0; i < 2000; ++i) many += text_of({.text = "1"});
    std::size_t sent = 0;
    for (int i = 0; i < 100; ++i) {
        sent += flood.send(std::string_view(many).substr(sent % many.size()));
        const std::size_t before = game.commands.size();
        terminal.send(text_of({.text = "mine"}));
        game.frames();
        CHECK(game.commands.size() - before <= ListenLimits{}.requests);
        // The flood does not delay the other terminal by a single frame.
        const auto mine = terminal.receive();
        CHECK(std::ranges::count(mine, Message::Kind::answer, &Message::kind) == 1);
        flood.receive();
    }
    CHECK(std::ranges::count(game.commands, "1") > 500);
    print_cost("a flood of requests", game);
}

TEST_CASE("a frame answers as many bytes as the limit allows for all terminals together") {
    // The limit of time is off, so only the number of bytes ends a turn.
    Game game({.busy_seconds = 1e9});
    std::vector<Client> crowd;
    for (int i = 0; i < 4; ++i) crowd.push_back(game.terminal());
    const std::string one = text_of({.text = std::string(longest_request - 100, 'x')}),
                      large = one + one;
    std::size_t most = 0;
    for (int i = 0; i < 20; ++i) {
        for (Client& each : crowd) each.send(large);
        const std::size_t before = game.commands.size();
        game.frames();
        most = std::max(most, game.commands.size() - before);
        for (Client& each : crowd) each.receive();
    }
    // A request and its answer are nearly a quarter of the limit, so a fifth one is the last.
    CHECK(most == 5);
    CHECK(game.commands.size() >= 40);
    print_cost("large requests of several", game);
}

TEST_CASE("a frame serves as many terminals as its time allows and the next one the others") {
    Game game;
    std::vector<Client> crowd;
    for (int i = 0; i < 8; ++i) crowd.push_back(game.terminal());
    game.frames(2);
    for (Client& each : crowd) each.receive();
    game.tick = ListenLimits{}.busy_seconds / 3;
    const std::string run = text_of({.text = "1"});
    std::vector<std::size_t> received(crowd.size());
    std::size_t most_messages = 0, most_commands = 0;
    for (int frame = 0; frame < 80; ++frame) {
        if (frame % 8 == 0) game.listener().print("a line");
        for (Client& each : crowd) each.send(run);
        const std::size_t before = game.commands.size();
        game.frames();
        most_commands = std::max(most_commands, game.commands.size() - before);
        std::size_t now = 0;
        for (std::size_t i = 0; i < crowd.size(); ++i) {
            const std::size_t messages = crowd[i].receive().size();
            received[i] += messages;
            now += messages > 0 ? 1 : 0;
        }
        most_messages = std::max(most_messages, now);
    }
    CHECK(most_commands <= 2);
    CHECK(most_messages <= 2);
    // Nobody waits for ever.
    for (const std::size_t each : received) CHECK(each >= 18);
}

TEST_CASE("a frame takes at least one connection however little time it has") {
    Game game;
    game.tick = 0.1;
    Client one = game.client(), two = game.client();
    one.send(greeting(game.place().token));
    two.send(greeting(game.place().token));
    game.frames(1);
    CHECK(game.listener().connections() == 1);
}

TEST_CASE("a frame answers one completion") {
    Game game({.busy_seconds = 1e9});
    std::vector<Client> crowd;
    for (int i = 0; i < 3; ++i) crowd.push_back(game.terminal());
    for (const Client& each : crowd)
        each.send(text_of({.kind = Request::Kind::complete, .text = "wor", .cursor = 3}) +
                  text_of({.text = "1"}));
    std::vector<std::size_t> answers_in_frame;
    for (int i = 0; i < 4; ++i) {
        game.frames();
        std::size_t answers = 0;
        for (Client& each : crowd) answers += each.receive().size();
        answers_in_frame.push_back(answers);
    }
    // A completion in each of three frames; the commands behind them do not wait for the last one.
    CHECK(answers_in_frame[0] == 1);
    CHECK(answers_in_frame[1] + answers_in_frame[2] + answers_in_frame[3] == 5);
    CHECK(game.commands.size() == 3);
}

TEST_CASE("a terminal that does not read its answers gets no more of them") {
    Game game({.busy_seconds = 1e9});
    game.lines_of_answer = 400;
    Client slow = game.terminal(), terminal = game.terminal();
    std::string many;
    for (int i = 0; i < 500; ++i) many += text_of({.text = std::string(100, 'y')});
    std::size_t sent = 0;
    for (int i = 0; i < 300; ++i) {
        sent += slow.send(std::string_view(many).substr(sent % many.size()));
        game.listener().print("a line of the game");
        game.frames();
        terminal.receive();
    }
    const std::size_t answered = game.commands.size();
    CHECK(answered < 50);
    CHECK(game.largest_buffer <= ListenLimits{}.kept + 3 * longest_answer);
    CHECK(answer_to(game, terminal, "1").starts_with("  said 1"));
    // When it reads again, it gets its answers and the number of lines that it has missed.
    std::size_t lost = 0;
    for (int i = 0; i < 30; ++i) {
        for (const Message& each : slow.receive()) lost += each.count;
        game.frames();
    }
    CHECK(lost > 100);
    CHECK(game.commands.size() > answered);
    print_cost("a slow reader", game);
}

TEST_CASE("a terminal that disconnects during an answer is removed") {
    Game game;
    game.lines_of_answer = 400;
    for (int i = 0; i < 100; ++i) {
        Client leaver = game.terminal();
        leaver.send(text_of({.text = std::string(100, 'y')}) + "{\"run\": \"ha");
        if (i % 2 == 0) game.frames();
    }
    game.frames(3);
    CHECK(game.listener().connections() == 0);
    Client terminal = game.terminal();
    CHECK(answer_to(game, terminal, "1").starts_with("  said 1"));
    print_cost("those who leave", game);
}

TEST_CASE("connections that end all at once are closed as the time of frames allows") {
    Game game({.greeting_seconds = 1});
    std::vector<Client> crowd;
    for (int i = 0; i < 8; ++i) crowd.push_back(game.client());
    game.frames(2);
    REQUIRE(game.listener().connections() == 8);
    // For each one that is closed, the system frees what it has sent.
    for (const Client& each : crowd) each.send(std::string(std::size_t{1} << 20, 'x'));
    game.clock += 2;
    game.tick = ListenLimits{}.busy_seconds * 2;
    for (std::size_t left = 8; left-- > 0;) {
        game.frames();
        CHECK(game.listener().connections() == left);
    }
    print_cost("connections that end all at once", game);
}

TEST_CASE("lines that the game prints too fast are counted") {
    Game game;
    Client terminal = game.terminal();
    for (int i = 0; i < 5000; ++i) game.listener().print("line");
    game.frames(3);
    std::size_t printed = 0, lost = 0;
    for (const Message& each : terminal.receive()) {
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
        for (const Message& each : terminal.receive()) {
            printed += each.kind == Message::Kind::print ? 1 : 0;
            lost += each.count;
        }
    }
    CHECK(printed == 2);
    CHECK(printed + lost == 100);
}

}  // namespace hostile_test
