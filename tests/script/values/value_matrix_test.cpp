// Special values, written in every way: all ways give the same result, and an accepted value is
// saved and loaded bit for bit.

#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>

#include <fettle/property/error.h>
#include <fettle/property/storage/scene.h>

#include "stage.h"

namespace value_matrix_test {

using stage::Handle;
using stage::Stage;
using stage::Value;

namespace {

struct Hard {
    const char* name;
    Value value;
    std::string lua;   // in a script
    std::string json;  // in a scene file, for a property declared as number or text; "" if it
                       // cannot be written
};

std::vector<Hard> hard_values() {
    constexpr double huge = std::numeric_limits<double>::infinity();
    const std::string text(300'000, 'x');
    return {
        {"-2", Value(-2), "-2", "-2"},
        {"-2.0", Value(-2.0), "-2.0", "-2.0"},
        {"smallest integer", Value(INT64_MIN), "math.mininteger", "-9223372036854775808"},
        {"largest integer", Value(INT64_MAX), "math.maxinteger", "9223372036854775807"},
        {"-0.0", Value(-0.0), "-0.0", "-0.0"},
        {"infinity", Value(huge), "math.huge", "\"inf\""},
        {"-infinity", Value(-huge), "-math.huge", "\"-inf\""},
        {"NaN", Value(std::nan("")), "0/0", ""},
        {"denormal", Value(5e-324), "5e-324", "5e-324"},
        {"2^53+1", Value(std::int64_t{9007199254740993}), "9007199254740993", "9007199254740993"},
        {"2.5", Value(2.5), "2.5", "2.5"},
        {"1e300", Value(1e300), "1e300", "1e300"},
        {"no text", Value(""), "\"\"", "\"\""},
        {"long text", Value(text), "(\"x\"):rep(300000)", "\"" + text + "\""},
    };
}

/// As "number 0x8000000000000000"; "refused" if the value was refused.
std::string outcome(const Stage& s, Handle ball, const std::string& property) {
    const Value value = s.tree->get(ball, property);
    if (value.is(fettle::property::Type::number)) {
        std::uint64_t bits = 0;
        const double number = value.number();
        std::memcpy(&bits, &number, sizeof bits);
        char out[40];
        std::snprintf(out, sizeof out, "number %016llx", static_cast<unsigned long long>(bits));
        return out;
    }
    if (value.is(fettle::property::Type::text))
        return "text of " + std::to_string(value.text().size());
    return fettle::property::value_text(value);
}

constexpr const char* refused = "refused";

Handle fresh_ball(Stage& s) {
    if (const Handle old = s.tree->child(s.world, "b")) s.tree->destroy(old);
    return s.tree->create(s.tree->class_named("Body"), s.world, "b");
}

std::string from_cpp(Stage& s, const Hard& hard, const std::string& property) {
    const Handle ball = fresh_ball(s);
    try {
        s.tree->set_or_add(ball, property, hard.value);
    } catch (const fettle::property::Error&) {
        return refused;
    }
    return outcome(s, ball, property);
}

std::string from_lua(Stage& s, const Hard& hard, const std::string& property) {
    const Handle ball = fresh_ball(s);
    s.errors.clear();
    if (!s.runtime->run("world.b." + property + " = " + hard.lua, "main.lua")) return refused;
    return outcome(s, ball, property);
}

std::string from_console(Stage& s, const Hard& hard, const std::string& property) {
    const Handle ball = fresh_ball(s);
    if (!s.runtime->evaluate("world.b." + property + " = " + hard.lua).ok) return refused;
    return outcome(s, ball, property);
}

std::string from_scene(Stage& s, const Hard& hard, const std::string& property) {
    if (hard.json.empty()) return refused;
    fresh_ball(s);
    s.tree->destroy(s.tree->child(s.world, "b"));
    const bool declared = s.tree->class_named("Body").property(property) != nullptr;
    std::string json = hard.json;
    // If the property is not declared as a number, the file says that the value is one.
    if ((!declared || property == "title") && hard.value.is(fettle::property::Type::number) &&
        json.front() == '"')
        json = "{\"number\": " + json + "}";
    const std::string text = std::string("{\"fettle_scene\": 1, \"class\": \"Body\", ") +
                             (declared ? "\"properties\"" : "\"ad_hoc\"") + ": {\"" + property +
                             "\": " + json + "}}";
    try {
        return outcome(s, fettle::property::load_scene_text(*s.tree, text, "a.json", s.world, "b"),
                       property);
    } catch (const fettle::property::Error&) {
        return refused;
    }
}

}  // namespace

TEST_CASE("a special value has the same result in C++ and Lua and the console and a scene file") {
    Stage s;
    const std::vector<Hard> all = hard_values();
    for (const char* property : {"number", "counter", "title", "mass", "friction", "own"}) {
        for (const Hard& hard : all) {
            INFO(property << " = " << hard.name);
            const std::string expected = from_cpp(s, hard, property);
            CHECK(from_lua(s, hard, property) == expected);
            CHECK(from_console(s, hard, property) == expected);
            CHECK(from_scene(s, hard, property) == expected);
        }
    }
    const auto made = [&](const char* property, std::size_t i) {
        return from_cpp(s, all[i], property);
    };
    CHECK(made("number", 0) == "number c000000000000000");
    CHECK(made("number", 2) == "number c3e0000000000000");
    CHECK(made("number", 3) == refused);  // no double equals that integer
    CHECK(made("number", 4) == "number 8000000000000000");
    CHECK(made("number", 7) == refused);
    CHECK(made("number", 8) == "number 0000000000000001");
    CHECK(made("number", 9) == refused);
    CHECK(made("number", 12) == refused);
    CHECK(made("counter", 2) == "-9223372036854775808");
    CHECK(made("counter", 5) == refused);
    CHECK(made("counter", 10) == refused);
    CHECK(made("mass", 0) == refused);
    CHECK(made("mass", 5) == "number 7ff0000000000000");
    CHECK(made("friction", 11) == refused);
    CHECK(made("own", 9) == "9007199254740993");
    CHECK(made("title", 13) == "text of 300000");
}

TEST_CASE("an accepted special value comes back bit for bit from a scene file") {
    Stage s;
    for (const char* property : {"number", "counter", "title", "mass", "friction", "own"}) {
        for (const Hard& hard : hard_values()) {
            INFO(property << " = " << hard.name);
            const std::string set = from_cpp(s, hard, property);
            if (set == refused) continue;
            const std::string text =
                fettle::property::scene_text(*s.tree, s.tree->child(s.world, "b"));
            s.tree->destroy(s.tree->child(s.world, "b"));
            const Handle back =
                fettle::property::load_scene_text(*s.tree, text, "a.json", s.world, "b");
            CHECK(outcome(s, back, property) == set);
        }
    }
}

}  // namespace value_matrix_test
