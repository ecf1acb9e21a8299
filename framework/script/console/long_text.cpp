#include <algorithm>
#include <set>

#include <fettle/property/natural_order.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>
#include <fettle/script/cells.h>

#include <console/long_text.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/instance_set.h>
#include <other_languages/foreign_classes.h>
#include <reference/reference_facts.h>
#include <text/columns.h>
#include <text/folded_rows.h>
#include <text/words.h>
#include <values/description.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

namespace {

constexpr std::size_t max_rows = 30;
constexpr std::size_t max_columns = 6;

/// Folds the rows of a table, `head` rows above them.
void fold_table(std::vector<std::string>& lines, std::size_t head, std::size_t total,
                const char* what, TableLines& table, FoldedLines& folded) {
    auto& cells = table.cells;
    if (const std::size_t shown = head + max_rows; cells.size() > shown) {
        const auto rest = cells.begin() + static_cast<std::ptrdiff_t>(shown);
        folded.cells.assign(rest, cells.end());
        cells.erase(rest, cells.end());
    }
    fold_rows(lines, {.before = head, .shown = max_rows, .total = total, .what = what}, folded);
}

// The value of a property in a list. A formula with an error affects only its own line.
std::string listed_value(const property::Tree& tree, Handle handle, const Property& property,
                         bool unit) {
    try {
        const Value value = tree.get(handle, property);
        return unit ? with_unit(tree, value, property) : tree.text(value, property.precision());
    } catch (const Error&) {
        return "in error (why(path) tells more)";
    }
}

// One row for each property in order of name: name, value with unit. Then the children.
std::vector<std::string> instance_lines(const property::Tree& tree, Handle handle,
                                        TableLines& table, FoldedLines& folded) {
    std::vector<std::string> lines = {tree.path(handle) + " · " + tree.class_of(handle).name()};
    std::vector<std::vector<std::string>> rows;
    for (const Property* property : tree.properties(handle)) {
        if (property->hidden) continue;
        rows.push_back({"  " + property->name, cut(listed_value(tree, handle, *property, true), 60),
                        property->read_only ? "(read-only)" : ""});
    }
    std::sort(rows.begin(), rows.end(), property::NaturalOrder{});
    table.first += lines.size();
    table.head = false;
    for (std::string& line : columns(rows, &table.cells)) lines.push_back(std::move(line));
    std::vector<std::vector<std::string>> children;
    for (Handle child = tree.first_child(handle); child && children.size() < max_rows + max_folded;
         child = tree.next_sibling(child))
        children.push_back(
            {"  " + property::path_suffix(tree.name(child)), tree.class_of(child).name()});
    const std::size_t before = lines.size();
    for (std::string& line : columns(children)) lines.push_back(std::move(line));
    fold_rows(lines,
              {.before = before,
               .shown = max_rows,
               .total = tree.child_count(handle),
               .what = "children"},
              folded);
    return lines;
}

bool may_be_column(const Property& property) {
    return !property.hidden && property.type != Type::list && property.type != Type::reference &&
           property.name != "class";  // has a column of its own
}

// One row for each instance: its path, and the properties of all instances that the command names
// or that have a value other than the default.
std::vector<std::string> set_lines(const property::Tree& tree, std::vector<Handle> handles,
                                   std::string_view command, TableLines& table,
                                   FoldedLines& folded) {
    std::erase_if(handles, [&](Handle h) { return !tree.alive(h); });
    if (handles.empty()) return {"no instances"};
    std::vector<std::pair<std::string, Handle>> sorted;
    sorted.reserve(handles.size());
    for (const Handle handle : handles) sorted.emplace_back(tree.path(handle), handle);
    std::ranges::stable_sort(sorted, property::NaturalOrder{},
                             &std::pair<std::string, Handle>::first);
    const std::size_t total = sorted.size();
    if (sorted.size() > max_rows + max_folded) sorted.resize(max_rows + max_folded);

    std::vector<const Property*> shared, others;
    for (const Property* property : tree.class_of(sorted.front().second).properties()) {
        if (!may_be_column(*property)) continue;
        bool everywhere = true, special = false;
        for (const auto& [path, handle] : sorted) {
            const Property* same = tree.find(handle, property->symbol);
            everywhere &= same == property;
            special |= same == property && !property->read_only && tree.overridden(handle, *same);
        }
        if (!everywhere) continue;
        if (find_word(command, property->name) != std::string_view::npos)
            shared.push_back(property);
        else if (special)
            others.push_back(property);
    }
    shared.insert(shared.end(), others.begin(), others.end());
    if (shared.size() > max_columns) shared.resize(max_columns);
    std::vector<std::vector<std::string>> rows;
    std::vector<std::string> head = {"path", "class"};
    for (const Property* property : shared)
        head.push_back(property->unit.empty() ? property->name
                                              : property->name + " [" + property->unit + "]");
    rows.push_back(head);
    for (const auto& [path, handle] : sorted) {
        std::vector<std::string> row = {path, tree.class_of(handle).name()};
        for (const Property* property : shared) {
            // A vector is not cut, because half a vector is useless.
            const std::size_t width = property->type == Type::vec2 ? line_width : 28;
            row.push_back(cut(listed_value(tree, handle, *property, false), width));
        }
        rows.push_back(std::move(row));
    }
    std::vector<std::string> lines = columns(rows, &table.cells);
    fold_table(lines, 1, total, "instances", table, folded);
    return lines;
}

// The instances in a table 1..n; empty if the table contains anything else.
std::vector<Handle> only_instances(lua_State* L, int index) {
    std::vector<Handle> handles;
    index = lua_absindex(L, index);
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
        const auto* box = instance_at(L, -1);
        if (!box) {
            lua_pop(L, 2);
            return {};
        }
        handles.push_back(box->handle);
    }
    return handles;
}

