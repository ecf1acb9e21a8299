// Texts: their measure, and what is drawn.

#include <catch.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "gallery.h"

namespace text_test {

using namespace fettle::visuals::test;

namespace {

/// The box around all pictures.
struct Box {
    double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
    explicit Box(const std::vector<Drawn>& all) {
        for (const Drawn& d : all) {
            left = std::min(left, d.lower_left.x);
            right = std::max(right, d.lower_right.x);
            bottom = std::min(bottom, d.lower_left.y);
            top = std::max(top, d.upper_left.y);
        }
    }
};

constexpr const char* sans_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* chinese_file = "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf";

/// Empty if this system has no such file.
std::string file_of(const char* path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream content;
    if (in) content << in.rdbuf();
    return content.str();
}

struct Written : Gallery {
    Handle text = make("Text", {{"text", "Hamburg"}, {"size", 1.0}});
    double width() { return tree.get(text, "text_width").number(); }
    double height() { return tree.get(text, "text_height").number(); }
};

}  // namespace

TEST_CASE_METHOD(Gallery, "a text without an instance may have an outline below its letters") {
    Sheet sheet;
    const auto written = [&](Color outline) {
        sheet.all.clear();
        visuals.media().text(sheet, Vec2(0, 0), "Ha", {.outline = outline});
        return sheet.all;
    };
    const auto plain = written(Color{0, 0, 0, 0});
    const auto lined = written(Color{1, 0, 0, 1});
    CHECK(plain.size() == 2);
    REQUIRE(lined.size() == 4);
    CHECK(lined[0].color == Color{1, 0, 0, 1});
    CHECK(lined[2].color == Color{1, 1, 1, 1});
    CHECK(Box({lined[0]}).left < Box({lined[2]}).left);
}

TEST_CASE_METHOD(Written, "a drawn text has the measured size at any zoom") {
    const double measured = width();
    CHECK(measured > 3);
    CHECK(measured < 6);
    CHECK(height() == Approx(1.2));
    for (const double zoom : {8.0, 13.7, 40.0, 400.0}) {
        Sheet sheet;
        sheet.zoom = zoom;
        const auto drawn = draw(sheet);
        REQUIRE(drawn.size() == 7);
        const Box box(drawn);
        CHECK(box.right - box.left == Approx(measured).margin(0.25 + 2 / zoom));
        CHECK(box.left + box.right == Approx(0).margin(0.2 + 2 / zoom));
        CHECK(box.top < 0.6 + 1 / zoom);
        CHECK(box.bottom > -0.6 - 1 / zoom);
        // The picture of a letter has as many pixels as the letter covers on the screen.
        const auto pixels = static_cast<double>(drawn[0].picture->height());
        if (zoom < 200)
            CHECK((drawn[0].upper_left.y - drawn[0].lower_left.y) * zoom ==
                  Approx(pixels).epsilon(0.04));
    }
    CHECK(width() == measured);
}

TEST_CASE_METHOD(Written, "texts of many sizes share the pictures of letters") {
    tree.set(text, "text", Value("H"));
    std::set<const Picture*> letters;
    for (int i = 0; i < 500; ++i) {
        Sheet sheet;
        sheet.zoom = 8 + 0.2 * i;
        const auto drawn = draw(sheet);
        REQUIRE(drawn.size() == 1);
        letters.insert(drawn[0].picture);
        // An enlarged letter is not visibly blurred.
        const auto pixels = static_cast<double>(drawn[0].picture->height());
        CHECK((drawn[0].upper_left.y - drawn[0].lower_left.y) * sheet.zoom ==
              Approx(pixels).epsilon(0.025));
    }
    CHECK(letters.size() > 50);
    CHECK(letters.size() <= 120);
}

TEST_CASE_METHOD(Written, "the measure of a text is proportional to its size") {
    const double one = width();
    tree.set(text, "size", Value(0.25));
    CHECK(width() == Approx(one / 4));
    CHECK(height() == Approx(0.3));
    tree.set(text, "size", Value(0.0));
    CHECK(width() == 0);
    CHECK(draw().empty());
}

TEST_CASE_METHOD(Written, "lines and tabs and wrapping change the measure") {
    const double one = width();
    tree.set(text, "text", Value("Hamburg\nHa"));
    CHECK(height() == Approx(2.4));
    CHECK(width() == Approx(one));
    tree.set(text, "text", Value("Ha\tburg"));
    CHECK(width() > 2);
    tree.set(text, "text", Value("Hamburg Hamburg Hamburg"));
    tree.set(text, "wrap", Value(one + 0.1));
    CHECK(height() == Approx(3.6));
    CHECK(width() == Approx(one));
    tree.set(text, "wrap", Value(1.0));  // less than a word, which stays in one piece
    CHECK(height() == Approx(3.6));
    tree.set(text, "wrap", Value(2 * one + 1));
    CHECK(height() == Approx(2.4));
    tree.set(text, "text", Value(""));
    CHECK(width() == 0);
    CHECK(height() == 0);
}

TEST_CASE_METHOD(Written, "Chinese wraps between characters and not before a full stop") {
    tree.set(text, "text", Value("我知道火车开走了"));
    const double eight = width();
    tree.set(text, "wrap", Value(eight / 2 + 0.01));
    CHECK(height() == Approx(2.4));
    CHECK(width() == Approx(eight / 2));
    tree.set(text, "text", Value("我知道火。"));  // the last character comes along
    tree.set(text, "wrap", Value(eight / 2 + 0.01));
    CHECK(height() == Approx(2.4));
    CHECK(width() < eight / 2);
    tree.set(text, "text", Value("Ham\u200bburg"));
    tree.set(text, "wrap", Value(3.0));
    CHECK(height() == Approx(2.4));
}

TEST_CASE_METHOD(Written,
                 "a text without an instance is divided into lines as one of an instance") {
    const double one = width();
    tree.set(text, "text", Value("Hamburg Hamburg Hamburg"));
    for (const double wrap : {0.0, 1.0, one + 0.1, 2 * one + 1, 100.0}) {
        INFO(wrap);
        tree.set(text, "wrap", Value(wrap));
        const Vec2 half =
            visuals.media().text_size("Hamburg Hamburg Hamburg", {.size = 0.5, .wrap = wrap / 2});
        CHECK(half.x == Approx(width() / 2));
        CHECK(half.y == Approx(height() / 2));
    }
}

TEST_CASE_METHOD(Written, "align and anchor place the lines") {
    tree.set(text, "text", Value("Hamburg\nH"));
    tree.set(text, "anchor", Value(Vec2(0, 1)));
    const auto last = [&] { return draw().back().lower_left.x; };
    tree.set(text, "align", Value("left"));
    const double left = last();
    CHECK(left == Approx(0).margin(0.2));
    tree.set(text, "align", Value("right"));
    const double right = last();
    CHECK(right > left + 2);
    tree.set(text, "align", Value("center"));
    CHECK(last() == Approx(0.5 * (left + right)).margin(1e-6));
    const Box box(draw());
    CHECK(box.top < 0);
    CHECK(box.bottom > -2.4);
}

TEST_CASE_METHOD(Written, "an outline goes around each letter and is drawn below all letters") {
    tree.set(text, "outline", Value(Color{1, 0, 0, 1}));
    tree.set(text, "outline_width", Value(0.1));
    const auto drawn = draw();
    REQUIRE(drawn.size() == 2 * 7);
    CHECK(drawn.front().color == Color{1, 0, 0, 1});
    CHECK(drawn.back().color == Color{1, 1, 1, 1});
    const Box letter({drawn[7]}), line({drawn[0]});
    CHECK(line.left == Approx(letter.left - 0.1).margin(0.06));
    CHECK(line.right == Approx(letter.right + 0.1).margin(0.06));
    CHECK(line.top == Approx(letter.top + 0.1).margin(0.06));
    CHECK(line.bottom == Approx(letter.bottom - 0.1).margin(0.06));
}

TEST_CASE_METHOD(Written, "fonts are files of the game or those of the system") {
    std::ifstream in("/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf", std::ios::binary);
    if (!in) return;
    std::ostringstream content;
    content << in.rdbuf();
    write("own.ttf", content.str());
    tree.set(text, "text", Value("iiiiWWWW"));
    const double sans = width();
    tree.set(text, "font", Value("mono"));
    const double mono = width();
    CHECK(mono != sans);
    tree.set(text, "font", Value("own.ttf"));
    CHECK(width() == mono);
    tree.set(text, "font", Value("onw.ttf"));
    CHECK(width() == sans);
    CHECK(problems ==
          std::vector<std::string>{
              tree.path(text) + ".font: there is no file \"onw.ttf\" (did you mean \"own.ttf\"?)"});
    write("broken.ttf", "0123456789012345678901234567890");
    tree.set(text, "font", Value("broken.ttf"));
    CHECK(width() == sans);
    CHECK(problems.size() == 2);
}

TEST_CASE_METHOD(Written, "a missing font is reported once even if nothing is drawn") {
    tree.set(text, "font", Value("onw.ttf"));
    step(3);
    CHECK(problems ==
          std::vector<std::string>{tree.path(text) + ".font: there is no file \"onw.ttf\""});
    CHECK(width() >= 0);
    CHECK(problems.size() == 1);
    tree.set(text, "font", Value("sanss"));
    step(1);
    REQUIRE(problems.size() == 2);
    CHECK(problems[1] == tree.path(text) +
                             ".font: there is no file \"sanss\"; the fonts without a file are "
                             "sans, bold and mono");
}

// A file of a game may be made to break a reader of fonts.
TEST_CASE_METHOD(Written, "a damaged font gives a message and never a crash") {
    const std::string header("\0\1\0\0", 4);
    write("noise.ttf", header + std::string(4000, '\xff'));
    write("short.ttf", header);
    write("empty.ttf", "");
    for (const char* name : {"noise.ttf", "short.ttf", "empty.ttf"}) {
        problems.clear();
        CAPTURE(name);
        tree.set(text, "font", Value(name));
        tree.set(text, "text", Value("hello"));
        CHECK(width() > 0);
        REQUIRE(problems.size() == 1);
        CHECK(problems.front().find("is not a font") != std::string::npos);
    }
    // Some bytes are changed at random. A font that can still be read is measured and drawn.
    const std::string good = file_of(sans_file);
    if (good.empty()) return;
    std::uint64_t random = 1;
    for (int i = 0; i < 60; ++i) {
        std::string bad = good;
        for (int n = 0; n < 40; ++n) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            const std::size_t within = n % 2 == 0 ? 1024 : bad.size();
            bad[(random >> 33) % within] = static_cast<char>(random >> 20);
        }
        const std::string name = "bad" + std::to_string(i) + ".ttf";
        write(name, bad);
        tree.set(text, "font", Value(name));
        CHECK(std::isfinite(width()));
        draw();
    }
}

