#include "fields.h"

#include <charconv>
#include <cmath>

namespace fettle::maps {

namespace {

using property::Color;
using property::Value;

const Json no_list = Json::array();

template <class T>
bool parse(const std::string& text, T& value) {
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && rest == end;
}

void add_properties(const Place& place, const Json& list, const std::string& prefix, int depth,
                    Properties& all);

/// A member of a class without a declared type has the type of its JSON value.
void add_value(const Place& place, const std::string& name, const std::string& type,
               const Json& value, int depth, Properties& all) {
    constexpr int max_depth = 64;
    if (depth > max_depth) place.fail("properties are nested too deep");
    const Place here{place.file, value, place.what + ", property \"" + name + "\""};
    if (value.is_object()) {
        if (value.contains("properties"))
            return add_properties(place, value["properties"], name + ".", depth + 1, all);
        for (const auto& [member, content] : value.items())
            add_value(place, name + "." + member, {}, content, depth + 1, all);
        return;
    }
    const Json one = {{"value", value}};
    const Place field = here.at(one);
    if (type == "bool" || (type.empty() && value.is_boolean()))
        all[name] = Value(field.boolean("value", false));
    else if (type == "int" || type == "object" || (type.empty() && value.is_number_integer()))
        all[name] = Value(field.integer("value", 0, INT64_MIN, INT64_MAX));
    else if (type == "float" || (type.empty() && value.is_number()))
        all[name] = Value(field.number("value", 0));
    else if (type == "color")
        all[name] = Value(field.color("value", Color{0, 0, 0, 0}));
    else
        all[name] = Value(field.text("value"));
}

void add_properties(const Place& place, const Json& list, const std::string& prefix, int depth,
                    Properties& all) {
    if (!list.is_array()) place.fail("\"properties\" is not a list");
    for (const Json& one : list) {
        const Place property = place.at(one);
        if (!one.is_object()) place.fail("a property is not an object");
        const std::string name = property.text("name");
        const auto value = one.find("value");
        if (value == one.end()) place.fail("property \"" + name + "\" has no value");
        add_value(place, prefix + name, property.text("type", "string"), *value, depth, all);
    }
}

}  // namespace

void Place::fail(const std::string& message) const {
    maps::fail(file, what.empty() ? message : what + ": " + message);
}

double Place::number(const char* key, double default_value) const {
    const auto found = json.find(key);
    if (found == json.end()) return default_value;
    double value = 0;
    if (found->is_number())
        value = found->get<double>();
    else if (!found->is_string() || !parse(found->get_ref<const std::string&>(), value))
        fail("\"" + std::string(key) + "\": expected a number, got " + found->dump().substr(0, 60));
    if (!std::isfinite(value)) fail("\"" + std::string(key) + "\": expected a finite number");
    return value;
}

std::int64_t Place::integer(const char* key, std::int64_t default_value, std::int64_t min,
                            std::int64_t max) const {
    const auto found = json.find(key);
    if (found == json.end()) return default_value;
    std::int64_t value = 0;
    bool known = true;
    if (found->is_number_unsigned())
        known = found->get<std::uint64_t>() <= static_cast<std::uint64_t>(INT64_MAX) &&
                ((value = found->get<std::int64_t>()), true);
    else if (found->is_number_integer())
        value = found->get<std::int64_t>();
    else
        known = found->is_string() && parse(found->get_ref<const std::string&>(), value);
    if (!known || value < min || value > max)
        fail("\"" + std::string(key) + "\": expected an integer from " + std::to_string(min) +
             " to " + std::to_string(max) + ", got " + found->dump().substr(0, 60));
    return value;
}

bool Place::boolean(const char* key, bool default_value) const {
    const auto found = json.find(key);
    if (found == json.end()) return default_value;
    if (found->is_boolean()) return found->get<bool>();
    if (*found == "1" || *found == "true") return true;
    if (*found == "0" || *found == "false") return false;
    fail("\"" + std::string(key) + "\": expected true or false, got " +
         found->dump().substr(0, 60));
}

std::string Place::text(const char* key, const std::string& default_value) const {
    const auto found = json.find(key);
    if (found == json.end() || found->is_null()) return default_value;
    if (!found->is_string())
        fail("\"" + std::string(key) + "\": expected a text, got " + found->dump().substr(0, 60));
    return found->get<std::string>();
}

Color Place::color(const char* key, Color default_value) const {
    const std::string written = text(key);
    return written.empty() ? default_value : parse_color(*this, written);
}

const Json& Place::list(const char* key) const {
    const auto found = json.find(key);
    if (found == json.end()) return no_list;
    if (!found->is_array()) fail("\"" + std::string(key) + "\" is not a list");
    return *found;
}

Properties Place::properties() const {
    Properties all;
    if (has("properties")) add_properties(*this, json["properties"], {}, 0, all);
    return all;
}

std::optional<Color> Place::transparent_color() const {
    const std::string written = text("transparentcolor");
    if (written.empty()) return std::nullopt;
    return parse_color(*this, written);
}

Color parse_color(const Place& place, const std::string& text) {
    const std::string digits = text.starts_with('#') ? text.substr(1) : text;
    std::uint32_t bits = 0;
    const auto [rest, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), bits, 16);
    if ((digits.size() != 6 && digits.size() != 8) || error != std::errc() ||
        rest != digits.data() + digits.size())
        place.fail("expected a color such as #ff8800, got \"" + text.substr(0, 60) + "\"");
    if (digits.size() == 6) bits |= 0xff000000u;
    const auto channel = [&](int shift) {
        return static_cast<float>(bits >> shift & 0xff) / 255.0f;
    };
    return {channel(16), channel(8), channel(0), channel(24)};
}

}  // namespace fettle::maps
