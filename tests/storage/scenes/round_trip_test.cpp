// A saved scene contains exactly the values that differ from the defaults.

#include <cmath>
#include <limits>

#include "catch.h"
#include "scene_world.h"

namespace round_trip_test {

using namespace scene_test;

namespace {

const std::vector<double> numbers = {-2.0,
                                     -0.0,
                                     0.1,
                                     infinity,
                                     -infinity,
                                     9007199254740993.0,
                                     9007199254740994.0,
                                     -9223372036854775808.0,
                                     18446744073709551616.0,
                                     1e22,
                                     1e23,
                                     123456789012345678.0,
                                     std::numeric_limits<double>::denorm_min(),
                                     std::numeric_limits<double>::min(),
                                     std::numeric_limits<double>::max(),
                                     5e-324,
                                     1.0 / 3.0,
                                     3.0};

const std::vector<float> floats = {-2.0f,
                                   -0.0f,
                                   0.1f,
                                   16777216.0f,
                                   16777218.0f,
                                   123456792.0f,
                                   1e10f,
                                   std::numeric_limits<float>::infinity(),
                                   std::numeric_limits<float>::denorm_min(),
                                   std::numeric_limits<float>::max(),
                                   1.0f / 3.0f};

const std::vector<std::int64_t> integers = {-2,        0,        1, (std::int64_t{1} << 53) + 1,
                                            INT64_MIN, INT64_MAX};

std::vector<std::string> texts() {
    std::string bytes;
    for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
    return {"",
            "plain",
            "inf",
            "-inf",
            "nil",
            "#ff8800",
            "50% of \"it\" \\ / \n\t\r\b",
            std::string("a\0b", 3),
            "Grüße, 世界 🎈",
            "caf\xe9",
            "\xff\xfe%41",
            "\xed\xa0\x80 a surrogate",
            "\xc0\x80 overlong",
            bytes,
            std::string(1 << 20, 'x'),
            "{\"vec2\": [1, 2]}"};
}

/// Every kind of value of an ad-hoc property.
std::vector<Value> matrix(Handle reference) {
    std::vector<Value> values = {
        true,
        false,
        Vec2(1, -0.0),
        Vec2(infinity, -infinity),
        Vec2(0.1, 1e300),
        Color{1, 0, 0, 1},
        Color{0.1f, 0.2f, 1.0f / 3, 0.5f},
        Color{-0.0f, 0, 0, 0},
        reference,
        Handle{},
        List{},
        List{1, 1.0, "x", List{Vec2(1, 2), List{}}, reference, Value(), true}};
    for (const double number : numbers) values.emplace_back(number);
    for (const std::int64_t integer : integers) values.emplace_back(integer);
    for (const std::string& text : texts()) values.emplace_back(text);
    List all(values.begin(), values.end());
    values.emplace_back(all);
    return values;
}

}  // namespace

TEST_CASE("native numbers survive a scene file bit for bit") {
    SceneWorld w;
    for (const double number : numbers) {
        const Handle thing = w.add("Thing");
        w.tree.set(thing, "number", number);
        w.tree.set(thing, "position", Vec2(number, -number));
        const Handle copy = w.copy(thing);
        CAPTURE(number, w.text(thing));
        CHECK(w.tree.get(copy, "number") == w.tree.get(thing, "number"));
        CHECK(w.tree.get(copy, "position") == w.tree.get(thing, "position"));
        w.tree.destroy(copy);
    }
}

TEST_CASE("native floats keep every bit in a scene file and are written with few digits") {
    SceneWorld w;
    for (const float number : floats) {
        const Handle thing = w.add("Thing");
        w.tree.set(thing, "small", number);
        const Handle copy = w.copy(thing);
        CAPTURE(number, w.text(thing));
        CHECK(w.tree.get(copy, "small") == w.tree.get(thing, "small"));
        w.tree.destroy(copy);
    }
    const Handle thing = w.add("Thing");
    w.tree.set(thing, "small", 0.1);
    w.tree.set(thing, "offset", Vec2(0.2, 0.3));
    w.tree.set(thing, "gain", 0.7);
    CHECK(w.text(thing).find("\"small\": 0.1,\n") != std::string::npos);
    CHECK(w.text(thing).find("\"offset\": [0.2, 0.3],\n") != std::string::npos);
    CHECK(w.text(thing).find("\"gain\": 0.7\n") != std::string::npos);
}

TEST_CASE("native integers enumerations booleans and colors survive a scene file") {
    SceneWorld w;
    for (const std::int64_t integer : integers) {
        const Handle thing = w.add("Thing");
        w.tree.set(thing, "integer", integer);
        CHECK(w.tree.get(w.copy(thing, "integer_" + std::to_string(w.tree.size())), "integer") ==
              Value(integer));
    }
    const Handle thing = w.add("Thing");
    w.tree.set(thing, "narrow", -5);
    w.tree.set(thing, "flag", true);
    w.tree.set(thing, "kind", "kinematic");
    w.tree.set(thing, "tint", Color{0.25f, 0.5f, 0.1f, 0.9f});
    const Handle copy = w.copy(thing);
    for (const Property* property : w.tree.class_of(thing).properties()) {
        if (property->name == "name") continue;
        CAPTURE(property->name);
        CHECK(w.tree.get(copy, *property) == w.tree.get(thing, *property));
    }
}

TEST_CASE("texts of any bytes survive a scene file") {
    SceneWorld w;
    for (const std::string& text : texts()) {
        const Handle note = w.add("Note");
        w.tree.set(note, "text", text);
        const Handle copy = w.copy(note);
        CHECK(w.tree.get(copy, "text") == Value(text));
        w.tree.destroy(copy);
    }
}

TEST_CASE("ad hoc properties keep value and type") {
    SceneWorld w;
    const Handle scene = w.add("Object", "scene");
    const Handle inside = w.add("Object", scene, "inside");
    std::vector<Value> values = matrix(w.world);
    for (std::size_t i = 0; i < values.size(); ++i) {
        w.tree.set_or_add(inside, "value_" + std::to_string(i), values[i]);
    }
    const Handle copy = w.tree.child(w.copy(scene), "inside");
    for (std::size_t i = 0; i < values.size(); ++i) {
        CAPTURE(i, w.tree.text(values[i]).substr(0, 200));
        CHECK(w.tree.get(copy, "value_" + std::to_string(i)) == values[i]);
    }
    CHECK(w.warnings.empty());
}

TEST_CASE("lists of a declared element type survive a scene file") {
    SceneWorld w;
    const Handle scene = w.add("Object", "scene");
    const Handle note = w.add("Note", scene, "note");
    const Handle other = w.add("Thing", scene, "other");
    List points;
    for (int i = 0; i < 40; ++i) points.emplace_back(Vec2(i / 10.0, -i));
    w.tree.set(note, "points", points);
    w.tree.set(note, "targets", List{other, Handle{}, w.world, scene});
    w.tree.set(note, "anything", List{1, 2.0, "three", Vec2(4, 5), infinity, List{6}});
    const Handle copy = w.copy(scene);
    const Handle copied = w.tree.child(copy, "note");
    CHECK(w.tree.get(copied, "points") == Value(points));
    CHECK(w.tree.get(copied, "targets") ==
          Value(List{w.tree.child(copy, "other"), Handle{}, w.world, copy}));
    CHECK(w.tree.get(copied, "anything") == w.tree.get(note, "anything"));
}

TEST_CASE("a nil that differs from the default survives a scene file") {
    SceneWorld w;
    const Handle note = w.add("Note");
    w.tree.set(note, "limit", Value());
    REQUIRE(w.tree.get(note, "limit").is_nil());
    CHECK(w.text(note).find("\"limit\": null") != std::string::npos);
    CHECK(w.tree.get(w.copy(note), "limit").is_nil());
}

TEST_CASE("children keep their order classes and names") {
    SceneWorld w;
    const Handle scene = w.add("Object", "scene");
    for (const char* name :
         {"zebra", "apple", "my ball", "end", "quote\"back\\slash", "ünï", "1"}) {
        w.add("Thing", w.add("Note", scene, name), "inner");
    }
    const Handle copy = w.copy(scene);
    std::vector<std::string> names;
    for (const Handle child : w.tree.children(copy)) {
        names.push_back(w.tree.name(child));
        CHECK(w.tree.class_of(child).name() == "Note");
        CHECK(w.tree.class_of(w.tree.child(child, "inner")).name() == "Thing");
    }
    CHECK(names == std::vector<std::string>{"zebra", "apple", "my ball", "end",
                                            "quote\"back\\slash", "ünï", "1"});
}

TEST_CASE("saving what was loaded gives the same text") {
    SceneWorld w;
    const Handle scene = w.add("Object", "scene");
    w.tree.set_or_add(scene, "lives", 3);
    w.tree.set_or_add(scene, "bounds", List{Vec2(1, 2), "wide"});
    for (int i = 0; i < 5; ++i) {
        const Handle thing = w.add("Thing", scene);
        w.tree.set(thing, "position", Vec2(i / 3.0, i));
        w.tree.set(thing, "mass", i == 0 ? infinity : i * 1.5);
        const Handle note = w.add("Note", thing, "note");
        w.tree.set(note, "thing", thing);
    }
    const std::string text = w.text(scene);
    SceneWorld other;
    const Handle loaded = other.load(text);
    CHECK(other.text(loaded) == text);
    CHECK(other.tree.path(loaded) == "world.scene");
}

TEST_CASE("only values that differ from the defaults are written") {
    SceneWorld w;
    const Handle thing = w.add("Thing", "ball");
    CHECK(w.text(thing) ==
          "{\n"
          "  \"fettle_scene\": 1,\n"
          "  \"class\": \"Thing\",\n"
          "  \"name\": \"ball\"\n"
          "}\n");
    w.tree.set(thing, "number", 2);
    w.tree.set(thing, "position", Vec2(0, 8));
    w.tree.set(thing, "tint", "#ff7f00");
    w.tree.set_or_add(thing, "lives", 3);
    w.tree.set_or_add(thing, "charge", 3.0);
    w.tree.set_or_add(thing, "home", Vec2(1, 2));
    const Handle note = w.add("Note", thing, "note");
    w.tree.set(note, "passing", 5);
    w.tree.set(note, "target", thing);
    CHECK(w.text(thing) ==
          "{\n"
          "  \"fettle_scene\": 1,\n"
          "  \"class\": \"Thing\",\n"
          "  \"name\": \"ball\",\n"
          "  \"properties\": {\n"
          "    \"number\": 2,\n"
          "    \"position\": [0, 8],\n"
          "    \"tint\": \"#ff7f00\"\n"
          "  },\n"
          "  \"ad_hoc\": {\n"
          "    \"charge\": 3.0,\n"
          "    \"home\": {\"vec2\": [1, 2]},\n"
          "    \"lives\": 3\n"
          "  },\n"
          "  \"children\": [\n"
          "    {\n"
          "      \"class\": \"Note\",\n"
          "      \"name\": \"note\",\n"
          "      \"properties\": {\n"
          "        \"target\": \".\"\n"
          "      }\n"
          "    }\n"
          "  ]\n"
          "}\n");
    w.tree.set(thing, "number", 0.0);
    CHECK(w.text(thing).find("\"number\"") == std::string::npos);
}

TEST_CASE("a mass computed from the density is not written and one that was set is") {
    SceneWorld w;
    const Handle thing = w.add("Thing");
    w.tree.set(thing, "density", 3);
    CHECK(w.text(thing).find("\"mass\"") == std::string::npos);
    CHECK(w.tree.get(w.copy(thing, "computed"), "mass") == Value(3.0));
    w.tree.set(thing, "mass", 3);
    CHECK(w.text(thing).find("\"mass\": 3") != std::string::npos);
    const Handle copy = w.copy(thing, "given");
    w.tree.set(copy, "density", 4);
    CHECK(w.tree.get(copy, "mass") == Value(3.0));
}

TEST_CASE("a change of one property changes one line") {
    SceneWorld w;
    const Handle scene = w.add("Object", "scene");
    for (int i = 0; i < 20; ++i) w.tree.set(w.add("Thing", scene), "number", i + 0.5);
    const auto lines = [&] {
        std::vector<std::string> all(1);
        for (const char c : w.text(scene)) {
            if (c == '\n') {
                all.emplace_back();
            } else {
                all.back() += c;
            }
        }
        return all;
    };
    const auto before = lines();
    w.tree.set(w.tree.children(scene)[7], "number", 100);
    const auto after = lines();
    REQUIRE(before.size() == after.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < before.size(); ++i) different += before[i] != after[i];
    CHECK(different == 1);
}

TEST_CASE("a list too long for one line has one line for each element") {
    SceneWorld w;
    const Handle note = w.add("Note");
    List points;
    for (int i = 0; i < 4; ++i) points.emplace_back(Vec2(i, i));
    w.tree.set(note, "points", points);
    CHECK(w.text(note).find("\"points\": [[0, 0], [1, 1], [2, 2], [3, 3]]\n") != std::string::npos);
    for (int i = 0; i < 20; ++i) points.emplace_back(Vec2(0.5, i));
    w.tree.set(note, "points", points);
    CHECK(w.text(note).find("\"points\": [\n      [0, 0],\n      [1, 1],\n") != std::string::npos);
    CHECK(w.tree.get(w.copy(note), "points") == Value(points));
}

TEST_CASE("a child that its parent creates itself is found when loading") {
    SceneWorld w;
    const Handle host = w.add("Host", "host");
    w.tree.set_or_add(w.tree.child(host, "service"), "level", 4);
    const Handle copy = w.copy(host);
    CHECK(w.tree.child_count(copy) == 1);
    CHECK(w.tree.get(w.tree.child(copy, "service"), "level") == Value(4));
}

}  // namespace round_trip_test
