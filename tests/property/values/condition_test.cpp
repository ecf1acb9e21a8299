// Conditions that instances are searched by.

#include <fettle/property/condition.h>

#include <random>

#include "catch.h"
#include "fixture.h"

namespace condition_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

struct Field {
    Field() : balls(tree) {
        world = tree.create(tree.object_class(), tree.root(), "world");
        ball = tree.create(*balls.type, world, "ball");
        tree.set(ball, "mass", Value(7.0));
        tree.set(ball, "velocity", Value(Vec2(3, -4)));
        tree.set_or_add(ball, "shade", Value(Color{0.25f, 0.5f, 0.75f, 1}));
        tree.set_or_add(ball, "points", Value(List{Value(2), Value(Vec2(5, 6))}));
        tree.set_or_add(ball, "awake", Value(true));
        tree.set_or_add(ball, "label", Value("red"));
        tree.set_or_add(ball, "friend_of", Value(world));
        tree.set_or_add(world, "score", Value(12));
    }
    bool holds(std::string_view text) {
        Condition condition(text);
        return condition.holds(tree, ball);
    }
    std::string unknown(std::string_view text) {
        Condition condition(text);
        tree.each_below(tree.root(), [&](Handle each) { condition.holds(tree, each); });
        return condition.problem(tree);
    }
    static std::string refusal(std::string_view text) {
        try {
            Condition condition(text);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    }
    Tree tree;
    BallModule balls;
    Handle world, ball;
};

}  // namespace

TEST_CASE("conditions compare properties and their parts") {
    Field field;
    for (const char* const text : {"mass > 5",
                                   "mass >= 7",
                                   "5 < mass",
                                   "mass == 7",
                                   "mass ~= 8",
                                   "mass > 5 and awake",
                                   "not (mass < 5)",
                                   "mass < 5 or mass > 6",
                                   "velocity.x == 3",
                                   "velocity.y < -3.5",
                                   "velocity.length == 5",
                                   "shade.g == .5",
                                   "points[1] == 2",
                                   "points[2].y == 6",
                                   "points[9] == nil",
                                   "label == 'red'",
                                   "label ~= \"blue\"",
                                   "label < 'rose'",
                                   "friend_of.score == 12",
                                   "Ball and mass > 5",
                                   "Ball",
                                   "name == \"ball\"",
                                   "mass * 2 + 1 == 15",
                                   "mass - 2 - 1 == 4",
                                   "-mass < -6",
                                   "(mass + 1) / 2 == 4",
                                   "awake == true",
                                   "1 + 2 > 2 + 0",
                                   "3 > 2 and 2 > 1",
                                   "wings == nil",
                                   "not wings",
                                   "mass > 5 and awake or wings",
                                   "wings and mass or awake",
                                   "friend_of"}) {
        INFO(text);
        CHECK(Field::refusal(text) == "");
        CHECK(field.holds(text));
    }
    for (const char* const text :
         {"mass < 5", "mass > 7", "mass > 'x'", "label > 3", "wings > 1", "wings.x == 1",
          "velocity > 1", "mass < 5 and awake", "awake and (mass < 5 or wings)", "nil", "false",
          "Sprite", "world", "friend_of.nothing", "mass + label == 7", "velocity.z", "points[9]",
          "not awake", "velocity == 3"}) {
        INFO(text);
        CHECK(!field.holds(text));
    }
}

