// Parsing and resolving of paths.

#include <fettle/property/path.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>

#include <fettle/property/error.h>
#include <fettle/property/spelling.h>
#include <fettle/property/tree.h>

#include "names_above.h"
#include "quoting.h"

namespace fettle::property {
namespace {

bool starts_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool in_name(char c) {
    return starts_name(c) || (c >= '0' && c <= '9');
}

constexpr std::string_view reserved[] = {"and",   "break", "do",       "else", "elseif", "end",
                                         "false", "for",   "function", "goto", "if",     "in",
                                         "local", "nil",   "not",      "or",   "repeat", "return",
                                         "then",  "true",  "until",    "while"};

class PathParser {
  public:
    explicit PathParser(std::string_view text) : text_(text) {}

    std::vector<Segment> run() {
        std::vector<Segment> segments;
        if (text_.empty()) fail("it is empty");
        if (text_[0] != '[') segments.push_back(name());
        while (at_ < text_.size()) {
            if (segments.size() >= most_names)  // without the text, which is long
                throw Error(ErrorKind::bad_path,
                            "a path has at most " + std::to_string(most_names) + " names");
            if (text_[at_] == '.') {
                ++at_;
                segments.push_back(name());
            } else if (text_[at_] == '[') {
                ++at_;
                segments.push_back(bracketed());
            } else {
                fail(std::string("unexpected \"") + text_[at_] + "\"");
            }
        }
        const auto* first = std::get_if<std::string>(&segments.front().key);
        if (first != nullptr && *first == "game") segments.erase(segments.begin());
        return segments;
    }

  private:
    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(ErrorKind::bad_path, "\"" + std::string(text_) +
                                             "\" is not a path: at character " +
                                             std::to_string(at_ + 1) + ": " + reason);
    }

    /// Other letters are in names, too, but not after a dot.
    std::string name_expected() const {
        std::size_t end = at_;
        while (end < text_.size() && (in_name(text_[end]) || (text_[end] & 0x80) != 0)) ++end;
        std::string expected = "a name was expected";
        if (end > at_)
            expected += " (write [\"" + std::string(text_.substr(at_, end - at_)) +
                        "\"]: a name after a dot has the letters a to z)";
        return expected;
    }

    Segment name() {
        const std::size_t from = at_;
        if (at_ >= text_.size() || !starts_name(text_[at_])) fail(name_expected());
        while (at_ < text_.size() && in_name(text_[at_])) ++at_;
        return {std::string(text_.substr(from, at_ - from))};
    }

    Segment bracketed() {
        if (at_ < text_.size() && text_[at_] == '"') return quoted();
        std::int64_t index = 0;
        const auto [end, error] =
            std::from_chars(text_.data() + at_, text_.data() + text_.size(), index);
        if (error != std::errc()) fail("an index or a quoted name was expected");
        at_ = static_cast<std::size_t>(end - text_.data());
        close();
        return {index};
    }

    Segment quoted() {
        std::string name;
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
            name += text_[at_] == '\\' ? unescaped(text_, at_) : text_[at_];
        }
        if (at_ >= text_.size()) fail("the quote is not closed");
        ++at_;
        close();
        return {name};
    }

