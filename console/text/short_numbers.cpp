#include <text/short_numbers.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

#include <fettle/property/value.h>

#include <text/highlight.h>

namespace fettle::console {

namespace {

/// The exponent of a number without zeros and plus in front: "1.5e-6".
std::string with_short_exponent(std::string shown) {
    const std::size_t exponent = shown.find('e') + 1;
    if (exponent == 0) return shown;
    const std::size_t sign = shown[exponent] == '-' ? 1 : 0;
    const std::size_t first = shown.find_first_not_of("+-0", exponent);
    return shown.erase(exponent + sign, first - exponent - sign);
}

/// With a point in every locale of the program.
std::string printed(std::chars_format format, int digits, double value) {
    char text[400];
    return std::string(text, std::to_chars(text, text + sizeof text, value, format, digits).ptr);
}

}  // namespace

std::string short_number(double value, int digits) {
    if (!std::isfinite(value)) return property::number_text(value);
    if (std::abs(value) < 1e-6) return "0";
    const double size = std::abs(value);
    if (size >= 1e7 || size < 1e-3)
        return with_short_exponent(printed(std::chars_format::general, digits, value));
    const int before = std::max(0, static_cast<int>(std::floor(std::log10(size))) + 1);
    const int leading = size < 1 ? -static_cast<int>(std::floor(std::log10(size))) - 1 : 0;
    const int decimals = std::max(0, digits - before + leading);
    std::string shown = printed(std::chars_format::fixed, decimals, value);
    if (shown.find('.') == std::string::npos) return shown;
    while (shown.back() == '0') shown.pop_back();
    if (shown.back() == '.') shown.pop_back();
    return shown;
}

std::string narrow_number(double value, int digits) {
    std::string usual = short_number(value, digits);
    if (!std::isfinite(value) || usual == "0") return usual;
    std::string other =
        with_short_exponent(printed(std::chars_format::scientific, digits - 1, value));
    return other.size() < usual.size() ? other : usual;
}

std::string aligned_number(double value, double largest, int digits) {
    const auto shown = static_cast<std::size_t>(digits);
    std::size_t beside = 3;  // a sign, and "0."
    if (largest >= 1e-6 && largest < 1e-3)
        beside = 5;  // a sign, a point, and "e-5"
    else if (largest >= 1e-3 && largest < 1e-1)
        beside += static_cast<std::size_t>(-std::floor(std::log10(largest))) - 1;
    const std::size_t width = std::max(shown + beside, short_number(-largest, digits).size());
    std::string text = short_number(value, digits);
    // Two notations in one vector would be hard to compare: an exponent is the last resort.
    const double size = std::abs(value);
    const bool plain = size < 1 && size >= 1e-3;
    for (int fewer = digits; text.size() > width && fewer > 0; --fewer)
        text = plain ? short_number(value, fewer) : narrow_number(value, fewer);
    for (int fewer = digits; text.size() > width && fewer > 0; --fewer)
        text = narrow_number(value, fewer);
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

namespace {

constexpr int usual_digits = 4, all_digits = 17;

/// A number in a line that has more digits than people need.
struct LongNumber {
    std::size_t begin, end;  // with its sign
    double value;
    int digits = usual_digits;
};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Whether a minus sign at the byte belongs to the number after it.
bool is_sign(std::string_view line, std::size_t at) {
    if (line[at] != '-') return false;
    const char before = at > 0 ? line[at - 1] : ' ';
    return before == ' ' || before == '(' || before == '{' || before == '[';
}

/// Significant digits of a decimal number.
int digits_of(std::string_view number) {
    number = number.substr(0, number.find_first_of("eE"));
    int count = 0;
    for (const char c : number)
        if (is_digit(c) && (count > 0 || c != '0')) ++count;
    return count;
}

/// The number that begins at the byte, if it is shown with fewer digits: not an integer, nor a part
/// of a version or of a number that was cut.
std::optional<LongNumber> long_number(std::string_view line, const Span& span) {
    const std::string_view text = line.substr(span.begin, span.end - span.begin);
    if (text.find_first_of(".eE") == std::string_view::npos ||
        line.substr(span.end).starts_with("…"))
        return {};
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size()) return {};
    const bool tiny = value != 0 && std::abs(value) < 1e-6;
    if (digits_of(text) <= usual_digits && !tiny) return {};
    const bool minus = span.begin > 0 && is_sign(line, span.begin - 1);
    return LongNumber{span.begin - (minus ? 1 : 0), span.end, minus ? -value : value};
}

/// The end of the source of a formula: where its value begins, or the end of the line.
std::size_t end_of_formula(std::string_view line, std::size_t begin) {
    return std::min(line.find(" = ", begin), line.size());
}

/// Whether the word at the byte introduces the source of a formula: `path: is x`, `value   is x`.
bool begins_formula(std::string_view line, const Span& span) {
    if (line.substr(span.begin, span.end - span.begin) != "is") return false;
    const std::string_view before = line.substr(0, span.begin);
    return before.empty() || before.ends_with(": ") || before.ends_with("→ ") ||
           before.ends_with("  ");
}

/// Gives numbers on both sides of an arrow so many digits that different ones are seen to differ.
void tell_apart(std::string_view line, std::size_t arrow, std::vector<LongNumber>& numbers) {
    const std::size_t colon = line.substr(0, arrow).rfind(": ");
    const std::size_t first = colon == std::string_view::npos ? 0 : colon;
    auto old = std::ranges::find_if(numbers, [&](const auto& n) { return n.begin >= first; });
    auto now = std::ranges::find_if(numbers, [&](const auto& n) { return n.begin > arrow; });
    const auto end = now;
    for (; old != end && now != numbers.end(); ++old, ++now) {
        if (old->value == now->value) continue;
        int digits = usual_digits;
        while (digits < all_digits &&
               short_number(old->value, digits) == short_number(now->value, digits))
            ++digits;
        old->digits = now->digits = digits;
    }
}

std::vector<LongNumber> long_numbers(std::string_view line) {
    std::vector<LongNumber> found;
    std::size_t formula = 0;  // up to this byte
    std::vector<std::size_t> arrows;
    for (const Span& span : highlight_output(line)) {
        if (span.begin < formula) continue;
        if (span.token == Token::arrow) arrows.push_back(span.begin);
        if (span.token == Token::plain && begins_formula(line, span))
            formula = end_of_formula(line, span.end);
        if (span.token != Token::number) continue;
        if (const auto number = long_number(line, span)) found.push_back(*number);
    }
    for (const std::size_t arrow : arrows) tell_apart(line, arrow, found);
    return found;
}

}  // namespace

ShortLine with_short_numbers(std::string_view line) {
    ShortLine made;
    std::size_t done = 0;
    for (const LongNumber& number : long_numbers(line)) {
        const std::string whole(line.substr(number.begin, number.end - number.begin));
        const std::string text = short_number(number.value, number.digits);
        if (text.size() >= whole.size()) continue;
        made.text += line.substr(done, number.begin - done);
        made.numbers.push_back({made.text.size(), made.text.size() + text.size(), whole});
        made.text += text;
        done = number.end;
    }
    made.text += line.substr(done);
    return made;
}

std::string whole_text(std::string_view text, const std::vector<ShortNumber>& numbers,
                       std::size_t begin, std::size_t end) {
    std::string out;
    for (const ShortNumber& number : numbers) {
        if (number.end <= begin || number.begin >= end) continue;
        if (number.begin > begin) out += text.substr(begin, number.begin - begin);
        out += number.whole;
        begin = number.end;
    }
    if (begin < end) out += text.substr(begin, end - begin);
    return out;
}

}  // namespace fettle::console
