// Conversions of values that are written into properties and read from them, for every kind of
// memory behind a property.

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <random>
#include <variant>

#include <fettle/property/bound_text.h>
#include <fettle/property/coercion.h>

#include "catch.h"
#include "fixture.h"

namespace values_test {

using namespace fettle::property;
using fettle::property::testing::message_of;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double denormal = std::numeric_limits<double>::denorm_min();
constexpr std::int64_t beyond =
    (std::int64_t{1} << 53) + 1;  // the first integer that no double equals
const double largest = std::numeric_limits<double>::max();

struct Cell {
    double f64 = 0;
    float f32 = 0;
    std::int64_t i64 = 0;
    std::int32_t i32 = 0;
    bool flag = false;
    double vec2d[2] = {0, 0};
    float vec2f[2] = {0, 0};
    Color color{};
    std::uint8_t kind = 0;
    Value kept = 0.0;  // behind a getter and a setter
};

using Cells = std::vector<Cell>;

#define FETTLE_TEST_COLUMN(member, native)                                      \
    column(cells, Native::native, sizeof(Cell), [](Cells& c) {                  \
        return reinterpret_cast<std::byte*>(c.data()) + offsetof(Cell, member); \
    })

class CellFixture {
  public:
    CellFixture() {
        ClassDescriptor d;
        d.name = "Cell";
        d.lifecycle.context = &cells;
        d.lifecycle.create = [](void* c, Tree&, Handle) {
            static_cast<Cells*>(c)->emplace_back();
            return static_cast<Row>(static_cast<Cells*>(c)->size() - 1);
        };
        const auto add = [&d](std::string name, Type type, Binding binding) -> Property& {
            Property property;
            property.name = std::move(name);
            property.type = type;
            property.infinity = true;
            property.binding = binding;
            return d.properties.emplace_back(std::move(property));
        };
        add("f64", Type::number, FETTLE_TEST_COLUMN(f64, f64));
        add("f32", Type::number, FETTLE_TEST_COLUMN(f32, f32));
        add("i64", Type::integer, FETTLE_TEST_COLUMN(i64, i64));
        add("i32", Type::integer, FETTLE_TEST_COLUMN(i32, i32));
        add("flag", Type::boolean, FETTLE_TEST_COLUMN(flag, boolean));
        add("vec2d", Type::vec2, FETTLE_TEST_COLUMN(vec2d, vec2d));
        add("vec2f", Type::vec2, FETTLE_TEST_COLUMN(vec2f, vec2f));
        add("color", Type::color, FETTLE_TEST_COLUMN(color, color));
        add("kind", Type::text, FETTLE_TEST_COLUMN(kind, enumeration)).enumerators = {"one", "two"};
        add("finite", Type::number, FETTLE_TEST_COLUMN(f64, f64)).infinity = false;
        add("behind", Type::number,
            accessor(
                cells, [](Cells& c, Row r) { return c[r].kept; },
                [](Cells& c, Row r, const Value& v) { c[r].kept = v; }));
        add("kept_number", Type::number, {});
        add("kept_integer", Type::integer, {});
        add("kept_flag", Type::boolean, {});
        add("kept_text", Type::text, {});
        add("kept_vec2", Type::vec2, {});
        add("kept_color", Type::color, {});
        add("kept_list", Type::list, {}).element = Type::number;
        tree.define(std::move(d));
        cell = tree.create(tree.class_named("Cell"), tree.root(), "cell");
    }

    Cells cells;
    Tree tree;
    Handle cell;
};

using Outcome = std::variant<Value, ErrorKind>;

/// The value that is read after writing, or the reason for a refusal. A refused write changes
/// nothing.
Outcome write(Tree& tree, Handle cell, const std::string& name, const Value& value) {
    const Value before = tree.get(cell, name);
    try {
        tree.set(cell, name, value);
    } catch (const Error& e) {
        CHECK(std::string(e.what()).find("cell." + name) != std::string::npos);
        CHECK(tree.get(cell, name) == before);
        return e.kind();
    }
    return tree.get(cell, name);
}

std::string described(const Outcome& outcome) {
    if (const auto* value = std::get_if<Value>(&outcome)) {
        return std::string(type_name(value->type())) + " " + value_text(*value).substr(0, 80);
    }
    return "error " + std::to_string(static_cast<int>(std::get<ErrorKind>(outcome)));
}

struct Case {
    Value written;
    Outcome outcome;
};

void check(CellFixture& f, const std::vector<std::string>& names, const std::vector<Case>& cases) {
    for (const std::string& name : names) {
        for (const Case& each : cases) {
            const Outcome got = write(f.tree, f.cell, name, each.written);
            CAPTURE(name, value_text(each.written).substr(0, 80), described(got),
                    described(each.outcome));
            CHECK(got == each.outcome);
        }
    }
}

double random_double(std::mt19937_64& random) {
    const std::uint64_t bits = random();
    double number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
}

}  // namespace

