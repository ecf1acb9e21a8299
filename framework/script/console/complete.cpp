#include <algorithm>
#include <cctype>

#include <fettle/property/last_value.h>
#include <fettle/property/path.h>
#include <fettle/script/runtime.h>

#include <calls/errors.h>
#include <calls/protected.h>
#include <classes/script_classes.h>
#include <console/candidates.h>
#include <console/complete.h>
#include <console/expression.h>
#include <library/globals.h>
#include <lua/environment.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/instance_set.h>
#include <reference/language.h>
#include <reference/reference_facts.h>
#include <reference/signature.h>
#include <text/columns.h>
#include <text/words.h>
#include <values/description.h>
#include <values/members.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

namespace {

// Children of one instance, or entries of one table, that are compared: a letter that is typed,
// here or in an attached terminal, must not delay the game.
constexpr std::size_t max_compared = 2'000;

// --- Candidates

std::string facts_with_value(const property::Tree& tree, Handle instance,
                             const Property& property) {
    const Value value = last_value(tree, instance, property);
    const std::string problem = tree.problem(instance, property).empty() ? "" : "in error, ";
    return problem + cut(with_unit(tree, value, property), 40) + " · " +
           property_facts(tree, property);
}

void add_functions(Machine& machine, const Class& of, Candidates& out) {
    for (const property::Method* method : of.methods())
        out.add(method->name, described(signature(*method), method->doc), Group::function);
    std::vector<std::string> functions;
    machine.classes.add_function_names(of, functions);
    for (const std::string& name : functions)
        out.add(name, described("function of " + of.name()), Group::function);
    for (const GlobalDoc& method : instance_docs())
        out.add(method.name, described(plain_signatures(method.signature), method.doc),
                Group::function);
}

/// `separator`: where the dot is, which a name that is not an identifier replaces, or the bracket
/// before a quoted name, which each name replaces.
void add_named(const std::string& name, std::size_t separator, Describe describe, Group group,
               Candidates& out) {
    if (property::is_identifier(name) && separator + 1 == out.replace_from())
        out.add(name, std::move(describe), group);
    else
        out.add_as(name, property::path_suffix(name), separator, std::move(describe), group);
}

void add_children(const property::Tree& tree, Handle instance, std::size_t separator,
                  Candidates& out) {
    const auto add = [&](Handle child) {
        const Class* const of = &tree.class_of(child);
        add_named(
            tree.name(child), separator,
            [of](Completion& candidate) {
                candidate.detail = of->name();
                candidate.doc = of->doc();
            },
            Group::value, out);
    };
    std::size_t compared = 0;
    Handle child = tree.first_child(instance);
    for (; child && compared < max_compared; child = tree.next_sibling(child), ++compared)
        add(child);
    if (!child) return;
    // Beyond the limit a child is found by its whole name, and by all but two digits of its number.
    const auto look_up = [&](const std::string& name) {
        if (const Handle found = tree.child(instance, name)) add(found);
    };
    const std::string typed(out.typed());
    look_up(typed);
    if (typed.empty() || std::isdigit(static_cast<unsigned char>(typed.back())) == 0) return;
    for (int more = 0; more < 10; ++more) look_up(typed + std::to_string(more));
    for (int more = 0; more < 100; ++more)
        look_up(typed + std::to_string(more / 10) + std::to_string(more % 10));
}

void add_instance(Machine& machine, Handle instance, bool methods_only, std::size_t separator,
                  Candidates& out) {
    const property::Tree& tree = machine.tree;
    if (!methods_only) {
        add_children(tree, instance, separator, out);
        for (const Property* property : tree.properties(instance)) {
            if (property->hidden) continue;
            out.add(
                property->name,
                [&tree, instance, property](Completion& candidate) {
                    candidate.detail = facts_with_value(tree, instance, *property);
                    candidate.doc = property->doc;
                },
                Group::value);
        }
    }
    add_functions(machine, tree.class_of(instance), out);
}

// The table must remain on the stack until the candidates are taken.
void add_table(lua_State* L, int index, std::size_t separator, Candidates& out) {
    index = lua_absindex(L, index);
    std::size_t compared = 0;
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
        if (++compared > max_compared) {
            lua_pop(L, 2);
            return;
        }
        if (lua_type(L, -2) != LUA_TSTRING) continue;
        add_named(
            string_at(L, -2), separator,
            [L, index](Completion& candidate) {
                push_text(L, candidate.label);
                lua_rawget(L, index);
                candidate.detail = cut(short_text(L, -1), 50);
                lua_pop(L, 1);
            },
            lua_isfunction(L, -1) ? Group::function : Group::value, out);
    }
}

