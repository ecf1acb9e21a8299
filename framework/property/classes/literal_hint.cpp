#include <fettle/property/literal_hint.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace fettle::property {

namespace {

std::string write(const std::string& way) {
    return " (write " + way + ")";
}

bool is_list_of_numbers(const Value& value) {
    return value.is(Type::list) &&
           std::ranges::all_of(value.list(), [](const Value& each) { return each.is_numeric(); });
}

bool is_number_text(const std::string& text) {
    double number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    return read.ec == std::errc() && read.ptr == end && std::isfinite(number);
}

std::string way_to_write_vec(const Value& value) {
    if (value.is_numeric()) return write("vec(x, y)");
    if (!is_list_of_numbers(value) || value.list().size() != 2) return {};
    return write("vec(" + value_text(value.list()[0]) + ", " + value_text(value.list()[1]) + ")");
}

/// Channels above 1 are probably those of other libraries, which count to 255. Some of these count
/// the opacity to 1 all the same. An integer is the same in one number: 0xff8000.
std::string way_to_write_color(const Value& value) {
    constexpr double full = 255;
    constexpr std::int64_t white = 0xffffff;
    if (value.is(Type::integer) && value.integer() >= 0 && value.integer() <= white) {
        const auto channel = [&](int shift) {
            return static_cast<float>(static_cast<double>((value.integer() >> shift) & 255) / full);
        };
        return write(value_text(Value(Color{channel(16), channel(8), channel(0), 1})));
    }
    if (!is_list_of_numbers(value)) return {};
    const List& list = value.list();
    if (list.size() != 3 && list.size() != 4) return {};
    for (const Value& each : list)
        if (!(each.as_double() >= 0 && each.as_double() <= full)) return {};
    const auto above_one = [](const Value& each) { return each.as_double() > 1; };
    const bool to_full = std::any_of(list.begin(), list.begin() + 3, above_one);
    const auto channel = [&](std::size_t i, bool scaled) {
        return static_cast<float>(list[i].as_double() / (scaled ? full : 1));
    };
    const float opacity = list.size() == 4 ? channel(3, above_one(list[3])) : 1;
    const Color color{channel(0, to_full), channel(1, to_full), channel(2, to_full), opacity};
    return write(value_text(Value(color)));
}

}  // namespace

std::string literal_hint(Type type, const Value& value) {
    switch (type) {
        case Type::vec2:
            return way_to_write_vec(value);
        case Type::color:
            return way_to_write_color(value);
        case Type::number:
        case Type::integer:
            if (!value.is(Type::text) || !is_number_text(value.text())) return {};
            return write(value.text() + " without quotes");
        case Type::boolean:
            if (!value.is(Type::integer) || value.integer() < 0 || value.integer() > 1) return {};
            return write(value.integer() == 1 ? "true" : "false");
        case Type::text:
            return value.is_numeric() ? write("tostring(" + value_text(value) + ")")
                                      : std::string();
        case Type::nil:
        case Type::reference:
        case Type::list:
            return {};
    }
    return {};
}

}  // namespace fettle::property
