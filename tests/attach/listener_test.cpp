#include <attach/listener.h>
#include <attach/protocol.h>
#include <catch.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include <files/game_path.h>

#include "listener_rig.h"

namespace listener_test {

using namespace fettle;
using namespace fettle::program;
using test::answer_to;
using test::Client;
using test::Game;

namespace {

mode_t mode_of(const std::filesystem::path& file) {
    struct stat info {};
    REQUIRE(::stat(file.c_str(), &info) == 0);
    return info.st_mode & 0777;
}

}  // namespace

TEST_CASE("several terminals send commands and receive what the game prints") {
    Game game;
    Client one = game.terminal(), two = game.terminal();
    CHECK(answer_to(game, one, "1") == "  said 1");
    CHECK(answer_to(game, two, "2") == "  said 2");
    CHECK(game.commands == std::vector<std::string>{"1", "2"});
    one.send(text_of({.kind = Request::Kind::complete, .text = "wor", .cursor = 3}));
    game.frames();
    const auto found = one.receive();
    REQUIRE(found.size() == 1);
    CHECK(found[0].found.at(0).text == "word");
    game.listener().print("a line");
    game.frames();
    CHECK(one.receive().at(0).text == "a line");
    CHECK(two.receive().at(0).text == "a line");
    CHECK(game.notes ==
          std::vector<std::string>{"terminal 1 is attached", "terminal 2 is attached"});
    CHECK(game.asked == std::vector<std::string>{"terminal 1", "terminal 2"});
    { const Client goes = std::move(one); }
    game.frames();
    CHECK(game.listener().connections() == 1);
    // Each terminal that attaches is noted; the end of one is not.
    CHECK(game.notes.size() == 2);
}

TEST_CASE("a terminal gets the smallest number that no other has") {
    Game game;
    auto one = std::make_unique<Client>(game.terminal());
    Client two = game.terminal();
    one.reset();
    game.frames();
    Client next = game.terminal();
    answer_to(game, next, "1");
    answer_to(game, two, "2");
    CHECK(game.asked == std::vector<std::string>{"terminal 1", "terminal 2"});
}

TEST_CASE("what a command finds later comes before its answer and before the next command") {
    Game game;
    Client client = game.terminal();
    game.later = true;
    client.send(text_of({.text = "ab"}) + text_of({.text = "next"}));
    game.frames();
    CHECK(game.commands == std::vector<std::string>{"ab"});
    CHECK(client.receive().empty());
    game.listener().print("it is found");
    game.later = false;
    game.frames();
    const auto messages = client.receive();
    REQUIRE(messages.size() == 3);
    CHECK(messages[0].text == "it is found");
    CHECK(messages[1].lines == std::vector<std::string>{"  said ab"});
    CHECK(messages[2].lines == std::vector<std::string>{"  said next"});
}

TEST_CASE("a terminal that waits gets its answer afterwards and the others do not wait") {
    Game game;
    Client client = game.terminal(), other = game.terminal();
    game.later = true;
    game.waited.reset();
    client.send(text_of({.text = "wait"}) + text_of({.text = "next"}));
    game.frames(5);
    game.later = false;
    CHECK(game.commands == std::vector<std::string>{"wait"});
    CHECK(client.receive().empty());
    CHECK(answer_to(game, other, "2") == "  said 2");
    game.waited = {"the end of it", "✗ a problem"};
    game.frames();
    const auto messages = client.receive();
    REQUIRE(messages.size() == 4);
    CHECK(messages[0].text == "  the end of it");
    CHECK(messages[1].text == "✗ a problem");
    CHECK(messages[2].lines == std::vector<std::string>{"  said wait"});
    CHECK(messages[3].lines == std::vector<std::string>{"  said next"});
    CHECK(game.stopped.empty());
}

TEST_CASE("a terminal may stop its wait") {
    Game game;
    Client client = game.terminal();
    game.later = true;
    game.waited.reset();
    client.send(text_of({.text = "wait"}));
    game.frames(2);
    game.later = false;
    client.send(text_of({.kind = Request::Kind::stop}));
    game.frames(2);
    CHECK(game.stopped == std::vector<std::string>{"terminal 1"});
    REQUIRE(client.receive().size() == 1);
    // Without a wait, it is not answered.
    client.send(text_of({.kind = Request::Kind::stop}));
    game.frames(2);
    CHECK(client.receive().empty());
    CHECK(game.stopped.size() == 1);
    CHECK(answer_to(game, client, "next") == "  said next");
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
        Client client = game.client();
        client.send(first + text_of({.text = "1"}));
        game.frames(2);
        CHECK(client.ended());
    }
    CHECK(game.commands.empty());
    CHECK(game.notes.empty());
    CHECK(game.listener().connections() == 0);
}

TEST_CASE("a greeting and a request may come in any pieces") {
    Game game;
    Client slow = game.client();
    const std::string all = greeting(game.place().token) + text_of({.text = "1"});
    for (const char each : all) {
        CHECK(game.commands.empty());
        slow.send(std::string_view(&each, 1));
        game.frames();
    }
    CHECK(game.commands.size() == 1);
    Client fast = game.client();
    fast.send(all + text_of({.text = "2"}));
    game.frames(2);
    CHECK(game.commands.size() == 3);
}

TEST_CASE("a connection that never sends a greeting is closed") {
    Game game({.greeting_seconds = 0});
    Client silent = game.client();
    game.frames(2);
    CHECK(silent.ended());
    CHECK(game.listener().connections() == 0);
}

TEST_CASE("there are no more terminals than the limit") {
    Game game({.terminals = 2});
    Client one = game.terminal(), two = game.terminal(), three = game.client();
    three.send(greeting(game.place().token));
    game.frames();
    const auto messages = three.receive();
    REQUIRE(messages.size() == 1);
    CHECK(messages[0].kind == Message::Kind::refusal);
    CHECK(three.ended());
    CHECK(answer_to(game, one, "1") == "  said 1");
    CHECK(game.listener().connections() == 2);
}

TEST_CASE("a completion is answered alone in its frame and the next one after other requests") {
    Game game;
    Client one = game.terminal(), two = game.terminal();
    const std::string run = text_of({.text = "1"}), complete = text_of({Request::Kind::complete});
    for (int i = 0; i < 10; ++i) {
        one.send(run + run + complete + run);
        two.send(complete + run);
    }
    for (int i = 0; i < 60; ++i) {
        const std::size_t commands = game.commands.size(), completions = game.completions;
        game.frames();
        const bool others = game.commands.size() > commands;
        CHECK(game.completions - completions <= (others ? 0U : 1U));
    }
    CHECK(one.receive().size() == 40);
    CHECK(two.receive().size() == 20);
}

}  // namespace listener_test
