// Texts whose letters are joined or run from right to left, as a reader expects them.

#include <catch.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "gallery.h"

namespace shaping_test {

using namespace fettle::visuals::test;

namespace {

constexpr const char* sans_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* hindi_file =
    "/usr/share/fonts/truetype/lohit-devanagari/Lohit-Devanagari.ttf";

/// False, with a word, if this system has no such file.
bool there(const char* file) {
    if (std::ifstream(file)) return true;
    WARN("SKIP: there is no file " << file);
    return false;
}

struct Shaped : Gallery {
    Handle text = make("Text", {{"size", 1.0}, {"align", "left"}, {"anchor", Vec2(0, 1)}});

    std::vector<Drawn> drawn(std::string_view written) {
        tree.set(text, "text", Value(written));
        return draw();
    }
    double width(std::string_view written) {
        tree.set(text, "text", Value(written));
        return tree.get(text, "text_width").number();
    }
    /// The letters of a text from left to right, line by line. Only for letters that have one form.
    std::string seen(std::string_view written, const std::vector<std::string>& letters) {
        std::map<const Picture*, std::string> names;
        for (const std::string& letter : letters) names[drawn(letter).at(0).picture] = letter;
        std::vector<Drawn> all = drawn(written);
        const auto line = [](const Drawn& d) {
            return std::floor(-0.5 * (d.lower_left.y + d.upper_left.y) / 1.2);
        };
        std::ranges::stable_sort(all, [&](const Drawn& a, const Drawn& b) {
            return line(a) != line(b) ? line(a) < line(b) : a.lower_left.x < b.lower_left.x;
        });
        std::string result;
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (i > 0 && line(all[i]) != line(all[i - 1])) result += "/";
            result += names.contains(all[i].picture) ? names[all[i].picture] : "?";
        }
        return result;
    }
};

const std::vector<std::string> hebrew = {"א", "ב", "ג", "ד", "ה", "ו", "a",
                                         "b", "c", "1", "2", "3", "(", ")"};

}  // namespace

TEST_CASE_METHOD(Shaped, "Hebrew runs from right to left, with Latin and numbers in it") {
    if (!there(sans_file)) return;
    CHECK(seen("abc", hebrew) == "abc");
    CHECK(seen("אבג", hebrew) == "גבא");
    CHECK(seen("abc אבג 12", hebrew) == "abc12גבא");     // the text begins at the left
    CHECK(seen("אב abc גד 12", hebrew) == "12דגabcבא");  // and at the right
    CHECK(seen("א(ב)", hebrew) == "(ב)א");               // brackets are mirrored
    CHECK(width("אב abc") == Approx(width("abc אב")));
}

TEST_CASE_METHOD(Shaped, "lines of a text from right to left are divided in the order of reading") {
    if (!there(sans_file)) return;
    const double three = width("אבג דה");
    tree.set(text, "wrap", Value(three + 0.01));
    CHECK(seen("אבג דה וא בג", hebrew) == "הדגבא/גבאו");
    // A line that begins with Latin letters has the direction of the paragraph as well.
    CHECK(seen("אבג דה abc וא", hebrew) == "הדגבא/אוabc");
    // Spaces at the end of a line are not seen: both lines end at the same place.
    tree.set(text, "align", Value("right"));
    const auto edge = [&](double above) {
        double most = -1e9;
        for (const Drawn& d : drawn("אבג דה\nאבג דה  "))
            if (d.lower_left.y > above) most = std::max(most, d.lower_right.x);
        return most;
    };
    CHECK(edge(-1.2) == Approx(edge(-1e9)));
    CHECK(width("אבג דה  ") == Approx(three));
}

TEST_CASE_METHOD(Shaped, "Arabic letters are joined") {
    if (!there(sans_file)) return;
    CHECK(drawn("سلام").size() == 3);  // lam and alef are one form
    // Between letters that are not joined is a mark that is not seen.
    const auto apart = drawn("ب\u200cب\u200cب"), joined = drawn("ببب");
    REQUIRE(joined.size() == 3);
    REQUIRE(apart.size() == 3);
    CHECK(apart[0].picture == apart[2].picture);
    CHECK(joined[0].picture != joined[2].picture);
    CHECK(width("ببب") < width("ب\u200cب\u200cب"));
    // Vowel signs are above their letters and take no width.
    CHECK(width("بَ") == Approx(width("ب")));
    CHECK(drawn("بَ").size() == 2);
}

