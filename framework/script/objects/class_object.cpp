// Class objects: `Body { ... }` constructs an instance; `function Ball:step(dt)` adds a function.

#include <algorithm>
#include <functional>
#include <utility>

#include <fettle/property/exception_text.h>
#include <fettle/property/spelling.h>

#include <classes/class_definition.h>
#include <classes/reflection.h>
#include <classes/script_classes.h>
#include <handlers/connections.h>
#include <handlers/formulas.h>
#include <handlers/subscriptions.h>
#include <lua/exception_guard.h>
#include <lua/library_chunks.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <motion/tweens.h>
#include <objects/class_object.h>
#include <objects/generic_methods.h>
#include <objects/hints.h>
#include <objects/instance.h>
#include <objects/methods.h>
#include <other_languages/synonyms.h>
#include <reference/language.h>
#include <text/words.h>
#include <values/recording.h>
#include <values/short_text.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/writes.h>

namespace fettle::script {

namespace {

// --- Constructing

bool is_orphan(lua_State* L, const property::Tree& tree, int index) {
    const auto* box = instance_at(L, index);
    return box && tree.alive(box->handle) && box->handle != tree.root() &&
           !tree.parent(box->handle);
}

// Pushes the field `name` of the table at 2.
int push_key(lua_State* L, const std::string& name) {
    push_text(L, name);
    return lua_rawget(L, 2);
}

/// An instance under construction. Unless `finish` is called, the destructor deletes it and moves
/// its children back to their former places.
class Construction {
  public:
    Construction(Machine& machine, const Class& to_make)
        : of(to_make), made(machine.classes.create(to_make)), machine_(machine) {}
    ~Construction() {
        if (finished_) return;
        for (auto back = placement_restorers_.rbegin(); back != placement_restorers_.rend(); ++back)
            (*back)();
        if (machine_.tree.alive(made)) machine_.tree.destroy(made);
    }
    Construction(const Construction&) = delete;

    /// To be called before `child` is moved into the new instance.
    void adopts(Handle child) {
        placement_restorers_.push_back(machine_.tree.placement_restorer(child));
    }
    void finish() { finished_ = true; }

    const Class& of;
    const Handle made;

  private:
    Machine& machine_;
    std::vector<std::function<void()>> placement_restorers_;
    bool finished_ = false;
};

/// For `Text { "hello" }`: the property that takes the text, as an assignment.
std::string hint_at_text_property(lua_State* L, const Class& of) {
    if (lua_type(L, -1) != LUA_TSTRING) return "";
    for (const char* name : {"text", "image", "file", "map"})
        if (of.property(name) != nullptr)
            return hint_to_write(std::string(name) + " = " + short_text(L, lua_gettop(L)));
    return "";
}

void adopt_unnamed(lua_State* L, Machine& machine, Construction& now) {
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, 2));
    property::PlainNames plain_names;
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_rawgeti(L, 2, i);
        const auto* box = instance_at(L, -1);
        if (!box)
            throw Error(ErrorKind::wrong_type, now.of.name() + ": element " + std::to_string(i) +
                                                   " is " + describe_type(L, -1) +
                                                   "; what has no name becomes a child, so it "
                                                   "must be an instance" +
                                                   hint_at_text_property(L, now.of));
        machine.tree.require(box->handle);
        if (!is_orphan(L, machine.tree, -1))
            throw Error(
                ErrorKind::bad_structure,
                now.of.name() + ": " + machine.tree.path(box->handle) + " has its place already");
        now.adopts(box->handle);
        place(machine, box->handle, now.made, {}, &plain_names);
        lua_pop(L, 1);
    }
}

void set_declared(lua_State* L, Machine& machine, Handle made, const Property& property) {
    if (is_formula(L, 3)) return define_formula(L, machine, 3, made, property.name);
    const Value value = to_value(L, 3);
    machine.classes.explain_integer(property, value);
    write_property(machine, made, property, value);
}

