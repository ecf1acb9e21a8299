// Small quads that are drawn on the processor look as OpenGL draws them.

#include <catch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <draw/quad_raster.h>

namespace quad_raster_test {

using namespace fettle::app;

namespace {

using Pixel = std::array<double, 4>;

constexpr int side = 12;  // texels

std::vector<std::uint8_t> random_texels(std::mt19937& random) {
    std::vector<std::uint8_t> all(side * side * 4);
    for (std::uint8_t& each : all) each = static_cast<std::uint8_t>(random());
    return all;
}

Pixel texel(const TexelRows& of, double x, double y) {
    const auto column = static_cast<std::size_t>(std::clamp(std::floor(x), 0.0, side - 1.0));
    const auto row = static_cast<std::size_t>(std::clamp(std::floor(y), 0.0, side - 1.0));
    Pixel out{};
    for (std::size_t c = 0; c < 4; ++c) out[c] = of.rgba[4 * (row * side + column) + c];
    return out;
}

Pixel sample(const TexelRows& of, double u, double v) {
    if (!of.smooth) return texel(of, u, v);
    const double x = u - 0.5, y = v - 0.5;
    const double right = x - std::floor(x), down = y - std::floor(y);
    Pixel out{};
    for (std::size_t c = 0; c < 4; ++c)
        out[c] = (1 - down) * ((1 - right) * texel(of, x, y)[c] + right * texel(of, x + 1, y)[c]) +
                 down * ((1 - right) * texel(of, x, y + 1)[c] + right * texel(of, x + 1, y + 1)[c]);
    return out;
}

/// The equations of OpenGL, for each pixel whose middle lies in the quad.
std::vector<Pixel> expected(const std::vector<CanvasVertex>& corners, const TexelRows& texels,
                            const PixelBox& box, bool adds) {
    std::vector<Pixel> out(static_cast<std::size_t>(box.width() * box.height()));
    for (std::size_t i = 0; i < corners.size(); i += 4) {
        const CanvasVertex &a = corners[i], &b = corners[i + 1], &d = corners[i + 3];
        const double ax = b.x - a.x, ay = b.y - a.y, dx = d.x - a.x, dy = d.y - a.y;
        const double area = ax * dy - ay * dx;
        for (int y = box.top; y < box.bottom; ++y)
            for (int x = box.left; x < box.right; ++x) {
                const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
                const double s = (px * dy - py * dx) / area, t = (py * ax - px * ay) / area;
                if (s < 0 || s >= 1 || t < 0 || t >= 1) continue;
                Pixel color = sample(texels, a.u + s * (b.u - a.u), a.v + t * (d.v - a.v));
                const std::array<double, 4> tint{double(a.r), double(a.g), double(a.b),
                                                 double(a.a)};
                for (std::size_t c = 0; c < 4; ++c) color[c] *= tint[c] / 255;
                Pixel& below =
                    out[static_cast<std::size_t>((y - box.top) * box.width() + x - box.left)];
                for (std::size_t c = 0; c < 4; ++c) {
                    const double part = c == 3 ? color[3] : color[c] * color[3] / 255;
                    below[c] = adds ? std::min(255.0, below[c] + part)
                                    : part + below[c] * (1 - color[3] / 255);
                }
            }
    }
    return out;
}

/// A parallelogram around a place, with a part of the texture.
void add_quad(std::vector<CanvasVertex>& to, float x, float y, float width, float height,
              float angle, float u, float v, std::array<std::uint8_t, 4> tint) {
    const float c = std::cos(angle), s = std::sin(angle);
    const auto corner = [&](float i, float j) {
        const float p = i * width / 2, q = j * height / 2;
        to.emplace_back(angle == 0 ? x + p : x + c * p - s * q,
                        angle == 0 ? y + q : y + s * p + c * q, tint[0], tint[1], tint[2], tint[3],
                        i < 0 ? u : u + 5, j < 0 ? v : v + 7);
    };
    corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1);
}

/// The greatest difference between a channel of the picture and the equations.
double worst(const std::vector<CanvasVertex>& corners, const TexelRows& texels, bool adds) {
    QuadRaster raster;
    raster.measure(corners, {0, 0, 40, 30});
    raster.draw(corners, texels, adds);
    const PixelBox& box = raster.box();
    const std::vector<Pixel> wanted = expected(corners, texels, box, adds);
    double most = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c)
            most = std::max(most, std::abs(raster.rgba()[4 * i + c] - wanted[i][c]));
    return most;
}

}  // namespace

TEST_CASE("small quads on the processor have the colors that OpenGL gives them") {
    std::mt19937 random(7);
    const auto number = [&](float least, float most) {
        return std::uniform_real_distribution<float>(least, most)(random);
    };
    for (int round = 0; round < 200; ++round) {
        const std::vector<std::uint8_t> rgba = random_texels(random);
        const bool smooth = round % 2 == 0, adds = round % 4 < 2, turned = round % 8 < 4;
        std::vector<CanvasVertex> corners;
        const int count = 1 + round % 3;
        for (int i = 0; i < count; ++i)
            add_quad(corners, number(-3, 43), number(-3, 33), number(0.3f, 9) * (i == 1 ? -1 : 1),
                     number(0.3f, 9) * (i == 2 ? -1 : 1), turned ? number(-3, 3) : 0, number(0, 6),
                     number(0, 4),
                     {static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                      static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random())});
        INFO("round " << round);
        // A texel is divided into 128 parts.
        CHECK(worst(corners, {rgba.data(), side, side, smooth}, adds) < 3 + count);
    }
}

TEST_CASE("a picture of small quads is as large as what they reach") {
    std::vector<CanvasVertex> corners;
    QuadRaster raster;
    add_quad(corners, 10, 8, 4, 2, 0, 0, 0, {255, 255, 255, 255});
    add_quad(corners, -50, 20, 4, 4, 0, 0, 0, {255, 255, 255, 255});
    raster.measure(corners, {0, 0, 40, 30});
    CHECK(raster.box().left == 0);
    CHECK(raster.box().right == 12);
    CHECK(raster.box().top == 7);
    CHECK(raster.box().bottom == 22);
    raster.measure(corners, {20, 0, 40, 30});
    CHECK(raster.box().width() == 0);
    // A few quads far apart are left to OpenGL, many are not.
    corners.clear();
    add_quad(corners, 1, 1, 4, 4, 0, 0, 0, {255, 255, 255, 255});
    add_quad(corners, 1279, 799, 4, 4, 0, 0, 0, {255, 255, 255, 255});
    raster.measure(corners, {0, 0, 1280, 800});
    CHECK_FALSE(raster.is_faster());
    for (int i = 0; i < 30'000; ++i)
        add_quad(corners, 600, 400, 4, 4, 0, 0, 0, {255, 255, 255, 255});
    raster.measure(corners, {0, 0, 1280, 800});
    CHECK(raster.is_faster());
}

}  // namespace quad_raster_test
