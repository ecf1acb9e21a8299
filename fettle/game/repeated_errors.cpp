#include <game/repeated_errors.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace fettle::program {

namespace {

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// "main.lua:12" of "main.lua:12: no such name"; the whole message if it names no place.
std::string place_or_message(std::string_view message) {
    const std::size_t number = message.find(':') + 1;
    if (number == 0) return std::string(message);
    const auto after = std::find_if_not(message.begin() + static_cast<std::ptrdiff_t>(number),
                                        message.end(), is_digit);
    const auto end = static_cast<std::size_t>(after - message.begin());
    const bool placed = end > number && end < message.size() && message[end] == ':';
    return std::string(placed ? message.substr(0, end) : message);
}

}  // namespace

bool RepeatedErrors::first(const script::ScriptError& error) {
    if (error.context == "chunk") return true;
    const auto [place, added] = places_.try_emplace(place_or_message(error.message));
    if (added) return true;
    ++place->second.further;
    place->second.last = error.context;
    return false;
}

std::vector<std::string> RepeatedErrors::take() {
    std::vector<std::string> sentences;
    for (const auto& [name, place] : places_) {
        if (place.further == 0) continue;
        const std::string times =
            place.further == 1 ? "once more" : std::to_string(place.further) + " more times";
        sentences.push_back(name + ": the same error " + times + ", last in " + place.last);
    }
    places_.clear();
    return sentences;
}

}  // namespace fettle::program
