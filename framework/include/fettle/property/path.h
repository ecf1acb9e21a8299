#pragma once
// Paths: `world.ball.velocity.x`, `world["my ball"].vertices[2]`, and patterns: `world.*.velocity`,
// `world.**`.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// One step of a path: a name or a list index (from 1).
struct Segment {
    /// A name or an index from 1.
    std::variant<std::string, std::int64_t> key;
    bool is_index() const {
        return std::holds_alternative<std::int64_t>(key);
    }  ///< whether it is an index
};

/// Throws Error(bad_path) with the position of the error. A leading `game.` may be omitted; "game"
/// alone is the root.
std::vector<Segment> parse_path(std::string_view text);

/// The text of `name` in a path after its parent: `.ball`, or `["my ball"]` if it is not an
/// identifier.
std::string path_suffix(std::string_view name);
/// Letters, digits and underscores, not beginning with a digit, not a reserved word of Lua.
bool is_identifier(std::string_view name);
constexpr std::size_t longest_name = 1000;  ///< bytes; of an instance, a property, a class, an edit
/// Throws Error(bad_name) if a name has more than `longest_name` bytes.
void check_name_length(std::string_view name);

/// The target of a path: an instance; a property of it; or a part of a property's value.
struct Place {
    Handle instance;                     ///< that has the property
    const Property* property = nullptr;  // nullptr: the instance itself
    std::vector<Segment> part;           // "x", "y", "r", "g", "b", "a" or indices into a list
};

/// Throws Error(unknown_name) with the nearest spelling, Error(bad_path), Error(deleted).
Place resolve(const Tree& tree, std::string_view path);
/// A component or an element of a value. Throws as above; `what`: the path for the message.
Value part_of(const Value& whole, const std::vector<Segment>& part, const std::string& what);
/// `whole` with that part replaced. One past the end of a list appends.
Value with_part(const Value& whole, const std::vector<Segment>& part, const Value& value,
                const std::string& what);

// By path. Throw property::Error.
/// The value at a path. Throws Error with the nearest spelling.
Value get(const Tree& tree, std::string_view path);
/// Writes the value at a path, as `Tree::set` does.
void set(Tree& tree, std::string_view path, const Value& value);

/// A pattern for instances and optionally a property: `*` is any one name (or part of one:
/// `ball_*`), `**` any number of levels, also none. `world.**` is every property of everything
/// below the world.
class Pattern {
  public:
    /// Throws Error(bad_path).
    explicit Pattern(std::string_view text);
    const std::string& text() const { return text_; }  ///< as it was given
    /// Names of the pattern; each may contain stars.
    const std::vector<std::string>& segments() const { return segments_; }
    /// Whether the pattern matches the path.
    bool matches(const Tree& tree, Handle instance, const Property& property) const;
    bool matches(const Tree& tree, Handle instance) const;
    /// `names`: the names of a path, without the root; they need not exist.
    bool matches(const std::vector<std::string>& names) const;
    /// False if no property of this name can match. Cheap, so that changes can be skipped early.
    bool may_match(Symbol property) const;
    /// The only property name that can match; empty if several may match.
    Symbol only_property() const;

  private:
    std::string text_;
    std::vector<std::string> segments_;
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
