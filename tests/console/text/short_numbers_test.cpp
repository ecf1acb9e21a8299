// Numbers with four significant digits in the log, and the whole numbers that they stand for.

#include <string>
#include <string_view>
#include <vector>

#include <text/log.h>
#include <text/short_numbers.h>
#include "catch.h"
#include "rig.h"

namespace short_numbers_test {

using namespace fettle;
using console::Log;
using console::with_short_numbers;
using console::test::Rig;
using property::Value;

TEST_CASE("printed values have four significant digits") {
    const auto shown = [](std::string_view line) { return with_short_numbers(line).text; };
    CHECK(shown("18.095575 kg") == "18.1 kg");
    CHECK(shown("vec(-1.23456789, 0.000012345678) m") == "vec(-1.235, 1.235e-5) m");
    CHECK(shown("-1.5e-9") == "0");
    CHECK(shown("vec(-2.98e-08, 4)") == "vec(0, 4)");
    CHECK(shown("a - 1.23456") == "a - 1.235");
    CHECK(shown("3-1.23456") == "3-1.235");
    CHECK(shown("{1.23456, x = 2.34567}") == "{1.235, x = 2.346}");
    // Numbers with few digits, whole numbers and other texts are not changed.
    for (const std::string_view same :
         {"0.25", "1e-05", "123456789", "1.2345.6", "0x1.23456p3", "1.23456…", "step 123456",
          "07:42:48", "world.brick_1.23456", "\"1.23456\"", "~/a-1.23456/b", ""})
        CHECK(shown(same) == same);
}

TEST_CASE("observed numbers have a constant width") {
    using console::aligned_number;
    for (const double number :
         {0.0, 1.5, -1.5, 12.3456, -0.123456, -0.00123456, 98.7, 1e-5, -1.2e-5})
        CHECK(aligned_number(number, 98.7).size() == 7);
    CHECK(aligned_number(-12.3456, 98.7) == " -12.35");
    CHECK(aligned_number(-0.00123456, 98.7) == "-0.0012");
    // Numbers that are all small keep four digits.
    CHECK(aligned_number(-0.00123456, 0.005) == "-0.001235");
    CHECK(aligned_number(0.5, 1234567) == "     0.5");
    CHECK(aligned_number(1.25, 2, 2) == "  1.2");
    // Both numbers of a vector have the same notation.
    CHECK(aligned_number(-0.03698, 0.03698, 2) == "-0.037");
    CHECK(aligned_number(-0.00242, 0.03698, 2) == "-0.002");
}

TEST_CASE("numbers in the text of a formula are not shortened") {
    CHECK(with_short_numbers("a.b: is 1.23456 * c = 2.46912 m").text ==
          "a.b: is 1.23456 * c = 2.469 m");
    CHECK(with_short_numbers("a.b = 2.46912 m   is 1.23456 * c").text ==
          "a.b = 2.469 m   is 1.23456 * c");
}

TEST_CASE("an old and a new value that differ are printed differently") {
    const auto shown = [](std::string_view line) { return with_short_numbers(line).text; };
    CHECK(shown("a.b: 1.2345678 → 2.3456789 kg") == "a.b: 1.235 → 2.346 kg");
    CHECK(shown("a.b: 1.2345678 → 1.2345789 kg") == "a.b: 1.23457 → 1.23458 kg");
    CHECK(shown("a.b: vec(1.2345678, 7.1234567) → vec(1.2345678, 7.1234599)") ==
          "a.b: vec(1.235, 7.123457) → vec(1.235, 7.12346)");
}

TEST_CASE("a copied part of a text contains the whole numbers in place of the short ones") {
    const auto made = with_short_numbers("vec(-1.23456789, 2) m");
    REQUIRE(made.text == "vec(-1.235, 2) m");
    const auto whole = [&](std::size_t begin, std::size_t end) {
        return console::whole_text(made.text, made.numbers, begin, end);
    };
    CHECK(whole(0, made.text.size()) == "vec(-1.23456789, 2) m");
    CHECK(whole(0, 4) == "vec(");
    CHECK(whole(0, 6) == "vec(-1.23456789");
    CHECK(whole(7, 12) == "-1.23456789, ");
    CHECK(whole(12, 13) == "2");
}

TEST_CASE("printed numbers have every digit in the log") {
    Log log;
    script::Evaluation evaluation;
    evaluation.lines = {"1.23456789", "1.23456789", "2.3456789 kg"};
    evaluation.printed = {0};
    log.output(evaluation);
    REQUIRE(log.lines().size() == 3);
    CHECK(log.lines()[0].text == "1.23456789");
    CHECK(log.lines()[1].text == "1.235");
    CHECK(log.lines()[1].whole() == "1.23456789");
    CHECK(log.lines()[2].text == "2.346 kg");
    log.game("1.23456789");
    CHECK(log.lines().back().text == "1.23456789");
}

TEST_CASE("lines that differ in digits that are not shown are not counted as one") {
    Log log;
    log.output("1.23456");
    log.output("1.23457");
    log.output("1.23457");
    REQUIRE(log.lines().size() == 2);
    CHECK(log.lines()[0].text == log.lines()[1].text);
    CHECK(log.lines()[1].count == 2);
}

TEST_CASE("a table with short numbers has narrow columns below each other") {
    script::Evaluation evaluation;
    evaluation.lines = {"path  at                         unit m²   end",
                        "a     vec(1.23456789, 2.345678)  7         x",
                        "b     vec(1, 2)                  5.123456  y"};
    // The sign of a square has two bytes.
    evaluation.tables = {{0, true, {{0, 6, 33, 44}, {0, 6, 33, 43}, {0, 6, 33, 43}}}};
    Log log;
    log.output(evaluation);
    REQUIRE(log.lines().size() == 3);
    CHECK(log.lines()[0].text == "path  at                 unit m²  end");
    CHECK(log.lines()[1].text == "a     vec(1.235, 2.346)  7        x");
    CHECK(log.lines()[2].text == "b     vec(1, 2)          5.123    y");
    CHECK(log.lines()[1].whole().find("vec(1.23456789, 2.345678)") != std::string::npos);
    REQUIRE(log.lines()[1].table);
    CHECK(log.lines()[1].table->begins == std::vector<std::size_t>{0, 6, 25, 34});
    CHECK(log.lines()[0].cells.back() == 35);
}

TEST_CASE("a copy of the log has whole numbers") {
    Rig rig;
    rig.key("grave");
    rig.state().log.output("18.095575 kg");
    rig.draw(3);
    const auto& view = rig.state().views.log_view;
    CHECK(view.shown_rows().back() == "18.1 kg");
    const float y = view.text_end().y - view.line_height() / 2;
    // The signs at the left of the log take two cells.
    rig.drag(view.text_end().x + 2 * view.cell() + 1, y, view.text_end().x + 9.5f * view.cell(), y);
    rig.draw(2);
    CHECK(view.selected() == "18.095575 kg");
}

TEST_CASE("the log is also filtered by whole numbers") {
    Rig rig;
    rig.key("grave");
    rig.state().log.output("18.095575 kg");
    rig.draw(3);
    const auto shown = [&](const std::string& filter) {
        property::set(rig.tree, "console.filter", Value(filter));
        rig.draw(2);
        return rig.state().views.log_view.shown_rows();
    };
    CHECK(shown("18.0955") == std::vector<std::string>{"18.1 kg"});
    CHECK(shown("18.2").empty());
}

}  // namespace short_numbers_test
