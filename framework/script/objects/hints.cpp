#include <algorithm>
#include <cctype>
#include <functional>
#include <map>

#include <fettle/property/added_rules.h>
#include <fettle/property/spelling.h>

#include <classes/script_classes.h>
#include <classes/unplaced.h>
#include <lua/environment.h>
#include <lua/guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/sources.h>
#include <lua/stack.h>
#include <objects/hints.h>
#include <reference/language.h>
#include <text/synonyms.h>
#include <text/words.h>
#include <values/recording.h>
#include <values/values.h>

namespace fettle::script {

namespace {

// The name in a text such as "position = vec(x, y)".
std::string_view name_in(std::string_view way_to_write) {
    return way_to_write.substr(0, way_to_write.find(' '));
}

std::string meaning_hint(std::string_view what) {
    return " (did you mean " + std::string(what) + "?)";
}

/// The known callback or event that `name` probably means; "" if there is none.
std::string meant_by(const std::string& name, const std::vector<std::string>& known) {
    for (const std::string_view synonym : callback_synonyms(name))
        if (among(known, synonym)) return std::string(synonym);
    return property::nearest(name, known);
}

}  // namespace

void Hints::tell(const std::string& about, const std::string& note) {
    constexpr std::size_t limit = 100;  // notes for one game
    if (given_.size() >= limit || !given_.insert(about).second) return;
    if (const auto sink = machine_.host.on_note) sink(note);
}

void Hints::forget() {
    given_.clear();
    checked_.clear();
}

// --- Properties

/// The declared property that `name` probably means, as it would be written; "" if it is unclear.
std::string Hints::meaning(const Class& of, std::string_view name) const {
    for (const std::string_view way : property_synonyms(name))
        if (of.property(name_in(way)) != nullptr) return std::string(way);
    const std::string snake = snake_case(name);
    if (snake != name && of.property(snake) != nullptr) return snake;
    // Shorter names are similar to too many others.
    return name.size() < 7 ? std::string() : property::nearest(name, of.member_names());
}

std::string Hints::did_you_mean(const Class& of, std::string_view name) const {
    if (const std::string meant = meaning(of, name); !meant.empty()) return meaning_hint(meant);
    if (std::string meant = property::suggestion(name, of.member_names()); !meant.empty())
        return meant;
    std::vector<std::string> events;
    for (const property::Event* event : of.events()) events.push_back(event->name);
    for (const std::string_view meant : callback_synonyms(name))
        if (among(events, meant)) return meaning_hint(meant);
    return property::suggestion(name, events);
}

std::string Hints::child_with(Handle instance, std::string_view name) const {
    std::vector<std::string_view> names = {name};
    for (const std::string_view way : property_synonyms(name)) names.push_back(name_in(way));
    constexpr int limit = 8;
    int looked_at = 0;
    for (Handle child = machine_.tree.first_child(instance); child && looked_at < limit;
         child = machine_.tree.next_sibling(child), ++looked_at)
        for (const std::string_view wanted : names)
            if (machine_.tree.class_of(child).property(wanted) != nullptr)
                return "its " + machine_.tree.class_of(child).name() + " has " +
                       std::string(wanted);
    return {};
}

std::string Hints::of_added(Handle instance, std::string_view name) const {
    constexpr std::size_t least = 3;  // letters; shorter names are similar to too many others
    const property::Tree& tree = machine_.tree;
    const Class& of = tree.class_of(instance);
    if (const std::string meant = meaning(of, name); !meant.empty()) return meaning_hint(meant);
    if (name.size() >= least) {
        std::vector<std::string> known = of.member_names();
        for (const property::Property* each : tree.ad_hoc(instance)) known.push_back(each->name);
        for (Handle child = tree.first_child(instance); child; child = tree.next_sibling(child))
            known.push_back(tree.name(child));
        std::erase_if(known, [&](const std::string& each) {
            return each == name || property::of_one_series(name, each);
        });
        if (std::string meant = property::suggestion(name, known); !meant.empty()) return meant;
    }
    const std::string child = child_with(instance, name);
    return child.empty() ? child : "; " + child;
}

void Hints::property_added(Handle instance, std::string_view name) {
    if (machine_.recording.active) return;  // the console shows the hint beside the change
    const Class& of = machine_.tree.class_of(instance);
    const Class* native = &of;
    while (machine_.classes.scripted(*native)) native = native->base();
    // A plain Object has no expected properties, and games keep variables in `game`.
    if (native == &machine_.tree.object_class() || instance == machine_.tree.root()) return;
    // A game may add the same property to thousands of instances.
    const std::uint64_t both = std::uint64_t{of.id()} << 32 | property::Symbol::find(name).id();
    if (!checked_.insert(both).second) return;
    std::string hint;
    if (const std::string meant = meaning(*native, name); !meant.empty())
        hint = meaning_hint(meant);
    else if (const std::string child = child_with(instance, name); !child.empty())
        hint = "; " + child;
    // Some parts of the framework, such as `input.actions` and `view.uniforms`, take any property.
    else if (native->creatable() || property::has_added_rules(machine_.tree, instance) ||
             native->properties().size() == machine_.tree.object_class().properties().size())
        return;
    tell(of.name() + "." + std::string(name),
         position(machine_.lua.running) + native->name() + " has no property \"" +
             std::string(name) + "\", so it was added to this one and changes nothing" + hint);
}

// --- Time

void Hints::rewinding() {
    const Handle time = machine_.tree.child(machine_.tree.root(), "time");
    const property::Property* const limit =
        time ? machine_.tree.find(time, "rewind_limit") : nullptr;
    if (limit == nullptr || machine_.tree.peek(time, *limit).as_double() > 0) return;
    tell("rewind", position(machine_.lua.running) +
                       "rewind does nothing: time.rewind_limit is 0, so no past is kept");
}

// --- Variables

void Hints::stated(const std::string& name, const std::string& problem) {
    tell("state " + name, position(machine_.lua.running) + problem);
}

// --- Functions

/// Whether the name occurs anywhere in the game's sources except in a definition of this function
/// and in comments.
bool Hints::is_called(const std::string& name) const {
    for (const auto& [chunk, text] : machine_.sources.texts) {
        if (chunk == "console") continue;
        for (std::size_t at = text.find(name); at != std::string::npos;
             at = text.find(name, at + 1)) {
            const std::size_t end = at + name.size();
            if ((at > 0 && is_word(text[at - 1])) || (end < text.size() && is_word(text[end])))
                continue;
            const std::size_t line = text.rfind('\n', at) + 1;  // 0 in the first line
            if (text.substr(line, at - line).find("--") != std::string::npos) continue;
            // Skip "Enemy:" backwards to the word "function".
            std::size_t start = at;
            while (start > 0 &&
                   (is_word(text[start - 1]) || text[start - 1] == '.' || text[start - 1] == ':'))
                --start;
            while (start > 0 && std::isspace(static_cast<unsigned char>(text[start - 1])) != 0)
                --start;
            constexpr std::string_view keyword = "function";
            if (start < keyword.size() ||
                std::string_view(text).substr(start - keyword.size(), keyword.size()) != keyword)
                return true;
        }
    }
    return false;
}

void Hints::check_globals() {
    lua_State* L = machine_.lua.main;
    const std::vector<std::string>& known = callback_names();
    for (const std::string& name : machine_.globals.assigned) {
        if (among(known, name)) continue;
        push_text(L, name);
        if (lua_rawget(L, -2) == LUA_TFUNCTION && lua_iscfunction(L, -1) == 0) {
            const std::string meant = meant_by(name, known);
            if (!meant.empty() && !is_called(name))
                tell(name, definition(L) + "nothing calls " + name + meaning_hint(meant));
        }
        lua_pop(L, 1);
    }
}

void Hints::check_classes() {
    lua_State* L = machine_.lua.main;
    for (const Class* of : machine_.tree.classes()) {
        std::vector<std::string> known;
        for (const GlobalDoc& doc : class_callback_docs()) known.emplace_back(doc.name);
        for (const property::Event* event : of->events()) known.push_back(event->name);
        for (const std::string& name : machine_.classes.own_functions(*of)) {
            if (among(known, name)) continue;
            const std::string meant = meant_by(name, known);
            const bool global = among(callback_names(), name);
            if ((meant.empty() && !global) || is_called(name)) continue;
            if (!machine_.classes.push_function(L, *of, name)) continue;
            const std::string note =
                definition(L) + "nothing calls " + of->name() + ":" + name +
                (meant.empty() ? "; only the global function " + name + " is called"
                               : meaning_hint(meant));
            lua_pop(L, 1);
            tell(of->name() + ":" + name, note);
        }
    }
}

// --- Sources

namespace {

/// "main.lua:12: "
std::string place_in(const std::string& chunk, std::string_view text, std::size_t at) {
    return chunk + ":" + std::to_string(1 + std::ranges::count(text.substr(0, at), '\n')) + ": ";
}

std::size_t end_of_word(std::string_view text, std::size_t at) {
    while (at < text.size() && is_word(text[at])) ++at;
    return at;
}

/// Calls `visit` with the place behind each `what`.
void each_place(std::string_view text, std::string_view what,
                const std::function<void(std::size_t)>& visit) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        visit(at + what.size());
}

/// The text in quotes at `at`, or "" if there is none.
std::string quoted_at(std::string_view text, std::size_t at) {
    if (at >= text.size() || (text[at] != '"' && text[at] != '\'')) return {};
    const std::size_t end = text.find_first_of("\"'\\\n", at + 1);
    if (end == std::string::npos || text[end] != text[at]) return {};
    return std::string(text.substr(at + 1, end - at - 1));
}

}  // namespace

