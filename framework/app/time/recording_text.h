#pragma once
// The text format of a recording: one item on each line, texts in quotes, numbers exact.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <fettle/app/event.h>
#include <fettle/property/value.h>

namespace fettle::app {

/// The number of the format, which changes with the lines and with the data that their hashes
/// cover.
constexpr std::int64_t recording_format = 5;

/// Adds double quotes and escapes line breaks, quotes, backslashes and control characters.
std::string in_quotes(std::string_view text);
/// Hexadecimal, which is exact.
std::string exact(double number);
std::string hex(std::uint64_t bits);
std::string encoded(const property::Value& value);

/// Reads words from the front of a line. Each function returns nothing if the next word has another
/// form.
class Words {
  public:
    explicit Words(std::string_view line) : rest_(line) {}
    std::optional<std::string> word();
    std::optional<std::string> text();
    std::optional<double> number();
    std::optional<std::int64_t> integer();
    std::optional<std::uint64_t> bits();
    std::optional<property::Value> value();
    bool at_end();

  private:
    void skip();
    std::string_view rest_;
};

std::string event_text(const InputEvent& event, bool taken);
std::optional<std::pair<InputEvent, bool>> parse_event(Words& words);

}  // namespace fettle::app