// Adds the members of a value that is not an instance.
void add_members_of_type(const TypeDoc& type, bool methods_only, Candidates& out) {
    for (const MemberDoc& member : type.members) {
        const bool function = member.is_function();
        if (member.name[0] == '[' || (methods_only && !function)) continue;
        out.add(
            member.name,
            described(function ? plain_signatures(member.signature) : member.signature, member.doc),
            function ? Group::function : Group::value);
    }
}

// Adds the entries of a library such as `math`, or of a table of Fettle such as `scene`.
void add_documented(const std::string& library, Candidates& out) {
    const std::string prefix = library + ".";
    for (const auto* docs : {&global_docs(), &library_docs()})
        for (const GlobalDoc& doc : *docs)
            if (std::string_view(doc.name).starts_with(prefix))
                out.add(std::string(doc.name).substr(prefix.size()),
                        described(shown_name(doc), doc.doc), Group::function);
}

// Adds the names in a list of descriptions, or the fields of one description.
void add_description(lua_State* L, const DescriptionKind& kind, Candidates& out) {
    push_described(L, -1);
    const int table = lua_gettop(L);
    if (is_description_list(kind)) {
        for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
            if (lua_type(L, -2) != LUA_TSTRING) continue;
            std::string doc;
            if (push_described(L, -1)) {
                lua_getfield(L, -1, "doc");
                if (lua_type(L, -1) == LUA_TSTRING) doc = string_at(L, -1);
                lua_pop(L, 2);
            }
            out.add(string_at(L, -2), described(cut(short_text(L, -1), 50), doc), Group::value);
        }
    }
    for (const std::string& field : kind.fields) {
        lua_getfield(L, table, field.c_str());
        out.add(field, described(cut(short_text(L, -1), 50)), Group::value);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
}

// The type of the value at the top of the stack; nullptr for an instance or a plain table.
const TypeDoc* type_of(lua_State* L) {
    if (vec_at(L, -1)) return type_doc("vec");
    if (color_at(L, -1)) return type_doc("color");
    if (class_object_at(L, -1)) return type_doc("Class");
    if (is_set(L, -1)) return type_doc("Set");
    if (lua_type(L, -1) != LUA_TUSERDATA || luaL_getmetafield(L, -1, "__name") != LUA_TSTRING)
        return nullptr;
    const std::string name = string_at(L, -1);
    lua_pop(L, 1);
    return name == "connection" ? type_doc("Connection")
           : name == "pen"      ? type_doc("Pen")
                                : nullptr;
}

// Adds the members of the value at the top of the stack, which has the path `path`.
void add_members(lua_State* L, Machine& machine, std::string_view path, bool methods_only,
                 std::size_t separator, Candidates& out) {
    if (const auto* box = instance_at(L, -1)) {
        if (machine.tree.alive(box->handle))
            add_instance(machine, box->handle, methods_only, separator, out);
    } else if (const DescriptionKind* kind = description_kind(L, -1)) {
        add_description(L, *kind, out);
    } else if (const TypeDoc* type = type_of(L)) {
        add_members_of_type(*type, methods_only, out);
        if (const Class* of = class_object_at(L, -1)) {
            std::vector<std::string> names;
            machine.classes.add_function_names(*of, names);
            for (const std::string& name : names)
                out.add(name, described("function of " + of->name()), Group::function);
        }
    } else if (lua_type(L, -1) == LUA_TSTRING) {
        add_documented("string", out);
    } else if (lua_type(L, -1) == LUA_TTABLE) {
        add_documented(std::string(path), out);
        add_table(L, -1, separator, out);
    }
}

