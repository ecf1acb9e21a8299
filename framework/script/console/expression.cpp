#include <cctype>
#include <charconv>
#include <string>

#include <classes/reflection.h>
#include <console/expression.h>
#include <library/globals.h>
#include <lua/environment.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <text/words.h>
#include <values/description.h>
#include <values/values.h>

namespace fettle::script {

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

namespace {

// Replaces a table of functions at the top of the stack by the instance with the same name, if only
// the instance has the member: `scene.hero` beside `scene.load`.
void prefer_instance(lua_State* L, Machine& machine, std::string_view first,
                     std::string_view member) {
    if (lua_type(L, -1) != LUA_TTABLE) return;
    const Handle instance = machine.tree.child(machine.tree.root(), first);
    if (!instance || !machine.tree.child(instance, member)) return;
    push_text(L, member);
    const bool has = lua_rawget(L, -2) != LUA_TNIL;
    lua_pop(L, 1);
    if (has) return;
    lua_pop(L, 1);
    push_instance(L, instance);
}

// Replaces the value at the top of the stack by its member `name` or `index`. Returns false if
// there is none.
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
    if (const Class* of = class_object_at(L, -1)) {
        lua_pop(L, 1);
        return push_class_field(L, machine, *of, name) && !lua_isnil(L, -1);
    }
    if (push_described(L, -1)) lua_remove(L, -2);
    if (lua_type(L, -1) != LUA_TTABLE) return false;
    if (name.empty())
        lua_rawgeti(L, -1, index);
    else {
        push_text(L, name);
        lua_rawget(L, -2);
    }
    lua_remove(L, -2);
    return !lua_isnil(L, -1);
}

}  // namespace

bool push_path(lua_State* L, Machine& machine, std::string_view path, const Property** read) {
    *read = nullptr;
    std::size_t i = 0;
    while (i < path.size() && is_word(path[i])) ++i;
    if (i == 0) return false;
    const std::string first(path.substr(0, i));
    push_registry(L, machine.globals.table);
    push_text(L, first);
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
        if (index == 0 && name.size() + first.size() + 1 == i)
            prefer_instance(L, machine, first, name);
        if (!descend(L, machine, name, index, read)) return false;
    }
    return true;
}

}  // namespace fettle::script