TEST_CASE_METHOD(Shaped, "vowel signs of Hindi stand where they are read") {
    if (!there(hindi_file)) return;
    std::ostringstream content;
    content << std::ifstream(hindi_file, std::ios::binary).rdbuf();
    write("hindi.ttf", content.str());
    tree.set(text, "font", Value("hindi.ttf"));
    const Picture* const ka = drawn("क").at(0).picture;
    const auto ki = drawn("कि");  // the sign is written after the letter, and stands before it
    REQUIRE(ki.size() == 2);
    CHECK(ki[1].picture == ka);
    CHECK(ki[0].lower_left.x < ki[1].lower_left.x);
    CHECK(drawn("क्ष").size() == 1);  // three code points, one form
}

TEST_CASE_METHOD(Shaped, "a space after an emoji is as wide as after a letter") {
    if (!there(sans_file) || !there("/usr/share/fonts/truetype/noto/NotoColorEmoji.ttf")) return;
    const double space = width("a a") - width("aa");
    CHECK(width("🙂 a") - width("🙂a") == Approx(space).margin(0.01));
    CHECK(width("🙂 א") - width("🙂א") == Approx(space).margin(0.01));
}

TEST_CASE_METHOD(Shaped, "accents that are code points of their own lie on their letters") {
    if (!there(sans_file)) return;
    CHECK(width("e\u0301") == Approx(width("e")));
    CHECK(width("fi") == Approx(width("f") + width("i")).margin(0.06));  // no ligature
}

TEST_CASE_METHOD(Shaped, "a caret goes through a text in the order of reading") {
    if (!there(sans_file)) return;
    const auto carets = [&](std::string_view written) {
        return visuals.media().carets(written, {.size = 2.0});
    };
    const auto rising = carets("abc ");
    REQUIRE(rising.size() == 5);
    CHECK(rising[0] == 0);
    CHECK(rising[3] == Approx(2 * width("abc")));
    CHECK(rising[4] > rising[3]);  // also behind a space
    const auto falling = carets("אבג");
    REQUIRE(falling.size() == 4);
    CHECK(falling[0] == Approx(2 * width("אבג")));
    CHECK(falling[1] == Approx(2 * width("בג")));
    CHECK(falling[3] == Approx(0).margin(1e-9));
    // A number in a text from right to left runs from left to right.
    const auto mixed = carets("אב12");
    CHECK(mixed[2] < mixed[3]);
    CHECK(mixed[3] < mixed[1]);
    CHECK(carets("") == std::vector<double>{0});
}

TEST_CASE_METHOD(Shaped, "any mixture of directions and marks can be written") {
    std::uint64_t random = 7;
    const std::vector<std::string> parts = {
        "a",      " ",      "א",      "ب",  "ل",    "ا",      "َ",       "1",
        "(",      ")",      "\t",     "\n", "\r",   "\u200f", "\u202e", "\u202c",
        "\u2067", "\u2069", "\u200d", "कि", "\xff", "你",     "\u200b", "😀"};
    for (int i = 0; i < 300; ++i) {
        std::string mixed;
        for (int n = 0; n < 40; ++n) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            mixed += parts[(random >> 33) % parts.size()];
        }
        CAPTURE(mixed);
        tree.set(text, "wrap", Value(i % 2 == 0 ? 0.0 : 3.0));
        CHECK(std::isfinite(width(mixed)));
        for (const Drawn& d : draw()) CHECK(d.lower_left.is_finite());
        const auto carets = visuals.media().carets(mixed, {});
        CHECK(std::ranges::all_of(carets, [](double x) { return std::isfinite(x); }));
    }
}

}  // namespace shaping_test