/// The texts of the files of the game, by name.
std::map<std::string, std::string_view> Hints::files() const {
    std::map<std::string, std::string_view> found;
    for (const auto& [chunk, text] : machine_.sources.texts)
        if (chunk.ends_with(".lua")) found.emplace(chunk, text);
    return found;
}

/// `state = "menu"` replaces a function of Fettle, which the game can then no longer call.
void Hints::check_replaced() {
    lua_State* L = machine_.lua.main;
    const int globals = lua_gettop(L);
    for (const GlobalDoc& doc : global_docs()) {
        push_text(L, doc.name);
        lua_rawget(L, globals);
        const int value = lua_gettop(L);
        const bool function = std::string_view(doc.signature).find('(') != std::string_view::npos;
        // `tween` is a table that can be called.
        const bool callable =
            lua_isfunction(L, value) || luaL_getmetafield(L, value, "__call") != LUA_TNIL;
        if (function && !callable && !lua_isnil(L, value))
            tell(doc.name, std::string(doc.name) + " is " + describe_type(L, value) +
                               " now, and was a function of Fettle: " + doc.signature);
        lua_settop(L, globals);
    }
}

/// `local function start()` looks like a callback, and nothing calls it.
void Hints::check_local_callbacks() {
    constexpr std::string_view first_words = "local function ";
    for (const auto& [chunk, text] : files())
        each_place(text, first_words, [&, &file = chunk, &code = text](std::size_t at) {
            const std::size_t begin = at - first_words.size();
            if (begin > 0 && code[begin - 1] != '\n')
                return;  // indented: inside a function or a block
            const std::string name(code.substr(at, end_of_word(code, at) - at));
            if (!among(callback_names(), name) || among(machine_.globals.assigned, name) ||
                is_called(name))
                return;
            tell("local " + name, place_in(file, code, at) + "nothing calls " + name +
                                      ", because it is local: write function " + name + "(...)");
        });
}