/// Sets the properties in the table at 3, which need not be declared.
void set_props(lua_State* L, Machine& machine, Construction& now) {
    if (!lua_istable(L, 3))
        throw Error(ErrorKind::wrong_type, now.of.name() +
                                               ".props: expected a table of values by "
                                               "name, got " +
                                               describe_type(L, 3));
    if (lua_rawlen(L, 3) > 0)
        throw Error(ErrorKind::bad_name,
                    now.of.name() + ".props: a value has no name; children stand beside props");
    for (const std::string& key : sorted_keys(L, 3, now.of.name() + ".props")) {
        lua_pushvalue(L, 3);
        push_text(L, key);
        lua_rawget(L, 3);
        lua_replace(L, 3);
        write_member(L, machine, now.made, now.of, key);
        lua_replace(L, 3);
    }
}

/// A function is meant as the handler of an event.
void refuse_unknown_handler(const Class& of, const std::string& name) {
    std::vector<std::string> events;
    for (const property::Event* each : of.events()) events.push_back(each->name);
    if (events.empty()) return;
    std::string hint = property::suggestion(name, events);
    if (hint.empty()) {
        for (const std::string& each : events) hint += (hint.empty() ? "; it has " : ", ") + each;
    }
    throw Error(ErrorKind::unknown_name, of.name() + " has no event \"" + name + "\"" + hint);
}

/// "; radius is one of Capsule, Circle": the native classes that declare a property of that name,
/// or "".
std::string classes_declaring(const property::Tree& tree, const std::string& name) {
    constexpr std::size_t most = 4;
    std::vector<std::string> names;
    for (const Class* each : tree.classes())
        if (const Property* const found = each->property(name);
            found != nullptr && found->owner == each)
            names.push_back(each->name());
    if (names.empty() || names.size() > most) return {};
    std::ranges::sort(names);
    std::string text = "; " + name + " is one of ";
    for (const std::string& each : names) text += (&each == names.data() ? "" : ", ") + each;
    return text;
}

/// "; a Label beside it shows a text: ...", for widgets without a text, or "".
std::string hint_at_label(const property::Tree& tree, const Class& of, const std::string& name) {
    const Class* const widget = tree.find_class("Widget");
    if (widget == nullptr || !of.is_a(*widget)) return {};
    const std::vector<std::string_view> meant = property_synonyms(name);
    if (name != "text" && std::ranges::find(meant, "text") == meant.end()) return {};
    return "; a Label beside it shows a text: Row { Label { text = ..., grow = 1 }, " + of.name() +
           " { ... } }";
}

/// A native class has all the properties that its instances need, so another name is an error. The
/// classes of scripts and plain objects take any name. The value is at 3.
void refuse_unknown(lua_State* L, const Machine& machine, const Class& of,
                    const std::string& name) {
    if (machine.classes.scripted(of) || &of == &machine.tree.object_class()) return;
    if (of.event(name) != nullptr)
        throw Error(ErrorKind::wrong_type, of.name() + "." + name +
                                               ": expected a function, which is called at this "
                                               "event, got " +
                                               describe_type(L, 3));
    if (lua_isfunction(L, 3)) refuse_unknown_handler(of, name);
    std::string hint = machine.hints.of_shapes(of, name, true);
    if (hint.empty()) hint = machine.hints.did_you_mean(of, name);
    if (hint.empty()) hint = machine.hints.of_shapes(of, name);
    if (hint.empty()) hint = hint_at_label(machine.tree, of, name);
    if (hint.empty())
        hint = classes_declaring(machine.tree, name) +
               "; a property of your own goes into props = { " + name + " = ... }";
    throw Error(ErrorKind::unknown_name, of.name() + " has no property \"" + name + "\"" + hint);
}

