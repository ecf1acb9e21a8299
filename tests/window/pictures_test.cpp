// Sprites, layers and the pen's state, compared pixel by pixel.

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "catch.h"
#include "game_window.h"
#include "temporary_folder.h"

namespace pictures_test {

using fettle::test::GameWindow;
using fettle::test::missing_tools;
using fettle::test::Picture;
namespace fs = std::filesystem;

namespace {

/// True, with a message, if windows cannot be tested here.
bool skipped() {
    const std::string missing = missing_tools();
    if (!missing.empty()) std::cout << "SKIPPED: " << missing << " not found\n";
    return !missing.empty();
}

/// Two by two pixels: red, green; blue, white.
std::string dots() {
    std::string file(18, '\0');
    file[2] = 2;
    file[12] = file[14] = 2;
    file[16] = 32;
    file[17] = 0x28;
    for (const char* pixel : {"\0\0\xff\xff", "\0\xff\0\xff", "\xff\0\0\xff", "\xff\xff\xff\xff"})
        file += std::string(pixel, 4);
    return file;
}

Picture picture_of(const std::string& name, const std::string& script) {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "dots.tga", std::ios::binary) << dots();
    std::ofstream(folder.path / "main.lua") << R"(
        view.background = color("white")
        world.gravity = vec(0, 0)
        local pictures = 0
        function update() pictures = pictures + 1 if pictures == 10 then print("drawn") end end
        Dots = class("Dots", Sprite) { image = "dots.tga", smooth = false }
    )" << script;
    GameWindow game(folder.path);
    const bool drawn = game.prints("drawn");
    INFO(game.printed());
    REQUIRE(drawn);
    Picture picture = game.settled();
    picture.save_png(fs::path(FETTLE_PICTURES) / ("pictures_" + name + ".png"));
    return picture;
}

/// Whether a pixel has about this color.
bool has(const Picture& picture, double x, double y, int r, int g, int b) {
    const std::size_t i =
        (std::size_t(std::lround(y)) * picture.width + std::size_t(std::lround(x))) * 3;
    const auto near = [&](std::size_t c, int wanted) {
        return std::abs(int(picture.rgb.at(i + c)) - wanted) < 5;
    };
    const bool same = near(0, r) && near(1, g) && near(2, b);
    if (!same)
        UNSCOPED_INFO("(" << x << ", " << y << ") is " << int(picture.rgb.at(i)) << " "
                          << int(picture.rgb.at(i + 1)) << " " << int(picture.rgb.at(i + 2)));
    return same;
}

/// The same for a point of the world.
bool has_at(const Picture& picture, double x, double y, int r, int g, int b) {
    return has(picture, 640 + 40 * x, 400 - 40 * y, r, g, b);
}

}  // namespace

TEST_CASE("sprites are drawn upright and turned and mirrored and blended") {
    if (skipped()) return;
    const Picture picture = picture_of("sprites", R"(
        world.upright = Dots { size = vec(4, 4) }
        world.turned = Dots { size = vec(4, 4), position = vec(0, -6), angle = deg(90) }
        world.mirrored = Dots { size = vec(4, 4), position = vec(6, -6), flip_x = true }
        world.below = Body { type = "static", position = vec(-8, 0), angle = deg(180),
            Box { width = 5, height = 5, color = color(0.5, 0.5, 0.5), border = color(0.5, 0.5, 0.5) },
            Dots { size = vec(4, 4), blend = "multiply" } }
        world.black = Body { type = "static", position = vec(8, 0),
            Box { width = 5, height = 5, color = color(0, 0, 0.5), border = color(0, 0, 0.5) },
            Dots { size = vec(4, 4), blend = "add", tint = color(0.5, 1, 0, 1) } }
        world.back = Dots { size = vec(2, 2), z = -1, position = vec(8, 1) }
    )");
    CHECK(has_at(picture, -1, 1, 255, 0, 0));
    CHECK(has_at(picture, 1, 1, 0, 255, 0));
    CHECK(has_at(picture, -1, -1, 0, 0, 255));
    CHECK(has_at(picture, 1, -1, 255, 255, 255));
    // The edges are sharp.
    CHECK(has_at(picture, -0.1, 1.9, 255, 0, 0));
    CHECK(has_at(picture, 0.1, 1.9, 0, 255, 0));
    // Turned counter-clockwise: what was at the top right is at the top left.
    CHECK(has_at(picture, -1, -5, 0, 255, 0));
    CHECK(has_at(picture, -1, -7, 255, 0, 0));
    CHECK(has_at(picture, 1, -7, 0, 0, 255));
    CHECK(has_at(picture, 5, -5, 0, 255, 0));
    CHECK(has_at(picture, 7, -5, 255, 0, 0));
    // Below a body that is turned by half a turn.
    CHECK(has_at(picture, -7, -1, 128, 0, 0));
    CHECK(has_at(picture, -9, 1, 128, 128, 128));
    CHECK(has_at(picture, 7, 1, 128, 0, 128));
    CHECK(has_at(picture, 9, -1, 128, 255, 128));
}