    void close() {
        if (at_ >= text_.size() || text_[at_] != ']') fail("\"]\" was expected");
        ++at_;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

std::string segment_text(const Segment& segment) {
    return segment.is_index() ? "[" + std::to_string(std::get<std::int64_t>(segment.key)) + "]"
                              : path_suffix(std::get<std::string>(segment.key));
}

// Index of a component of a vec2 or a color, or -1.
int component_index(Type type, const std::string& name) {
    const std::string_view names = type == Type::vec2 ? "xy" : type == Type::color ? "rgba" : "";
    if (name.size() != 1) return -1;
    const std::size_t at = names.find(name[0]);
    return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

[[noreturn]] void no_part(const Value& whole, const Segment& segment, const std::string& what) {
    std::string has = " has no parts";
    if (whole.is(Type::vec2)) has = " has the parts x and y";
    if (whole.is(Type::color)) has = " has the parts r, g, b and a";
    if (whole.is(Type::list)) has = " has the elements 1 to " + std::to_string(whole.list().size());
    throw Error(ErrorKind::unknown_name, what + ": " + with_article(type_name(whole.type())) + has +
                                             ", not " + segment_text(segment));
}

}  // namespace

bool is_identifier(std::string_view name) {
    return !name.empty() && starts_name(name.front()) &&
           std::all_of(name.begin(), name.end(), in_name) &&
           std::find(std::begin(reserved), std::end(reserved), name) == std::end(reserved);
}

void check_name_length(std::string_view name) {
    if (name.size() <= longest_name) return;
    throw Error(ErrorKind::bad_name, "the name \"" + std::string(name.substr(0, 40)) +
                                         "...\" has " + std::to_string(name.size()) +
                                         " bytes, and a name has at most " +
                                         std::to_string(longest_name));
}

std::string path_suffix(std::string_view name) {
    if (is_identifier(name)) return "." + std::string(name);
    std::string out = "[\"";
    for (std::size_t i = 0; i < name.size();) append_escaped(out, name, i);
    return out + "\"]";
}

std::vector<Segment> parse_path(std::string_view text) {
    return PathParser(text).run();
}

Place resolve(const Tree& tree, std::string_view path) {
    const std::vector<Segment> segments = parse_path(path);
    Place place{.instance = tree.root(), .property = nullptr, .part = {}};
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const auto* name = std::get_if<std::string>(&segments[i].key);
        if (place.property != nullptr) {
            place.part.push_back(segments[i]);
            continue;
        }
        if (name == nullptr)
            throw Error(ErrorKind::bad_path,
                        tree.path(place.instance) + " is an instance: an index like " +
                            segment_text(segments[i]) + " does not apply to it");
        if (const Handle child = tree.child(place.instance, *name)) {
            place.instance = child;
            continue;
        }
        const Property& property = tree.property(place.instance, *name);
        // If the path continues, a reference is followed.
        const bool may_refer = property.type == Type::reference || property.any_type;
        if (may_refer && i + 1 < segments.size()) {
            const Value value = tree.get(place.instance, property);
            if (value.is(Type::reference)) {
                tree.require(value.reference());
                place.instance = value.reference();
                continue;
            }
        }
        place.property = &property;
    }
    return place;
}

Value part_of(const Value& whole, const std::vector<Segment>& part, const std::string& what) {
    Value value = whole;
    for (const Segment& segment : part) {
        if (segment.is_index() && value.is(Type::list)) {
            const std::int64_t index = std::get<std::int64_t>(segment.key);
            if (index < 1 || index > static_cast<std::int64_t>(value.list().size()))
                no_part(value, segment, what);
            value = Value(value.list()[static_cast<std::size_t>(index - 1)]);
            continue;
        }
        const int component =
            segment.is_index() ? -1
                               : component_index(value.type(), std::get<std::string>(segment.key));
        if (component < 0) no_part(value, segment, what);
        if (value.is(Type::vec2)) {
            value = value.vec2()[component];
        } else {
            const Color c = value.color();
            value = std::array{c.r, c.g, c.b, c.a}[static_cast<std::size_t>(component)];
        }
    }
    return value;
}

Value with_part(const Value& whole, const std::vector<Segment>& part, const Value& value,
                const std::string& what) {
    if (part.empty()) return value;
    const Segment& segment = part.front();
    const std::vector<Segment> rest(part.begin() + 1, part.end());
    if (segment.is_index() && whole.is(Type::list)) {
        List list = whole.list();
        const std::int64_t index = std::get<std::int64_t>(segment.key);
        const auto size = static_cast<std::int64_t>(list.size());
        if (index < 1 || index > size + 1 || (index == size + 1 && !rest.empty()))
            no_part(whole, segment, what);
        if (index == size + 1)
            list.push_back(value);
        else
            list[static_cast<std::size_t>(index - 1)] =
                with_part(list[static_cast<std::size_t>(index - 1)], rest, value, what);
        return list;
    }
    const int component =
        segment.is_index() ? -1 : component_index(whole.type(), std::get<std::string>(segment.key));
    if (component < 0 || !rest.empty()) no_part(whole, segment, what);
    if (!value.is_numeric())
        throw Error(ErrorKind::wrong_type,
                    what + segment_text(segment) + ": expected a number, got " +
                        std::string(type_name(value.type())) + " " + value_text(value));
    if (whole.is(Type::vec2)) {
        Vec2 v = whole.vec2();
        v[component] = value.as_double();
        return v;
    }
    Color c = whole.color();
    float* const channels[] = {&c.r, &c.g, &c.b, &c.a};
    *channels[component] = static_cast<float>(value.as_double());
    return c;
}

Value get(const Tree& tree, std::string_view path) {
    const Place place = resolve(tree, path);
    if (place.property == nullptr) return place.instance;
    return part_of(tree.get(place.instance, *place.property), place.part,
                   tree.path(place.instance, *place.property));
}

void set(Tree& tree, std::string_view path, const Value& value) {
    const Place place = resolve(tree, path);
    if (place.property == nullptr)
        throw Error(ErrorKind::wrong_type,
                    tree.path(place.instance) + " is an instance, not a property");
    const std::string what = tree.path(place.instance, *place.property);
    if (place.part.empty()) return tree.set(place.instance, *place.property, value);
    tree.set(place.instance, *place.property,
             with_part(tree.get(place.instance, *place.property), place.part, value, what));
}

}  // namespace fettle::property
