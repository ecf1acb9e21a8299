#include <algorithm>

#include <fettle/property/natural_order.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <classes/script_classes.h>
#include <console/help.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/generic_methods.h>
#include <other_languages/foreign_classes.h>
#include <reference/language.h>
#include <reference/reference_facts.h>
#include <reference/signature.h>
#include <sandbox/sandbox.h>
#include <text/columns.h>
#include <values/members.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

using property::Method;

std::vector<std::string> property_help(const property::Tree& tree, const Property& property) {
    std::vector<std::string> lines = {
        (property.owner ? property.owner->name() + "." : std::string()) + property.name + " · " +
        property_facts(tree, property)};
    if (!property.doc.empty()) lines.push_back("  " + shown_doc(property.doc));
    if (!property.derives_from.empty()) {
        std::string sources;
        for (const std::string& source : property.derives_from)
            sources += (sources.empty() ? "" : ", ") + source;
        lines.push_back("  derived from " + sources);
    }
    return lines;
}

namespace {

std::string fields_text(const std::vector<property::Field>& fields) {
    std::string text;
    for (const property::Field& field : fields) {
        text += (text.empty() ? "" : ", ") + field.name + ": " +
                std::string(property::type_name(field.type));
        if (!field.unit.empty()) text += " " + field.unit;
    }
    return text;
}

}  // namespace

std::vector<std::string> method_help(const Method& method) {
    std::vector<std::string> lines = {":" + signature(method)};
    if (!method.doc.empty()) lines.push_back("  " + shown_doc(method.doc));
    if (!method.parameters.empty())
        lines.push_back("  parameters: " + fields_text(method.parameters));
    if (!method.returns.empty()) lines.push_back("  returns: " + fields_text(method.returns));
    return lines;
}

namespace {

void add_members(Machine& machine, const Class& of, std::vector<std::string>& lines) {
    std::vector<std::vector<std::string>> rows;
    for (const Property* property : of.properties()) {
        if (property->hidden) continue;
        rows.push_back({"  ." + property->name, property_facts(machine.tree, *property),
                        shown_doc(property->doc)});
    }
    std::sort(rows.begin(), rows.end(), property::NaturalOrder{});
    std::vector<std::vector<std::string>> methods;
    for (const Method* method : of.methods())
        methods.push_back({"  :" + signature(*method), shown_doc(method->doc)});
    std::sort(methods.begin(), methods.end(), property::NaturalOrder{});
    std::vector<std::vector<std::string>> events;
    for (const property::Event* event : of.events())
        events.push_back({"  " + event->name, shown_doc(event->doc)});
    std::sort(events.begin(), events.end(), property::NaturalOrder{});
    const auto add = [&](const char* title, const std::vector<std::vector<std::string>>& part) {
        if (part.empty()) return;
        lines.emplace_back(title);
        for (std::string& line : columns(part)) lines.push_back(std::move(line));
    };
    add("properties", rows);
    add("methods", methods);
    add("events", events);
    std::vector<std::string> functions;
    machine.classes.add_function_names(of, functions);
    std::vector<std::vector<std::string>> own;
    own.reserve(functions.size());
    for (const std::string& name : functions) own.push_back({"  :" + name + "(...)"});
    add("functions", own);
}

}  // namespace

std::vector<std::string> class_help(Machine& machine, const Class& of) {
    std::string head = of.name();
    for (const Class* base = of.base(); base; base = base->base()) head += " < " + base->name();
    std::vector<std::string> lines = {head};
    if (!of.doc().empty()) lines.push_back("  " + shown_doc(of.doc()));
    if (of.creatable()) lines.push_back("  make one with " + of.name() + " { ... }");
    add_members(machine, of, lines);
    return lines;
}