TEST_CASE("layers and the state of the pen change what is drawn") {
    if (skipped()) return;
    const Picture picture = picture_of("layers", R"(
        world.pale = Layer { opacity = 0.5,
            Dots { size = vec(4, 4) },
            Body { type = "static", position = vec(5, 0),
                Box { width = 2, height = 2, color = color(0, 0, 0), border = color(0, 0, 0) } } }
        world.hidden = Layer { visible = false, Dots { size = vec(40, 40) } }
        game.corner = Layer { space = "screen", anchor = "bottom_right",
            Dots { size = vec(40, 40), position = vec(-20, -20) } }
        world.far = Layer { parallax = vec(0.5, 1), Dots { size = vec(2, 2), position = vec(-6, 6) } }
        view.center = vec(4, 0)
        function draw(pen)
            pen.push(vec(4, 6), deg(90), 2)
            pen.clip(vec(-0.5, -1), vec(0.5, 1))
            pen.box(vec(0, 0), 10, 10, "black")
            pen.pop()
            pen.push(vec(12, 6))
            pen.fade(0.5)
            pen.image("dots.tga", vec(0, 0), 2)
            pen.pop()
            pen.box(vec(15, 6), 1, 1, "black")
        end
    )");
    const double moved = -4;  // the view is 4 m to the right
    CHECK(has_at(picture, moved - 1, 1, 255, 128, 128));
    CHECK(has_at(picture, moved + 5, 0, 128, 128, 128));
    CHECK(has(picture, 1250, 770, 255, 0, 0));
    CHECK(has(picture, 1270, 770, 0, 255, 0));
    CHECK(has(picture, 1250, 790, 0, 0, 255));
    CHECK(has_at(picture, -6.5 + 2 + moved, 6.5, 255, 0, 0));
    CHECK(has_at(picture, 4 + moved, 6, 0, 0, 0));
    CHECK(has_at(picture, 4 + moved + 1.8, 6.8, 0, 0, 0));
    CHECK(has_at(picture, 4 + moved + 2.2, 6, 255, 255, 255));
    CHECK(has_at(picture, 4 + moved, 7.2, 255, 255, 255));
    CHECK(has_at(picture, 11.5 + moved, 6.5, 255, 128, 128));
    CHECK(has_at(picture, 15 + moved, 6, 0, 0, 0));
}

TEST_CASE("a letterbox has bars beside the picture") {
    if (skipped()) return;
    const Picture picture = picture_of("letterbox", R"(
        view.design = vec(100, 100)
        view.fit = "letterbox"
        view.angle = deg(90)
        world.dots = Dots { size = vec(4, 4) }
        function draw(pen)
            pen.screen(function(screen)
                screen.box(vec(5, 5), 10, 10, "lime")
                screen.box(view.screen - vec(5, 5), 10, 10, "lime")
            end)
        end
    )");
    // What is on the screen counts from the corner of the picture.
    CHECK(has(picture, 243, 3, 0, 255, 0));
    CHECK(has(picture, 1037, 797, 0, 255, 0));
    CHECK(has(picture, 100, 400, 0, 0, 0));
    CHECK(has(picture, 1200, 400, 0, 0, 0));
    CHECK(has(picture, 260, 20, 255, 255, 255));
    CHECK(has_at(picture, 1, 1, 255, 0, 0));  // the viewer is turned to the left
    CHECK(has_at(picture, -1, 1, 0, 0, 255));
}

