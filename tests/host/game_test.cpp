#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "catch.h"
#include "game.h"
#include "hosted.h"

namespace game_test {

using namespace hosted;

TEST_CASE("a program in C hosts a game and watches it") {
    double height = 0;
    int changes = 0;
    const int32_t code = run_a_game_in_c(&height, &changes);
    INFO(fettle_last_error());
    REQUIRE(code == FETTLE_DONE);
    CHECK(height == Approx(0.55).margin(0.1));
    CHECK(changes == 1);
}

TEST_CASE("all games are used by one thread until they are destroyed") {
    Game game = make("world.ball = Body { Circle {} }");
    fettle_property_id y = 0;
    fettle_instance ball = 0;
    require(fettle_property_at(game.get(), "world.ball.position.y", &y));
    require(fettle_hosted_find(game.get(), "world.ball", &ball));
    const auto elsewhere = [](auto act) {
        std::string said;
        std::thread([&] {
            if (act() == FETTLE_LOCKED) said = fettle_last_error();
        }).join();
        return said;
    };
    const std::string refusal = "one thread uses all games of a process";
    double height = 0;
    fettle_hosted* other = nullptr;
    CHECK_THAT(elsewhere([&] { return fettle_hosted_step(game.get()); }), contains(refusal));
    CHECK_THAT(elsewhere([&] { return fettle_property_get_number(game.get(), y, &height); }),
               contains(refusal));
    CHECK_THAT(elsewhere([&] { return fettle_hosted_create(nullptr, &other); }), contains(refusal));
    CHECK_THAT(elsewhere([&] { return fettle_hosted_destroy(game.get()); }), contains(refusal));
    bool alive = true;
    elsewhere([&] {
        alive = fettle_hosted_is_alive(game.get(), ball);
        return FETTLE_DONE;
    });
    CHECK_FALSE(alive);
    require(fettle_hosted_step(game.get()));

    game.reset();
    CHECK(elsewhere([&] {
              require(fettle_hosted_create(nullptr, &other));
              require(fettle_hosted_step(other));
              return fettle_hosted_destroy(other);
          }) == "");
    game = make();
    require(fettle_hosted_step(game.get()));
}

TEST_CASE("errors of scripts have the message that users of Lua see") {
    const Game game = make("world.ball = Body { Circle {} }");
    std::string told;
    require(fettle_hosted_on_problem(
        game.get(),
        [](void* user, const fettle_hosted_problem* problem) {
            *static_cast<std::string*>(user) = problem->file + std::string("|") +
                                               std::to_string(problem->line) + "|" +
                                               problem->message;
        },
        &told));
    CHECK(fettle_hosted_run(game.get(), "\nworld.ball.velocty = vec(1, 0)", "start.lua") ==
          FETTLE_FAILED);
    CHECK_THAT(fettle_last_error(), contains("fettle_hosted_run: start.lua:2: "));
    CHECK_THAT(fettle_last_error(), contains("velocity"));
    CHECK_THAT(told, contains("|2|start.lua:2: "));
    require(fettle_hosted_run(game.get(), "function update() error('no') end", "start"));
    CHECK(fettle_hosted_frame(game.get(), 0.1, nullptr) == FETTLE_FAILED);
    CHECK_THAT(fettle_last_error(), contains("no"));
    require(fettle_hosted_run(game.get(), "function update() end", "start"));
    CHECK(fettle_hosted_frame(game.get(), 0.1, nullptr) == FETTLE_DONE);
}

TEST_CASE("scripts call functions of the host and the host calls scripts") {
    const Game game = make();
    require(fettle_hosted_add_function(
        game.get(), "twice",
        [](void*, const fettle_hosted_value* arguments, uint32_t count,
           fettle_hosted_value* result) -> fettle_code {
            if (count != 1 || arguments[0].type != FETTLE_VALUE_NUMBER) {
                *result = text("twice: one number is needed");
                return FETTLE_INVALID;
            }
            *result = number(2 * arguments[0].as.number);
            return FETTLE_DONE;
        },
        nullptr));
    fettle_hosted_value result;
    require(fettle_hosted_evaluate(game.get(), "twice(1.25)", &result, nullptr));
    CHECK(result.as.number == 2.5);
    CHECK(fettle_hosted_evaluate(game.get(), "twice('a')", &result, nullptr) == FETTLE_FAILED);
    CHECK_THAT(fettle_last_error(), contains("one number is needed"));
    require(fettle_hosted_run(
        game.get(), "game.seen = 0  function hear(n, t) game.seen = n + #t end", "start"));
    const fettle_hosted_value arguments[] = {number(3), text("four")};
    require(fettle_hosted_call(game.get(), "hear", arguments, 2));
    CHECK(number_at(game.get(), "seen") == 7);
}

TEST_CASE("a function of the host without a reason or with a result of no type is a clear error") {
    const Game game = make();
    require(fettle_hosted_add_function(
        game.get(), "wrong",
        [](void*, const fettle_hosted_value*, uint32_t, fettle_hosted_value* result) {
            result->type = 99;
            return fettle_code(FETTLE_DONE);
        },
        nullptr));
    require(fettle_hosted_add_function(
        game.get(), "silent",
        [](void*, const fettle_hosted_value*, uint32_t, fettle_hosted_value* result) {
            *result = text("");
            return fettle_code(FETTLE_STALE);
        },
        nullptr));
    CHECK(fettle_hosted_run(game.get(), "wrong()", "test") == FETTLE_FAILED);
    CHECK_THAT(fettle_last_error(), contains("the result of the function: got a value of type 99"));
    CHECK(fettle_hosted_run(game.get(), "silent()", "test") == FETTLE_FAILED);
    CHECK_THAT(fettle_last_error(), contains("failed with the code 2"));
}

TEST_CASE("output of scripts and of commands reaches the host") {
    const Game game = make();
    std::string printed;
    require(fettle_hosted_on_print(
        game.get(), [](void* user, const char* line) { *static_cast<std::string*>(user) += line; },
        &printed));
    require(fettle_hosted_run(game.get(), "print('hello', 2)", "start"));
    CHECK_THAT(printed, contains("hello"));
    const char* output = nullptr;
    require(fettle_hosted_evaluate(game.get(), "world.gravity", nullptr, &output));
    CHECK_THAT(output, contains("vec(0, -"));
    CHECK(fettle_hosted_evaluate(game.get(), "if true then", nullptr, &output) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("not complete"));
}

TEST_CASE("frames make the steps that are due") {
    const Game game = make("world.dot = Body { Circle {} }");
    uint32_t steps = 7;
    require(fettle_hosted_frame(game.get(), 0.5 / 60, &steps));
    CHECK(steps == 0);
    require(fettle_hosted_frame(game.get(), 2.6 / 60, &steps));
    CHECK(steps == 3);
    CHECK(fettle_hosted_frame(game.get(), -1, &steps) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("expected 0 to 3600"));
}

TEST_CASE("a game is loaded from a folder and loaded again while it runs") {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / "fettle_host_reload";
    std::filesystem::create_directories(folder);
    const auto write = [&](const char* text) { std::ofstream(folder / "main.lua") << text; };
    write("world.ball = Body { Circle {}, position = vec(0, 5), gravity_scale = 1 }");
    const Game game = make();
    require(fettle_hosted_load(game.get(), folder.c_str()));
    for (int i = 0; i < 30; ++i) require(fettle_hosted_step(game.get()));
    const double fallen = number_at(game.get(), "world.ball.position.y");
    CHECK(fallen < 4.5);
    write("world.ball = Body { Circle {}, position = vec(0, 5), gravity_scale = 0.25 }");
    require(fettle_hosted_reload(game.get()));
    CHECK(number_at(game.get(), "world.ball.gravity_scale") == 0.25);
    CHECK(number_at(game.get(), "world.ball.position.y") == fallen);
    write("world.ball = Body { Circle {}, gravity_scal = 0.5 }");
    CHECK(fettle_hosted_reload(game.get()) == FETTLE_FAILED);
    CHECK_THAT(fettle_last_error(), contains("gravity_scale"));
    CHECK(number_at(game.get(), "world.ball.gravity_scale") == 0.25);
    std::filesystem::remove_all(folder);
    CHECK(fettle_hosted_load(game.get(), folder.c_str()) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("fettle_host_reload"));
}

TEST_CASE("null and stale pointers and wrong definitions are refused") {
    fettle_hosted_def def;
    CHECK(fettle_hosted_def_init(nullptr, sizeof def) == FETTLE_INVALID);
    CHECK(fettle_hosted_def_init(&def, 3) == FETTLE_INVALID);
    require(fettle_hosted_def_init(&def, sizeof def));
    CHECK(fettle_hosted_create(&def, nullptr) == FETTLE_INVALID);
    fettle_hosted* game = nullptr;
    def.call_seconds = -1;
    CHECK(fettle_hosted_create(&def, &game) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("call_seconds"));
    fettle_hosted_def_init(&def, sizeof def);
    for (const uint64_t memory : {uint64_t{1}, ~uint64_t{0}}) {
        def.lua_memory = memory;
        CHECK(fettle_hosted_create(&def, &game) == FETTLE_INVALID);
        CHECK_THAT(fettle_last_error(), contains("expected 16 MiB to 64 TiB"));
    }
    require(fettle_hosted_create(nullptr, &game));
    require(fettle_hosted_destroy(game));
    CHECK(fettle_hosted_destroy(game) == FETTLE_STALE);
    CHECK(fettle_hosted_step(game) == FETTLE_STALE);
    CHECK_THAT(fettle_last_error(), contains("it was destroyed"));
    CHECK(fettle_hosted_step(nullptr) == FETTLE_INVALID);
    CHECK(fettle_hosted_destroy(nullptr) == FETTLE_DONE);
    const Game other = make();
    CHECK(fettle_hosted_run(other.get(), nullptr, nullptr) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("lua: expected a pointer, got null"));
}

TEST_CASE("a game is not destroyed by the functions that it calls") {
    const Game game = make("world.ball = Body { Circle {} }");
    require(fettle_hosted_add_function(
        game.get(), "end_it",
        [](void* user, const fettle_hosted_value*, uint32_t, fettle_hosted_value* result) {
            auto* const of = static_cast<fettle_hosted*>(user);
            const bool refused = fettle_hosted_destroy(of) == FETTLE_LOCKED &&
                                 fettle_hosted_step(of) == FETTLE_LOCKED &&
                                 fettle_hosted_reload(of) == FETTLE_LOCKED &&
                                 fettle_hosted_rewind(of, 1) == FETTLE_LOCKED;
            *result = number(refused ? 1 : 0);
            return fettle_code{FETTLE_DONE};
        },
        game.get()));
    fettle_hosted_value result;
    require(fettle_hosted_evaluate(game.get(), "end_it()", &result, nullptr));
    CHECK(result.as.number == 1);
}

}  // namespace game_test