namespace {

std::vector<std::string> instance_help(Machine& machine, Handle instance) {
    const Class& of = machine.tree.class_of(instance);
    std::vector<std::string> lines = {machine.tree.path(instance) + " · " + of.name()};
    if (!of.doc().empty()) lines.push_back("  " + shown_doc(of.doc()));
    add_members(machine, of, lines);
    return lines;
}

// One line for each signature, then the description.
std::vector<std::string> function_lines(std::string_view prefix, std::string_view signatures,
                                        std::string_view doc) {
    std::vector<std::string> lines;
    for (const Signature& each : parse_signatures(signatures))
        lines.push_back(std::string(prefix) + typed(each));
    lines.push_back("  " + shown_doc(doc));
    return lines;
}

std::vector<std::string> generic_help(const GlobalDoc& method) {
    return function_lines(":", method.signature, method.doc);
}

std::vector<std::string> type_help(const TypeDoc& type) {
    std::vector<std::string> lines = {"  " + shown_doc(type.doc)};
    std::vector<std::vector<std::string>> rows;
    for (const MemberDoc& member : type.members) {
        const std::string separator = member.is_function() && !type.by_dot ? ":" : ".";
        rows.push_back({"  " + separator +
                            (member.is_function() ? plain_signatures(member.signature)
                                                  : std::string(member.name)),
                        shown_doc(member.doc)});
    }
    for (std::string& line : columns(rows)) lines.push_back(std::move(line));
    return lines;
}

std::vector<std::string> global_help(const GlobalDoc& doc) {
    const bool function = std::string_view(doc.signature).find('(') != std::string_view::npos;
    std::vector<std::string> lines =
        function ? function_lines("", doc.signature, doc.doc)
                 : std::vector<std::string>{std::string(doc.name) + ": " + doc.signature,
                                            "  " + shown_doc(doc.doc)};
    if (const TypeDoc* type = type_doc(doc.name))
        for (std::string& line : type_help(*type)) lines.push_back(std::move(line));
    return lines;
}

// Help for a type or a member of one: "vec.rotated", "Pen.circle", "pen".
std::vector<std::string> value_help(std::string path) {
    if (path == "pen" || path.starts_with("pen.") || path.starts_with("pen:")) path[0] = 'P';
    if (const TypeDoc* type = type_doc(path)) {
        std::vector<std::string> lines = type_help(*type);
        lines.insert(lines.begin(), type->name);
        return lines;
    }
    const std::size_t cut_at = path.find_first_of(".:");
    const TypeDoc* type = type_doc(path.substr(0, cut_at));
    if (!type || cut_at == std::string::npos) return {};
    for (const MemberDoc& member : type->members) {
        if (path.compare(cut_at + 1, std::string::npos, member.name) != 0) continue;
        if (member.is_function())
            return function_lines(type->by_dot ? "." : ":", member.signature, member.doc);
        return {path + ": " + member.signature, "  " + shown_doc(member.doc)};
    }
    return {};
}

// Help for a member of an instance or class.
std::vector<std::string> member_help(Machine& machine, const Class& of, std::string_view name) {
    if (const Property* property = of.property(name)) return property_help(machine.tree, *property);
    if (const Method* method = of.method(name)) return method_help(*method);
    if (const property::Event* event = of.event(name)) {
        std::vector<std::string> lines = {"event " + event->name + " of " + of.name()};
        if (!event->doc.empty()) lines.push_back("  " + shown_doc(event->doc));
        if (!event->fields.empty()) lines.push_back("  tells: " + fields_text(event->fields));
        return lines;
    }
    for (const GlobalDoc& method : instance_docs())
        if (name == method.name) return generic_help(method);
    std::vector<std::string> functions;
    machine.classes.add_function_names(of, functions);
    for (const std::string& function : functions)
        if (name == function) return {":" + function + "(...)", "  a function of the game's own"};
    return {};
}

// Pushes the value of a dotted name in the environment; nil if there is none.
void push_named(lua_State* L, std::string_view name) {
    push_registry(L, machine_of(L).globals.table);
    for (std::size_t start = 0; start <= name.size();) {
        const std::size_t end = std::min(name.find('.', start), name.size());
        if (!lua_istable(L, -1)) break;
        push_text(L, name.substr(start, end - start));
        lua_rawget(L, -2);
        lua_remove(L, -2);
        start = end + 1;
    }
}

std::vector<std::string> function_help(lua_State* L, int index) {
    if (const Method* method = machine_of(L).members.method_of(L, index))
        return method_help(*method);
    if (const std::string_view name = generic_name(L, index); !name.empty())
        for (const GlobalDoc& method : instance_docs())
            if (method.name == name) return generic_help(method);
    for (const auto* docs : {&global_docs(), &library_docs(), &callback_docs()}) {
        for (const GlobalDoc& doc : *docs) {
            push_named(L, doc.name);
            const bool same = lua_rawequal(L, -1, index) != 0;
            lua_pop(L, 1);
            if (same) return global_help(doc);
        }
    }
    return {short_text(L, index)};
}

}  // namespace

