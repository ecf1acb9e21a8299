#include <time/recording_text.h>

#include <charconv>
#include <cmath>
#include <cstdio>

#include <fettle/property/bytes.h>
#include <fettle/property/error.h>

namespace fettle::app {

std::string in_quotes(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n') {
            out += "\\n";
        } else if (code < 0x20 || code == 0x7f) {
            char escape[5];
            std::snprintf(escape, sizeof escape, "\\x%02x", code);
            out += escape;
        } else {
            out += c;
        }
    }
    return out + '"';
}

std::string exact(double number) {
    if (!std::isfinite(number)) return std::isnan(number) ? "nan" : number < 0 ? "-inf" : "inf";
    char text[40];
    const auto end =
        std::to_chars(text, text + sizeof text, std::abs(number), std::chars_format::hex);
    return (std::signbit(number) ? "-0x" : "0x") + std::string(text, end.ptr);
}

std::string hex(std::uint64_t bits) {
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(bits));
    return text;
}

std::string encoded(const property::Value& value) {
    std::vector<std::byte> bytes;
    property::ByteWriter(bytes).put(value);
    std::string out;
    for (const std::byte byte : bytes) {
        constexpr const char* digits = "0123456789abcdef";
        out += digits[std::to_integer<int>(byte) >> 4];
        out += digits[std::to_integer<int>(byte) & 15];
    }
    return out;
}

// --- Reading

void Words::skip() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
}

bool Words::at_end() {
    skip();
    return rest_.empty();
}

std::optional<std::string> Words::word() {
    skip();
    if (rest_.empty() || rest_.front() == '"') return std::nullopt;
    const std::size_t end = std::min(rest_.find(' '), rest_.size());
    const std::string taken(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return taken;
}

namespace {

int digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    return -1;
}

}  // namespace

std::optional<std::string> Words::text() {
    skip();
    if (rest_.empty() || rest_.front() != '"') return std::nullopt;
    std::string out;
    std::size_t i = 1;
    for (; i < rest_.size() && rest_[i] != '"'; ++i) {
        if (rest_[i] != '\\') {
            out += rest_[i];
            continue;
        }
        if (++i >= rest_.size()) return std::nullopt;
        if (rest_[i] == 'n') {
            out += '\n';
        } else if (rest_[i] == 'x') {
            if (i + 2 >= rest_.size()) return std::nullopt;
            const int high = digit(rest_[i + 1]), low = digit(rest_[i + 2]);
            if (high < 0 || low < 0) return std::nullopt;
            out += static_cast<char>(high * 16 + low);
            i += 2;
        } else {
            out += rest_[i];
        }
    }
    if (i >= rest_.size()) return std::nullopt;
    rest_.remove_prefix(i + 1);
    return out;
}

std::optional<double> Words::number() {
    const auto taken = word();
    if (!taken || taken->empty()) return std::nullopt;
    std::string_view digits = *taken;
    const bool negative = digits.starts_with('-');
    if (negative) digits.remove_prefix(1);
    const bool hexadecimal = digits.starts_with("0x");
    if (hexadecimal) digits.remove_prefix(2);
    if (digits.starts_with('-')) return std::nullopt;
    double number = 0;
    const char* const last = digits.data() + digits.size();
    const auto [end, error] =
        std::from_chars(digits.data(), last, number,
                        hexadecimal ? std::chars_format::hex : std::chars_format::general);
    if (error != std::errc() || end != last) return std::nullopt;
    return negative ? -number : number;
}

std::optional<std::int64_t> Words::integer() {
    const auto taken = word();
    if (!taken) return std::nullopt;
    std::int64_t number = 0;
    const char* const last = taken->data() + taken->size();
    const auto [end, error] = std::from_chars(taken->data(), last, number);
    if (error != std::errc() || end != last) return std::nullopt;
    return number;
}

std::optional<std::uint64_t> Words::bits() {
    const auto taken = word();
    if (!taken) return std::nullopt;
    std::uint64_t bits = 0;
    const char* const last = taken->data() + taken->size();
    const auto [end, error] = std::from_chars(taken->data(), last, bits, 16);
    if (error != std::errc() || end != last) return std::nullopt;
    return bits;
}

std::optional<property::Value> Words::value() {
    const auto taken = word();
    if (!taken || taken->size() % 2 != 0) return std::nullopt;
    std::vector<std::byte> bytes;
    for (std::size_t i = 0; i < taken->size(); i += 2) {
        const int high = digit((*taken)[i]), low = digit((*taken)[i + 1]);
        if (high < 0 || low < 0) return std::nullopt;
        bytes.push_back(static_cast<std::byte>(high * 16 + low));
    }
    try {
        property::ByteReader from(bytes);
        property::Value value = from.value();
        from.finish();
        return value;
    } catch (const property::Error&) {
        return std::nullopt;
    }
}

std::string event_text(const InputEvent& event, bool taken) {
    const int flags = event.control | event.shift << 1 | event.alt << 2 | event.repeated << 3 |
                      event.focused << 4 | taken << 5;
    return "event " + std::to_string(static_cast<int>(event.kind)) + " " + in_quotes(event.name) +
           " " + std::to_string(static_cast<std::uint32_t>(event.character)) + " " +
           exact(event.x) + " " + exact(event.y) + " " + exact(event.delta) + " " +
           std::to_string(event.gamepad) + " " + std::to_string(flags);
}

std::optional<std::pair<InputEvent, bool>> parse_event(Words& words) {
    const auto kind = words.integer();
    const auto name = words.text();
    const auto character = words.integer();
    const auto x = words.number(), y = words.number(), delta = words.number();
    const auto gamepad = words.integer(), flags = words.integer();
    if (!kind || !name || !character || !x || !y || !delta || !gamepad || !flags || *kind < 0 ||
        *kind > static_cast<int>(EventKind::gamepad_disconnected))
        return std::nullopt;
    InputEvent event;
    event.kind = static_cast<EventKind>(*kind);
    event.name = *name;
    event.character = static_cast<char32_t>(*character);
    event.x = static_cast<float>(*x);
    event.y = static_cast<float>(*y);
    event.delta = static_cast<float>(*delta);
    event.gamepad = static_cast<int>(*gamepad);
    event.control = (*flags & 1) != 0;
    event.shift = (*flags & 2) != 0;
    event.alt = (*flags & 4) != 0;
    event.repeated = (*flags & 8) != 0;
    event.focused = (*flags & 16) != 0;
    return std::pair(event, (*flags & 32) != 0);
}

}  // namespace fettle::app
