// What stands before the cursor is walked without running any of it: no function is called and no
// metamethod of a script.

#include "complete.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <unordered_set>

#include <fettle/property/error.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include "format.h"
#include "fuzzy.h"
#include "generic_methods.h"
#include "globals.h"
#include "help.h"
#include "instance.h"
#include "machine.h"
#include "methods.h"
#include "protected.h"
#include "script_classes.h"

namespace fettle::script {

using property::Class;
using property::Handle;
using property::Property;

namespace {

constexpr std::size_t most_candidates = 200;

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// Groups in a list without anything typed: what an instance holds, then what it can do.
enum class Group : int { value, function, other };

class Candidates {
  public:
    Candidates(std::string_view typed, std::size_t replace_from)
        : typed_(typed), replace_from_(replace_from) {}

    void add(const std::string& label, std::string detail, std::string doc, Group group) {
        add_as(label, label, replace_from_, std::move(detail), std::move(doc), group);
    }
    void add_as(const std::string& label, const std::string& text, std::size_t from,
                std::string detail, std::string doc, Group group) {
        int score = fuzzy_score(typed_, label);
        if (score == 0) return;
        if (expected_) score += 10'000;
        if (entries_.size() >= most_collected || !labels_.insert(label).second) return;
        entries_.push_back({score, group, {text, label, std::move(detail), std::move(doc), from}});
    }
    /// What is added until the next call is what belongs here, ahead of everything else.
    void expect(bool expected) { expected_ = expected; }
    std::size_t replace_from() const { return replace_from_; }

    std::vector<Completion> take() {
        std::stable_sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
            if (a.score != b.score) return a.score > b.score;
            if (a.group != b.group) return a.group < b.group;
            return a.completion.label < b.completion.label;
        });
        if (entries_.size() > most_candidates) entries_.resize(most_candidates);
        std::vector<Completion> result;
        for (Entry& entry : entries_) result.push_back(std::move(entry.completion));
        return result;
    }

  private:
    struct Entry {
        int score;
        Group group;
        Completion completion;
    };
    std::string_view typed_;
    std::size_t replace_from_;
    // A world may have a hundred thousand children.
    static constexpr std::size_t most_collected = 20'000;
    std::vector<Entry> entries_;
    std::unordered_set<std::string> labels_;
    bool expected_ = false;
};

// --- What stands before the cursor

struct Scan {
    bool in_string = false;
    std::size_t string_start = 0;     // behind the quote
    std::vector<std::size_t> braces;  // unclosed `{` and `(`, outermost first
};

Scan scan(std::string_view text) {
    Scan result;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote) {
            if (c == '\\')
                ++i;
            else if (c == quote)
                quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
            result.string_start = i + 1;
        } else if (c == '{' || c == '(') {
            result.braces.push_back(i);
        } else if ((c == '}' || c == ')') && !result.braces.empty()) {
            result.braces.pop_back();
        }
    }
    result.in_string = quote != 0;
    return result;
}

std::size_t word_start(std::string_view text, std::size_t end) {
    while (end > 0 && is_word(text[end - 1])) --end;
    return end;
}

std::size_t skip_blanks_back(std::string_view text, std::size_t end) {
    while (end > 0 && std::isspace(static_cast<unsigned char>(text[end - 1]))) --end;
    return end;
}

// Start of the path expression (names, dots, brackets) that ends at `end`.
std::size_t path_start(std::string_view text, std::size_t end) {
    for (;;) {
        if (end > 0 && text[end - 1] == ']') {
            std::size_t open = end - 1;
            char quote = 0;
            while (open > 0) {
                const char c = text[--open];
                if (quote) {
                    if (c == quote) quote = 0;
                } else if (c == '"' || c == '\'') {
                    quote = c;
                } else if (c == '[') {
                    break;
                }
            }
            if (text[open] != '[') return end;
            end = open;
            continue;
        }
        const std::size_t word = word_start(text, end);
        if (word == end) return end;
        end = word;
        if (end > 0 && (text[end - 1] == '.' || text[end - 1] == ':'))
            --end;
        else
            return end;
    }
}

