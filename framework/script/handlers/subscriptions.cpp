#include <algorithm>

#include <fettle/property/path.h>
#include <fettle/property/question.h>
#include <fettle/property/spelling.h>
#include <fettle/script/runtime.h>

#include <calls/function_ref.h>
#include <calls/held_memory.h>
#include <calls/protected.h>
#include <handlers/connections.h>
#include <handlers/subscriptions.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <other_languages/synonyms.h>
#include <values/records.h>
#include <values/values.h>
#include <writes/declarations.h>

namespace fettle::script {

using property::Change;
using property::Event;
using property::Existence;
using property::Occurrence;
using property::WatchOptions;
using Function = Subscription::Function;

// --- Arguments of handlers

namespace {

/// The path of a property; "(deleted ball).mass" if an earlier handler has deleted the instance.
std::string path_or_name(const property::Tree& tree, Handle instance, const Property& property) {
    if (tree.alive(instance)) return tree.path(instance, property);
    const auto remains = tree.deleted_info(instance);
    return "(deleted" + (remains ? " " + remains->name : std::string()) + ")" +
           property::path_suffix(property.name);
}

void push_change(lua_State* L, const Change& change) {
    Machine& machine = machine_of(L);
    lua_createtable(L, 0, 7);
    push_instance(L, change.instance);
    lua_setfield(L, -2, "instance");
    put(L, "property", change.property->name);
    put(L, "path", path_or_name(machine.tree, change.instance, *change.property));
    put(L, "cause", change.cause.text());
    put(L, "step", static_cast<lua_Integer>(change.cause.step));
    put(L, "restored", change.cause.writer == property::Writer::restore);
    seal_record(L, machine);
}

}  // namespace

void push_occurrence(lua_State* L, const Occurrence& occurrence) {
    push_record(L, occurrence.record);
    lua_pushstring(L, "instance");
    push_instance(L, occurrence.instance);
    lua_rawset(L, -3);
    lua_pushstring(L, "step");
    lua_pushinteger(L, static_cast<lua_Integer>(occurrence.step));
    lua_rawset(L, -3);
}

/// Reads the answers from the record at the top of the stack, which was the argument of the
/// handler.
void read_answers(lua_State* L, property::Question& question) {
    const auto& fields = question.event().fields;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        push_text(L, fields[i].name);
        lua_rawget(L, -2);
        question.answer(i, to_value(L, lua_gettop(L)));
        lua_pop(L, 1);
    }
}

bool caused_by_restore(const Existence& existence) {
    return existence.cause.writer == property::Writer::restore;
}

void push_existence(lua_State* L, const Existence& existence) {
    lua_createtable(L, 0, 5);
    push_instance(L, existence.instance);
    lua_setfield(L, -2, "instance");
    put(L, "path", existence.path);
    put(L, "cause", existence.cause.text());
    put(L, "step", static_cast<lua_Integer>(existence.cause.step));
    lua_newtable(L);
    for (const auto& [property, value] : existence.last_values) {
        push_text(L, property->name);
        push_value(L, value);
        lua_rawset(L, -3);
    }
    lua_setfield(L, -2, "last");
    seal_record(L, machine_of(L));
}

// --- Connecting

namespace {

// Keeps the function at `index`. Raises an error for another type.
std::shared_ptr<FunctionRef> function_at(lua_State* L, int index, const char* what) {
    Machine& machine = machine_of(L);
    check_function(L, index, what);
    lua_pushvalue(L, index);
    const std::size_t holds = machine.connections.recorded() ? held_memory(L, machine, -1) : 0;
    auto function = std::make_shared<FunctionRef>(L, machine);
    function->set_holds(holds);
    return function;
}

WatchOptions options_here(lua_State* L) {
    WatchOptions options;
    options.label = position(L);
    if (options.label.size() > 2) options.label.resize(options.label.size() - 2);
    return options;
}

/// Whether the scene whose `enter` connected a handler does not live any more, for example after a
/// rewind. False for a null handle.
bool has_ended(const Machine& machine, Handle scene) {
    return scene && !machine.tree.alive(scene);
}

property::ChangeHandler change_handler(Machine& machine, const Function& function, Handle scene) {
    return [&machine, function, scene](const Change& change) {
        if (has_ended(machine, scene)) return;
        protected_run(machine, Context("watcher", change.instance, change.property),
                      [&](lua_State* L) {
                          function->push(L);
                          push_value(L, change.new_value);
                          push_value(L, change.old_value);
                          push_change(L, change);
                          lua_call(L, 3, 0);
                      });
    };
}

property::ExistenceHandler existence_handler(Machine& machine, const char* name,
                                             const Function& function, Handle scene) {
    return [&machine, function, name, scene](const Existence& existence) {
        if (has_ended(machine, scene) || caused_by_restore(existence)) return;
        protected_run(machine, std::string("handler of ") + name + " of " + existence.path,
                      [&](lua_State* L) {
                          function->push(L);
                          push_existence(L, existence);
                          lua_call(L, 1, 0);
                      });
    };
}

/// A handler of the event `restored` runs while it exists.
class RestoredScope {
  public:
    RestoredScope(Machine& machine, bool is_restored) : running_(machine.globals.in_restored) {
        if (is_restored) ++running_;
    }
    ~RestoredScope() { running_ = before_; }
    RestoredScope(const RestoredScope&) = delete;