// The text of a value in a table from `query`, whose keys are paths; with the unit of the property.
std::string entry_text(lua_State* L, const property::Tree& tree, const std::string& key) {
    try {
        const property::Place place = property::resolve(tree, key);
        if (place.property && place.part.empty()) {
            const Value value = to_value(L, -1);
            return cut(with_unit(tree, value, *place.property), line_width);
        }
    } catch (const Error&) {
        // The key is not a path.
    }
    return short_text(L, -1);
}

bool has_match(const property::Tree& tree, const property::Pattern& pattern) {
    bool found = false;
    tree.each_below(tree.root(),
                    [&](Handle handle) { found = found || pattern.matches(tree, handle); });
    return found;
}

/// The text for an empty set: at the console, a name of the pattern is perhaps misspelt.
std::string nothing_found(const property::Tree& tree, const std::string& pattern) {
    std::string text = "no instances";
    if (pattern.empty()) return text;
    std::set<std::string> names;
    tree.each_below(tree.root(), [&](Handle handle) {
        names.insert(tree.name(handle));
        for (const Property* property : tree.properties(handle)) names.insert(property->name);
    });
    const property::Pattern asked(pattern);
    // A name alone is looked for among the children of game only.
    if (asked.segments().size() == 1) {
        const std::string deep = "**." + pattern;
        if (const property::Pattern anywhere(deep); has_match(tree, anywhere))
            return text + " (write query(\"" + deep + "\") to search all of the tree)";
    }
    for (const std::string& each : asked.segments()) {
        if (each.find('*') != std::string::npos || names.contains(each)) continue;
        const std::string start = property::message_text(text + ": nothing has \"" + each + "\"");
        if (const std::string hint = hint_for_class(each); !hint.empty()) return start + hint;
        std::vector<std::string> known(names.begin(), names.end());
        if (asked.segments().size() == 1)  // the name of a class alone is a pattern, too
            for (const property::Class* of : tree.classes()) known.push_back(of->name());
        return start + property::suggestion(each, known);
    }
    return text;
}

// An entry of a table whose key is not in its list.
struct NamedEntry {
    std::string key;   // the key as it is printed
    std::string text;  // the value; of a text key it is found later
    bool is_text;      // whether the key is a text
};

// All entries of the table at `index` except the first `length` of its list, in no order.
std::vector<NamedEntry> named_entries(lua_State* L, int index, lua_Integer length) {
    std::vector<NamedEntry> named;
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
        if (lua_isinteger(L, -2) && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= length)
            continue;
        if (lua_type(L, -2) == LUA_TSTRING)
            named.push_back({.key = string_at(L, -2), .text = {}, .is_text = true});
        else
            named.push_back({.key = key_text(L, -2), .text = short_text(L, -1), .is_text = false});
    }
    return named;
}