// One step down from the value on top; the new value replaces it. False when there is none.
bool descend(lua_State* L, Machine& machine, std::string_view name, lua_Integer index,
             const Property** read) {
    *read = nullptr;
    if (const auto* box = instance_at(L, -1)) {
        const Handle handle = box->handle;
        if (!machine.tree.alive(handle)) return false;
        lua_pop(L, 1);
        if (name.empty()) return false;
        if (const Handle child = machine.tree.child(handle, name)) {
            push_instance(L, child);
            return true;
        }
        if (const Property* property = machine.tree.find(handle, name)) {
            *read = property;
            push_value(L, machine.tree.peek(handle, *property));
            return true;
        }
        return false;
    }
    if (lua_type(L, -1) != LUA_TTABLE) return false;
    if (name.empty())
        lua_rawgeti(L, -1, index);
    else {
        lua_pushlstring(L, name.data(), name.size());
        lua_rawget(L, -2);
    }
    lua_remove(L, -2);
    return !lua_isnil(L, -1);
}

// Pushes what the path stands for; the property it ends in goes to `read`. Nothing is pushed when
// it stands for nothing.
bool push_path(lua_State* L, Machine& machine, std::string_view path, const Property** read) {
    *read = nullptr;
    std::size_t i = 0;
    while (i < path.size() && is_word(path[i])) ++i;
    if (i == 0) return false;
    const std::string first(path.substr(0, i));
    push_registry(L, machine.environment);
    lua_pushlstring(L, first.data(), first.size());
    lua_rawget(L, -2);
    lua_remove(L, -2);
    if (lua_isnil(L, -1)) {
        lua_pop(L, 1);
        if (first == "_")
            push_last_result(L, machine);
        else if (!push_known_global(L, machine, first))
            return false;
    }
    while (i < path.size()) {
        std::string name;
        lua_Integer index = 0;
        if (path[i] == '.' || path[i] == ':') {
            const std::size_t start = ++i;
            while (i < path.size() && is_word(path[i])) ++i;
            name = std::string(path.substr(start, i - start));
            if (name.empty()) return false;
        } else if (path[i] == '[') {
            const std::size_t end = path.find(']', i);
            if (end == std::string_view::npos) return false;
            std::string_view inside = path.substr(i + 1, end - i - 1);
            if (inside.size() >= 2 && (inside.front() == '"' || inside.front() == '\''))
                name = std::string(inside.substr(1, inside.size() - 2));
            else if (std::from_chars(inside.data(), inside.data() + inside.size(), index).ec !=
                     std::errc{})
                return false;
            i = end + 1;
        } else {
            return false;
        }
        if (!descend(L, machine, name, index, read)) return false;
    }
    return true;
}

// --- Candidates

std::string facts_with_value(const Machine& machine, Handle instance, const Property& property) {
    return cut(with_unit(machine, machine.tree.get(instance, property), property), 40) + " · " +
           property_facts(machine, property);
}

void add_functions(Machine& machine, const Class& of, Candidates& out) {
    for (const property::Method* method : of.methods())
        out.add(method->name, signature(*method), method->doc, Group::function);
    std::vector<std::string> functions;
    machine.classes->add_function_names(of, functions);
    for (const std::string& name : functions)
        out.add(name, "function of " + of.name(), {}, Group::function);
    for (const GenericMethod& method : generic_methods())
        out.add(method.name, std::string(method.name) + "(" + method.parameters + ")", method.doc,
                Group::function);
}

void add_instance(Machine& machine, Handle instance, bool methods_only, std::size_t separator,
                  Candidates& out) {
    const property::Tree& tree = machine.tree;
    if (!methods_only) {
        for (Handle child = tree.first_child(instance); child; child = tree.next_sibling(child)) {
            const std::string name = tree.name(child);
            const std::string& of = tree.class_of(child).name();
            if (property::is_identifier(name))
                out.add(name, of, tree.class_of(child).doc(), Group::value);
            else
                out.add_as(name, property::path_suffix(name), separator, of,
                           tree.class_of(child).doc(), Group::value);
        }
        for (const Property* property : tree.properties(instance)) {
            if (property->hidden) continue;
            out.add(property->name, facts_with_value(machine, instance, *property), property->doc,
                    Group::value);
        }
    }
    add_functions(machine, tree.class_of(instance), out);
}

void add_table(lua_State* L, int index, std::size_t separator, Candidates& out) {
    index = lua_absindex(L, index);
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING) continue;
        const std::string name = lua_tostring(L, -2);
        const Group group = lua_isfunction(L, -1) ? Group::function : Group::value;
        if (property::is_identifier(name))
            out.add(name, cut(short_text(L, -1), 50), {}, group);
        else
            out.add_as(name, property::path_suffix(name), separator, cut(short_text(L, -1), 50), {},
                       group);
    }
}

