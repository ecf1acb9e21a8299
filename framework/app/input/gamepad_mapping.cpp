#include <charconv>
#include <stdexcept>
#include <vector>

#include <fettle/property/spelling.h>

#include <input/gamepad_mapping.h>
#include <input/index_among.h>

namespace fettle::app {

namespace {

struct Controller {
    std::string_view name;
    std::string_view maker;  // hexadecimal digits; "": every other maker
    std::string_view mapping;
};

// Buttons and axes have the numbers that Linux's drivers give them: hid-playstation and hid-sony;
// hid-nintendo; xpad.
constexpr std::array<Controller, 3> controllers{{
    {"playstation", "054c",
     "a:b0,b:b1,y:b2,x:b3,leftshoulder:b4,rightshoulder:b5,back:b8,start:b9,guide:b10,"
     "leftstick:b11,rightstick:b12,dpup:h0.1,dpright:h0.2,dpdown:h0.4,dpleft:h0.8,leftx:a0,"
     "lefty:a1,lefttrigger:a2,rightx:a3,righty:a4,righttrigger:a5"},
    {"switch_pro", "057e",
     "a:b0,b:b1,y:b2,x:b3,leftshoulder:b5,rightshoulder:b6,lefttrigger:b7,righttrigger:b8,back:b9,"
     "start:b10,guide:b11,leftstick:b12,rightstick:b13,dpup:h0.1,dpright:h0.2,dpdown:h0.4,"
     "dpleft:h0.8,leftx:a0,lefty:a1,rightx:a3,righty:a4"},
    {"xbox", "",
     "a:b0,b:b1,x:b2,y:b3,leftshoulder:b4,rightshoulder:b5,back:b6,start:b7,guide:b8,leftstick:b9,"
     "rightstick:b10,dpup:h0.1,dpright:h0.2,dpdown:h0.4,dpleft:h0.8,leftx:a0,lefty:a1,"
     "lefttrigger:a2,rightx:a3,righty:a4,righttrigger:a5"},
}};

// The names of the format, in the order of `gamepad_button_names` and of `PadTarget`.
constexpr std::array<std::string_view, 15> button_entries{
    "a",     "b",         "x",          "y",    "leftshoulder", "rightshoulder", "back",  "start",
    "guide", "leftstick", "rightstick", "dpup", "dpright",      "dpdown",        "dpleft"};
constexpr std::array<std::string_view, pad_targets> target_entries{
    "leftx", "lefty", "rightx", "righty", "lefttrigger", "righttrigger"};
// Entries that mappings of other programs contain and that have no meaning here.
constexpr std::array<std::string_view, 16> ignored_entries{
    "platform", "crc",     "type",    "face",    "hint",    "misc1",    "misc2", "misc3",
    "misc4",    "paddle1", "paddle2", "paddle3", "paddle4", "touchpad", "sdk",   "name"};

std::optional<int> number_in(std::string_view digits, int largest) {
    int number = 0;
    const auto [end, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (problem != std::errc() || end != digits.data() + digits.size() || number < 0 ||
        number > largest)
        return std::nullopt;
    return number;
}

/// "b3", "a2", "-a1", "a4~", "h0.8"; nothing if it is malformed.
std::optional<PadSource> parse_source(std::string_view text) {
    PadSource source;
    if (!text.empty() && (text[0] == '+' || text[0] == '-')) {
        source.half = text[0] == '+' ? 1 : -1;
        text.remove_prefix(1);
    }
    if (text.size() > 1 && text.back() == '~') {
        source.inverted = true;
        text.remove_suffix(1);
    }
    if (text.size() < 2) return std::nullopt;
    const char kind = text[0];
    text.remove_prefix(1);
    const bool plain = source.half == 0 && !source.inverted;
    std::optional<int> index;
    if (kind == 'b' && plain) {
        source.kind = PadSource::Kind::button;
        index = number_in(text, 15);
    } else if (kind == 'a') {
        source.kind = PadSource::Kind::axis;
        index = number_in(text, 7);
    } else if (kind == 'h' && plain && text.starts_with("0.")) {
        source.kind = PadSource::Kind::hat;
        index = number_in(text.substr(2), 8);
        if (index && *index != 1 && *index != 2 && *index != 4 && *index != 8) index.reset();
    }
    if (!index) return std::nullopt;
    source.index = *index;
    return source;
}

[[noreturn]] void refuse_entry(std::string_view name) {
    std::vector<std::string> known(button_entries.begin(), button_entries.end());
    known.insert(known.end(), target_entries.begin(), target_entries.end());
    throw std::invalid_argument("no part of a gamepad is called \"" + std::string(name) + "\"" +
                                property::suggestion(name, known));
}

void read_entry(GamepadMapping& mapping, std::string_view entry) {
    const std::size_t colon = entry.find(':');
    std::string_view name = entry.substr(0, colon);
    if (index_among(ignored_entries, name)) return;
    const std::optional<PadSource> source = parse_source(entry.substr(colon + 1));
    if (!source)
        throw std::invalid_argument(
            "\"" + std::string(entry) +
            "\" is not an entry of a mapping: expected a name and b0 to b15, a0 "
            "to a7 or h0.1, h0.2, h0.4, h0.8, as in a:b0 or leftx:a0");
    if (const auto button = index_among(button_entries, name))
        mapping.buttons[*button] = *source;
    else if (const auto target = index_among(target_entries, name))
        mapping.targets[*target] = *source;
    else
        refuse_entry(name);
}

[[noreturn]] void refuse_controller(std::string_view name) {
    std::vector<std::string> known;
    known.reserve(controllers.size());
    for (const Controller& each : controllers) known.emplace_back(each.name);
    throw std::invalid_argument("\"" + std::string(name) +
                                "\" is neither a known controller nor an entry such as a:b0" +
                                property::suggestion(name, known));
}

const Controller* controller_named(std::string_view name) {
    for (const Controller& each : controllers)
        if (each.name == name) return &each;
    return nullptr;
}

}  // namespace

std::string_view controller_of(std::string_view device) {
    const std::string_view maker = device.substr(0, device.find(':'));
    for (const Controller& each : controllers)
        if (!each.maker.empty() && each.maker == maker) return each.name;
    return "xbox";
}

GamepadMapping parse_gamepad_mapping(std::string_view text) {
    if (const Controller* known = controller_named(text)) text = known->mapping;
    GamepadMapping mapping;
    std::size_t begin = 0, place = 0;
    bool any = false;
    while (begin < text.size()) {
        const std::size_t comma = text.find(',', begin);
        const std::size_t end = comma == std::string_view::npos ? text.size() : comma;
        const std::string_view entry = text.substr(begin, end - begin);
        begin = end + 1;
        const bool named = entry.find(':') != std::string_view::npos;
        // A line of a mapping file begins with the number and the name of the device.
        const bool heading = place++ < 2 && !named && begin < text.size();
        if (heading || entry.empty()) continue;
        if (!named) refuse_controller(entry);
        read_entry(mapping, entry);
        any = true;
    }
    if (!any) throw std::invalid_argument("a mapping has one entry at least, such as a:b0");
    return mapping;
}

}  // namespace fettle::app