TEST_CASE("gradients fill shapes and end with the pop of their push") {
    if (skipped()) return;
    const Picture picture = picture_of("gradients", R"(
        function draw(pen)
            pen.push()
            pen.linear(vec(-4, 0), vec(4, 0), { "black", "red", "black" })
            pen.box(vec(0, 0), 12, 4, "white", "lime", 4)
            pen.pop()
            pen.push(vec(0, -6), deg(90), 2)
            pen.radial(vec(0, 0), 1, { "white", "blue" })
            pen.circle(vec(0, 0), 1.5)
            pen.pop()
            pen.push()
            pen.linear(vec(6, 0), vec(6, 4), { "white", "red" })
            pen.circle(vec(9, 2), 2, color(0, 0, 1))
            pen.pop()
            pen.box(vec(-9, 0), 2, 2, "yellow")
        end
    )");
    CHECK(has_at(picture, 0, 0, 254, 0, 0));
    CHECK(has_at(picture, -2, 1, 128, 0, 0));
    CHECK(has_at(picture, 2, -1, 128, 0, 0));
    CHECK(has_at(picture, -5, 0, 0, 0, 0));  // beyond the ends of the line
    CHECK(has_at(picture, 0, 1.95, 0, 255, 0));
    // Turned and scaled: a radius of 2, and a circle of 3.
    CHECK(has_at(picture, 0, -6, 253, 253, 255));
    CHECK(has_at(picture, 1, -6, 128, 128, 255));
    CHECK(has_at(picture, 0, -7, 128, 128, 255));
    CHECK(has_at(picture, 2.5, -6, 0, 0, 255));
    CHECK(has_at(picture, 9, 2, 0, 0, 128));  // multiplied by the color of the fill
    CHECK(has_at(picture, -9, 0, 255, 255, 0));
}

TEST_CASE("a frame of a sheet is drawn by the pen") {
    if (skipped()) return;
    const Picture picture = picture_of("frames", R"(
        function draw(pen)
            local function frame(n, x, columns, rows)
                pen.image({ "dots.tga", columns = columns, rows = rows, frame = n }, vec(x, 0), 2, 2,
                    0, nil, false)
            end
            for i = 1, 5 do frame(i, 3 * i - 9, 2, 2) end
            frame(2, 9, 1, 2)
        end
    )");
    CHECK(has_at(picture, -6, 0, 255, 0, 0));
    CHECK(has_at(picture, -3, 0, 0, 255, 0));
    CHECK(has_at(picture, 0, 0, 0, 0, 255));
    CHECK(has_at(picture, 3, 0, 255, 255, 255));
    CHECK(has_at(picture, 6, 0, 255, 0, 0));  // beyond the last frame, the first again
    CHECK(has_at(picture, 8.5, 0, 0, 0, 255));
    CHECK(has_at(picture, 9.5, 0, 255, 255, 255));
}