void describe_global(lua_State* L, Machine& machine, Completion& candidate) {
    if (const GlobalDoc* doc = global_doc(candidate.label)) {
        candidate.detail = shown_name(*doc);
        candidate.doc = doc->doc;
    } else if (const Class* of = machine.tree.find_class(candidate.label)) {
        candidate.detail = of->creatable() ? constructor_text(*of) : "class";
        candidate.doc = of->doc();
    } else {
        const Property* read = nullptr;
        const int top = lua_gettop(L);
        if (push_path(L, machine, candidate.label, &read))
            candidate.detail = cut(short_text(L, -1), 50);
        lua_settop(L, top);
    }
}

void add_globals(lua_State* L, Machine& machine, Candidates& out) {
    std::size_t in_game = 0, others = 0;
    each_global_name(machine, [&](std::string_view name, bool in_tree) {
        if (name == "_G" || name == "_VERSION") return;
        if (++(in_tree ? in_game : others) > max_compared) return;
        out.add(
            name, [L, &machine](Completion& candidate) { describe_global(L, machine, candidate); },
            in_tree ? Group::value : Group::other);
    });
    if (machine.tree.alive(machine.globals.it))
        out.add("it", described(machine.tree.path(machine.globals.it), "what is selected"),
                Group::value);
    for (const char* word : {"and", "break",    "do",     "else", "elseif", "end",   "false",
                             "for", "function", "if",     "in",   "local",  "nil",   "not",
                             "or",  "repeat",   "return", "then", "true",   "until", "while"})
        out.add(word, {}, Group::other);
}

void add_keys(const property::Tree& tree, const Class& of, Candidates& out) {
    for (const Property* property : of.properties())
        if (!property->hidden && !property->read_only)
            out.add(property->name, described(property_facts(tree, *property), property->doc),
                    Group::value);
}

// The class whose constructor contains the cursor, if a key may be written there.
const Class* constructor_at(const property::Tree& tree, std::string_view before,
                            const Scan& scanned, std::size_t token) {
    if (scanned.braces.empty() || before[scanned.braces.back()] != '{') return nullptr;
    const std::size_t previous = skip_blanks_back(before, token);
    if (previous == 0 ||
        (before[previous - 1] != '{' && before[previous - 1] != ',' && before[previous - 1] != ';'))
        return nullptr;
    std::size_t end = skip_blanks_back(before, scanned.braces.back());
    if (end > 0 && before[end - 1] == '(') end = skip_blanks_back(before, end - 1);
    return tree.find_class(before.substr(word_start(before, end), end - word_start(before, end)));
}

// The property to which a value at `end` would be assigned or compared: after `path =`, or after a
// key in a constructor.
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
    if (const Class* of = constructor_at(machine.tree, before, scanned, start))
        return of->property(path);
    return nullptr;
}

void add_enumerators(const Property& property, bool quoted, Candidates& out) {
    const auto add = [&](const std::string& word) {
        out.add_as(word, quoted ? word : "\"" + word + "\"", out.replace_from(),
                   described(property.name), Group::value);
    };
    for (const std::string& word : property.enumerators) add(word);
    if (property.type == Type::color && quoted)
        for (const std::string& name : property::color_names()) add(name);
    if (property.type == Type::boolean && !quoted)
        for (const char* word : {"true", "false"})
            out.add(word, described(property.name), Group::value);
}

