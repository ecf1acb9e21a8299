// Paths and patterns: names in them, their targets, and invalid paths.

#include <functional>
#include <random>

#include "catch.h"
#include "fixture.h"

namespace paths_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

class PathFixture {
  public:
    PathFixture() : balls(tree) {
        world = tree.create(tree.object_class(), tree.root(), "world");
        ball = tree.create(*balls.type, world, "ball");
        tree.set_or_add(world, "home", Vec2(1, 2));
        tree.set_or_add(world, "points", List{Vec2(1, 2), Vec2(3, 4), "x"});
        tree.set_or_add(world, "shade", Color{0.25f, 0.5f, 0.75f, 1});
        tree.set_or_add(world, "favorite", ball);
    }
    Value at(std::string_view path) const { return get(tree, path); }
    std::string refusal(std::string_view path) const {
        return message_of([&] { resolve(tree, path); });
    }

    Tree tree;
    BallModule balls;
    Handle world, ball;
};

std::vector<std::string> names(const std::vector<Segment>& segments) {
    std::vector<std::string> all;
    for (const Segment& segment : segments) {
        all.push_back(segment.is_index() ? "#" + std::to_string(std::get<std::int64_t>(segment.key))
                                         : std::get<std::string>(segment.key));
    }
    return all;
}

/// A simple implementation of patterns.
bool plainly_matches(const std::vector<std::string>& pattern, std::size_t p,
                     const std::vector<std::string>& path, std::size_t n) {
    if (p == pattern.size()) return n == path.size();
    if (pattern[p] == "**") {
        for (std::size_t skip = n; skip <= path.size(); ++skip) {
            if (plainly_matches(pattern, p + 1, path, skip)) return true;
        }
        return false;
    }
    if (n == path.size()) return false;
    const std::function<bool(std::string_view, std::string_view)> fits =
        [&](std::string_view want, std::string_view name) {
            if (want.empty()) return name.empty();
            if (want[0] == '*') {
                return fits(want.substr(1), name) || (!name.empty() && fits(want, name.substr(1)));
            }
            return !name.empty() && want[0] == name[0] && fits(want.substr(1), name.substr(1));
        };
    return fits(pattern[p], path[n]) && plainly_matches(pattern, p + 1, path, n + 1);
}

std::string joined(const std::vector<std::string>& parts) {
    std::string all;
    for (const std::string& part : parts) all += (all.empty() ? "" : ".") + part;
    return all;
}

}  // namespace

TEST_CASE("a name after a dot in letters of another language is answered with what to write") {
    const std::string message = message_of([] { parse_path("world.日本語"); });
    CHECK(message.find("write [\"日本語\"]: a name after a dot has the letters a to z") !=
          std::string::npos);
}

TEST_CASE("a path consists of names and indices") {
    using Names = std::vector<std::string>;
    CHECK(names(parse_path("world.ball.velocity.x")) == Names{"world", "ball", "velocity", "x"});
    CHECK(names(parse_path("game.world")) == Names{"world"});
    CHECK(names(parse_path("game")).empty());
    CHECK(names(parse_path("world[\"my ball\"].vertices[2]")) ==
          Names{"world", "my ball", "vertices", "#2"});
    CHECK(names(parse_path("world[\"a \\\"b\\\" \\\\\"]")) == Names{"world", "a \"b\" \\"});
    CHECK(names(parse_path("a[-1]")) == Names{"a", "#-1"});
    CHECK(names(parse_path("world[\"game\"].game")) == Names{"world", "game", "game"});
}

TEST_CASE("an error in a path is reported with its position") {
    for (const char* text : {"",
                             ".",
                             "world.",
                             ".world",
                             "world..ball",
                             "world[",
                             "world[]",
                             "world[1",
                             "world[\"a",
                             "world[\"a\"",
                             "world[x]",
                             "1",
                             "world.1",
                             "a b",
                             "world ball",
                             "world[1.5]",
                             "world[99999999999999999999]",
                             "*",
                             "world.*",
                             "a]",
                             "\"a\"",
                             "a.[1]",
                             "a[1]b"}) {
        CAPTURE(text);
        try {
            parse_path(text);
            FAIL_CHECK("taken for a path");
        } catch (const Error& e) {
            CHECK(e.kind() == ErrorKind::bad_path);
            CHECK(std::string(e.what()).find("is not a path") != std::string::npos);
        }
    }
    CHECK(message_of([] { parse_path("world..ball"); }).find("at character 7") !=
          std::string::npos);
}

