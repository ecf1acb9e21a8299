#pragma once
// Typed access to the fields of a document, with defaults, and errors that name file and place.
// Numbers and booleans may be texts, as they are in XML.

#include <cstdint>
#include <optional>
#include <string>

#include <fettle/maps/map.h>

#include "document.h"

namespace fettle::maps {

/// An object of a document, and what it is in messages: `layer "ground"`.
struct Place {
    const std::string& file;
    const Json& json;
    std::string what;

    [[noreturn]] void fail(const std::string& message) const;
    /// The place of a member, with the same name in messages.
    Place at(const Json& member) const { return {file, member, what}; }

    bool has(const char* key) const { return json.contains(key); }
    double number(const char* key, double default_value) const;
    /// Throws for numbers out of the range.
    std::int64_t integer(const char* key, std::int64_t default_value, std::int64_t min,
                         std::int64_t max) const;
    bool boolean(const char* key, bool default_value) const;
    std::string text(const char* key, const std::string& default_value = {}) const;
    property::Color color(const char* key, property::Color default_value) const;
    /// The color of the pixels of an image that are not seen.
    std::optional<property::Color> transparent_color() const;
    /// An empty list if there is none. Throws if the member is not a list.
    const Json& list(const char* key) const;
    Properties properties() const;
};

/// "#rrggbb" or "#aarrggbb".
property::Color parse_color(const Place& place, const std::string& text);

}  // namespace fettle::maps