  private:
    int& running_;
    const int before_ = running_;
};

property::EventHandler event_handler(Machine& machine, const Event& event, const Function& function,
                                     Handle scene) {
    return [&machine, function, &event, scene](const Occurrence& occurrence) {
        if (has_ended(machine, scene)) return;
        const RestoredScope restored(machine, event.name == "restored");
        const Context context("handler of " + event.name, occurrence.instance);
        protected_run(machine, context, [&](lua_State* M) {
            push_occurrence(M, occurrence);
            function->push(M);
            lua_pushvalue(M, -2);
            lua_call(M, 1, 0);
            property::Question* question = property::Question::current();
            if (question == nullptr) return;
            try {
                read_answers(M, *question);
            } catch (const Error& refused) {
                // No line of the script is running, so the message gets the position of the
                // handler.
                function->push(M);
                throw Error(refused.kind(), definition(M) + refused.what());
            }
        });
    };
}

/// "; Body and Shape have it", or "".
std::string classes_with(const property::Tree& tree, std::string_view event) {
    std::string text;
    for (const Class* of : tree.classes())
        if (const Event* found = of->event(event); found != nullptr && found->owner == of)
            text += (text.empty() ? "; " : " and ") + of->name();
    return text.empty() ? text : text + (text.find(" and ") == text.npos ? " has it" : " have it");
}

const Event& event_of(const property::Tree& tree, const Class& of, const std::string& name) {
    if (const Event* event = of.event(name)) return *event;
    std::vector<std::string> names = {"created"};
    for (const Event* event : of.events()) names.push_back(event->name);
    // What this class has under another name comes before other classes that have this name.
    std::string hint;
    for (const std::string_view meant : callback_synonyms(name))
        if (of.event(std::string(meant)) != nullptr) hint = hint_at({meant}, name, names);
    if (hint.empty()) hint = classes_with(tree, name);
    if (hint.empty()) hint = hint_at(callback_synonyms(name), name, names);
    if (hint.empty()) {
        hint = "; it has ";
        for (const std::string& known : names) hint += (&known == names.data() ? "" : ", ") + known;
    }
    throw Error(ErrorKind::unknown_name, of.name() + ": no event \"" + name + "\"" + hint);
}

}  // namespace

Subscription event_subscription(lua_State* L, Machine& machine, const Class& of,
                                const std::string& name, bool whole_class) {
    const WatchOptions options = options_here(L);
    const Handle scene = machine.globals.entering;
    Function function = function_at(L, lua_gettop(L), "on");
    property::Tree& tree = machine.tree;
    if (name == "deleted")
        return {function, [&machine, &tree, &of, options, whole_class, scene](
                              Handle instance, const Function& called) {
                    auto handler = existence_handler(machine, "deleted", called, scene);
                    return whole_class ? tree.watch_deleted(of, handler, options)
                                       : tree.watch_deleted(instance, handler, options);
                }};
    if (name == "created" && whole_class)
        return {function, [&machine, &tree, &of, options, scene](Handle, const Function& called) {
                    return tree.watch_created(
                        of, existence_handler(machine, "created", called, scene), options);
                }};
    const Event& event = event_of(tree, of, name);
    return {function, [&machine, &tree, &of, &event, options, whole_class, scene](
                          Handle instance, const Function& called) {
                auto handler = event_handler(machine, event, called, scene);
                return whole_class ? tree.on(of, event, handler, options)
                                   : tree.on(instance, event, handler, options);
            }};
}

namespace {

/// `name`: of a property; empty: all of the instance.
Subscription property_subscription(lua_State* L, Machine& machine, int function,
                                   const std::string& name) {
    return {function_at(L, function, "watch"),
            [&machine, options = options_here(L), scene = machine.globals.entering, name](
                Handle instance, const Function& called) {
                const auto handler = change_handler(machine, called, scene);
                return name.empty() ? machine.tree.watch(instance, handler, options)
                                    : machine.tree.watch(instance, name, handler, options);
            }};
}

/// `property`: null for all of the class.
Subscription class_subscription(lua_State* L, Machine& machine, int function, const Class& of,
                                const Property* property) {
    return {function_at(L, function, "watch"),
            [&machine, &of, property, options = options_here(L), scene = machine.globals.entering](
                Handle, const Function& called) {
                return machine.tree.watch(of, property, change_handler(machine, called, scene),
                                          options);
            }};
}

}  // namespace

int subscribe_event(lua_State* L) {
    Machine& machine = machine_of(L);
    lua_settop(L, 3);
    const Class* whole = class_object_at(L, 1);
    const Handle self = whole ? Handle{} : check_instance(L, 1, "on");
    const std::string name = check_text(L, 2, "on: needs the name of an event");
    const Class& of = whole ? *whole : machine.tree.class_of(self);
    machine.connections.push(L, self, event_subscription(L, machine, of, name, whole != nullptr));
    return 1;
}