TEST_CASE_METHOD(CellFixture, "numbers keep every bit in every kind of double memory") {
    check(*this, {"f64", "behind", "kept_number"},
          {{-2, Value(-2.0)},
           {-2.0, Value(-2.0)},
           {-0.0, Value(-0.0)},
           {0, Value(0.0)},
           {infinity, Value(infinity)},
           {-infinity, Value(-infinity)},
           {denormal, Value(denormal)},
           {largest, Value(largest)},
           {INT64_MIN, Value(-0x1p63)},
           {beyond - 1, Value(0x1p53)},
           {nan, ErrorKind::not_finite},
           {-nan, ErrorKind::not_finite},
           {INT64_MAX, ErrorKind::out_of_range},
           {beyond, ErrorKind::out_of_range},
           {-beyond, ErrorKind::out_of_range},
           {"", ErrorKind::wrong_type},
           {"2", ErrorKind::wrong_type},
           {std::string(1 << 20, '1'), ErrorKind::wrong_type},
           {true, ErrorKind::wrong_type},
           {Vec2(1, 2), ErrorKind::wrong_type},
           {List{1.0}, ErrorKind::wrong_type}});
}

TEST_CASE_METHOD(CellFixture, "infinity is refused where it is not allowed") {
    check(*this, {"finite"},
          {{infinity, ErrorKind::not_finite},
           {-infinity, ErrorKind::not_finite},
           {nan, ErrorKind::not_finite},
           {largest, Value(largest)}});
}

TEST_CASE_METHOD(CellFixture, "numbers in a float are the nearest float") {
    check(*this, {"f32"},
          {{-2, Value(-2.0)},
           {-0.0, Value(-0.0)},
           {0.1, Value(static_cast<double>(0.1f))},
           {infinity, Value(infinity)},
           {16777216, Value(16777216.0)},
           {16777217, ErrorKind::out_of_range},
           {16777217.0, Value(16777216.0)},
           {denormal, Value(0.0)},
           {static_cast<double>(std::numeric_limits<float>::denorm_min()),
            Value(static_cast<double>(std::numeric_limits<float>::denorm_min()))},
           {INT64_MIN, Value(-0x1p63)},
           {INT64_MAX, ErrorKind::out_of_range},
           {1e39, ErrorKind::out_of_range},
           {-1e300, ErrorKind::out_of_range},
           {nan, ErrorKind::not_finite}});
}

TEST_CASE_METHOD(CellFixture, "integers keep every bit and accept numbers that are integers") {
    check(*this, {"i64", "kept_integer"},
          {{-2, Value(-2)},
           {INT64_MIN, Value(INT64_MIN)},
           {INT64_MAX, Value(INT64_MAX)},
           {beyond, Value(beyond)},
           {3.0, Value(3)},
           {-0.0, Value(0)},
           {-0x1p63, Value(INT64_MIN)},
           {0x1p63, ErrorKind::wrong_type},
           {2.5, ErrorKind::wrong_type},
           {denormal, ErrorKind::wrong_type},
           {infinity, ErrorKind::wrong_type},
           {-infinity, ErrorKind::wrong_type},
           {nan, ErrorKind::not_finite},
           {"3", ErrorKind::wrong_type},
           {true, ErrorKind::wrong_type}});
}

TEST_CASE_METHOD(CellFixture, "32 bit integers refuse larger values") {
    check(*this, {"i32"},
          {{INT32_MIN, Value(INT32_MIN)},
           {INT32_MAX, Value(INT32_MAX)},
           {std::int64_t{INT32_MAX} + 1, ErrorKind::out_of_range},
           {std::int64_t{INT32_MIN} - 1, ErrorKind::out_of_range},
           {INT64_MAX, ErrorKind::out_of_range},
           {INT64_MIN, ErrorKind::out_of_range},
           {4294967296.0, ErrorKind::out_of_range}});
}

