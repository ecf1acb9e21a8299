#include <cctype>

#include <fettle/property/spelling.h>

#include <lua/environment.h>
#include <lua/guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/sources.h>
#include <lua/stack.h>
#include <objects/hints.h>
#include <objects/script_classes.h>
#include <reference/language.h>
#include <text/synonyms.h>
#include <text/words.h>
#include <values/recording.h>

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
    constexpr std::size_t limit = 100;  // a limit for games with very many of them
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
    // A plain Object has no expected properties.
    if (native == &machine_.tree.object_class()) return;
    // A game may add the same property to thousands of instances.
    const std::uint64_t both = std::uint64_t{of.id()} << 32 | property::Symbol::find(name).id();
    if (!checked_.insert(both).second) return;
    std::string hint;
    if (const std::string meant = meaning(*native, name); !meant.empty())
        hint = meaning_hint(meant);
    else if (const std::string child = child_with(instance, name); !child.empty())
        hint = "; " + child;
    else
        return;
    tell(of.name() + "." + std::string(name),
         position(machine_.lua.running) + native->name() + " has no property \"" +
             std::string(name) + "\", so it was added to this one and changes nothing" + hint);
}

// --- Functions

/// Whether the name occurs anywhere in the game's sources except in a definition of this function.
bool Hints::is_called(const std::string& name) const {
    for (const auto& [chunk, text] : machine_.sources.texts) {
        if (chunk == "console") continue;
        for (std::size_t at = text.find(name); at != std::string::npos;
             at = text.find(name, at + 1)) {
            const std::size_t end = at + name.size();
            if ((at > 0 && is_word(text[at - 1])) || (end < text.size() && is_word(text[end])))
                continue;
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

void Hints::game_loaded() {
    lua_State* L = machine_.lua.main;
    if (!lua_checkstack(L, 10)) return;
    push_registry(L, machine_.globals.table);
    check_globals();
    lua_pop(L, 1);
    check_classes();
}

}  // namespace fettle::script