// The kerning of letter pairs is only in the table GPOS in newer fonts, and in kern in older fonts.
TEST_CASE_METHOD(Written, "the kerning of letter pairs is read from either table of a font") {
    const std::string font = file_of(sans_file);
    if (font.empty()) return;
    const auto without = [&](std::string_view table, std::string_view renamed) {
        std::string changed = font;
        const std::size_t at = changed.find(table);
        REQUIRE(at < 512);  // in the directory of tables
        return changed.replace(at, 4, renamed);
    };
    write("gpos.ttf", without("kern", "kerm"));
    write("kern.ttf", without("GPOS", "GPOT"));
    const auto of = [&](const char* file, const char* letters) {
        tree.set(text, "font", Value(file));
        tree.set(text, "text", Value(letters));
        return width();
    };
    for (const char* file : {"gpos.ttf", "kern.ttf"}) {
        CAPTURE(file);
        CHECK(of(file, "AV") < of(file, "A") + of(file, "V") - 0.03);
        CHECK(of(file, "nn") == Approx(2 * of(file, "n")));
        CHECK(of(file, "fi") == Approx(of(file, "f") + of(file, "i")).margin(0.06));
    }
}

TEST_CASE_METHOD(Written, "letters that no font of the game has are taken from the system") {
    if (file_of(chinese_file).empty()) return;
    tree.set(text, "text", Value("\xf4\x8f\xbf\xbf\xf4\x8f\xbf\xbf"));  // no font has U+10FFFF
    const double boxes = width();
    tree.set(text, "text", Value("\xe4\xbd\xa0\xe5\xa5\xbd"));  // U+4F60 U+597D
    CHECK(width() == Approx(2).margin(0.2));
    CHECK(width() != boxes);
    const auto drawn = draw();
    REQUIRE(drawn.size() == 2);
    CHECK(drawn[0].picture != drawn[1].picture);
}

TEST_CASE_METHOD(Written, "only the beginning of a very long text is drawn") {
    tree.set(text, "text", Value(std::string(100'000, 'x')));
    const double most = width();
    tree.set(text, "text", Value(std::string(5'000'000, 'x')));
    CHECK(width() == most);
    tree.set(text, "text", Value(std::string(99'999, 'x')));
    CHECK(width() < most);
}

TEST_CASE_METHOD(Written, "a text of any bytes can be drawn") {
    for (const char* bytes : {"\xff\xfe", "\xc3", "\xf4\x90\x80\x80", "\r\n\t\n", "\xe2\x82\xac"}) {
        tree.set(text, "text", Value(bytes));
        CHECK(width() >= 0);
        CHECK_NOTHROW(draw());
    }
}

}  // namespace text_test
