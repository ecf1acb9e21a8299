// Text of values: for the console and messages; Lua reads the same value back.

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fettle/property/bound_text.h>
#include <fettle/property/value.h>

#include "quoting.h"

namespace fettle::property {

std::string_view type_name(Type type) {
    switch (type) {
        case Type::nil:
            return "nil";
        case Type::boolean:
            return "boolean";
        case Type::integer:
            return "integer";
        case Type::number:
            return "number";
        case Type::text:
            return "text";
        case Type::vec2:
            return "vec2";
        case Type::color:
            return "color";
        case Type::reference:
            return "reference";
        case Type::list:
            return "list";
    }
    return "?";
}

namespace {

bool is_float(double number) {
    return static_cast<double>(static_cast<float>(number)) == number;
}

/// Whether a number that is exactly a float needs many digits as a double, as values of physics do:
/// the float nearest to 0.1 is 0.10000000149011612. Others, such as 1234567.125, may be floats by
/// chance.
bool is_long_float(double number) {
    if (!is_float(number) || std::trunc(number) == number) return false;
    char buffer[40];
    const char* const end = std::to_chars(buffer, buffer + sizeof buffer, std::fabs(number),
                                          std::chars_format::scientific)
                                .ptr;
    constexpr std::size_t most_digits = 12;  // few floats need so few by chance
    const std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
    return text.find('e') > most_digits + 1;  // with the point
}

}  // namespace

Precision shortest_precision(double number) {
    return is_long_float(number) ? Precision::single_precision : Precision::double_precision;
}

Precision shortest_precision(const Vec2& vec) {
    const bool floats = is_float(vec.x) && is_float(vec.y);
    return floats && (is_long_float(vec.x) || is_long_float(vec.y)) ? Precision::single_precision
                                                                    : Precision::double_precision;
}

std::string number_text(double number, Precision precision) {
    if (std::isnan(number)) return "nan";
    if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
    const auto narrow = static_cast<float>(number);
    // A number that is not exactly a float is printed with all digits, whatever the property says.
    const bool as_float =
        precision == Precision::single_precision && static_cast<double>(narrow) == number;
    // The shortest form of a million would be 1e+06, which is unusual for people.
    const double size = std::fabs(number);
    const auto format = size == 0 || (size >= 1e-5 && size < 1e15) ? std::chars_format::fixed
                                                                   : std::chars_format::scientific;
    char buffer[40];
    const std::to_chars_result end =
        as_float ? std::to_chars(buffer, buffer + sizeof buffer, narrow, format)
                 : std::to_chars(buffer, buffer + sizeof buffer, number, format);
    return {buffer, end.ptr};
}

std::string bound_text(double bound, Precision precision) {
    constexpr double many_zeros = 1e6;
    if (!std::isfinite(bound) || std::abs(bound) < many_zeros) return number_text(bound, precision);
    int zeros = 0;
    double digits = bound;
    for (; std::fmod(digits, 10) == 0; ++zeros) digits /= 10;
    if (std::abs(digits) > 99) return number_text(bound, precision);
    return number_text(digits) + "e" + std::to_string(zeros);
}

namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '\n' || c == '\t') {
            out += c == '\n' ? "\\n" : "\\t";
            ++i;
        } else {
            append_escaped(out, text, i);
        }
    }
    return out + '"';
}

}  // namespace

std::string value_text(const Value& value, Precision precision) {
    switch (value.type()) {
        case Type::nil:
            return "nil";
        case Type::boolean:
            return value.boolean() ? "true" : "false";
        case Type::integer:
            return std::to_string(value.integer());
        case Type::number:
            return number_text(value.number(), precision);
        case Type::text:
            return quoted(value.text());
        case Type::vec2:
            return "vec(" + number_text(value.vec2().x, precision) + ", " +
                   number_text(value.vec2().y, precision) + ")";
        case Type::color:
            return "color(\"" + color_text(value.color()) + "\")";
        case Type::reference:
            if (!value.reference()) return "nil";
            return "#" + std::to_string(value.reference().index) + ":" +
                   std::to_string(value.reference().generation);
        case Type::list: {
            std::string out = "{";
            for (const Value& element : value.list()) {
                if (out.size() > 1) out += ", ";
                out += value_text(element, precision);
            }
            return out + "}";
        }
    }
    return "?";
}

}  // namespace fettle::property