namespace {

// Whether the path without its last name is the path of an instance.
bool leads_to_instance(const property::Tree& tree, const std::string& path) {
    const std::size_t last = path.find_last_of(".[");
    if (last == std::string::npos) return false;
    try {
        const property::Place place = property::resolve(tree, path.substr(0, last));
        return place.property == nullptr;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

std::vector<std::string> help_for(Machine& machine, const std::string& path) {
    if (path == "it" && machine.tree.alive(machine.globals.it))
        return instance_help(machine, machine.globals.it);
    if (const GlobalDoc* doc = global_doc(path)) return global_help(*doc);
    if (const Class* of = machine.tree.find_class(path)) return class_help(machine, *of);
    const std::size_t cut_at = path.find_last_of(".:");
    if (cut_at != std::string::npos && cut_at > 0) {
        const std::string owner = path.substr(0, cut_at), name = path.substr(cut_at + 1);
        if (const Class* of = machine.tree.find_class(owner))
            return member_help(machine, *of, name);
        try {
            const property::Place place = owner == "it"
                                              ? property::Place{machine.globals.it, nullptr, {}}
                                              : property::resolve(machine.tree, owner);
            if (!place.property && machine.tree.alive(place.instance)) {
                const Class& of = machine.tree.class_of(place.instance);
                if (auto lines = member_help(machine, of, name); !lines.empty()) {
                    if (const Property* property = of.property(name))
                        lines.insert(
                            lines.begin() + 1,
                            "  now " + with_unit(machine.tree,
                                                 machine.tree.get(place.instance, *property),
                                                 *property));
                    return lines;
                }
            }
        } catch (const Error&) {
            // The whole path is resolved below.
        }
    }
    try {
        const property::Place place = property::resolve(machine.tree, path);
        if (!place.property) return instance_help(machine, place.instance);
        return property_help(machine.tree, *place.property);
    } catch (const Error& error) {
        auto lines = value_help(path);
        if (lines.empty() && leads_to_instance(machine.tree, path)) lines.push_back(error.what());
        return lines;
    }
}

namespace {

bool is_path(std::string_view text) {
    try {
        return !property::parse_path(text).empty();
    } catch (const Error&) {
        return false;
    }
}

/// Help for the properties, methods and events of any class that have this name.
std::vector<std::string> members_called(const property::Tree& tree, const std::string& name) {
    std::vector<std::string> lines;
    const auto add = [&lines](std::vector<std::string> more, const std::string& before = {}) {
        if (!more.empty()) more.front().insert(0, before);
        lines.insert(lines.end(), more.begin(), more.end());
    };
    for (const Class* of : tree.classes()) {
        if (const Property* property = of->property(name);
            property != nullptr && property->owner == of && !property->hidden)
            add(property_help(tree, *property));
        if (const Method* method = of->method(name); method != nullptr && method->owner == of)
            add(method_help(*method), of->name());
        if (const property::Event* event = of->event(name); event != nullptr && event->owner == of)
            add({of->name() + " event " + name, "  " + shown_doc(event->doc)});
    }
    return lines;
}

std::vector<std::string> known_names(const property::Tree& tree) {
    std::vector<std::string> names;
    for (const Class* of : tree.classes()) names.push_back(of->name());
    for (const auto* docs : {&global_docs(), &library_docs()})
        for (const GlobalDoc& doc : *docs) names.emplace_back(doc.name);
    for (const Handle child : tree.children(tree.root())) names.push_back(tree.name(child));
    return names;
}

}  // namespace

std::vector<std::string> help_lines(lua_State* L, int index) {
    Machine& machine = machine_of(L);
    if (const auto* box = instance_at(L, index)) {
        machine.tree.require(box->handle);
        return instance_help(machine, box->handle);
    }
    if (const Class* of = class_object_at(L, index)) return class_help(machine, *of);
    if (vec_at(L, index)) return value_help("vec");
    if (color_at(L, index)) return value_help("color");
    if (lua_type(L, index) == LUA_TFUNCTION) return function_help(L, lua_absindex(L, index));
    if (lua_type(L, index) == LUA_TSTRING) {
        const std::string name = string_at(L, index);
        auto lines = help_for(machine, name);
        if (!lines.empty()) return lines;
        if (lines = members_called(machine.tree, name); !lines.empty()) return lines;
        if (is_path(name)) {
            std::string hint = hint_for_class(name);
            if (hint.empty()) hint = property::suggestion(name, known_names(machine.tree));
            if (hint.empty()) hint = "; find " + name + " searches names and explanations";
            return {name + ": no such name" + hint};
        }
    }
    return {short_text(L, index) + " · " + describe_type(L, index)};
}

namespace {

int help(lua_State* L) {
    Machine& machine = machine_of(L);
    if (lua_gettop(L) == 0) {
        print_line(machine,
                   "help(x) explains a class, an instance, a method or a path; x? does "
                   "the same; find(\"word\") searches.");
        std::vector<std::vector<std::string>> rows;
        for (const GlobalDoc& doc : global_docs())
            rows.push_back({"  " + shown_name(doc), shown_doc(doc.doc)});
        for (std::string& line : columns(rows)) print_line(machine, std::move(line));
        std::string classes = "classes:";
        for (const Class* of : machine.tree.classes())
            if (of->creatable()) classes += " " + of->name();
        print_line(machine, classes);
        return 0;
    }
    // A callback that the game lacks is nil, and has documentation.
    const bool missing = lua_isnil(L, 1) && !machine.recording.missing.empty();
    for (std::string& line :
         missing ? help_for(machine, machine.recording.missing) : help_lines(L, 1))
        print_line(machine, std::move(line));
    return 0;
}

}  // namespace

void open_help(lua_State* L) {
    add_function<help>(L, "help");
}

}  // namespace fettle::script