// Completes the quoted name after `path[`: names of children, and of the entries of a table. The
// brackets give way to a dot where the name allows one.
void add_in_brackets(lua_State* L, Machine& machine, std::string_view before, Candidates& out) {
    const std::size_t start = path_start(before, before.size());
    const Property* read = nullptr;
    if (!push_path(L, machine, before.substr(start), &read)) return;
    if (const auto* box = instance_at(L, -1)) {
        if (machine.tree.alive(box->handle))
            add_children(machine.tree, box->handle, before.size(), out);
    } else if (lua_type(L, -1) == LUA_TTABLE) {
        add_table(L, -1, before.size(), out);
    }
}

// Completes inside quotes: texts that the function or property before them accepts.
void add_in_string(lua_State* L, Machine& machine, std::string_view before, const Scan& scanned,
                   Candidates& out) {
    const std::size_t quote = scanned.string_start - 1;
    if (const Property* property = assigned_property(L, machine, before, scanned, quote)) {
        add_enumerators(*property, true, out);
        return;
    }
    std::size_t end = skip_blanks_back(before, quote);
    if (end > 0 && before[end - 1] == '[')
        return add_in_brackets(L, machine, before.substr(0, end - 1), out);
    if (end == 0 || before[end - 1] != '(') return;
    end = skip_blanks_back(before, end - 1);
    const std::size_t name_at = word_start(before, end);
    const std::string_view function = before.substr(name_at, end - name_at);
    if (function == "color") {
        for (const std::string& name : property::color_names()) out.add(name, {}, Group::value);
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
                out.add(event->name, described("event", event->doc), Group::value);
        if (of && (function == "watch" || function == "has"))
            for (const Property* property : of->properties())
                out.add(property->name,
                        described(property_facts(machine.tree, *property), property->doc),
                        Group::value);
        if (function == "find" || function == "all" || function == "each" || function == "is_a" ||
            function == "children")
            for (const Class* each : machine.tree.classes())
                out.add(each->name(), described("class", each->doc()), Group::value);
    }
    lua_settop(L, top);
}

// Adds what fits the place after `before`.
void add_all(lua_State* L, Machine& machine, std::string_view before, const Scan& scanned,
             Candidates& out) {
    if (scanned.in_string) return add_in_string(L, machine, before, scanned, out);
    const std::size_t token = out.replace_from();
    const char separator = token > 0 ? before[token - 1] : '\0';
    const bool concatenation = separator == '.' && token > 1 && before[token - 2] == '.';
    if ((separator == '.' && !concatenation) || separator == ':') {
        const std::size_t start = path_start(before, token - 1);
        const Property* read = nullptr;
        const std::string_view path = before.substr(start, token - 1 - start);
        if (push_path(L, machine, path, &read))
            add_members(L, machine, path, separator == ':', token - 1, out);
        return;
    }
    out.expect(true);
    if (const Property* property = assigned_property(L, machine, before, scanned, token))
        add_enumerators(*property, false, out);
    if (const Class* of = constructor_at(machine.tree, before, scanned, token))
        add_keys(machine.tree, *of, out);
    out.expect(false);
    add_globals(L, machine, out);
}

/// Where the name before the cursor begins. It may have letters that need brackets.
std::size_t name_start(std::string_view before) {
    std::size_t at = before.size();
    while (at > 0 &&
           (is_word(before[at - 1]) || static_cast<unsigned char>(before[at - 1]) >= 0x80))
        --at;
    return at;
}

}  // namespace

std::vector<Completion> complete(Machine& machine, std::string_view input, std::size_t cursor,
                                 std::size_t most) {
    const std::string_view before = input.substr(0, std::min(cursor, input.size()));
    const Scan scanned = scan(before);
    const std::size_t token = scanned.in_string ? scanned.string_start : name_start(before);
    Candidates out(before.substr(token), token);
    std::vector<Completion> found;
    protected_run(
        machine, "completion",
        [&](lua_State* L) {
            add_all(L, machine, before, scanned, out);
            found = out.best(most);
        },
        false);
    machine.errors.caught.reset();
    return found;
}

}  // namespace fettle::script