// Order: named children, so that the numbers of unnamed ones avoid their names; then unnamed
// children; then properties, which may depend on children. Names are sorted, so that runs are the
// same. Declared properties are set in the order of declaration, since the valid values of one may
// depend on earlier ones (whether a chain is closed depends on its points).
void fill(lua_State* L, Machine& machine, Construction& now) {
    const Class& of = now.of;
    std::vector<std::pair<std::size_t, const Property*>> declared;
    std::vector<std::string> others;
    for (const std::string& key : sorted_keys(L, 2, of.name())) {
        if (const Property* property = of.property(key)) {
            const auto& all = of.properties();
            declared.emplace_back(std::find(all.begin(), all.end(), property) - all.begin(),
                                  property);
            continue;
        }
        push_key(L, key);
        lua_replace(L, 3);
        if (is_orphan(L, machine.tree, 3)) {
            now.adopts(instance_at(L, 3)->handle);
            write_member(L, machine, now.made, of, key);
        } else {
            others.push_back(key);
        }
    }
    adopt_unnamed(L, machine, now);
    std::sort(declared.begin(), declared.end());
    for (const auto& [place, property] : declared) {
        push_key(L, property->name);
        lua_replace(L, 3);
        set_declared(L, machine, now.made, *property);
    }
    for (const std::string& key : others) {
        push_key(L, key);
        lua_replace(L, 3);
        if (key == "props") {
            set_props(L, machine, now);
            continue;
        }
        // pressed = function() ... end: a handler of the event.
        if (of.event(key) != nullptr && lua_isfunction(L, 3)) {
            machine.connections.push(L, now.made, event_subscription(L, machine, of, key, false));
            lua_pop(L, 1);
            continue;
        }
        refuse_unknown(L, machine, of, key);
        write_member(L, machine, now.made, of, key);
    }
}

// Replaces "(detached ball).mass: ..." by "Ball.mass: ..." in errors of a constructor.
std::string named_by_class(const std::string& message, const std::string& path, const Class& of) {
    const std::size_t at = message.find(path);
    if (at != std::string::npos) {
        std::string text = message;
        return text.replace(at, path.size(), of.name());
    }
    return message.starts_with(of.name()) ? message : of.name() + ": " + message;
}

/// Turns off the recording of changes for the console while it exists.
class Unrecorded {
  public:
    explicit Unrecorded(Recording& recording)
        : recording_(recording), before_(std::exchange(recording.active, false)) {}
    ~Unrecorded() { recording_.active = before_; }
    Unrecorded(const Unrecorded&) = delete;

  private:
    Recording& recording_;
    bool before_;
};

int construct(lua_State* L) {
    const Class* of = class_object_at(L, 1);
    if (!of) throw Error(ErrorKind::wrong_type, "needs a class");
    Machine& machine = machine_of(L);
    if (!of->creatable())
        throw Error(ErrorKind::bad_structure,
                    of->name() + ": cannot be made; " + why_not_creatable(machine.tree, *of));
    if (lua_gettop(L) >= 2 && !lua_istable(L, 2))
        refuse_type(L, 2, of->name() + ": needs a table, as in " + of->name() + " { }");
    lua_settop(L, 3);
    // Without this, the console would echo each child separately.
    const Unrecorded quiet(machine.recording);
    Construction now(machine, *of);
    try {
        if (lua_istable(L, 2)) fill(L, machine, now);
        machine.tweens.require_valid(now.made);
    } catch (const std::exception& error) {
        std::string message = property::exception_text(error);
        if (machine.tree.alive(now.made))
            message = named_by_class(message, machine.tree.path(now.made), *of);
        throw Error(ErrorKind::rejected, message);
    }
    now.finish();
    machine.declarations.made(now.made);
    push_instance(L, now.made);
    return 1;
}

// --- Class objects

[[noreturn]] void unknown_class_member(Machine& machine, const Class& of, const std::string& name) {
    std::vector<std::string> names = class_fields();
    machine.classes.add_function_names(of, names);
    for (const property::Method* method : of.methods()) names.push_back(method->name);
    names.insert(names.end(), generic_names().begin(), generic_names().end());
    const std::string hint = name == "new" ? " (write " + of.name() + " { ... } to make one)"
                                           : property::suggestion(name, names);
    throw Error(ErrorKind::unknown_name, of.name() + "." + name + ": no such name" + hint);
}

