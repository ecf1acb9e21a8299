// Properties and states: what is checked while the game runs.

#include <algorithm>

#include <fettle/property/added_rules.h>
#include <fettle/property/spelling.h>

#include <classes/script_classes.h>
#include <classes/unplaced_instances.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <objects/hints.h>
#include <other_languages/synonyms.h>
#include <sources/sources.h>
#include <text/command_words.h>
#include <text/words.h>
#include <values/recording.h>

namespace fettle::script {

namespace {

// The name in a text such as "position = vec(x, y)".
std::string_view name_in(std::string_view literal_hint) {
    return literal_hint.substr(0, literal_hint.find(' '));
}

}  // namespace

void Hints::report(const std::string& about, const std::string& note) {
    constexpr std::size_t limit = 100;  // notes for one game
    if (given_.size() >= limit || !given_.insert(about).second) return;
    if (const auto sink = machine_.host.on_note) sink(note);
}

void Hints::forget() {
    given_.clear();
    checked_.clear();
    earlier_ = machine_.unplaced.handles;
    machine_.recording.drawn_changes.clear();
    machine_.recording.degrees.clear();
    machine_.recording.late_change_noted = false;
}

// --- Properties

namespace {

/// What can be given a value, so no methods.
std::vector<std::string> property_names(const Class& of) {
    std::vector<std::string> names;
    for (const property::Property* each : of.properties()) names.push_back(each->name);
    return names;
}

}  // namespace

/// The declared property that `name` probably means, as it would be written; "" if it is unclear.
std::string Hints::meaning(const Class& of, std::string_view name) const {
    for (const std::string_view way : property_synonyms(name))
        if (of.property(name_in(way)) != nullptr) return std::string(way);
    std::string snake = snake_case(name);
    if (snake != name && of.property(snake) != nullptr) return snake;
    // Shorter names are similar to too many others.
    return name.size() < 7 ? std::string() : property::nearest(name, property_names(of));
}

std::string Hints::did_you_mean(const Class& of, std::string_view name) const {
    if (const std::string meant = meaning(of, name); !meant.empty()) return hint_of(meant);
    if (std::string meant = property::suggestion(name, property_names(of)); !meant.empty())
        return meant;
    std::vector<std::string> events;
    for (const property::Event* event : of.events()) events.push_back(event->name);
    for (const std::string_view meant : callback_synonyms(name))
        if (among(events, meant)) return hint_of(meant);
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
    if (const std::string meant = meaning(of, name); !meant.empty()) return hint_of(meant);
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

bool Hints::begins_command(std::string_view word) const {
    if (!machine_.recording.active) return false;
    const auto command = machine_.sources.texts.find(TypedCommands::plain_chunk);
    return command != machine_.sources.texts.end() && first_word(command->second) == word;
}

std::string Hints::of_command(std::string_view word) const {
    return begins_command(word)
               ? hint_for_command(machine_.sources.texts[TypedCommands::plain_chunk])
               : std::string();
}

/// The first path that `part` finds, level by level from the top.
std::string Hints::path_of_first(const std::function<std::string(Handle)>& part) const {
    constexpr std::size_t most = 20'000;  // instances that are looked at
    const property::Tree& tree = machine_.tree;
    std::vector<Handle> level = tree.children(tree.root());
    for (std::size_t i = 0; i < level.size() && i < most; ++i) {
        if (std::string path = part(level[i]); !path.empty()) return path;
        for (Handle child = tree.first_child(level[i]); child && level.size() < most;
             child = tree.next_sibling(child))
            level.push_back(child);
    }
    return {};
}

std::string Hints::path_of_instance(std::string_view name) const {
    const property::Tree& tree = machine_.tree;
    return path_of_first(
        [&](Handle each) { return tree.name(each) == name ? tree.path(each) : std::string(); });
}

std::string Hints::path_of_member(std::string_view name) const {
    const property::Tree& tree = machine_.tree;
    const std::string wanted = lower(name);
    if (wanted.size() < 2 || !property::Symbol::find(wanted)) return {};
    const auto path_in = [&](Handle instance) {
        const Class& of = tree.class_of(instance);
        if (const Property* found = of.property(wanted)) return tree.path(instance, *found);
        return of.method(wanted) == nullptr ? std::string()
                                            : tree.path(instance) + ":" + wanted + "(...)";
    };
    if (tree.alive(machine_.globals.it))
        if (std::string path = path_in(machine_.globals.it); !path.empty()) return path;
    return path_of_first(path_in);
}

std::string Hints::of_shapes(const property::Class& of, const std::string& name, bool exact) const {
    const property::Tree& tree = machine_.tree;
    const property::Class* const body = tree.find_class("Body");
    const property::Class* const shape = tree.find_class("Shape");
    if (body == nullptr || shape == nullptr || !of.is_a(*body)) return {};
    std::vector<std::string> names = {name};
    if (!exact)
        for (const std::string_view meant : property_synonyms(name)) names.emplace_back(meant);
    for (const std::string& wanted : names)
        for (const property::Class* each : tree.classes())
            if (each->is_a(*shape) && each->creatable() && each->property(wanted) != nullptr)
                return "; its shapes have it, as in " + each->name() + " { " + wanted + " = ... }";
    return {};
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
        hint = hint_of(meant);
    else if (const std::string child = child_with(instance, name); !child.empty())
        hint = "; " + child;
    else if (&of == native)  // a class of the game may keep here what it gives to its shapes
        hint = of_shapes(of, std::string(name));
    // Some parts of the framework, such as `input.actions` and `view.uniforms`, take any property.
    if (hint.empty() &&
        (native->creatable() || property::has_added_rules(machine_.tree, instance) ||
         native->properties().size() == machine_.tree.object_class().properties().size()))
        return;
    report(of.name() + "." + std::string(name),
           position(machine_.lua.running) + native->name() + " has no property \"" +
               std::string(name) + "\", so it was added to this one and changes nothing" + hint);
}

// --- Time

void Hints::rewinding() {
    const Handle time = machine_.tree.child(machine_.tree.root(), "time");
    const auto number = [&](const char* name) {
        const property::Property* const found = time ? machine_.tree.find(time, name) : nullptr;
        return found == nullptr ? -1 : machine_.tree.peek(time, *found).as_double();
    };
    std::string reason;
    if (number("rewind_limit") == 0)
        reason = "time.rewind_limit is 0, so no past is kept";
    else if (machine_.recording.active && number("step") == 0)
        reason = "no step was made yet";
    else if (machine_.recording.active && number("step") == number("oldest"))
        reason = "this is the oldest step that is kept";
    if (reason.empty()) return;
    reason = "rewind does nothing: " + reason;
    if (machine_.recording.active) return machine_.recording.lines.push_back(reason);
    report("rewind", position(machine_.lua.running) + reason);
}

// --- Variables

void Hints::variable_added(std::string_view name, const property::Value& value) {
    const auto& stated = machine_.globals.stated;
    const auto meant = std::find_if(stated.begin(), stated.end(), [&](const auto& each) {
        const bool alike =
            each.second.type() == value.type() || (each.second.is_numeric() && value.is_numeric());
        return alike && property::near_miss(name, each.first);
    });
    if (meant == stated.end()) return;
    report("variable " + std::string(name),
           position(machine_.lua.running) + std::string(name) +
               " is a new variable and not a state (did you mean \"" + meant->first + "\"?)");
}

void Hints::variable_hides_property(std::string_view name, const std::string& hint) {
    report("variable " + std::string(name),
           position(machine_.lua.running) + std::string(name) +
               " is a new variable of the whole game and no property" + hint);
}

void Hints::stated(const std::string& name, const std::string& problem) {
    report("state " + name, position(machine_.lua.running) + problem);
}

}  // namespace fettle::script
