#pragma once
// A tree with the classes of the visuals, a folder with images, and a painter that records what it
// is asked to draw.

#include <catch.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/error.h>
#include <fettle/property/painter.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/storage/assets.h>
#include <fettle/property/storage/game_files.h>
#include <fettle/property/tree.h>
#include <fettle/visuals/visuals.h>

#include "temporary_folder.h"

namespace fettle::visuals::test {

using namespace fettle::property;

/// A figure or a picture in the coordinates of the world or the screen.
struct Drawn {
    std::string kind;
    Vec2 lower_left, lower_right, upper_left;  // as seen; of a line: its ends
    PictureArea area{};
    Color color{};
    float opacity = 1;
    Blend blend = Blend::normal;
    bool smooth = true, on_screen = false;
    const Picture* picture = nullptr;
};

class Sheet : public Painter {
  public:
    void circle(const Vec2&, double, const Paint&) override {}
    void ellipse(const Vec2&, const Vec2&, double, const Paint&) override {}
    void polygon(std::span<const Vec2> v, double rounding, const Paint& paint) override {
        Drawn d = made("polygon", paint.fill);
        d.lower_left = transform()(v.front());
        d.lower_right = transform()(v.back());
        d.area.width = rounding;
        all.push_back(d);
    }
    void line(const Vec2& a, const Vec2& b, Color color, float width) override {
        Drawn d = made("line", color);
        d.lower_left = transform()(a);
        d.lower_right = transform()(b);
        d.area.width = static_cast<double>(width);
        all.push_back(d);
    }
    void point(const Vec2&, Color, float) override {}
    void text(const Vec2&, std::string_view, double, Color, TextAlign) override {}
    void part_of(std::uint64_t) override {}
    bool shows(Overlay) const override { return false; }
    bool sees(const Vec2&, const Vec2&) const override { return true; }
    void begin_screen() override { push_screen(); }
    void end_screen() override { pop(); }
    Seen seen() const override { return view; }
    double pixels_per_unit() const override {
        return (on_screen() ? 1 : zoom) * transform().scale();
    }
    void picture(const Picture& picture, const PictureArea& area, const Vec2& lower,
                 const Vec2& upper, Color tint, bool smooth) override {
        Drawn d = made("picture", tint);
        const double bottom = on_screen() ? upper.y : lower.y;
        const double top = on_screen() ? lower.y : upper.y;
        d.lower_left = transform()({lower.x, bottom});
        d.lower_right = transform()({upper.x, bottom});
        d.upper_left = transform()({lower.x, top});
        d.area = area;
        d.smooth = smooth;
        d.picture = &picture;
        all.push_back(d);
    }

    std::vector<Drawn> all;
    Seen view{{0, 0}, {-10, -5}, {10, 5}, {800, 400}};
    double zoom = 40;

  private:
    Drawn made(const char* kind, Color color) const {
        Drawn d;
        d.kind = kind;
        d.color = color;
        d.opacity = state().opacity;
        d.blend = state().blend;
        d.on_screen = on_screen();
        return d;
    }
};

/// An uncompressed TGA file, each pixel of another color.
inline std::string tga(unsigned width, unsigned height) {
    std::string file(18, '\0');
    file[2] = 2;
    file[12] = static_cast<char>(width & 255), file[13] = static_cast<char>(width >> 8);
    file[14] = static_cast<char>(height & 255), file[15] = static_cast<char>(height >> 8);
    file[16] = 32;
    file[17] = 0x28;  // rows from the top, eight bits of opacity
    for (unsigned y = 0; y < height; ++y)
        for (unsigned x = 0; x < width; ++x)
            file += {static_cast<char>(10), static_cast<char>(y), static_cast<char>(x),
                     static_cast<char>(255)};
    return file;
}

struct Gallery {
    TemporaryFolder folder;
    GameFiles files;
    Assets assets{files, folder.path};
    Visuals visuals{&assets};
    Tree tree;
    std::vector<std::string> problems;

    Gallery() {
        write("hero.tga", tga(8, 4));
        visuals.on_problem([this](const std::string& line) { problems.push_back(line); });
        visuals.attach(tree);
    }
    void write(const std::string& name, const std::string& content) {
        std::ofstream(folder.path / name, std::ios::binary) << content;
    }
    Handle make(std::string_view of, std::vector<std::pair<std::string, Value>> values = {},
                Handle parent = {}) {
        const Handle made = tree.create(tree.class_named(of), parent ? parent : tree.root());
        for (const auto& [name, value] : values) tree.set(made, name, value);
        return made;
    }
    std::vector<Drawn> draw(Sheet sheet = {}, double alpha = 1) {
        tree.draw(tree.root(), sheet, alpha);
        CHECK(sheet.pushed() == 0);
        return sheet.all;
    }
    void step(int count, double dt = 1.0 / 60) {
        for (int i = 0; i < count; ++i) {
            visuals.step(dt);
            visuals.report(tree);
            tree.barrier();
        }
    }
    std::int64_t frame(Handle of) { return tree.get(of, "frame").integer(); }
};

inline bool near(const Vec2& a, const Vec2& b, double tolerance = 1e-9) {
    return (a - b).length() < tolerance;
}

}  // namespace fettle::visuals::test