TEST_CASE("many small pictures in a row look like the same ones a few at a time") {
    if (skipped()) return;
    // A sharp picture between smooth ones ends a batch.
    const auto scene = [](const char* name, int at_a_time) {
        return picture_of(name, "local at_a_time = " + std::to_string(at_a_time) + R"(
            view.background = color("black")
            function draw(pen)
                for i = 1, 4000 do
                    local at = vec(i * 0.618 % 1, i * 0.331 % 1) * 9
                    local tint = color(i % 3 / 2, i % 5 / 4, i % 7 / 6, 0.3 + i % 8 / 10)
                    if i % 2000 == 1 then
                        pen.push()
                        pen.blend(i == 1 and "normal" or "add")
                        pen.clip(vec(0.3, 0.4), vec(8.2, 8.6))
                    end
                    pen.image("dots.tga", at, 0.08 + i % 4 / 40, 0.12, i % 2, tint)
                    if i % at_a_time == 0 then pen.image("dots.tga", vec(-3, 0), 1, 1, 0, nil, false) end
                    if i % 2000 == 0 then pen.pop() end
                end
            end
        )");
    };
    const Picture many = scene("many_small", 4000), few = scene("few_small", 20);
    int worst = 0;
    std::size_t far = 0, colored = 0;
    for (std::size_t i = 0; i < many.rgb.size(); ++i) {
        const int off = std::abs(int(many.rgb[i]) - int(few.rgb.at(i)));
        worst = std::max(worst, off);
        if (off > 8) ++far;
        if (many.rgb[i] > 40) ++colored;
    }
    INFO("greatest difference " << worst << ", channels that differ much: " << far);
    CHECK(far < 300);  // a pixel whose middle is on an edge may be on either side
    CHECK(colored > 20'000);
}

TEST_CASE("a file that is missing from the beginning is told over the game") {
    if (skipped()) return;
    const TemporaryFolder folder;
    const auto save = [&](const fs::path& file, const char* image) {
        std::ofstream(file) << "view.background = color('white')\n"
                               "world.sign = Sprite { image = '"
                            << image << "' }\nprint('" << image << "')\n";
    };
    std::ofstream(folder.path / "dots.tga", std::ios::binary) << dots();
    save(folder.path / "main.lua", "dost.tga");
    GameWindow game(folder.path);
    REQUIRE(game.prints(
        "world.sign.image: there is no file \"dost.tga\" (did you mean \"dots.tga\"?)"));
    const auto error_is_shown = [&] { return !has_at(game.picture(), 12, -9.8, 255, 255, 255); };
    CHECK(game.eventually(error_is_shown));
    save(game.folder() / "game" / "new", "dots.tga");
    fs::rename(game.folder() / "game" / "new", game.folder() / "game" / "main.lua");
    CHECK(game.prints("reloaded main.lua"));
    CHECK(game.eventually([&] { return !error_is_shown(); }));
}

TEST_CASE("settings in error keep a game from beginning again and the window stays") {
    if (skipped()) return;
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua") << "x = = 1\n";
    GameWindow game(folder.path);
    REQUIRE(game.prints("main.lua:1: "));
    const auto change = [&](const char* name, const std::string& text) {
        std::ofstream(game.folder() / "game" / "new") << text;
        fs::rename(game.folder() / "game" / "new", game.folder() / "game" / name);
    };
    change("game.json", R"({ "nam": "Stay" })");
    game.key("r");
    CHECK(game.prints("game.json:1:3: nam: there is no such setting"));
    change("main.lua", "print('it begins')\n");
    CHECK(game.running());
    change("game.json", R"({ "name": "Stay" })");
    CHECK(game.prints("it begins"));
    CHECK(game.running());
}

TEST_CASE("an effect changes the picture and follows its uniforms") {
    if (skipped()) return;
    const TemporaryFolder folder;
    const auto write = [&](const char* name, const std::string& text) {
        std::ofstream(folder.path / name) << text;
    };
    // The right half repeats the left half, and the upper half gets another color.
    const std::string good = R"(uniform vec4 tint; // uniform float no;
        uniform float strength, other; uniform vec2 far;
        void main() {
            vec4 c = picture(vec2(mod(point.x, size.x / 2.0), point.y));
            if (point.y < size.y / 2.0) c.rgb *= tint.rgb * strength;
            gl_FragColor = vec4(c.rgb, 1.0);
        })";
    write("good.frag", good);
    write("bad.frag", "uniform float strength;\nvoid main() {\n    gl_FragColor = nonsense;\n}\n");
    const std::string main = R"(
        view.background = color("white")
        view.effect = "good.frag"
        view.uniforms.tint = color(1, 0.5, 0)
        view.uniforms.strength = 1
        view.uniforms.no = 1
        view.uniforms.far = 2
        world.gravity = vec(0, 0)
        world.left = Body { position = vec(-8, 0), Box { width = 8, height = 16, color = color(0, 0, 1),
                            border = color(0, 0, 1) } }
        local frames = 0
        function update()
            frames = frames + 1
            if frames == 60 then print("drawn") end
        end
        function key_pressed(key)
            if key == "b" then view.effect = "bad.frag" end
            if key == "h" then view.uniforms.strength = 0.5 end
        end
    )";
    write("main.lua", main);
    GameWindow game(folder.path);
    REQUIRE(game.prints("drawn"));
    const Picture picture = game.settled();
    picture.save_png(fs::path(FETTLE_PICTURES) / "pictures_effect.png");
    CHECK(has_at(picture, 1, 8.5, 255, 128, 0));
    CHECK(has_at(picture, 1, -7, 255, 255, 255));
    CHECK(has_at(picture, -8, -4, 0, 0, 255));
    CHECK(has_at(picture, 8, -4, 0, 0, 255));
    CHECK(has_at(picture, 8, 4, 0, 0, 0));
    CHECK(game.prints("view.uniforms.no: good.frag declares no uniform of that name"));
    CHECK(game.prints("view.uniforms.far: good.frag declares a vec2, got 2"));
    game.key("h");
    CHECK(game.eventually([&] { return has_at(game.picture(), 1, 8.5, 128, 64, 0); }));
    // New code with an error leaves the picture as it was, with a message over the game until it is
    // right.
    const auto change = [&](const char* name, const std::string& text) {
        std::ofstream(game.folder() / "game" / "new") << text;
        fs::rename(game.folder() / "game" / "new", game.folder() / "game" / name);
    };
    const auto error_is_shown = [&] { return !has_at(game.picture(), 12, -9.8, 255, 255, 255); };
    CHECK(error_is_shown());  // about the uniforms
    change("good.frag", "uniform float strength;\nvoid main() { nonsense }");
    CHECK(game.prints("view.effect: good.frag:2: "));
    CHECK(game.printed().find("view.uniforms.tint: ") == std::string::npos);
    CHECK(game.eventually(error_is_shown));
    CHECK(has_at(game.picture(), 1, 8.5, 128, 64, 0));
    change("main.lua", main + "print('again')");
    CHECK(game.prints("again"));
    CHECK(error_is_shown());
    std::string better = "uniform float no;" + good;
    better.replace(better.find("vec2 far"), 8, "float far");
    change("good.frag", better);
    CHECK(game.eventually([&] { return !error_is_shown(); }));
    game.key("b");
    CHECK(game.prints("view.effect: bad.frag:3: "));
    CHECK(game.eventually([&] { return has_at(game.picture(), 1, 8.5, 255, 255, 255); }));
}

