// What happens in go_to_scene is state of the tree: a transition is the instance `game.transition`,
// so that a rewind into it finds it as it was. Without a transition, the scene is replaced at the
// next barrier. Until then that instance, of the kind "none", contains the name of the new scene,
// because a rewind may return to a step before that barrier.

#include <algorithm>

#include <fettle/property/last_value.h>
#include <fettle/property/spelling.h>

#include <calls/protected.h>
#include <classes/script_classes.h>
#include <handlers/connections.h>
#include <handlers/timers.h>
#include <library/scene_changes.h>
#include <library/scene_files.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <text/words.h>
#include <values/values.h>
#include <writes/writes.h>

namespace fettle::script {

using property::List;

namespace {

constexpr const char* scene_name = "scene";
constexpr const char* transition_name = "transition";
const std::vector<std::string> transition_kinds = {"none", "fade", "wipe", "iris"};
const std::vector<std::string> option_names = {"args", "color", "seconds", "transition"};
constexpr double longest = 3600;  // s

/// The arguments of `enter` as a value of the tree: a table with names becomes a list of names and
/// values.
struct Arguments {
    Value value{};
    bool named = false;
};

property::ClassDescriptor transition_class() {
    return {
        .name = "Transition",
        .doc = "A change of the scene that is being shown: game.transition, made by go_to_scene.",
        .properties = {
            {.name = "kind",
             .type = Type::text,
             .default_value = "fade",
             .doc =
                 "fade: through a color. wipe: the color moves across the screen. iris: a circle "
                 "closes and opens.",
             .enumerators = transition_kinds},
            {.name = "seconds",
             .type = Type::number,
             .default_value = 0.5,
             .unit = "s",
             .range = {0, longest},
             .doc = "How long it takes, in real time. The scene is replaced in the middle."},
            {.name = "progress",
             .type = Type::number,
             .default_value = 0.0,
             .range = {0, 1},
             .doc = "The part of it that is over."},
            {.name = "color",
             .type = Type::color,
             .default_value = property::Color{0, 0, 0, 1},
             .range = {0, 1},
             .doc = "What covers the screen."},
            {.name = "to",
             .type = Type::text,
             .default_value = "",
             .doc = "The name of the scene."},
            {.name = "done",
             .type = Type::boolean,
             .default_value = false,
             .doc = "Whether the scene is replaced."},
            {.name = "args",
             .type = Type::nil,
             .doc = "What `enter` gets.",
             .any_type = true,
             .hidden = true},
            {.name = "named",
             .type = Type::boolean,
             .default_value = false,
             .doc = "Whether args is a list of names and values.",
             .hidden = true}}};
}

// --- Scenes by name

const Class* class_of_scene(Machine& machine, const std::string& name) {
    const Class* of = machine.tree.find_class(name);
    return of != nullptr && of->creatable() && machine.classes.scripted(*of) ? of : nullptr;
}

/// Throws, with the nearest name, unless there is a scene of that name.
void require_scene(Machine& machine, const std::string& name) {
    if (class_of_scene(machine, name) || !scene_file_named(machine, name).empty()) return;
    std::vector<std::string> known = scene_file_names(machine);
    for (const Class* of : machine.tree.classes())
        if (class_of_scene(machine, of->name())) known.push_back(of->name());
    throw Error(ErrorKind::unknown_name, "go_to_scene: there is no scene \"" + name +
                                             "\", neither a class of the game nor a file scenes/" +
                                             name + ".json" + property::suggestion(name, known));
}

Handle make_scene(Machine& machine, const std::string& name) {
    if (const Class* of = class_of_scene(machine, name)) return machine.classes.create(*of);
    return load_scene_file(machine, "go_to_scene", scene_file_named(machine, name), {}, {});
}

// --- Callbacks

void push_arguments(lua_State* L, const Arguments& arguments) {
    if (!arguments.named) return push_value(L, arguments.value);
    lua_newtable(L);
    const List& all = arguments.value.list();
    for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
        push_value(L, all[i]);
        push_value(L, all[i + 1]);
        lua_rawset(L, -3);
    }
}

/// Calls the function of the scene's class, or else the global one.
bool call_of_scene(Machine& machine, Handle scene, const char* name, const Arguments* arguments) {
    const Context context(std::string(name), scene);
    return protected_run(machine, context, [&](lua_State* L) {
        int given = 0;
        if (machine.classes.push_function(L, machine.tree.class_of(scene), name)) {
            push_instance(L, scene);
            given = 1;
        } else {
            push_registry(L, machine.globals.table);
            lua_pushstring(L, name);
            if (lua_rawget(L, -2) != LUA_TFUNCTION) return;
        }
        if (arguments != nullptr) push_arguments(L, *arguments);
        lua_call(L, given + (arguments != nullptr ? 1 : 0), 0);
    });
}

void change_scene(Machine& machine, const std::string& name, const Arguments& arguments) {
    property::Tree& tree = machine.tree;
    Handle next{};
    // The old scene stays if the new one cannot be made.
    const bool made = protected_run(machine, "go_to_scene", [&](lua_State*) {
        require_scene(machine, name);
        next = make_scene(machine, name);
    });
    if (!made) return;
    if (const Handle old = tree.child(tree.root(), scene_name)) {
        call_of_scene(machine, old, "leave", nullptr);
        if (tree.alive(old)) tree.destroy(old);
    }
    machine.connections.end_with_scenes();  // timers notice it themselves
    if (!tree.alive(next)) return;
    const bool placed = protected_run(machine, "go_to_scene", [&](lua_State*) {
        if (const Handle other = tree.child(tree.root(), scene_name)) tree.destroy(other);
        place(machine, next, tree.root(), scene_name);
    });
    if (!placed) return;
    machine.classes.deliver_ready();
    if (!tree.alive(next)) return;
    machine.globals.entering = next;
    call_of_scene(machine, next, "enter", &arguments);
    machine.globals.entering = {};
}

/// At the next barrier between steps.
void change_at_barrier(Machine& machine, std::string name, Arguments arguments) {
    machine.tree.at_barrier([&machine, alive = machine.lua.alive, name = std::move(name),
                             arguments = std::move(arguments)] {
        if (*alive != nullptr) change_scene(machine, name, arguments);
    });
}

/// Replaces the scene at the next barrier, unless another call of go_to_scene is in the way then.
void change_without_transition(Machine& machine) {
    machine.tree.at_barrier([&machine, alive = machine.lua.alive] {
        if (*alive == nullptr) return;
        property::Tree& tree = machine.tree;
        const Handle due = tree.child(tree.root(), transition_name);
        if (!due || tree.class_of(due).name() != "Transition" ||
            last_value(tree, due, "kind").text() != "none")
            return;
        const std::string name = last_value(tree, due, "to").text();
        const Arguments arguments{.value = last_value(tree, due, "args"),
                                  .named = last_value(tree, due, "named").boolean()};
        tree.destroy(due);
        change_scene(machine, name, arguments);
    });
}

// --- go_to_scene

Arguments arguments_at(lua_State* L, int index) {
    std::string what = "go_to_scene: args";
    const auto text = [&] { return what; };
    if (!lua_istable(L, index) || lua_rawlen(L, index) > 0)
        return {.value = lua_isnoneornil(L, index) ? Value() : to_value(L, index, text)};
    List named;
    for (const std::string& key : sorted_keys(L, index, what)) {
        push_text(L, key);
        lua_rawget(L, index);
        named.emplace_back(key);
        named.push_back(to_value(L, lua_gettop(L), [&] { return what + "." + key; }));
        lua_pop(L, 1);
    }
    return {.value = Value(std::move(named)), .named = true};
}

void check_options(lua_State* L) {
    if (!lua_istable(L, 2))
        refuse_type(L, 2, "go_to_scene: needs a table of options, as in { transition = \"fade\" }");
    for (const std::string& key : sorted_keys(L, 2, "go_to_scene"))
        if (!among(option_names, key))
            throw Error(ErrorKind::unknown_name, "go_to_scene has no option \"" + key + "\"" +
                                                     property::suggestion(key, option_names));
}

int go_to_scene(lua_State* L) {
    Machine& machine = machine_of(L);
    property::Tree& tree = machine.tree;
    lua_settop(L, 2);
    const std::string name = check_text(L, 1, "go_to_scene: needs the name of a scene");
    require_scene(machine, name);
    std::string kind = "none";
    double seconds = 0.5;
    Arguments arguments;
    Value color;
    if (!lua_isnil(L, 2)) {
        check_options(L);
        lua_getfield(L, 2, "transition");
        if (!lua_isnil(L, -1)) kind = check_text(L, -1, "go_to_scene: transition is a text");
        lua_getfield(L, 2, "seconds");
        if (!lua_isnil(L, -1)) seconds = check_number(L, -1, "go_to_scene: seconds");
        lua_getfield(L, 2, "color");
        if (!lua_isnil(L, -1)) color = to_value(L, lua_gettop(L));
        lua_getfield(L, 2, "args");
        arguments = arguments_at(L, lua_gettop(L));
    }
    if (!among(transition_kinds, kind))
        throw Error(ErrorKind::unknown_name, "go_to_scene: there is no transition \"" + kind +
                                                 "\"" +
                                                 property::suggestion(kind, transition_kinds));
    if (!(seconds >= 0 && seconds <= longest))
        throw Error(ErrorKind::out_of_range, "go_to_scene: seconds: expected 0 to 3600, got " +
                                                 property::number_text(seconds));
    Handle now = tree.child(tree.root(), transition_name);
    if (now && tree.class_of(now).name() != "Transition")
        throw Error(ErrorKind::bad_name, "go_to_scene: game.transition is something else");
    if (seconds == 0) kind = "none";
    // A transition that covers the screen already goes on with the new scene.
    if (now && last_value(tree, now, "done").boolean()) {
        tree.destroy(now);
        now = {};
    }
    const bool made = !now;
    if (made) now = tree.create(tree.class_named("Transition"), tree.root(), transition_name);
    try {  // what is refused changes nothing
        if (!color.is_nil()) color = tree.coerce(now, tree.property(now, "color"), color);
        arguments.value = tree.coerce(now, tree.property(now, "args"), arguments.value);
    } catch (...) {
        if (made) tree.destroy(now);
        throw;
    }
    tree.set(now, "kind", kind);
    tree.set(now, "seconds", seconds);
    tree.set(now, "to", name);
    tree.set(now, "args", arguments.value);
    tree.set(now, "named", arguments.named);
    if (!color.is_nil()) tree.set(now, "color", color);
    if (kind == "none") change_without_transition(machine);
    return 0;
}

}  // namespace

