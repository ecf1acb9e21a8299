// Drawing, compared pixel by pixel.

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>

#include "catch.h"
#include "game_window.h"
#include "temporary_folder.h"

namespace drawing_test {

using fettle::test::GameWindow;
using fettle::test::missing_tools;
using fettle::test::Picture;
namespace fs = std::filesystem;

namespace {

struct Rgb {
    int r = 0, g = 0, b = 0;
    int distance(const Rgb& other) const {
        return std::max({std::abs(r - other.r), std::abs(g - other.g), std::abs(b - other.b)});
    }
};
constexpr Rgb black{0, 0, 0}, white{255, 255, 255}, red{255, 0, 0};

Rgb at(const Picture& picture, int x, int y) {
    const std::size_t i = (std::size_t(y) * picture.width + std::size_t(x)) * 3;
    return {picture.rgb.at(i), picture.rgb.at(i + 1), picture.rgb.at(i + 2)};
}

/// Darkness of a pixel of a black and white picture, 0 to 1.
double ink(const Picture& picture, int x, int y) {
    return 1 - at(picture, x, y).g / 255.0;
}

/// True, with a message, if windows cannot be tested here.
bool skipped() {
    const std::string missing = missing_tools();
    if (!missing.empty()) std::cout << "SKIPPED: " << missing << " not found\n";
    return !missing.empty();
}

/// The picture of a game with one file: 40 pixels per meter, the origin in the middle of 1280 ×
/// 800.
Picture picture_of(const std::string& name, const std::string& script) {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua") << R"(
        view.background = color("white")
        world.gravity = vec(0, 0)
        local pictures = 0
        function update() pictures = pictures + 1 if pictures == 10 then print("drawn") end end
    )" << script;
    GameWindow game(folder.path);
    const bool drawn = game.prints("drawn");
    INFO(game.printed());
    REQUIRE(drawn);
    Picture picture = game.settled();
    picture.save_png(fs::path(FETTLE_PICTURES) / ("drawing_" + name + ".png"));
    return picture;
}

/// Calls `visit(x, y)` for the pixels of a strip along a line in the world, half_width pixels to
/// each side.
void along(double x0, double y0, double x1, double y1, int half_width,
           const std::function<void(int, int)>& visit) {
    const double ax = 640 + 40 * x0, ay = 400 - 40 * y0, bx = 640 + 40 * x1, by = 400 - 40 * y1;
    const double length = std::hypot(bx - ax, by - ay);
    for (double t = 0; t <= length; t += 0.5)
        for (int d = -half_width; d <= half_width; ++d)
            visit(int(std::floor(ax + (bx - ax) * t / length - (by - ay) * d / length)),
                  int(std::floor(ay + (by - ay) * t / length + (bx - ax) * d / length)));
}

}  // namespace

TEST_CASE("touching boxes of one color have no visible line between them") {
    if (skipped()) return;
    // Rows of ten boxes at all subpixel offsets and at three angles, drawn as bodies and by the
    // pen.
    const Picture picture = picture_of("tiles", R"(
        local brown = color("#5a3d2b")
        function start()
            for row = 0, 7 do
                local angle = ({0, 0.1, 0.6})[row % 3 + 1]
                for i = 0, 9 do
                    local at = vec(-15 + row * 0.0137, 8 - 2 * row + 0.0071 * row)
                        + 0.5 * i * vec(math.cos(angle), math.sin(angle))
                    local box = Box { width = 0.5, height = 0.5, color = brown }
                    if row % 2 == 0 then box.border = brown end
                    world:add(Body { type = "static", position = at, angle = angle, box })
                end
            end
        end
        function draw(pen)
            for row = 0, 7 do
                local angle = ({0, 0.1, 0.6})[row % 3 + 1]
                for i = 0, 9 do
                    local at = vec(-5 + row * 0.0137, 8 - 2 * row + 0.0071 * row)
                        + 0.5 * i * vec(math.cos(angle), math.sin(angle))
                    pen.box(at, 0.5, 0.5, brown, row % 2 == 0 and "black" or false, 1.5, angle)
                end
            end
        end
    )");
    for (int row = 0; row < 8; ++row) {
        const double angle = std::array{0.0, 0.1, 0.6}[std::size_t(row % 3)];
        for (const double left : {-15.0, -5.0}) {
            const double x = left + row * 0.0137, y = 8 - 2 * row + 0.0071 * row;
            int lightest = 0;
            along(x, y, x + 4.5 * std::cos(angle), y + 4.5 * std::sin(angle), 8,
                  [&](int px, int py) { lightest = std::max(lightest, at(picture, px, py).g); });
            INFO("row " << row << " from " << left);
            CHECK(lightest <= 0x3d + 1);
        }
    }
}

TEST_CASE("a body of many boxes shows no seams and has one border around all") {
    if (skipped()) return;
    const Picture picture = picture_of("floors", R"(
        local function floor(y, angle, fill, sensor)
            local body = Body { type = "static", position = vec(-14, y), angle = angle }
            for i = 0, 99 do
                body:add(Box { width = 0.25, height = 1, center = vec(i * 0.25, 0), color = fill, border = color("black"),
                    sensor = sensor or false })
            end
            world:add(body)
        end
        floor(6, 0, color("red"))
        floor(3.0071, 0.0613, color("red"))
        floor(-2, 0, color(1, 0, 0, 0.5))
        floor(-6.0071, 0.0613, color(1, 0, 0, 0.25), true)
    )");
    struct Floor {
        double y, angle;
        Rgb fill;
    };
    for (const Floor& floor :
         {Floor{6, 0, red}, Floor{3.0071, 0.0613, red}, Floor{-2, 0, {255, 128, 128}},
          Floor{-6.0071, 0.0613, {255, 191, 191}}}) {
        INFO("at " << floor.y);
        const double c = std::cos(floor.angle), s = std::sin(floor.angle);
        int worst = 0;
        along(-14, floor.y, -14 + 24.7 * c, floor.y + 24.7 * s, 15, [&](int x, int y) {
            worst = std::max(worst, at(picture, x, y).distance(floor.fill));
        });
        CHECK(worst <= 2);
        // The border of its upper edge has no gap.
        double thinnest = 10;
        for (double t = 0; t < 24.5; t += 0.01) {
            const double x = -14 + t * c - 0.5 * s, y = floor.y + t * s + 0.5 * c;
            const int px = int(std::floor(640 + 40 * x)), py = int(std::floor(400 - 40 * y));
            double dark = 0;
            for (int d = -3; d <= 3; ++d) dark += 1 - at(picture, px, py + d).r / 255.0;
            thinnest = std::min(thinnest, dark);
        }
        CHECK(thinnest > 1);
    }
}

TEST_CASE("a circle is round at any zoom") {
    if (skipped()) return;
    // The radius in pixels, and the angle at which the rim crosses the middle of the screen.
    const double radius = GENERATE(300.0, 20'000.0, 4'000'000.0);
    const double angle = 0.7;
    const std::string meters = std::to_string(radius / 40);
    const Picture picture = picture_of(
        "circle", "local center = -" + meters + " * vec(math.cos(0.7), math.sin(0.7))" +
                      "\nfunction draw(pen) pen.circle(center, " + meters + ", \"black\") end");
    // Many lines across the rim: the sum of the darkness along each gives the place of the rim.
    const double cx = 640 - radius * std::cos(angle), cy = 400 + radius * std::sin(angle);
    double worst = 0;
    int places = 0;
    for (double a = 0; a < 6.28; a += 0.02) {
        // Of a much larger circle only the visible part.
        const double t = radius < 1000 ? a : angle + (a - 3.14) * 150 / radius;
        const double nx = std::cos(t), ny = -std::sin(t);
        const double x = cx + radius * nx, y = cy + radius * ny;
        if (x < 20 || y < 20 || x > 1260 || y > 780) continue;
        // Along the axis that the rim crosses more steeply, twelve pixels to each side.
        const bool across = std::abs(nx) > std::abs(ny);
        const int line = int(std::floor(across ? y : x));
        const double middle = line + 0.5;
        const double rest = radius * radius - (across ? (middle - cy) * (middle - cy)
                                                      : (middle - cx) * (middle - cx));
        const double sign = (across ? nx : ny) > 0 ? 1 : -1;
        const double rim = (across ? cx : cy) + sign * std::sqrt(rest);
        const int from = int(std::floor(rim)) - 12;
        double sum = 0;
        for (int k = 0; k < 25; ++k)
            sum += across ? ink(picture, from + k, line) : ink(picture, line, from + k);
        const double found = sign > 0 ? from + sum : from + 25 - sum;
        worst = std::max(worst, std::abs(found - rim));
        ++places;
    }
    CHECK(places > 50);
    CHECK(worst < 0.5);
}

TEST_CASE("an ellipse is smooth at any zoom") {
    if (skipped()) return;
    const double zoom = GENERATE(40.0, 4'000.0);
    const Picture picture = picture_of("ellipse", "view.zoom = " + std::to_string(zoom) + R"(
        view.center = vec(0, 4)
        world.egg = Body { type = "static", Ellipse { radius_x = 8, radius_y = 4, color = color("black") } }
    )");
    // The upper edge: y = 4 sqrt(1 - x²/64), in the middle of the screen.
    double worst = 0;
    for (int x = 200; x < 1080; ++x) {
        const double wx = (x + 0.5 - 640) / zoom;
        const double rim = 400 - (4 * std::sqrt(1 - wx * wx / 64) - 4) * zoom;
        if (rim < 20 || rim > 700 || std::abs(wx) > 5) continue;
        double sum = 0;
        const int from = int(std::floor(rim)) - 10;
        for (int k = 0; k < 20; ++k) sum += ink(picture, x, from + k);
        worst = std::max(worst, std::abs(from + 20 - sum - rim));
    }
    CHECK(worst < 0.5);
}

TEST_CASE("a concave polygon is filled and has a border on all sides") {
    if (skipped()) return;
    const Picture picture = picture_of("arrow", R"(
        local arrow = { vec(-6, 6), vec(-2, 6), vec(-4, 4), vec(-2, 2), vec(-6, 2) }
        local bow = { vec(2, 2), vec(6, 6), vec(6, 2), vec(2, 6) }
        local star = {}
        for i = 0, 4 do star[i + 1] = vec(-4, -4) + 3 * vec(math.cos(0.8 * math.pi * i), math.sin(0.8 * math.pi * i)) end
        function draw(pen)
            pen.polygon(arrow, "red", "black", 4)
            pen.polygon(bow, "red", "black", 4)
            pen.polygon(star, "red", "black", 4)
        end
    )");
    const auto seen = [&](double x, double y) {
        return at(picture, int(std::floor(640 + 40 * x)), int(std::floor(400 - 40 * y)));
    };
    CHECK(seen(-5, 4).distance(red) == 0);
    CHECK(seen(-3, 5.6).distance(red) == 0);
    CHECK(seen(-2.5, 4).distance(white) == 0);  // the notch
    // Along the inside of each edge of the arrow there is a border, four pixels wide.
    const double arrow[][2] = {{-6, 6}, {-2, 6}, {-4, 4}, {-2, 2}, {-6, 2}};
    for (int i = 0; i < 5; ++i) {
        const double *from = arrow[i], *to = arrow[(i + 1) % 5];
        const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
        int worst = 0;
        for (double t = 0.1; t < 0.9;
             t += 0.01)  // two pixels to the right of an edge of a clockwise outline
            worst = std::max(worst, seen(from[0] + t * dx + 0.05 * dy / length,
                                         from[1] + t * dy - 0.05 * dx / length)
                                        .distance(black));
        INFO("edge " << i);
        CHECK(worst < 40);
    }
    // The bow tie is filled on both sides, and the middle of the star is filled; the lines are
    // drawn.
    CHECK(seen(5, 4).distance(red) == 0);
    CHECK(seen(3, 4).distance(red) == 0);
    CHECK(seen(4, 4).distance(black) < 40);
    CHECK(seen(4, 5).distance(white) == 0);
    CHECK(seen(-4, -4).distance(red) == 0);
    CHECK(seen(-1.5, -4).distance(red) == 0);
    CHECK(seen(-2.2, -2.2).distance(white) == 0);
}

TEST_CASE("a polygon of twenty thousand vertices is drawn with its border") {
    if (skipped()) return;
    const Picture picture = picture_of("many_vertices", R"(
        local points = {}
        for i = 1, 20000 do
            local angle = 2 * math.pi * i / 20000
            local radius = 7 + math.sin(40 * angle)
            points[i] = radius * vec(math.cos(angle), math.sin(angle))
        end
        function draw(pen) pen.polygon(points, "red", "black", 2) end
    )");
    CHECK(at(picture, 640, 400).distance(red) == 0);
    int changes = 0;  // along the circle of radius 7: from red to white and back
    bool was_white = false;
    const double outermost = std::numbers::pi / 80;
    for (double a = outermost; a < outermost + 2 * std::numbers::pi; a += 0.001) {
        const Rgb seen = at(picture, int(640 + 280 * std::cos(a)), int(400 - 280 * std::sin(a)));
        const bool is_white = seen.distance(white) < 5;
        if (is_white != was_white && (is_white || seen.distance(red) < 5)) ++changes;
        if (is_white || seen.distance(red) < 5) was_white = is_white;
    }
    CHECK(changes == 80);
}

TEST_CASE("letters that the font lacks are drawn with another font") {
    // The font of Debian's package fonts-droid-fallback.
    if (skipped() || !fs::exists("/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf"))
        return;
    const Picture picture = picture_of("other letters", R"(
        function draw(pen)
            pen.text(vec(-8, 0), "球", 6, "black")
            pen.text(vec(8, 0), "一", 6, "black")
        end
    )");
    // Without the other font both would be the same box.
    int left = 0, right = 0;
    for (int y = 200; y < 600; ++y)
        for (int x = 0; x < 640; ++x) {
            left += ink(picture, x, y) > 0.5;
            right += ink(picture, x + 640, y) > 0.5;
        }
    CHECK(left > 3 * right);
    CHECK(right > 100);
}

TEST_CASE("a text breaks at its newlines and each line is aligned") {
    if (skipped()) return;
    const Picture picture = picture_of("text", R"(
        function draw(pen)
            pen.text(vec(-15, 5), "HHHH\nHH\r\n\nHHHHHH", 1, "black", "left")
            pen.text(vec(-3, 5), "HHHH\nHH\r\n\nHHHHHH", 1, "black")
            pen.text(vec(14, 5), "HHHH\nHH\r\n\nHHHHHH", 1, "black", "right")
            pen.text(vec(-15, -5), "H\tH\nHH\tH\nHHHH\tH", 1, "black", "left")
            pen.text(vec(1, -5), "HH\tH\nHHi\tH", 1, "black", "left")
        end
    )");
    struct Line {
        int left, right, top, bottom;
    };
    // The lines with ink in a part of the picture.
    const auto lines_in = [&](int left, int right, int top, int bottom) {
        std::vector<Line> lines;
        for (int y = top; y < bottom; ++y) {
            int first = right, last = left;
            for (int x = left; x < right; ++x)
                if (ink(picture, x, y) > 0.5) first = std::min(first, x), last = std::max(last, x);
            if (first > last) continue;
            if (lines.empty() || lines.back().bottom < y - 1)
                lines.push_back({first, last, y, y});
            else
                lines.back() = {std::min(lines.back().left, first),
                                std::max(lines.back().right, last), lines.back().top, y};
        }
        return lines;
    };
    const auto left = lines_in(0, 360, 50, 390), middle = lines_in(360, 700, 50, 390),
               right = lines_in(800, 1280, 50, 390);
    for (const auto* lines : {&left, &middle, &right}) {
        REQUIRE(lines->size() == 3);
        const auto& l = *lines;
        CHECK(std::abs((l[1].top - l[0].top) - 48) <= 1);
        CHECK(std::abs((l[2].top - l[1].top) - 96) <= 1);  // one line is empty
        // The middle of all four lines is at the position of the text.
        CHECK(std::abs((l[0].top + l[2].bottom) / 2 - 200) <= 2);
    }
    for (int i = 1; i < 3; ++i) {
        CHECK(std::abs(left[std::size_t(i)].left - left[0].left) <= 1);
        CHECK(std::abs(right[std::size_t(i)].right - right[0].right) <= 1);
        const Line &a = middle[0], &b = middle[std::size_t(i)];
        INFO(a.left << " to " << a.right << " and " << b.left << " to " << b.right);
        CHECK(std::abs((a.left + a.right) - (b.left + b.right)) <= 3);
    }
    // After a tab each line continues at a multiple of two heights.
    const auto tabs = lines_in(0, 640, 450, 790);
    REQUIRE(tabs.size() == 3);
    CHECK(std::abs((tabs[0].right - tabs[1].right)) <= 1);
    CHECK(std::abs((tabs[2].right - tabs[1].right) - 80) <= 1);
    // A text that ends just before a multiple continues at the next one, so that words do not
    // touch.
    const auto near = lines_in(660, 1280, 450, 790);
    REQUIRE(near.size() == 2);
    CHECK(std::abs((near[1].right - near[0].right) - 80) <= 1);
}

TEST_CASE("a script draws at the drawn pose of a body exactly on the body") {
    if (skipped()) return;
    // Steps of a quarter of a second, so that any other pose is far away.
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua") << R"(
        view.background = color("white")
        view.show.aabbs = true
        world.gravity = vec(0, 0)
        time.dt = 0.25
        world.ship = Body { position = vec(-14, 0), velocity = vec(2, 0), angular_velocity = 1,
            Box { width = 4, height = 4, color = color("red"), border = color("red") } }
        function draw(pen)
            pen.box(world.ship:drawn_position(), 2, 2, "black", false, 0, world.ship:drawn_angle())
            pen.circle(world.ship:to_drawn(vec(1.5, 1.5)), 0.2, "black")
        end
        function start() print("drawn") end
    )";
    GameWindow game(folder.path);
    REQUIRE(game.prints("drawn"));
    // A picture may be taken during an update and then contains halves of two frames, most often on
    // a busy machine. With another pose than the drawn one, nearly every picture would be wrong.
    int looked = 0, right_ones = 0;
    for (int i = 0; i < 200 && looked < 40 && right_ones < 9; ++i) {
        const Picture picture = game.picture();
        double rx = 0, ry = 0, rn = 0, bx = 0, by = 0, bn = 0;
        int left = 2000, right = -1, frame_left = 2000, frame_right = -1;
        for (int y = 250; y < 550; ++y)
            for (int x = 0; x < 1280; ++x) {
                const Rgb seen = at(picture, x, y);
                const bool is_red = seen.distance(red) < 60, is_black = seen.distance(black) < 60;
                if (is_red || is_black) rx += x, ry += y, ++rn;
                if (is_red) left = std::min(left, x), right = std::max(right, x);
                if (is_black) bx += x, by += y, ++bn;
                if (seen.r > seen.g + 20 && seen.b > seen.g + 20)
                    frame_left = std::min(frame_left, x), frame_right = std::max(frame_right, x);
            }
        if (rn < 20'000 || bn < 5'000 || frame_right < 0) continue;  // half a picture
        ++looked;
        // The circle in a corner shifts the center a little.
        const double off = std::hypot(rx / rn - bx / bn, ry / rn - by / bn);
        const int box_off = std::max(std::abs(frame_left - left), std::abs(frame_right - right));
        right_ones += off < 4 && box_off <= 3;
        UNSCOPED_INFO("off by " << off << " px, its box by " << box_off);
    }
    CHECK(right_ones >= 9);
}

TEST_CASE("a thin translucent line is not darker in its corners") {
    if (skipped()) return;
    const Picture picture = picture_of("corners", R"(
        local gray = color(0, 0, 0, 0.4)
        for row, width in ipairs { 0.005, 0.025, 0.04, 0.06, 0.09 } do
            local points = {}
            for i = 0, 20 do points[#points + 1] = vec(-12 + i, 9 - 2 * row + i % 2) end
            game:add(Line { points = points, width = width, color = gray })
        end
        local circle = {}
        for i = 0, 99 do circle[#circle + 1] = vec(4, -6) + vec(3, 0):rotated(i * math.pi / 50) end
        game:add(Line { points = circle, width = 0.03, closed = true, color = gray })
        world.chain = Body { type = "static", position = vec(-8, -8), Chain { color = gray, closed = true,
            points = { vec(0, 0), vec(4, 1), vec(5, 4), vec(1, 3) } } }
    )");
    double darkest = 0, all = 0;
    for (int y = 0; y < int(picture.height); ++y)
        for (int x = 0; x < int(picture.width); ++x) {
            darkest = std::max(darkest, ink(picture, x, y));
            all += ink(picture, x, y);
        }
    CHECK(darkest < 0.42);
    CHECK(darkest > 0.38);
    CHECK(all > 1000);
}

}  // namespace drawing_test