TEST_CASE("words that Lua reserves are not identifiers") {
    CHECK(is_identifier("ball_2"));
    CHECK(is_identifier("_"));
    for (const char* name : {"", "2", "end", "nil", "my ball", "a-b", "ü", "a.b"}) {
        CAPTURE(name);
        CHECK_FALSE(is_identifier(name));
    }
    CHECK(path_suffix("ball") == ".ball");
    CHECK(path_suffix("end") == "[\"end\"]");
    CHECK(path_suffix("a \"b\"") == "[\"a \\\"b\\\"\"]");
}

TEST_CASE_METHOD(PathFixture, "a path leads to instances and properties and parts of values") {
    CHECK(at("game") == Value(tree.root()));
    CHECK(at("world.ball") == Value(ball));
    CHECK(at("game.world.ball.radius") == Value(0.5));
    CHECK(at("world.home.y") == Value(2.0));
    CHECK(at("world.points[2]") == Value(Vec2(3, 4)));
    CHECK(at("world.points[2].x") == Value(3.0));
    CHECK(at("world.shade.b") == Value(0.75));
    CHECK(at("world.favorite.radius") == Value(0.5));
    CHECK(at("world.favorite") == Value(ball));
    CHECK(resolve(tree, "world.ball").property == nullptr);
}

TEST_CASE_METHOD(PathFixture, "a path without a target is reported with the existing names") {
    CHECK(refusal("world.bal") == "world has no property \"bal\" (did you mean \"ball\"?)");
    CHECK(refusal("world.ball.radios").find("(did you mean \"radius\"?)") != std::string::npos);
    CHECK(refusal("wrld.ball").find("(did you mean \"world\"?)") != std::string::npos);
    CHECK(refusal("world[1]").find("is an instance") != std::string::npos);
    CHECK(message_of([&] { at("world.home.z"); }).find("x and y") != std::string::npos);
    CHECK(message_of([&] { at("world.points[4]"); }).find("1 to 3") != std::string::npos);
    CHECK(message_of([&] { at("world.points[0]"); }).find("1 to 3") != std::string::npos);
    CHECK(message_of([&] { at("world.points.x"); }) != "");
    CHECK(message_of([&] { at("world.ball.radius.x"); }).find("no parts") != std::string::npos);
    tree.destroy(ball);
    CHECK(message_of([&] { at("world.favorite.radius"); }).find("was deleted") !=
          std::string::npos);
}

TEST_CASE_METHOD(PathFixture, "a write to a part of a value writes the whole value") {
    set(tree, "world.points[1].y", 9);
    set(tree, "world.points[4]", "appended");
    CHECK(at("world.points") == Value(List{Vec2(1, 9), Vec2(3, 4), "x", "appended"}));
    set(tree, "world.shade.a", 0.5);
    CHECK(at("world.shade") == Value(Color{0.25f, 0.5f, 0.75f, 0.5f}));
    set(tree, "world.ball.velocity.x", 3);
    CHECK(at("world.ball.velocity") == Value(Vec2(3, 0)));
    const Value before = at("world.points");
    for (const auto& [path, value] :
         std::vector<std::pair<const char*, Value>>{{"world.points[6]", 1},
                                                    {"world.points[0]", 1},
                                                    {"world.points[1].y", "high"},
                                                    {"world.points[1].y", std::nan("")},
                                                    {"world.points[5].x", 1},
                                                    {"world.points[1].y.x", 1}}) {
        CAPTURE(path);
        CHECK(message_of([&, p = path, v = value] { set(tree, p, v); }) != "");
        CHECK(at("world.points") == before);
    }
    CHECK(message_of([&] { set(tree, "world.ball", 1); }).find("is an instance") !=
          std::string::npos);
}

TEST_CASE_METHOD(PathFixture, "the path of an instance leads to it with any name") {
    std::mt19937 random(3);
    std::vector<std::string> odd = {
        "my ball", "end", "1",   "a.b", "a\"b", "a\\",  "\\\"", "]",   "\n",    "[1]",
        "*",       "**",  "ünï", "x_1", "x_01", "x_00", "_1",   "nil", "x_1_2", "x_999999999999"};
    for (int i = 0; i < 300; ++i) {
        std::string name;
        for (unsigned n = 0; n <= random() % 6; ++n) name += static_cast<char>(random() % 255 + 1);
        odd.push_back(name);
    }
    for (const std::string& name : odd) {
        if (tree.child(world, name)) continue;
        const Handle made = tree.create(tree.object_class(), world, name);
        const Handle below = tree.create(tree.object_class(), made, name);
        CAPTURE(name);
        CHECK(tree.name(made) == name);
        CHECK(resolve(tree, tree.path(made)).instance == made);
        CHECK(resolve(tree, tree.path(below)).instance == below);
        tree.set_or_add(below, "own", 1);
        CHECK(at(tree.path(below, tree.property(below, "own"))) == Value(1));
        CHECK(Pattern(tree.path(below)).matches(tree, below));
    }
}

