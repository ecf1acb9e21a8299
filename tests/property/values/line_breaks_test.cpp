// Where a line of text may be divided.

#include <fettle/property/line_breaks.h>

#include <string>
#include <string_view>

#include <fettle/property/utf8.h>

#include "catch.h"

namespace line_breaks_test {

using namespace fettle::property;

namespace {

/// The text with a bar in each place where a line may be divided.
std::string divided(std::string_view text) {
    std::string all;
    char32_t before = 0;
    for (const char32_t c : decode_utf8(text)) {
        if (before != 0 && may_divide(before, c)) all += '|';
        append_code_point(all, c);
        before = c;
    }
    return all;
}

}  // namespace

TEST_CASE("a line may be divided beside ideographs and kana and Hangul") {
    CHECK(divided("我知道") == "我|知|道");
    CHECK(divided("ひらカナ") == "ひ|ら|カ|ナ");
    CHECK(divided("한국어") == "한|국|어");
    CHECK(divided("第12章abc節") == "第|12|章|abc|節");
    CHECK(divided("plain words, naïve") == "plain words, naïve");
    CHECK(divided("слово λόγος") == "слово λόγος");
}

TEST_CASE("punctuation stays at the character to which it belongs") {
    CHECK(divided("你好，我是「安」。再见！") == "你|好，|我|是|「安」。|再|见！");
    CHECK(divided("(是)") == "(是)");
    CHECK(divided("きゃっか") == "きゃっ|か");
    CHECK(divided("データ々") == "デー|タ々");
    CHECK(divided("価格￥100。") == "価|格|￥100。");
    CHECK(divided("か\u3099き") == "か\u3099き");
    CHECK(divided("我\u00a0你") == "我\u00a0你");
    CHECK(divided("ab\u200bcd") == "ab\u200b|cd");
}

}  // namespace line_breaks_test
