// The checks that all tests use: tests/include/checks.h.

#include <string>
#include <vector>

#include "catch.h"

namespace checks_test {

namespace {

std::string text(const checks::Outcome& outcome) {
    std::string all = outcome.show_left(outcome.left);
    if (outcome.right != nullptr)
        all += std::string(" ") + outcome.comparison + " " + outcome.show_right(outcome.right);
    return all;
}

}  // namespace

TEST_CASE("a check knows both sides of a comparison and whether it holds") {
    const std::string word = "one";
    const std::vector<int> numbers = {1, 2};
    const checks::Outcome wrong = checks::Expression() <= word == "two";
    CHECK_FALSE(wrong.holds);
    CHECK(text(wrong) == "\"one\" == \"two\"");
    const checks::Outcome right = checks::Expression() <= numbers.size() + 1 >= 3u;
    CHECK(right.holds);
    CHECK(right.comparison == std::string(">="));
    const checks::Outcome alone = checks::Expression() <= numbers.empty();
    CHECK_FALSE(alone.holds);
    CHECK(alone.right == nullptr);
}

TEST_CASE("a check of a match shows the value and what it should be") {
    const std::string word = "one";
    const auto matcher = contains("tw");
    const checks::Outcome outcome = checks::matched(word, matcher);
    CHECK_FALSE(outcome.holds);
    CHECK(outcome.show_left(outcome.left) == "\"one\"");
    CHECK(outcome.show_right(outcome.right).find("contains: \"tw\"") == 0);
}

}  // namespace checks_test