TEST_CASE_METHOD(PathFixture, "no child of the root has the name of the root") {
    CHECK(message_of([&] { tree.create(tree.object_class(), tree.root(), "game"); }) != "");
    CHECK(message_of([&] { tree.rename(world, "game"); }) != "");
    const Handle game = tree.create(tree.object_class(), world, "game");
    CHECK(tree.path(game) == "world.game");
    CHECK(resolve(tree, "world.game").instance == game);
}

TEST_CASE_METHOD(PathFixture, "text that is not a path does no harm") {
    std::mt19937 random(4);
    const std::string letters = "world.ball[1]\"\\ *game\xff\n-9";
    for (int i = 0; i < 20000; ++i) {
        std::string text;
        for (unsigned n = 0; n < random() % 24; ++n) text += letters[random() % letters.size()];
        try {
            resolve(tree, text);
        } catch (const Error&) {
        }
        try {
            Pattern(text).matches(tree, ball);
        } catch (const Error& e) {
            CHECK(e.kind() == ErrorKind::bad_path);
        }
    }
    CHECK(refusal(std::string(1'000'000, 'x')) != "");
    std::string long_path = "world";
    for (int i = 0; i < 100'000; ++i) long_path += ".a";
    CHECK(refusal(long_path) != "");
}

TEST_CASE_METHOD(PathFixture, "patterns match the described paths") {
    const Property& radius = tree.property(ball, "radius");
    const auto matches = [&](std::string_view pattern) {
        return Pattern(pattern).matches(tree, ball, radius);
    };
    for (const char* pattern : {"world.ball.radius", "game.world.ball.radius", "world.*.radius",
                                "world.**", "**", "**.radius", "world.**.ball.**.radius",
                                "world.b*.rad*s", "*.*.*", "world[\"ball\"].radius"}) {
        CAPTURE(pattern);
        CHECK(matches(pattern));
    }
    for (const char* pattern : {"world.ball", "world.*", "world.ball.radiu", "ball.radius", "*",
                                "world.**.mass", "world.ball.radius.*", "World.ball.radius"}) {
        CAPTURE(pattern);
        CHECK_FALSE(matches(pattern));
    }
    CHECK(Pattern("world.ball").matches(tree, ball));
    CHECK(Pattern("world.**").matches(tree, world));
    CHECK_FALSE(Pattern("world.*").matches(tree, world));
    const Handle loose = tree.create(*balls.type, {}, "loose");
    CHECK_FALSE(Pattern("**").matches(tree, loose));
}

TEST_CASE("a quoted name of a pattern is in brackets between dots") {
    REQUIRE_THROWS_WITH(Pattern("world.\"ball\""), contains("a quoted name stands in brackets"));
    REQUIRE_THROWS_WITH(Pattern("wor\"ld"), contains("a quoted name stands in brackets"));
    REQUIRE_THROWS_WITH(Pattern("world[\"ball\"]radius"), contains("\".\" was expected"));
    REQUIRE_NOTHROW(Pattern("world[\"a.b\"][\"c\"].radius"));
}

TEST_CASE_METHOD(PathFixture, "patterns match as in a simple implementation") {
    std::mt19937 random(6);
    const std::vector<std::string> steps = {"a", "b", "ab", "aab", "ba"};
    const std::vector<std::string> wanted = {"a", "b", "ab", "*", "**", "a*", "*b", "*a*", "a*b"};
    for (int i = 0; i < 3000; ++i) {
        Handle at = tree.root();
        std::vector<std::string> path;
        for (unsigned n = 0; n <= random() % 4; ++n) {
            path.push_back(steps[random() % steps.size()]);
            const Handle there = tree.child(at, path.back());
            at = there ? there : tree.create(tree.object_class(), at, path.back());
        }
        std::vector<std::string> pattern;
        for (unsigned n = 0; n <= random() % 4; ++n)
            pattern.push_back(wanted[random() % wanted.size()]);
        CAPTURE(joined(pattern), joined(path));
        CHECK(Pattern(joined(pattern)).matches(tree, at) == plainly_matches(pattern, 0, path, 0));
    }
}

TEST_CASE("a name of three stars is no pattern") {
    for (const char* wrong : {"***", "world.***.mass", "****"})
        CHECK_THAT(message_of([&] { Pattern{wrong}; }), contains("* stands for one name"));
    CHECK_NOTHROW(Pattern("world.**.mass*"));
    CHECK_NOTHROW(Pattern("[\"***\"]"));
}

}  // namespace paths_test
