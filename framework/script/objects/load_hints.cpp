// Checks that are made once, when the game is loaded: functions that nothing calls, and misleading
// names.

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>

#include <fettle/property/spelling.h>

#include <classes/script_classes.h>
#include <classes/unplaced_instances.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/hints.h>
#include <other_languages/synonyms.h>
#include <reference/language.h>
#include <sources/sources.h>
#include <text/words.h>
#include <values/values.h>

namespace fettle::script {

namespace {

/// The known callback or event that `name` probably means; "" if there is none.
std::string meant_by(const std::string& name, const std::vector<std::string>& known) {
    for (const std::string_view synonym : callback_synonyms(name))
        if (among(known, synonym)) return std::string(synonym);
    return property::nearest(name, known);
}

/// "main.lua:12: "
std::string place_in(const std::string& chunk, std::string_view text, std::size_t at) {
    return chunk + ":" + std::to_string(1 + std::ranges::count(text.substr(0, at), '\n')) + ": ";
}

std::size_t end_of_word(std::string_view text, std::size_t at) {
    while (at < text.size() && is_word(text[at])) ++at;
    return at;
}

/// Calls `visit` with the place after each `what`.
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

/// Whether the name occurs anywhere in the game's sources except in a definition of this function
/// and in comments.
bool Hints::is_called(const std::string& name) const {
    for (const auto& [chunk, text] : machine_.sources.texts) {
        if (TypedCommands::is_chunk(chunk)) continue;
        for (std::size_t at = find_word(text, name); at != std::string::npos;
             at = find_word(text, name, at + 1)) {
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
        push_text(L, name);
        const int type = lua_rawget(L, -2);
        if (among(known, name)) {
            // A table or an instance may be callable.
            if (type == LUA_TNUMBER || type == LUA_TSTRING || type == LUA_TBOOLEAN)
                report(name, name + " is no function, so that the callback " + name +
                                 " does nothing: write function " + name +
                                 "(...), or give the variable another name");
        } else if (type == LUA_TFUNCTION && lua_iscfunction(L, -1) == 0) {
            const std::string meant = meant_by(name, known);
            if (!meant.empty() && !is_called(name))
                report(name, definition(L) + "nothing calls " + name + hint_of(meant));
        }
        lua_pop(L, 1);
    }
}

void Hints::check_unfinished_classes() {
    for (const auto& [name, place] : machine_.classes.unfinished())
        report("unfinished " + name,
               place + "no class " + name + hint_of_unfinished_class(machine_.classes, name));
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
                               : hint_of(meant));
            lua_pop(L, 1);
            report(of->name() + ":" + name, note);
        }
    }
}

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
            report(doc.name, std::string(doc.name) + " is " + describe_type(L, value) +
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
            report("local " + name, place_in(file, code, at) + "nothing calls " + name +
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
                    report("key " + name, place_in(file, code, at + behind) +
                                              "no key is called \"" + name + "\"" +
                                              hint_of("\"" + meant + "\""));
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
    std::erase_if(dropped,
                  [&](Handle each) { return std::ranges::find(earlier_, each) != earlier_.end(); });
    // A shape without a body is made for queries, and a sound plays without a place.
    for (const char* const name : {"Shape", "SoundSource"})
        if (const Class* const of = tree.find_class(name))
            std::erase_if(dropped, [&](Handle each) { return tree.class_of(each).is_a(*of); });
    if (dropped.empty()) return;
    std::string text = property::with_article(tree.class_of(dropped.front()).name());
    if (dropped.size() > 1) text += " and " + std::to_string(dropped.size() - 1) + " more";
    report("dropped", text + (dropped.size() > 1 ? " were" : " was") +
                          " made, and added to nothing: parent:add(...) or parent.name = ... gives "
                          "an instance its place");
}

/// A variable holds the only body, so nothing is seen. Where other bodies are in the tree, the game
/// probably keeps this one for later.
void Hints::check_held() {
    const property::Tree& tree = machine_.tree;
    const auto waits = [&](Handle made) {
        return tree.alive(made) && !tree.parent(made) && tree.class_of(made).creatable();
    };
    for (const char* const name : {"Body", "Sprite", "Text"}) {
        const Class* const of = tree.find_class(name);
        if (of == nullptr) continue;
        const auto is_one = [&](Handle each) { return tree.class_of(each).is_a(*of); };
        const auto& made = machine_.unplaced.handles;
        const auto held =
            std::ranges::find_if(made, [&](Handle each) { return waits(each) && is_one(each); });
        if (held == made.end()) continue;
        bool any_placed = false;
        tree.each_below(tree.root(), [&](Handle each) { any_placed |= is_one(each); });
        if (any_placed) continue;
        report("held " + of->name(), property::with_article(tree.class_of(*held).name()) +
                                         " was made and has no place in the game yet: "
                                         "world:add(...) or world.name = ... gives it one");
    }
}

/// A formula that reads local variables and no property is computed once and never again.
void Hints::check_formulas() {
    constexpr int most = 2000;  // instances that are looked at
    const property::Tree& tree = machine_.tree;
    if (tree.formula_count() == 0) return;
    int looked_at = 0;
    tree.each_below(tree.root(), [&](Handle each) {
        if (++looked_at > most) return;
        for (const Property* property : tree.properties(each)) {
            const property::Formula* const formula = tree.formula(each, *property);
            if (formula == nullptr || formula->not_saved.empty()) continue;
            const std::string reason = formula->not_saved;
            if (!tree.problem(each, *property).empty() || !tree.why(each, *property).from.empty())
                continue;
            const std::string path = tree.path(each, *property);
            report("formula " + path, path +
                                          ": its formula reads no property, so it is not "
                                          "computed again: " +
                                          reason +
                                          "; state(\"name\", value) declares a variable whose "
                                          "changes are noticed");
        }
    });
}

void Hints::game_loaded() {
    lua_State* L = machine_.lua.main;
    if (!lua_checkstack(L, 10)) return;
    push_registry(L, machine_.globals.table);
    check_globals();
    check_replaced();
    lua_pop(L, 1);
    check_classes();
    check_unfinished_classes();
    check_local_callbacks();
    check_keys();
    check_dropped();
    check_held();
    check_formulas();
}

}  // namespace fettle::script