int subscribe_property(lua_State* L) {
    Machine& machine = machine_of(L);
    const Class* whole = class_object_at(L, 1);
    const Handle self = whole ? Handle{} : check_instance(L, 1, "watch");
    const int last = lua_gettop(L) >= 3 ? 3 : 2;
    if (last == 2) {
        if (whole)
            machine.connections.push(L, {}, class_subscription(L, machine, last, *whole, nullptr));
        else
            machine.connections.push(L, self, property_subscription(L, machine, last, {}));
        return 1;
    }
    check_function(L, last, "watch");
    const std::string name = check_text(L, 2, "watch: needs the name of a property");
    if (!whole) {
        machine.tree.property(self, name);  // must exist
        machine.connections.push(L, self, property_subscription(L, machine, last, name));
        return 1;
    }
    const Property* property = whole->property(name);
    if (!property)
        throw Error(ErrorKind::unknown_name, whole->name() + "." + name + ": no such property" +
                                                 property::suggestion(name, whole->member_names()));
    machine.connections.push(L, {}, class_subscription(L, machine, last, *whole, property));
    return 1;
}

namespace {

/// The target of a path. During a reload, this may be an instance that is not in its place yet.
property::Place place_of_path(const Machine& machine, const std::string& path) {
    if (machine.declarations.reloading())
        if (const auto waiting = machine.declarations.find_future(path)) return *waiting;
    return property::resolve(machine.tree, path);
}

/// The name that is probably meant: a name of a series (wheel1, wheel2) may be one that comes.
std::string misspelled(const std::string& name, std::vector<std::string> known) {
    constexpr std::size_t least = 3;  // letters; shorter names are similar to too many others
    if (name.size() < least) return {};
    const std::size_t limit = std::max<std::size_t>(1, name.size() / 3);
    std::erase_if(known, [&](const std::string& each) {
        return each.size() < least || property::of_one_series(name, each) ||
               property::edit_distance(name, each, limit) > limit;
    });
    return property::suggestion(name, known);
}

/// What a pattern that matches nothing now has wrong; "" if nothing is similar to its names.
std::string mistake_in(const property::Tree& tree, const property::Pattern& pattern) {
    const std::vector<std::string>& names = pattern.segments();
    Handle at = tree.root();  // where the names without stars at the beginning lead
    for (std::size_t i = 0; i + 1 < names.size(); ++i) {
        if (names[i].find('*') != std::string::npos) {
            at = {};
        } else if (at) {
            if (const Handle child = tree.child(at, names[i])) {
                at = child;
                continue;
            }
            std::vector<std::string> known;
            for (const Handle child : tree.children(at)) known.push_back(tree.name(child));
            if (const std::string hint = misspelled(names[i], std::move(known)); !hint.empty())
                return tree.path(at) + " has no child \"" + names[i] + "\"" + hint;
            return {};  // it may come
        }
    }
    // A name that is known may be one that the game adds.
    const std::string& name = names.back();
    if (name.find('*') != std::string::npos || property::Symbol::find(name)) return {};
    std::vector<std::string> known;
    for (const Class* of : tree.classes())
        for (const std::string& each : of->member_names()) known.push_back(each);
    const std::string hint = misspelled(name, std::move(known));
    return hint.empty() ? hint : "no class has a property \"" + name + "\"" + hint;
}

/// A pattern matches what may come, so a name that nothing has is a note and no error, and only if
/// something has nearly that name.
void note_mistake(Machine& machine, lua_State* L, const std::string& text) {
    if (!machine.host.on_note) return;
    const std::string mistake = mistake_in(machine.tree, property::Pattern(text));
    if (!mistake.empty() && machine.connections.notes(mistake))
        machine.host.on_note(position(L) + "watch: nothing matches \"" + text +
                             "\" now: " + mistake);
}

// Implements watch("world.*.velocity", fn).
int watch_pattern(lua_State* L) {
    Machine& machine = machine_of(L);
    lua_settop(L, 2);
    const std::string pattern =
        check_text(L, 1, "watch: needs a pattern such as \"world.*.velocity\"");
    if (pattern.find('*') == std::string::npos) {
        // Without a wildcard, the path must exist, so that a spelling error is reported.
        const property::Place place = place_of_path(machine, pattern);
        machine.connections.push(
            L, place.instance,
            property_subscription(L, machine, 2,
                                  place.property ? place.property->name : std::string()));
        return 1;
    }
    note_mistake(machine, L, pattern);
    Subscription subscription{function_at(L, 2, "watch"),
                              [&machine, pattern, options = options_here(L),
                               scene = machine.globals.entering](Handle, const Function& called) {
                                  return machine.tree.watch_pattern(
                                      pattern, change_handler(machine, called, scene), options);
                              }};
    machine.connections.push(L, {}, std::move(subscription));
    return 1;
}

}  // namespace

void open_watch(lua_State* L) {
    add_function<watch_pattern>(L, "watch");
}

}  // namespace fettle::script