void add_methods_of_meta(lua_State* L, int index, std::initializer_list<const char*> fields,
                         Candidates& out) {
    for (const char* field : fields) out.add(field, {}, {}, Group::value);
    if (luaL_getmetafield(L, index, "methods") == LUA_TTABLE) {
        for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1))
            if (lua_type(L, -2) == LUA_TSTRING)
                out.add(lua_tostring(L, -2), {}, {}, Group::function);
        lua_pop(L, 1);
    }
}

// Members of the value on top.
void add_members(lua_State* L, Machine& machine, bool methods_only, std::size_t separator,
                 Candidates& out) {
    if (const auto* box = instance_at(L, -1)) {
        if (machine.tree.alive(box->handle))
            add_instance(machine, box->handle, methods_only, separator, out);
    } else if (const Class* of = class_object_at(L, -1)) {
        std::vector<std::string> names;
        machine.classes->add_function_names(*of, names);
        for (const std::string& name : names) out.add(name, {}, {}, Group::function);
        for (const char* name : {"on", "watch"}) out.add(name, {}, {}, Group::function);
        for (const char* name : {"name", "base", "doc"}) out.add(name, {}, {}, Group::other);
    } else if (vec_at(L, -1)) {
        add_methods_of_meta(L, lua_gettop(L), {"x", "y"}, out);
    } else if (color_at(L, -1)) {
        for (const char* name : {"r", "g", "b", "a"}) out.add(name, {}, {}, Group::value);
    } else if (lua_type(L, -1) == LUA_TSTRING) {
        push_registry(L, machine.environment);
        lua_getfield(L, -1, "string");
        add_table(L, -1, separator, out);
        lua_pop(L, 2);
    } else if (lua_type(L, -1) == LUA_TTABLE) {
        add_table(L, -1, separator, out);
        add_methods_of_meta(L, lua_gettop(L), {}, out);
    } else if (lua_type(L, -1) == LUA_TUSERDATA) {
        add_methods_of_meta(L, lua_gettop(L), {}, out);
    }
}

void add_globals(lua_State* L, Machine& machine, Candidates& out) {
    for (const std::string& name : global_names(machine)) {
        std::string detail, text_doc;
        if (const GlobalDoc* doc = global_doc(name)) {
            detail = doc->signature;
            text_doc = doc->doc;
        } else if (const Class* of = machine.tree.find_class(name)) {
            detail = "class";
            text_doc = of->doc();
        } else {
            const Property* read = nullptr;
            const int top = lua_gettop(L);
            if (push_path(L, machine, name, &read)) detail = cut(short_text(L, -1), 50);
            lua_settop(L, top);
        }
        const Group group = machine.tree.child(machine.tree.root(), name) || name == "game"
                                ? Group::value
                                : Group::other;
        if (name != "_G" && name != "_VERSION")
            out.add(name, std::move(detail), std::move(text_doc), group);
    }
    if (machine.tree.alive(machine.it))
        out.add("it", machine.tree.path(machine.it), "what is selected", Group::value);
    for (const char* word : {"and", "break",    "do",     "else", "elseif", "end",   "false",
                             "for", "function", "if",     "in",   "local",  "nil",   "not",
                             "or",  "repeat",   "return", "then", "true",   "until", "while"})
        out.add(word, {}, {}, Group::other);
}

void add_keys(Machine& machine, const Class& of, Candidates& out) {
    for (const Property* property : of.properties())
        if (!property->hidden && !property->read_only)
            out.add(property->name, property_facts(machine, *property), property->doc,
                    Group::value);
}

// The class whose constructor the cursor is in, at a place where a key may stand.
const Class* constructor_at(Machine& machine, std::string_view before, const Scan& scanned,
                            std::size_t token) {
    if (scanned.braces.empty() || before[scanned.braces.back()] != '{') return nullptr;
    const std::size_t previous = skip_blanks_back(before, token);
    if (previous == 0 ||
        (before[previous - 1] != '{' && before[previous - 1] != ',' && before[previous - 1] != ';'))
        return nullptr;
    std::size_t end = skip_blanks_back(before, scanned.braces.back());
    if (end > 0 && before[end - 1] == '(') end = skip_blanks_back(before, end - 1);
    return machine.tree.find_class(
        before.substr(word_start(before, end), end - word_start(before, end)));
}