// Upvalues: a function and a class, which is its first argument.
int call_with_class(lua_State* L) {
    for (const int upvalue : {2, 1}) {
        lua_pushvalue(L, lua_upvalueindex(upvalue));
        lua_insert(L, 1);
    }
    lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
    return lua_gettop(L);
}

/// Whether a library of the framework defined the function at the top of the stack.
bool is_of_library(lua_State* L) {
    lua_Debug facts;
    lua_pushvalue(L, -1);
    lua_getinfo(L, ">S", &facts);
    return is_library(facts);
}

int class_index(lua_State* L) {
    const Class* of = class_object_at(L, 1);
    Machine& machine = machine_of(L);
    if (!of || lua_type(L, 2) != LUA_TSTRING)
        throw Error(ErrorKind::bad_name, "a class has functions by name");
    const std::string name = string_at(L, 2);
    if (machine.classes.push_function(L, *of, 2)) {
        // Such a function makes an instance, of a derived class if it is called there.
        if (is_of_library(L)) {
            lua_pushvalue(L, 1);
            lua_pushcclosure(L, call_with_class, 2);
        }
        return 1;
    }
    if (name == "states" && machine.classes.push_states(L, *of)) return 1;
    if (push_class_field(L, machine, *of, name)) return 1;
    // `on` and `watch` of a class are about all of its instances; other functions are those of each
    // instance, which comes as the first argument.
    if (name == "on") {
        lua_pushcfunction(L, guarded<effect<subscribe_event>>);
    } else if (name == "watch") {
        lua_pushcfunction(L, guarded<effect<subscribe_property>>);
    } else if (const property::Method* method = of->method(name)) {
        push_registry(L, method_reference(L, machine, *method));
    } else if (const int generic = generic_reference(L, machine, name); generic != LUA_NOREF) {
        push_registry(L, generic);
    } else {
        unknown_class_member(machine, *of, name);
    }
    return 1;
}

int class_newindex(lua_State* L) {
    const Class* of = class_object_at(L, 1);
    if (!of || lua_type(L, 2) != LUA_TSTRING)
        throw Error(ErrorKind::bad_name, "a class has functions by name");
    const std::string name = string_at(L, 2);
    machine_of(L).tree.require_changeable("define " + of->name() + "." + name);
    if (name == "states" && lua_istable(L, 3)) {
        lua_settop(L, 3);
        machine_of(L).classes.set_states(L, *of);
        return 0;
    }
    if (lua_type(L, 3) != LUA_TFUNCTION)
        throw Error(ErrorKind::wrong_type,
                    of->name() + "." + name + ": a class takes functions, not " +
                        describe_type(L, 3) + "; properties are declared in class(...) { }");
    lua_settop(L, 3);
    Machine& machine = machine_of(L);
    machine.classes.set_function(L, *of, name);
    return 0;
}

int class_tostring(lua_State* L) {
    const Class* of = class_object_at(L, 1);
    lua_pushstring(L, of ? of->name().c_str() : "class");
    return 1;
}

}  // namespace

void ScriptClasses::push(lua_State* L, const Class& of) {
    Info& own = info(of);
    if (own.object == LUA_NOREF) {
        auto* box = static_cast<ClassBox*>(lua_newuserdatauv(L, sizeof(ClassBox), 0));
        *box = {Tag::class_object, &of};
        push_registry(L, machine_.boxes.class_object);
        lua_setmetatable(L, -2);
        own.object = luaL_ref(L, LUA_REGISTRYINDEX);
    }
    push_registry(L, own.object);
}

void open_classes(lua_State* L, Machine& machine) {
    lua_newtable(L);
    add_pure<construct>(L, "__call");
    add_pure<class_index>(L, "__index");
    add_pure<class_newindex>(L, "__newindex");
    add_pure<class_tostring>(L, "__tostring");
    name_metatable(L, "class");
    machine.boxes.class_object = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