namespace {

/// Lengths of the runs of pixels with one color, from a pixel on, to the right or down.
std::vector<int> runs(const Picture& picture, int x, int y, int count, bool down) {
    const auto at = [&](int n) {
        const int px = down ? x : x + n, py = down ? y + n : y;
        const std::size_t i = (std::size_t(py) * picture.width + std::size_t(px)) * 3;
        return std::array{picture.rgb.at(i), picture.rgb.at(i + 1), picture.rgb.at(i + 2)};
    };
    std::vector<int> lengths;
    for (int n = 0; n < count; ++n)
        if (n > 0 && at(n) == at(n - 1))
            ++lengths.back();
        else
            lengths.push_back(1);
    return lengths;
}

}  // namespace

TEST_CASE("pixels of tiles are equally wide where they meet in the middle of a pixel") {
    if (skipped()) return;
    // 3 pixels of the screen for one of the image; all edges are half a pixel off.
    const Picture picture = picture_of("equal_pixels", R"(
        for y = 0, 19 do for x = 0, 19 do
            world:add(Dots { size = vec(0.15, 0.15), origin = vec(0, 0),
                position = vec(0.15 * x + 0.0125, 0.15 * y + 0.0125), flip_x = y == 5, flip_y = x == 5 })
        end end
    )");
    for (const bool down : {false, true}) {
        // The last 19 of 20 tiles, from the edge of the second one.
        const std::vector<int> lengths = runs(picture, 640 + 8, 400 - 116, 100, down);
        CHECK(
            std::all_of(lengths.begin() + 1, lengths.end() - 1, [](int n) { return n % 3 == 0; }));
        CHECK(lengths.size() > 20);
    }
}

TEST_CASE("many pictures in a row keep their order with the figures around them") {
    if (skipped()) return;
    const Picture picture = picture_of("many", R"(
        local function heap(z, x)
            for i = 1, 150 do
                world:add(Dots { size = vec(4, 4), position = vec(x, 0), z = z })
            end
        end
        heap(0, 0)
        world.box = Body { type = "static", z = 1, position = vec(1, 0),
            Box { width = 2, height = 8, color = color(0, 0, 0), border = color(0, 0, 0) } }
        heap(2, 2.5)
    )");
    CHECK(has_at(picture, -1, 1, 255, 0, 0));
    CHECK(has_at(picture, -1, -1, 0, 0, 255));
    CHECK(has_at(picture, 0.3, 1, 0, 0, 0));
    CHECK(has_at(picture, 0.3, 3, 0, 0, 0));
    CHECK(has_at(picture, 1.5, 1, 255, 0, 0));
    CHECK(has_at(picture, 3.5, 1, 0, 255, 0));
    CHECK(has_at(picture, 3.5, -1, 255, 255, 255));
}

}  // namespace pictures_test