TEST_CASE_METHOD(CellFixture, "vectors are checked component by component") {
    check(*this, {"vec2d", "kept_vec2"},
          {{Vec2(-0.0, denormal), Value(Vec2(-0.0, denormal))},
           {Vec2(infinity, -infinity), Value(Vec2(infinity, -infinity))},
           {Vec2(0.1, -2), Value(Vec2(0.1, -2))},
           {Vec2(nan, 0), ErrorKind::not_finite},
           {Vec2(0, nan), ErrorKind::not_finite},
           {1.0, ErrorKind::wrong_type},
           {List{1.0, 2.0}, ErrorKind::wrong_type}});
    check(*this, {"vec2f"},
          {{Vec2(0.1, -0.0), Value(Vec2(static_cast<double>(0.1f), -0.0))},
           {Vec2(0, 1e39), ErrorKind::out_of_range},
           {Vec2(nan, 0), ErrorKind::not_finite}});
}

TEST_CASE_METHOD(CellFixture,
                 "colors accept names and hexadecimal digits and stay within their range") {
    check(*this, {"color", "kept_color"},
          {{Color{0.1f, 0.2f, 0.3f, 0.4f}, Value(Color{0.1f, 0.2f, 0.3f, 0.4f})},
           {"#f00", Value(Color{1, 0, 0, 1})},
           {"#0000ff00", Value(Color{0, 0, 1, 0})},
           {"tomato", Value(Color{1, 99 / 255.0f, 71 / 255.0f, 1})},
           {Color{2, -1, 0.5f, 1}, Value(Color{1, 0, 0.5f, 1})},
           {Color{NAN, 0, 0, 1}, ErrorKind::not_finite},
           {Color{0, 0, 0, INFINITY}, ErrorKind::not_finite},
           {"", ErrorKind::wrong_type},
           {"#ff", ErrorKind::wrong_type},
           {"#gggggg", ErrorKind::wrong_type},
           {"tomatoo", ErrorKind::wrong_type},
           {std::string(1 << 20, '#'), ErrorKind::wrong_type},
           {1, ErrorKind::wrong_type}});
}

TEST_CASE_METHOD(CellFixture, "texts keep every byte and enumerations accept only their words") {
    std::string bytes;
    for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
    check(*this, {"kept_text"},
          {{"", Value("")},
           {bytes, Value(bytes)},
           {std::string(1 << 22, 'x'), Value(std::string(1 << 22, 'x'))},
           {2, ErrorKind::wrong_type},
           {true, ErrorKind::wrong_type},
           {nan, ErrorKind::wrong_type}});
    check(*this, {"kind"},
          {{"two", Value("two")},
           {"Two", ErrorKind::out_of_range},
           {"", ErrorKind::out_of_range},
           {std::string(1 << 20, 't'), ErrorKind::out_of_range},
           {1, ErrorKind::wrong_type}});
}

TEST_CASE_METHOD(CellFixture, "booleans are not converted from numbers or texts") {
    check(*this, {"flag", "kept_flag"},
          {{true, Value(true)},
           {1, ErrorKind::wrong_type},
           {0.0, ErrorKind::wrong_type},
           {"true", ErrorKind::wrong_type}});
}

TEST_CASE_METHOD(CellFixture, "lists are checked element by element") {
    check(*this, {"kept_list"},
          {{List{}, Value(List{})},
           {List{1, 2.5, -0.0}, Value(List{1.0, 2.5, -0.0})},
           {List{1, "x"}, ErrorKind::wrong_type},
           {List{1, nan}, ErrorKind::not_finite},
           {List{beyond}, ErrorKind::out_of_range},
           {List{Value(List{1.0})}, ErrorKind::wrong_type},
           {1.0, ErrorKind::wrong_type}});
    REQUIRE_THROWS_WITH(tree.set(cell, "kept_list", List{1, "x"}),
                        contains("cell.kept_list[2]: expected a number, got text \"x\""));
}

TEST_CASE_METHOD(CellFixture, "ad hoc properties keep value and type but refuse NaN at any depth") {
    for (const Value& value :
         {Value(-2), Value(-2.0), Value(INT64_MIN), Value(INT64_MAX), Value(-0.0), Value(infinity),
          Value(-infinity), Value(denormal), Value(beyond), Value(""),
          Value(std::string(1 << 20, 'x')), Value(Vec2(infinity, -0.0)), Value(cell),
          Value(List{1, List{2.0, "x"}})}) {
        tree.set_or_add(cell, "own", value);
        CHECK(tree.get(cell, "own") == value);
    }
    for (const Value& value : {Value(nan), Value(Vec2(0, nan)), Value(Color{0, NAN, 0, 0}),
                               Value(List{1, List{2, nan}})}) {
        CHECK(message_of([&] { tree.set_or_add(cell, "own", value); }) != "");
        CHECK(message_of([&] { tree.set_or_add(cell, "other", value); }) != "");
        CHECK(tree.find(cell, "other") == nullptr);
    }
}

