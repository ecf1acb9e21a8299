#include <fettle/script/fuzzy.h>

#include <algorithm>
#include <string>
#include <vector>

#include "catch.h"

namespace fuzzy_test {

using fettle::script::fuzzy_match;
using Positions = std::vector<std::size_t>;

namespace {

int score(std::string_view typed, std::string_view name) {
    return fuzzy_match(typed, name).value().score;
}

}  // namespace

TEST_CASE("fuzzy matching prefers beginnings of names and of words") {
    const std::vector<std::pair<std::string, std::string>> best_first = {
        {"mass", "mass"},  {"mass", "mass_total"}, {"mass", "Mass"},      {"mass", "mat_ss"},
        {"mass", "amass"}, {"mass", "mbatcsxs"},   {"mass", "moss_total"}};
    std::vector<int> scores;
    for (const auto& [typed, name] : best_first) scores.push_back(score(typed, name));
    CAPTURE(scores);
    CHECK(std::is_sorted(scores.rbegin(), scores.rend()));
    CHECK(score("gs", "gravity_scale") > score("gs", "angles"));
    CHECK(score("mas", "mass") > score("mas", "max_steps"));
    CHECK_FALSE(fuzzy_match("xyz", "position"));
    CHECK_FALSE(fuzzy_match("longer than it", "it"));
    CHECK(fuzzy_match("", "anything"));
    CHECK_FALSE(fuzzy_match("x", ""));
}

TEST_CASE("fuzzy matching compares each letter with each place once") {
    // There are 10¹⁰ ways to place seven letters at the beginnings of these words; none has the
    // last.
    std::string name;
    for (int i = 0; i < 128; ++i) name += "a_";
    CHECK_FALSE(fuzzy_match("aaaaaaab", name));
    CHECK(score("aaaaaaaa", name) > 600);
    CHECK(score("abab", "ab_a_ab") > 600);
}

TEST_CASE("fuzzy matching returns the matching letters") {
    const auto positions = [](std::string_view typed, std::string_view name) {
        return fuzzy_match(typed, name).value().positions;
    };
    CHECK(positions("gs", "gravity_scale") == Positions{0, 8});
    CHECK(positions("FRIC", "friction") == Positions{0, 1, 2, 3});
    CHECK_FALSE(fuzzy_match("tic", "friction"));
    CHECK(positions("cti", "friction") == Positions{3, 4, 5});
    CHECK(positions("avel", "angular_velocity") == Positions{0, 8, 9, 10});
    CHECK(positions("fcn", "friction") == Positions{0, 3, 7});
    CHECK(positions("frixt", "friction") == Positions{});
    CHECK(positions("", "friction") == Positions{});
}

TEST_CASE("the score without positions equals the score of a match") {
    const std::vector<std::string> texts = {
        "",       "a",          "m",    "gs",   "avel",
        "ct",     "frixt",      "Mass", "mass", "amass",
        "brick4", "brick_12",   "tic",  "a_a",  "angular_velocity",
        "ß",      "friction_x", "FRIC"};
    for (const std::string& typed : texts)
        for (const std::string& name : texts) {
            CAPTURE(typed, name);
            const auto match = fuzzy_match(typed, name);
            const auto alone = fettle::script::fuzzy_score(typed, name);
            REQUIRE(alone.has_value() == match.has_value());
            if (!match) continue;
            CHECK(*alone == match->score);
            CHECK(std::ranges::is_sorted(match->positions));
            for (const std::size_t at : match->positions) CHECK(at < name.size());
        }
}

}  // namespace fuzzy_test