std::vector<std::string> table_lines(lua_State* L, int index, std::string_view command,
                                     TableLines& table, FoldedLines& folded) {
    Machine& machine = machine_of(L);
    index = lua_absindex(L, index);
    if (const auto handles = only_instances(L, index); !handles.empty())
        return set_lines(machine.tree, handles, command, table, folded);
    if (is_set(L, index)) return {nothing_found(machine.tree, machine.recording.nothing)};
    std::string line = short_text(L, index);
    if (cell_count(line) <= 76 && line.find("…") == std::string::npos) return {line};

    const auto length = static_cast<lua_Integer>(lua_rawlen(L, index));
    std::vector<std::vector<std::string>> rows;
    for (lua_Integer i = 1; i <= length && rows.size() < max_rows + max_folded; ++i) {
        lua_rawgeti(L, index, i);
        rows.push_back({"  " + std::to_string(i), short_text(L, -1)});
        lua_pop(L, 1);
    }
    std::vector<NamedEntry> named = named_entries(L, index, length);
    const std::size_t total = static_cast<std::size_t>(length) + named.size();
    const std::size_t wanted = std::min(named.size(), max_rows + max_folded - rows.size());
    // Only what is listed is sorted and gets a text: a table may have a million keys.
    std::partial_sort(named.begin(), named.begin() + static_cast<std::ptrdiff_t>(wanted),
                      named.end(), [](const NamedEntry& a, const NamedEntry& b) {
                          return property::NaturalOrder{}(a.key, b.key);
                      });
    named.resize(wanted);
    for (NamedEntry& entry : named) {
        if (entry.is_text) {
            lua_pushlstring(L, entry.key.data(), entry.key.size());
            lua_rawget(L, index);
            entry.text = entry_text(L, machine.tree, entry.key);
            lua_pop(L, 1);
        }
        rows.push_back({"  " + cut(entry.key, 40), std::move(entry.text)});
    }
    table.head = false;
    std::vector<std::string> lines = columns(rows, &table.cells);
    fold_table(lines, 0, total, "entries", table, folded);
    return lines;
}

// One line `name  value` for each entry. A list of records becomes a table with the field names on
// top.
std::vector<std::string> description_lines(lua_State* L, int index, const DescriptionKind& kind) {
    push_described(L, index);
    const int table = lua_gettop(L);
    std::vector<std::vector<std::string>> rows;
    const auto cell = [&](int record, const std::string& field) {
        lua_getfield(L, record, field.c_str());
        const bool plain = lua_type(L, -1) == LUA_TSTRING;
        std::string text = lua_isnil(L, -1) ? ""
                           : plain          ? cut(string_at(L, -1), line_width)
                                            : short_text(L, -1);
        lua_pop(L, 1);
        return text;
    };
    if (!is_description_list(kind)) {
        rows.reserve(kind.fields.size());
        for (const std::string& field : kind.fields)
            rows.push_back({"  " + field, cell(table, field)});
    } else {
        const auto length = static_cast<lua_Integer>(lua_rawlen(L, table));
        for (lua_Integer i = 1; i <= length; ++i) {
            lua_rawgeti(L, table, i);
            if (push_described(L, -1)) {
                const int record = lua_gettop(L);
                rows.push_back({"  " + cell(record, "name"), cell(record, "type"),
                                cell(record, "unit"), cell(record, "doc")});
                lua_pop(L, 1);
            } else {
                rows.push_back({"  " + short_text(L, -1)});
            }
            lua_pop(L, 1);
        }
    }
    lua_pop(L, 1);
    return columns(rows);
}

}  // namespace

std::vector<std::string> long_text(lua_State* L, int index, std::string_view command,
                                   TableLines& table, FoldedLines& folded) {
    Machine& machine = machine_of(L);
    if (const auto* box = instance_at(L, index)) {
        if (!machine.tree.alive(box->handle)) return {short_text(L, index)};
        return instance_lines(machine.tree, box->handle, table, folded);
    }
    if (lua_type(L, index) == LUA_TTABLE) return table_lines(L, index, command, table, folded);
    if (const DescriptionKind* kind = description_kind(L, index))
        return description_lines(L, index, *kind);
    if (lua_type(L, index) == LUA_TSTRING)
        return {cut(property::value_text(Value(view_at(L, index).substr(0, 4000))), 2000)};
    return {short_text(L, index)};
}

}  // namespace fettle::script