TEST_CASE_METHOD(CellFixture, "any double is stored unchanged or is NaN") {
    std::mt19937_64 random(1);
    for (int i = 0; i < 20000; ++i) {
        const double number = random_double(random);
        const Outcome got = write(tree, cell, "f64", number);
        CHECK(got ==
              (std::isnan(number) ? Outcome(ErrorKind::not_finite) : Outcome(Value(number))));
    }
}

TEST_CASE_METHOD(CellFixture, "any integer becomes exactly that number or is refused") {
    std::mt19937_64 random(2);
    for (int i = 0; i < 20000; ++i) {
        const auto integer = static_cast<std::int64_t>(random()) >> (random() % 64);
        const auto number = static_cast<double>(integer);
        // 2^63 is the only double near an integer that is not equal to one.
        const bool exact = number != 0x1p63 && static_cast<std::int64_t>(number) == integer;
        const Outcome got = write(tree, cell, "f64", integer);
        CAPTURE(integer);
        CHECK(got == (exact ? Outcome(Value(number)) : Outcome(ErrorKind::out_of_range)));
    }
}

TEST_CASE(
    "a printed number reads back as itself and a float is printed with as few digits as possible") {
    std::mt19937_64 random(3);
    for (int i = 0; i < 20000; ++i) {
        const double number = random_double(random);
        if (std::isnan(number)) continue;
        CHECK(Value(std::strtod(number_text(number).c_str(), nullptr)) == Value(number));
        const auto narrow = static_cast<float>(std::ldexp(
            1.0 + static_cast<double>(random() % 1000), static_cast<int>(random() % 60) - 30));
        const std::string text =
            number_text(static_cast<double>(narrow), Precision::single_precision);
        CAPTURE(text);
        CHECK(Value(std::strtof(text.c_str(), nullptr)) == Value(narrow));
        CHECK(text.size() <= 17);
    }
    CHECK(number_text(0.1) == "0.1");
    CHECK(number_text(static_cast<double>(0.1f), Precision::single_precision) == "0.1");
    CHECK(number_text(infinity) == "inf");
    CHECK(number_text(-infinity) == "-inf");
    CHECK(number_text(-0.0) == "-0");
    CHECK(number_text(1e6) == "1000000");
}

TEST_CASE("large bounds of ranges are short texts in errors") {
    CHECK(bound_text(1e8) == "1e8");
    CHECK(bound_text(-2.5e7) == "-25e6");
    CHECK(bound_text(65536) == "65536");
    CHECK(bound_text(2147483647) == "2147483647");
    CHECK(bound_text(static_cast<double>(0.1f), Precision::single_precision) == "0.1");
    CHECK(bound_text(-infinity) == "-inf");
    Tree tree;
    const Property wide{.name = "at", .type = Type::number, .unit = "m", .range = {-1e8, 1e8}};
    CHECK_THAT(message_of([&] { coerced(tree, wide, Value(1e9), "ball.at"); }),
               contains("a number from -1e8 to 1e8 m, got 1000000000"));
}

TEST_CASE("a change of a value does not affect its copies") {
    Value text("a text that is longer than any small buffer would be");
    const Value copy = text;
    text = Value(2);
    CHECK(copy == Value("a text that is longer than any small buffer would be"));
    Value list(List{1, "two", List{3}});
    Value other = list;
    list = other.list()[2];
    CHECK(list == Value(List{3}));
    CHECK(other == Value(List{1, "two", List{3}}));
    other = Value(other);
    CHECK(other.list().size() == 3);
    Value moved = std::move(other);
    CHECK(moved.list()[1] == Value("two"));
}

TEST_CASE("hexadecimal colors are printed as they were read") {
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i) {
        char text[10];
        std::snprintf(text, sizeof text, "#%06x", static_cast<unsigned>(random() & 0xFFFFFF));
        Color color;
        REQUIRE(parse_color(text, color));
        CHECK(color_text(color) == text);
    }
    for (const std::string& name : color_names()) {
        Color color;
        CAPTURE(name);
        CHECK(parse_color(name, color));
    }
}

TEST_CASE_METHOD(CellFixture, "an error of a vector with NaN shows both of its components") {
    CHECK_THAT(message_of([&] { tree.set(cell, "vec2d", Value(Vec2(nan, 1))); }),
               Catch::Matchers::EndsWith("got vec(nan, 1)"));
}

}  // namespace values_test
