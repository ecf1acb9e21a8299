// Code points of texts in UTF-8.

#include <fettle/property/utf8.h>

#include "catch.h"

namespace utf8_test {

using namespace fettle::property;

TEST_CASE("each code point that is appended is decoded again") {
    std::string text;
    const std::u32string code_points =
        U"a\u00e9\u20ac\U0001f600\x7f\u0080\u07ff\u0800\uffff\U00010000\U0010ffff";
    for (const char32_t c : code_points) append_code_point(text, c);
    CHECK(decode_utf8(text) == code_points);
    CHECK(code_point_count(text) == code_points.size());
    std::size_t at = 0;
    for (std::size_t i = 0; i < code_points.size(); ++i) {
        CHECK(code_point_offset(text, i) == at);
        CHECK(code_point_at(text, at) == code_points[i]);
        CHECK(code_point_boundary(text, next_code_point(text, at) - 1) == at);
        CHECK(previous_code_point(text, next_code_point(text, at)) == at);
        at = next_code_point(text, at);
    }
    CHECK(at == text.size());
    CHECK(code_point_offset(text, 100) == text.size());
    CHECK(next_code_point(text, 1000) == text.size());
}

TEST_CASE("invalid UTF-8 is decoded as U+FFFD and no position is beyond the text") {
    for (const char* bad : {"\x80", "\xc0\x80", "\xe0\x80\x80", "\xed\xa0\x80", "\xf4\x90\x80\x80",
                            "\xf8\x88\x80\x80\x80", "\xff", "\xe2\x82", "\xf0\x9f\x98"}) {
        const std::string text = bad;
        CAPTURE(text);
        CHECK(valid_code_point_size(text) == 0);
        CHECK(decode_utf8(text) == std::u32string(text.size(), U'\uFFFD'));
        CHECK(decode_utf8("a" + text + "b").back() == U'b');
        for (std::size_t i = 0; i <= text.size() + 1; ++i) {
            CHECK(next_code_point(text, i) <= text.size());
            CHECK(code_point_boundary(text, i) <= text.size());
            CHECK(previous_code_point(text, i) <= text.size());
        }
    }
    std::string text;
    append_code_point(text, 0xd800);
    append_code_point(text, 0x110000);
    CHECK(decode_utf8(text) == U"\uFFFD\uFFFD");
}

}  // namespace utf8_test