// The property that a value at `end` would be assigned to or compared with: `path =`, or a key in a
// constructor.
const Property* assigned_property(lua_State* L, Machine& machine, std::string_view before,
                                  const Scan& scanned, std::size_t end) {
    end = skip_blanks_back(before, end);
    std::size_t signs = end;
    while (signs > 0 && (before[signs - 1] == '=' || before[signs - 1] == '~')) --signs;
    if (signs == end) return nullptr;
    const std::size_t path_end = skip_blanks_back(before, signs);
    const std::size_t start = path_start(before, path_end);
    const std::string_view path = before.substr(start, path_end - start);
    if (path.empty()) return nullptr;
    const Property* read = nullptr;
    const int top = lua_gettop(L);
    const bool found = push_path(L, machine, path, &read);
    lua_settop(L, top);
    if (found && read) return read;
    if (const Class* of = constructor_at(machine, before, scanned, start))
        return of->property(path);
    return nullptr;
}

void add_enumerators(const Property& property, bool quoted, Candidates& out) {
    const auto add = [&](const std::string& word) {
        out.add_as(word, quoted ? word : "\"" + word + "\"", out.replace_from(), property.name, {},
                   Group::value);
    };
    for (const std::string& word : property.enumerators) add(word);
    if (property.type == property::Type::color && quoted)
        for (const std::string& name : property::color_names()) add(name);
    if (property.type == property::Type::boolean && !quoted)
        for (const char* word : {"true", "false"}) out.add(word, property.name, {}, Group::value);
}

// Inside quotes: what the function or property before them takes.
void add_in_string(lua_State* L, Machine& machine, std::string_view before, const Scan& scanned,
                   Candidates& out) {
    const std::size_t quote = scanned.string_start - 1;
    if (const Property* property = assigned_property(L, machine, before, scanned, quote)) {
        add_enumerators(*property, true, out);
        return;
    }
    std::size_t end = skip_blanks_back(before, quote);
    if (end == 0 || before[end - 1] != '(') return;
    end = skip_blanks_back(before, end - 1);
    const std::size_t name_at = word_start(before, end);
    const std::string_view function = before.substr(name_at, end - name_at);
    if (function == "color") {
        for (const std::string& name : property::color_names()) out.add(name, {}, {}, Group::value);
        return;
    }
    if (name_at == 0 || before[name_at - 1] != ':') return;
    const std::size_t start = path_start(before, name_at - 1);
    const Property* read = nullptr;
    const int top = lua_gettop(L);
    if (push_path(L, machine, before.substr(start, name_at - 1 - start), &read)) {
        const Class* of = class_object_at(L, -1);
        const auto* box = instance_at(L, -1);
        if (box && machine.tree.alive(box->handle)) of = &machine.tree.class_of(box->handle);
        if (of && function == "on")
            for (const property::Event* event : of->events())
                out.add(event->name, "event", event->doc, Group::value);
        if (of && (function == "watch" || function == "has"))
            for (const Property* property : of->properties())
                out.add(property->name, property_facts(machine, *property), property->doc,
                        Group::value);
        if (function == "find" || function == "all" || function == "each" || function == "is_a" ||
            function == "children")
            for (const Class* each : machine.tree.classes())
                out.add(each->name(), "class", each->doc(), Group::value);
    }
    lua_settop(L, top);
}

}  // namespace

std::vector<Completion> complete(Machine& machine, std::string_view input, std::size_t cursor) {
    const std::string_view before = input.substr(0, std::min(cursor, input.size()));
    const Scan scanned = scan(before);
    const std::size_t token =
        scanned.in_string ? scanned.string_start : word_start(before, before.size());
    Candidates out(before.substr(token), token);
    protected_run(
        machine, "completion",
        [&](lua_State* L) {
            if (scanned.in_string) {
                add_in_string(L, machine, before, scanned, out);
                return;
            }
            const char separator = token > 0 ? before[token - 1] : '\0';
            const bool concatenation = separator == '.' && token > 1 && before[token - 2] == '.';
            if ((separator == '.' && !concatenation) || separator == ':') {
                const std::size_t start = path_start(before, token - 1);
                const Property* read = nullptr;
                if (push_path(L, machine, before.substr(start, token - 1 - start), &read))
                    add_members(L, machine, separator == ':', token - 1, out);
                return;
            }
            out.expect(true);
            if (const Property* property = assigned_property(L, machine, before, scanned, token))
                add_enumerators(*property, false, out);
            if (const Class* of = constructor_at(machine, before, scanned, token))
                add_keys(machine, *of, out);
            out.expect(false);
            add_globals(L, machine, out);
        },
        false);
    machine.caught.reset();
    return out.take();
}

}  // namespace fettle::script