/// A comparison such as `key == "Space"` never holds.
void Hints::check_keys() {
    const Class* const of = machine_.tree.find_class("Keys");
    if (of == nullptr) return;
    std::vector<std::string> keys;
    for (const Property* key : of->properties()) keys.push_back(key->name);
    for (const auto& [chunk, text] : files())
        for (const char* callback : {"function key_pressed(", "function key_released("})
            each_place(text, callback, [&, &file = chunk, &code = text](std::size_t at) {
                const std::string parameter(code.substr(at, end_of_word(code, at) - at));
                if (parameter.empty()) return;
                // Only the body of this callback: elsewhere, a variable of that name may hold no
                // key.
                const std::size_t end = std::min(code.find("\nend", at), code.size());
                const std::string_view body = code.substr(0, end);
                each_place(body.substr(at), parameter + " == ", [&](std::size_t behind) {
                    const std::string name = quoted_at(body, at + behind);
                    if (name.empty() || among(keys, name)) return;
                    std::string meant = property::nearest(name, keys);
                    for (const std::string_view synonym : property_synonyms(name))
                        if (of->property(synonym) != nullptr) meant = synonym;
                    if (meant.empty()) return;
                    tell("key " + name, place_in(file, code, at + behind) + "no key is called \"" +
                                            name + "\"" + meaning_hint("\"" + meant + "\""));
                });
            });
}

/// `Body {}` alone makes an instance that is never placed in the tree.
void Hints::check_dropped() {
    const property::Tree& tree = machine_.tree;
    if (std::ranges::none_of(machine_.unplaced.handles,
                             [&](Handle made) { return tree.alive(made) && !tree.parent(made); }))
        return;
    std::vector<Handle> dropped = dropped_instances(machine_);
    // A shape without a body is made for queries.
    if (const Class* const shape = tree.find_class("Shape"))
        std::erase_if(dropped, [&](Handle each) { return tree.class_of(each).is_a(*shape); });
    if (dropped.empty()) return;
    std::string text = property::with_article(tree.class_of(dropped.front()).name());
    if (dropped.size() > 1) text += " and " + std::to_string(dropped.size() - 1) + " more";
    tell("dropped", text + (dropped.size() > 1 ? " were" : " was") +
                        " made, and added to nothing: parent:add(...) or parent.name = ... gives "
                        "an instance its place");
}

void Hints::game_loaded() {
    lua_State* L = machine_.lua.main;
    if (!lua_checkstack(L, 10)) return;
    push_registry(L, machine_.globals.table);
    check_globals();
    check_replaced();
    lua_pop(L, 1);
    check_classes();
    check_local_callbacks();
    check_keys();
    check_dropped();
}

}  // namespace fettle::script