void open_scene_changes(lua_State* L) {
    property::Tree& tree = machine_of(L).tree;
    if (tree.find_class("Transition") == nullptr) tree.define(transition_class());
    add_function<go_to_scene>(L, "go_to_scene");
}

void advance_transition(Machine& machine, double seconds) {
    property::Tree& tree = machine.tree;
    const Handle now = tree.child(tree.root(), transition_name);
    if (!now || tree.class_of(now).name() != "Transition") return;
    static std::function<std::string()> where = [] { return std::string("go_to_scene"); };
    const property::Tree::CauseScope cause(tree, property::Writer::module, &where);
    if (last_value(tree, now, "kind").text() == "none") return change_without_transition(machine);
    const double length = std::max(1e-9, last_value(tree, now, "seconds").as_double());
    double progress = last_value(tree, now, "progress").as_double() + seconds / length;
    if (!last_value(tree, now, "done").boolean() && progress >= 0.5) {
        // A picture of the covered screen comes before the new scene, however long a frame takes.
        progress = 0.5;
        tree.set(now, "done", true);
        change_at_barrier(machine, last_value(tree, now, "to").text(),
                          {.value = last_value(tree, now, "args"),
                           .named = last_value(tree, now, "named").boolean()});
    }
    if (progress >= 1)
        tree.destroy(now);
    else
        tree.set(now, "progress", progress);
}

}  // namespace fettle::script