TEST_CASE("a text that is not a condition is refused with its place") {
    CHECK(Field::refusal("mass = 5") ==
          "condition \"mass = 5\", character 6: two values are compared by ==");
    CHECK(Field::refusal("mass >").ends_with(
        "character 7: expected a property or a value, got the end"));
    CHECK(Field::refusal("(mass > 5").ends_with("expected ), got the end"));
    CHECK(Field::refusal("mass != 5").ends_with("\"not equal\" is written ~="));
    CHECK(Field::refusal("1 < mass < 5").ends_with("comparisons are joined by \"and\""));
    CHECK(Field::refusal("mass 5").ends_with("expected an operator or the end, got \"5\""));
    CHECK(Field::refusal("quit()").ends_with("a condition calls no functions"));
    CHECK(Field::refusal("label == \"red").ends_with("this text has no end"));
    CHECK(Field::refusal("points[0] == 1").ends_with("expected an index from 1, got \"0\""));
    for (const char* const text : {"", " ", "and", "not", "mass >", ")", "a.", "a[1", "3x", "1e999",
                                   "a; b", "mass..x", "a == == b", "x = 1 -- y", "\x01"}) {
        INFO(text);
        CHECK(Field::refusal(text) != "");
    }
    CHECK(Field::refusal(std::string(3000, '1')).ends_with("at most 2000 bytes"));
    CHECK(Field::refusal(std::string(900, '(') + "1" + std::string(900, ')')) != "");
    std::string many;
    for (int i = 0; i < 400; ++i) many += "not ";
    CHECK(Field::refusal(many + "1") != "");
    CHECK(Field::refusal(std::string(40, '(') + "1" + std::string(40, ')')) == "");
}

TEST_CASE("a name that no instance has is reported with the nearest one") {
    Field field;
    CHECK(field.unknown("mass > 5 and awake") == "");
    CHECK(field.unknown("score > 5") == "");
    CHECK(field.unknown("masss > 5") == "nothing has \"masss\" (did you mean \"mass\"?)");
    CHECK(field.unknown("velocity.z > 5") == "nothing has \"velocity.z\"");
    CHECK(field.unknown("Bal") == "nothing has \"Bal\" (did you mean \"Ball\"?)");
}

TEST_CASE("a name alone is meant as a name") {
    for (const char* const text : {"mass > 5", "not awake", "a and b", "(x", "a == 1", "x+1"})
        CHECK(Condition::is_meant(text));
    for (const char* const text :
         {"", "ball", "world.ball", "brick 3", "android", "notes", "ball_*"})
        CHECK(!Condition::is_meant(text));
}

TEST_CASE("a failing formula makes its instance fail and nothing else") {
    Field field;
    field.tree.set_formula(
        field.ball, "charge",
        Formula{.function = [](const Tree&) -> Value { throw Error(ErrorKind::rejected, "no"); },
                .source = "no"});
    CHECK(!field.holds("charge > 0 or true"));
    CHECK(field.holds("mass > 5"));
    field.tree.destroy(field.world);
    CHECK(!field.holds("true"));
}

TEST_CASE("a vector that is compared with a number has a hint") {
    Field field;
    for (const char* text : {"velocity > 3", "3 <= velocity", "Ball and velocity < mass"}) {
        INFO(text);
        Condition condition(text);
        CHECK(!condition.holds(field.tree, field.ball));
        CHECK(condition.problem(field.tree) ==
              "velocity is a vector (write velocity.length, velocity.x or velocity.y)");
    }
    Condition length("velocity.length >= 0");
    CHECK(length.holds(field.tree, field.ball));
    CHECK(length.problem(field.tree).empty());
}

TEST_CASE("signs of other languages are conditions, whose messages name the words of Lua") {
    for (const auto& [text, message] : {std::pair("!awake", "\"not\" is a word here"),
                                        {"mass && awake", "\"and\" is a word here"},
                                        {"mass || awake", "\"or\" is a word here"}}) {
        INFO(text);
        CHECK(Condition::is_meant(text));
        CHECK_THROWS_WITH(Condition(text), contains(message));
    }
}

TEST_CASE("any text is refused or gives an answer") {
    Field field;
    const std::vector<std::string> words = {
        "mass", "velocity", ".",  "x", "[", "1",   "]",   "(",    ")", "and",       "or", "not",
        "<",    ">=",       "==", "-", "*", "'a'", "nil", "Ball", " ", "friend_of", "+"};
    std::minstd_rand random(7);
    int accepted = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text;
        for (std::size_t n = 1 + random() % 9; n > 0; --n)
            text += words[random() % words.size()] + " ";
        try {
            Condition condition(text);
            condition.holds(field.tree, field.ball);
            ++accepted;
        } catch (const Error&) {
        }
    }
    CHECK(accepted > 100);
}

}  // namespace condition_test
