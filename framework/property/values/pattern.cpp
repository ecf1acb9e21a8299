// Patterns over paths: `*` within one name, `**` over any number of them.

#include <algorithm>

#include <fettle/property/error.h>
#include <fettle/property/path.h>
#include <fettle/property/tree.h>

#include "names_above.h"
#include "quoting.h"

namespace fettle::property {
namespace {

// Whether `name` matches `pattern`, in which `*` stands for any characters. After a mismatch only
// the last star is extended.
bool fits(std::string_view pattern, std::string_view name) {
    std::size_t p = 0, n = 0, star = std::string_view::npos, mark = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            mark = n;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++mark;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

std::vector<std::string> split(std::string_view text) {
    const auto fail = [text](const std::string& reason) {
        throw Error(ErrorKind::bad_path,
                    "\"" + std::string(text) + "\" is not a pattern: " + reason);
    };
    std::vector<std::string> segments;
    std::size_t at = 0;
    while (at < text.size()) {
        std::string segment;
        if (text[at] == '[') {
            if (at + 1 >= text.size() || text[at + 1] != '"')
                fail("a quoted name was expected after \"[\"");
            for (at += 2; at < text.size() && text[at] != '"'; ++at) {
                segment += text[at] == '\\' ? unescaped(text, at) : text[at];
            }
            if (text.substr(at, 2) != "\"]") fail("\"]\" was expected");
            at += 2;
        } else {
            while (at < text.size() && text[at] != '.' && text[at] != '[' && text[at] != '"')
                segment += text[at++];
            if (at < text.size() && text[at] == '"') fail("a quoted name stands in brackets");
            if (segment.size() > 2 && segment.find_first_not_of('*') == std::string::npos)
                fail("\"" + segment + "\" is no name: * stands for one name, ** for any number");
        }
        if (segment.empty()) fail("a name is missing");
        segments.push_back(std::move(segment));
        if (segments.size() > most_names)  // without the text, which is long
            throw Error(ErrorKind::bad_path,
                        "a pattern has at most " + std::to_string(most_names) + " names");
        if (at < text.size() && text[at] == '.') {
            if (++at == text.size()) fail("it ends with a dot");
        } else if (at < text.size() && text[at] != '[') {
            fail("\".\" was expected after \"]\"");
        }
    }
    if (segments.empty()) fail("it is empty");
    if (segments.front() == "game" && segments.size() > 1) segments.erase(segments.begin());
    return segments;
}

}  // namespace

std::vector<std::string> names_above(const Tree& tree, Handle instance) {
    std::vector<std::string> names;
    Handle at = instance;
    for (; at && at != tree.root(); at = tree.parent(at)) names.push_back(tree.name(at));
    if (!at) return {};  // a detached instance has no path
    std::reverse(names.begin(), names.end());
    return names;
}

Pattern::Pattern(std::string_view text) : text_(text), segments_(split(text)) {}

bool Pattern::matches(const std::vector<std::string>& names) const {
    // The same algorithm as in `fits`, but for names: after a mismatch only the last `**` is
    // extended.
    std::size_t p = 0, n = 0, star = std::string::npos, mark = 0;
    while (n < names.size()) {
        if (p < segments_.size() && segments_[p] == "**") {
            star = p++;
            mark = n;
        } else if (p < segments_.size() && fits(segments_[p], names[n])) {
            ++p;
            ++n;
        } else if (star != std::string::npos) {
            p = star + 1;
            n = ++mark;
        } else {
            return false;
        }
    }
    while (p < segments_.size() && segments_[p] == "**") ++p;
    return p == segments_.size();
}

bool Pattern::matches(const Tree& tree, Handle instance, const Property& property) const {
    if (!may_match(property.symbol)) return false;
    if (std::find(segments_.begin(), segments_.end(), "**") == segments_.end()) {
        // Compares from the lowest name upwards, which excludes most instances without collecting
        // all names above them.
        std::size_t left = segments_.size() - 1;
        Handle at = instance;
        for (; at && at != tree.root(); at = tree.parent(at)) {
            if (left == 0) return false;
            const std::string& segment = segments_[--left];
            if (segment != "*" && !fits(segment, tree.name(at))) return false;
        }
        return at && left == 0;
    }
    std::vector<std::string> names = names_above(tree, instance);
    if (names.empty() && instance != tree.root()) return false;
    names.push_back(property.name);
    return matches(names);
}

bool Pattern::matches(const Tree& tree, Handle instance) const {
    const std::vector<std::string> names = names_above(tree, instance);
    return !(names.empty() && instance != tree.root()) && matches(names);
}

Symbol Pattern::only_property() const {
    const std::string& last = segments_.back();
    return last.find('*') == std::string::npos ? Symbol(last) : Symbol();
}

bool Pattern::may_match(Symbol property) const {
    return segments_.back() == "**" || fits(segments_.back(), property.text());
}

}  // namespace fettle::property
