#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "catch.h"
#include "hosted.h"

namespace console_test {

using namespace hosted;

namespace {

fettle_hosted_input input(int32_t kind, const char* name = nullptr) {
    fettle_hosted_input made;
    require(fettle_hosted_input_init(&made, sizeof made));
    made.kind = kind;
    made.name = name;
    return made;
}
bool send(const Game& game, const fettle_hosted_input& event) {
    bool used = false;
    require(fettle_hosted_handle(game.get(), &event, &used));
    return used;
}
void press(const Game& game, const char* key) {
    send(game, input(FETTLE_INPUT_KEY_PRESSED, key));
    send(game, input(FETTLE_INPUT_KEY_RELEASED, key));
}
void type(const Game& game, const char* text) {
    for (; *text != 0; ++text) {
        fettle_hosted_input event = input(FETTLE_INPUT_TEXT);
        event.character = static_cast<unsigned char>(*text);
        send(game, event);
    }
}
fettle_console_picture draw(const Game& game, int frames = 30) {
    fettle_console_picture picture{};
    for (int i = 0; i < frames; ++i) {
        require(fettle_hosted_frame(game.get(), 1.0 / 60, nullptr));
        require(fettle_console_draw(game.get(), 800, 600, 1.0 / 60, &picture));
    }
    return picture;
}

}  // namespace

TEST_CASE("the grave key opens the console and its triangles are whole") {
    const Game game = make("world.ball = Body { Circle {} }");
    CHECK(draw(game).command_count == 0);
    CHECK(send(game, input(FETTLE_INPUT_KEY_PRESSED, "grave")));
    bool open = false;
    require(fettle_console_is_open(game.get(), &open));
    CHECK(open);
    const fettle_console_picture picture = draw(game);
    REQUIRE(picture.command_count > 3);
    REQUIRE(picture.texture_count >= 1);
    uint32_t used = 0, outside = 0;
    for (uint32_t i = 0; i < picture.command_count; ++i) {
        const fettle_console_command& command = picture.commands[i];
        CHECK(command.first_index == used);
        CHECK(command.index_count % 3 == 0);
        CHECK(command.clip.left + command.clip.width <= 800);
        CHECK(command.clip.top + command.clip.height <= 600);
        const bool known = std::any_of(
            picture.textures, picture.textures + picture.texture_count,
            [&](const fettle_console_texture& each) { return each.id == command.texture; });
        CHECK((command.texture == 0 || known));
        used += command.index_count;
    }
    CHECK(used == picture.index_count);
    for (uint32_t i = 0; i < picture.index_count; ++i)
        if (picture.indices[i] >= picture.vertex_count) ++outside;
    CHECK(outside == 0);
    // The font: some of its pixels are opaque, and most are not.
    const fettle_console_texture& font = picture.textures[0];
    std::size_t opaque = 0;
    const std::size_t pixels = std::size_t{font.width} * font.height;
    for (std::size_t i = 0; i < pixels; ++i) opaque += font.rgba[4 * i + 3] == 255 ? 1 : 0;
    CHECK(opaque > pixels / 200);
    CHECK(opaque < pixels / 2);
    press(game, "grave");
}

TEST_CASE("a command that is typed runs in the game") {
    const Game game = make("world.ball = Body { Circle {} }");
    require(fettle_console_open(game.get(), true));
    draw(game, 2);
    type(game, "world.ball.gravity_scale = 2.5");
    press(game, "enter");
    CHECK(number_at(game.get(), "world.ball.gravity_scale") == 2.5);
    // A closed console leaves keys to the program.
    require(fettle_console_open(game.get(), false));
    draw(game, 30);
    CHECK_FALSE(send(game, input(FETTLE_INPUT_KEY_PRESSED, "w")));
}

TEST_CASE("a click on a body selects it where the program draws it") {
    const Game game = make("world.ball = Body { Circle { radius = 1 }, type = 'static' }");
    // Between the windows of the console and its prompt.
    const double map[] = {40, 0, 0, -40, 300, 400};
    require(fettle_console_set_view(game.get(), map));
    require(fettle_console_open(game.get(), true));
    draw(game);
    for (const int32_t kind :
         {FETTLE_INPUT_MOUSE_MOVED, FETTLE_INPUT_MOUSE_PRESSED, FETTLE_INPUT_MOUSE_RELEASED}) {
        fettle_hosted_input event =
            input(kind, kind == FETTLE_INPUT_MOUSE_MOVED ? nullptr : "left");
        event.x = 300;
        event.y = 400;
        send(game, event);
        draw(game, 1);
    }
    fettle_instance selected = 0, ball = 1;
    require(fettle_console_selected(game.get(), &selected));
    require(fettle_hosted_find(game.get(), "world.ball", &ball));
    CHECK(selected == ball);
    const double flat[] = {40, 0, 40, 0, 0, 0};
    CHECK(fettle_console_set_view(game.get(), flat) == FETTLE_INVALID);
}

TEST_CASE("the font has another texture when its size changes") {
    const Game game = make();
    require(fettle_console_open(game.get(), true));
    const fettle_console_texture before = draw(game).textures[0];
    require(fettle_hosted_run(game.get(), "console.font_size = 24", "start"));
    const fettle_console_picture picture = draw(game);
    for (uint32_t i = 0; i < picture.command_count; ++i)
        CHECK(picture.commands[i].texture != before.id);
    // Old sizes are not kept forever.
    for (int size = 10; size < 40; ++size) {
        const fettle_hosted_value value = number(size);
        require(fettle_hosted_set(game.get(), "console.font_size", &value));
        draw(game, 1);
    }
    CHECK(draw(game).texture_count <= 8);
}

TEST_CASE("a game may have no console and input is checked") {
    fettle_hosted_def def;
    require(fettle_hosted_def_init(&def, sizeof def));
    def.console = false;
    fettle_hosted* made = nullptr;
    require(fettle_hosted_create(&def, &made));
    const Game bare(made);
    fettle_console_picture picture;
    CHECK(fettle_console_draw(made, 800, 600, 0, &picture) == FETTLE_INVALID);
    CHECK_THAT(fettle_last_error(), contains("without a console"));
    CHECK_FALSE(send(bare, input(FETTLE_INPUT_KEY_PRESSED, "a")));
    CHECK(get(made, "input.keys.a").as.boolean != 0);

    const Game game = make();
    fettle_hosted_input event = input(FETTLE_INPUT_MOUSE_MOVED);
    event.x = std::nanf("");
    CHECK(fettle_hosted_handle(game.get(), &event, nullptr) == FETTLE_INVALID);
    event = input(77);
    CHECK(fettle_hosted_handle(game.get(), &event, nullptr) == FETTLE_INVALID);
    CHECK(fettle_console_draw(game.get(), 0, 600, 0, &picture) == FETTLE_INVALID);
}

TEST_CASE("the console uses the clipboard of the program") {
    const Game game = make();
    std::string clipboard = "1 + 41";
    require(fettle_console_set_clipboard(
        game.get(), [](void* user) { return static_cast<std::string*>(user)->c_str(); },
        [](void* user, const char* text) { *static_cast<std::string*>(user) = text; }, &clipboard));
    require(fettle_hosted_run(game.get(), "game.sum = 0", "start"));
    require(fettle_console_open(game.get(), true));
    draw(game, 2);
    type(game, "game.sum = ");
    fettle_hosted_input paste = input(FETTLE_INPUT_KEY_PRESSED, "v");
    paste.control = true;
    send(game, paste);
    press(game, "enter");
    CHECK(number_at(game.get(), "sum") == 42);
}

TEST_CASE("two branches of the past are compared side by side") {
    const Game game = make("world.ball = Body { position = vec(0, 2), Circle {} }");
    const auto run = [&game](const char* command) {
        require(fettle_hosted_evaluate(game.get(), command, nullptr, nullptr));
        return draw(game, 3).vertex_count;
    };
    require(fettle_console_open(game.get(), true));
    draw(game, 60);
    run("rewind(0.5)");
    run("world.ball.velocity = vec(5, 5)");
    draw(game, 20);
    run("clear");
    // One view for each branch is drawn. An error would be a line of the log.
    const uint32_t before = run("time.paused = true"), with = run("compare_branch()");
    CHECK(with > before + 200);
}

TEST_CASE("the console goes on while formulas of its settings and of the services fail") {
    const std::pair<std::string, std::string> all[] = {
        {"console.memory_limit", "64"},   {"console.pauses", "true"},    {"console.ghosts", "true"},
        {"console.font_size", "20"},      {"console.inspector", "true"}, {"time.paused", "true"},
        {"view.show.onion_skins", "true"}};
    for (const auto& [path, other] : all) {
        INFO(path);
        const Game game = make("");
        const auto evaluate = [&game](const std::string& command) {
            return fettle_hosted_evaluate(game.get(), command.c_str(), nullptr, nullptr);
        };
        require(evaluate("world.kept = Object { value = " + path + " }"));
        require(evaluate(path + " is world.kept.value"));
        require(fettle_console_open(game.get(), true));
        draw(game, 2);
        require(evaluate("world.kept:delete()"));
        // The error of the formula itself is reported once.
        (void)fettle_hosted_frame(game.get(), 1.0 / 60, nullptr);
        (void)fettle_hosted_frame(game.get(), 1.0 / 60, nullptr);
        draw(game, 2);
        press(game, "escape");
        type(game, "x");
        draw(game, 2);
        require(evaluate("1 + 1"));
        require(evaluate(path + " = " + other));
        require(evaluate(path));
    }
}

}  // namespace console_test
