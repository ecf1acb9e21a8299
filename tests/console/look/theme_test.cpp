// Contrast of the colors, by the formula of the Web Content Accessibility Guidelines.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>
#include <look/fields.h>
#include <look/theme.h>
#include <text/short_numbers.h>

#include "catch.h"
#include "comma_locale.h"
#include "rig.h"

namespace theme_test {

using namespace fettle;
using console::with_alpha;
namespace palette = console::palette;

namespace {

struct Named {
    const char* name;
    ImU32 color;
};

double channel(ImU32 color, int shift) {
    return static_cast<double>(color >> shift & 255) / 255;
}

double luminance(ImU32 color) {
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(channel(color, IM_COL32_R_SHIFT)) +
           0.7152 * linear(channel(color, IM_COL32_G_SHIFT)) +
           0.0722 * linear(channel(color, IM_COL32_B_SHIFT));
}

double contrast(ImU32 a, ImU32 b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

/// The color that is seen where `over` lies over `under`.
ImU32 seen(ImU32 over, ImU32 under) {
    const double alpha = channel(over, IM_COL32_A_SHIFT);
    ImU32 out = IM_COL32_A_MASK;
    for (const int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT}) {
        const double c = alpha * channel(over, shift) + (1 - alpha) * channel(under, shift);
        out |= static_cast<ImU32>(std::lround(c * 255)) << shift;
    }
    return out;
}

std::vector<Named> backgrounds() {
    return {{"panel", palette::panel},
            {"well", palette::well},
            {"raised", palette::raised},
            {"popup", palette::popup},
            {"hover", palette::hover},
            {"chosen", palette::chosen},
            {"selection in a well", seen(palette::selection, palette::well)},
            {"selection in a panel", seen(palette::selection, palette::panel)}};
}

}  // namespace

TEST_CASE("all text has a contrast of four and a half at least") {
    const std::vector<Named> texts = {
        {"text", palette::text},     {"dim", palette::dim},       {"faint", palette::faint},
        {"accent", palette::accent}, {"path", palette::path},     {"number", palette::number},
        {"string", palette::string}, {"error", palette::error},   {"note", palette::note},
        {"axis x", palette::axis_x}, {"axis y", palette::axis_y},
    };
    for (const Named& under : backgrounds())
        for (const Named& text : texts) {
            INFO(text.name << " on " << under.name);
            CHECK(contrast(text.color, under.color) >= 4.5);
        }
    // A number over the bar that shows its share of the range, also where it cannot be changed.
    const ImU32 share = seen(palette::share, palette::hover);
    CHECK(contrast(palette::text, share) >= 4.5);
    CHECK(contrast(palette::dim, share) >= 4.5);
    for (const ImU32 color : {palette::text, palette::dim})
        CHECK(contrast(seen(with_alpha(color, console::disabled_alpha), palette::raised),
                       seen(with_alpha(palette::raised, console::disabled_alpha),
                            palette::panel)) >= 4.5);
}

TEST_CASE("the colors of classes have a contrast of four and a half at least") {
    for (int i = 0; i < 2000; ++i) {
        const ImU32 color = console::class_color("Class" + std::to_string(i));
        INFO(i);
        CHECK(contrast(color, seen(with_alpha(color, 0.18f), palette::panel)) >= 4.5);
        CHECK(contrast(color, palette::hover) >= 4.5);
    }
}

TEST_CASE("borders have a contrast of two at least") {
    for (const ImU32 under : {palette::panel, palette::well, palette::popup})
        CHECK(contrast(palette::line, under) >= 2);
}

TEST_CASE("nothing of the game is seen behind text") {
    console::test::Rig rig;
    CHECK(rig.value("console.opacity") == property::Value(1.0));
    for (const Named& each : backgrounds()) CHECK(channel(each.color, IM_COL32_A_SHIFT) == 1.0);
}

TEST_CASE("shown numbers have a point in every locale of the program") {
    const CommaLocale comma;
    if (!comma.there()) return;
    CHECK(console::short_number(1.5) == "1.5");
    CHECK(console::short_number(1.5e-6) == "1.5e-6");
    CHECK(console::narrow_number(-0.000123456) == "-1.235e-4");
}

TEST_CASE("numbers are shown with four significant digits") {
    using console::short_number;
    CHECK(short_number(3.14159265) == "3.142");
    CHECK(short_number(0.0123456) == "0.01235");
    CHECK(short_number(0.000123456) == "0.0001235");
    CHECK(short_number(-2.9e-11) == "0");
    CHECK(short_number(9.9e-7) == "0");
    CHECK(short_number(1.5e-6) == "1.5e-6");
    CHECK(short_number(0.05) == "0.05");
    CHECK(console::narrow_number(-0.00031234, 1) == "-3e-4");
    CHECK(console::narrow_number(-0.0512, 1) == "-0.05");
    CHECK(console::narrow_number(-0.000123456) == "-1.235e-4");
    CHECK(console::narrow_number(-12345678.9) == "-1.235e7");
    CHECK(short_number(0.7853982) == "0.7854");
    CHECK(short_number(12.5) == "12.5");
    CHECK(short_number(-123.456) == "-123.5");
    CHECK(short_number(1234567.8) == "1234568");
    CHECK(short_number(1.5e9) == "1.5e9");
    CHECK(short_number(2) == "2");
    CHECK(short_number(0) == "0");
    CHECK(short_number(std::numeric_limits<double>::infinity()) == "inf");
    CHECK(short_number(9.99999) == "10");
}

}  // namespace theme_test
