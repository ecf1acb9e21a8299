#include <algorithm>
#include <utility>

#include <fettle/property/redefinition.h>
#include <fettle/property/spelling.h>

#include <calls/protected.h>
#include <classes/own_events.h>
#include <classes/reflection.h>
#include <classes/script_classes.h>
#include <classes/unplaced_instances.h>
#include <handlers/connections.h>
#include <handlers/subscriptions.h>
#include <limits/limiters.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <reference/language.h>
#include <text/words.h>
#include <values/members.h>
#include <values/values.h>
#include <writes/declarations.h>

namespace fettle::script {

namespace {

bool is_callback(std::string_view name) {
    return name == "ready" || name == "step" || name == "draw";
}

}  // namespace

// --- Functions

// The tables of functions of the class and its bases, nearest first.
const std::vector<int>& ScriptClasses::chain(const Class& of) {
    if (const auto found = chains_.find(&of); found != chains_.end()) return found->second;
    std::vector<int> tables;
    for (const Class* c = &of; c; c = c->base())
        if (const auto found = infos_.find(c);
            found != infos_.end() && found->second.functions != LUA_NOREF)
            tables.push_back(found->second.functions);
    return chains_.emplace(&of, std::move(tables)).first->second;
}

bool ScriptClasses::push_function(lua_State* L, const Class& of, int name) {
    if (!any_functions_) return false;
    for (const int table : chain(of)) {
        push_registry(L, table);
        lua_pushvalue(L, name);
        const bool found = lua_rawget(L, -2) != LUA_TNIL;
        lua_remove(L, -2);
        if (found) return true;
        lua_pop(L, 1);
    }
    return false;
}

bool ScriptClasses::push_function(lua_State* L, const Class& of, std::string_view name) {
    push_text(L, name);
    const bool found = push_function(L, of, lua_gettop(L));
    lua_remove(L, found ? -2 : -1);
    return found;
}

const Class* ScriptClasses::definer(const Class& of, std::string_view name) {
    for (const Class* c = &of; c; c = c->base()) {
        const auto found = infos_.find(c);
        if (found == infos_.end()) continue;
        if (among(found->second.function_names, name)) return c;
    }
    return nullptr;
}

bool ScriptClasses::has_function(const Class& of, std::string_view name) {
    return any_functions_ && definer(of, name) != nullptr;
}

std::vector<std::string> ScriptClasses::own_functions(const Class& of) const {
    const auto found = infos_.find(&of);
    return found == infos_.end() ? std::vector<std::string>() : found->second.function_names;
}

void ScriptClasses::add_function_names(const Class& of, std::vector<std::string>& names) {
    for (const Class* c = &of; c; c = c->base())
        if (const auto found = infos_.find(c); found != infos_.end())
            for (const std::string& name : found->second.function_names)
                if (!among(names, name)) names.push_back(name);
}

void ScriptClasses::set_function(lua_State* L, const Class& of, const std::string& name) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::bad_name, of.name() + "." + name + ": " + why);
    };
    if (of.property(name)) refuse("is a property already");
    if (of.method(name)) refuse("is a method already");
    if (among(generic_names(), name)) refuse("is a method of every instance already");
    if (among(class_fields(), name)) refuse("every class has that");
    const bool is_event = of.event(name) != nullptr || name == "deleted";
    if (is_callback(name) && !is_event && !scripted(of))
        refuse("only classes made with class(...) have it; derive one from " + of.name());
    if (!is_event && !is_callback(name)) {
        std::vector<std::string> events = {"ready", "deleted"};
        for (const property::Event* event : of.events()) events.push_back(event->name);
        for (const std::string& event : events)
            if (name.size() >= 8 && property::near_miss(name, event))
                refuse("no such event (did you mean \"" + event + "\"?)");
    }
    Info& own = info(of);
    if (own.functions == LUA_NOREF) {
        lua_newtable(L);
        own.functions = luaL_ref(L, LUA_REGISTRYINDEX);
        chains_.clear();
    }
    any_functions_ = true;
    push_registry(L, own.functions);
    push_text(L, name);
    lua_pushvalue(L, -3);
    lua_rawset(L, -3);
    lua_pop(L, 2);
    if (!among(own.function_names, name)) own.function_names.push_back(name);
    if (is_event && !is_callback(name)) connect(of, name);
}

// Connects one handler for each class and event. The function is looked up when the event occurs,
// so that a redefinition takes effect and a derived class's function replaces the base's.
void ScriptClasses::connect(const Class& of, const std::string& name) {
    Info& own = info(of);
    if (among(own.connected, name)) return;
    own.connected.push_back(name);
    const Class* here = &of;
    const auto run = [this, here, name](const Class& actual, Handle instance, auto push) {
        if (definer(actual, name) != here) return;
        protected_run(machine_, Context(actual.name() + ":" + name, instance), [&](lua_State* L) {
            push(L);
            if (!push_function(L, actual, name)) return;
            push_instance(L, instance);
            lua_pushvalue(L, -3);
            lua_call(L, 2, 0);
            if (property::Question* question = property::Question::current())
                read_answers(L, *question);
        });
    };
    if (name == "deleted") {
        machine_.connections.keep(
            machine_.tree.watch_deleted(of, [run](const property::Existence& existence) {
                if (caused_by_restore(existence)) return;
                run(*existence.instance_class, existence.instance,
                    [&](lua_State* L) { push_existence(L, existence); });
            }));
        return;
    }
    machine_.connections.keep(
        machine_.tree.on(of, *of.event(name), [this, run](const property::Occurrence& occurrence) {
            if (!machine_.tree.alive(occurrence.instance)) return;
            run(machine_.tree.class_of(occurrence.instance), occurrence.instance,
                [&](lua_State* L) { push_occurrence(L, occurrence); });
        }));
}

void ScriptClasses::forget_functions() {
    unfinished_.clear();
    places_.clear();
    lua_State* L = machine_.lua.main;
    for (auto& [of, own] : infos_) {
        if (own.functions != LUA_NOREF) luaL_unref(L, LUA_REGISTRYINDEX, own.functions);
        own.functions = LUA_NOREF;
        if (own.states != LUA_NOREF) luaL_unref(L, LUA_REGISTRYINDEX, own.states);
        own.states = LUA_NOREF;
        own.function_names.clear();
        own.connected.clear();
    }
    chains_.clear();
    any_functions_ = false;
    any_states_ = false;
    waiting_.clear();
    for (const auto& [of, own] : infos_)
        if (own.scripted) observe(*of);
}

// --- Definition

bool ScriptClasses::scripted(const Class& of) const {
    const auto found = infos_.find(&of);
    return found != infos_.end() && found->second.scripted;
}

// Instances that no constructor of a script made (by a scene file or a module) get the class's
// callbacks, too. One that undo or redo brings back has been ready: it has what `ready` made below
// it, and would get that twice.
void ScriptClasses::observe(const Class& of) {
    // The observer of the base includes these instances.
    if (of.base() && scripted(*of.base())) return;
    machine_.connections.keep(
        machine_.tree.watch_created(of, [this](const property::Existence& existence) {
            if (!machine_.tree.alive(existence.instance)) return;
            if (adopt(existence.instance) && existence.cause.writer != property::Writer::undo)
                wait_for(existence.instance, false);
        }));
}

bool ScriptClasses::adopt(Handle instance) {
    if (!known_.insert(instance.key()).second) return false;
    if (members_.size() >= prune_at_) {
        forget_ended();
        prune_at_ = std::max<std::size_t>(1024, 2 * members_.size());
    }
    members_.push_back(instance);
    if (noting_) changes_.adopted.push_back(instance);
    return true;
}

void ScriptClasses::forget_ended() {
    std::erase_if(members_, [this](Handle member) {
        if (machine_.tree.alive(member)) return false;
        known_.erase(member.key());
        return true;
    });
}

void ScriptClasses::wait_for(Handle instance, bool announce) {
    waiting_.push_back({instance, announce});
    if (!noting_) return;
    changes_.waiting.push_back(waiting_.back());
    if (changes_.waiting.size() > 65536) changes_ = {};  // they are not taken any more
}

namespace {

/// How the properties of the first definition of a class differ from those of the second; "" if
/// they do not.
std::string difference(const Class& first, const std::vector<Property>& second) {
    for (const Property& property : second) {
        const Property* found = first.property(property.name);
        if (!found || found->owner != &first) return "the first has no \"" + property.name + "\"";
        if (found->type != property.type)
            return "\"" + property.name + "\" is " +
                   property::with_article(property::type_name(found->type)) + " in the first and " +
                   property::with_article(property::type_name(property.type)) + " in the second";
    }
    for (const Property* found : first.properties())
        if (found->owner == &first &&
            std::ranges::find(second, found->name, &Property::name) == second.end())
            return "the second has no \"" + found->name + "\"";
    return {};
}

}  // namespace

/// `first`: "main.lua:3: ", where this load has defined it; "" if an earlier one has.
void ScriptClasses::refuse_base(const Class& existing, const std::string& first) const {
    const std::string which = ": exists already with another base, " + existing.base()->name();
    if (!first.empty())
        throw Error(ErrorKind::bad_name,
                    existing.name() + which + ", from " + first.substr(0, first.size() - 2));
    throw Error(ErrorKind::bad_name, existing.name() + which +
                                         "; a class keeps its base while the game runs: restart() "
                                         "in the console begins the game again with the new one");
}

void ScriptClasses::note_second(const std::string& name, const std::string& first,
                                const std::string& second) const {
    if (first.empty() || first == second || !machine_.declarations.active() ||
        !machine_.host.on_note)
        return;
    machine_.host.on_note(second + "class " + name + " is defined already, at " +
                          first.substr(0, first.size() - 2) +
                          ": the two are one class, which has the functions of both; give one of "
                          "them another name, or define it in one file");
}

const Class& ScriptClasses::define(Definition definition) {
    const auto begun = unfinished_.find(definition.name);
    const std::string place = begun == unfinished_.end() ? std::string() : begun->second;
    if (begun != unfinished_.end()) unfinished_.erase(begun);
    const std::string first = std::exchange(places_[definition.name], place);
    const Class* existing = machine_.tree.find_class(definition.name);
    if (existing) {
        if (!scripted(*existing))
            throw Error(ErrorKind::bad_name, definition.name + ": is a class of the framework");
        if (existing->base() == definition.base) note_second(definition.name, first, place);
        if (existing->base() == definition.base && machine_.declarations.reloading()) {
            info(*existing).defaults.clear();
            declare_events(*existing, {});  // a property may take the name of one
            property::redefine(machine_.tree, *existing, std::move(definition.properties));
            declare_events(*existing, std::move(definition.events));
            machine_.members.clear();
            return *existing;
        }
        if (existing->base() != definition.base) refuse_base(*existing, first);
        if (const std::string how = difference(*existing, definition.properties); !how.empty())
            throw Error(ErrorKind::bad_name,
                        definition.name + ": exists already with other properties: " + how);
        Info& own = info(*existing);
        if (const std::string how = difference(own.events, definition.events); !how.empty())
            throw Error(ErrorKind::bad_name,
                        definition.name + ": exists already with other events: " + how);
        own.defaults.clear();
        // In the order in which properties are set together.
        for (const Property* declared : existing->properties())
            for (const Property& property : definition.properties)
                if (property.name == declared->name &&
                    !(declared->default_value == property.default_value))
                    own.defaults.emplace_back(declared, property.default_value);
        return *existing;
    }
    property::ClassDescriptor descriptor;
    descriptor.name = definition.name;
    descriptor.base = definition.base->name();
    descriptor.doc = definition.doc;
    descriptor.creatable = true;
    descriptor.properties = std::move(definition.properties);
    const Class& made = machine_.tree.define(std::move(descriptor));
    Info& own = info(made);
    own.scripted = true;
    declare_events(made, std::move(definition.events));
    observe(made);
    return made;
}

// --- Instances

Handle ScriptClasses::create(const Class& of) {
    const Handle made = machine_.tree.create(of);
    machine_.unplaced.handles.push_back(made);
    // Defaults of the base first, so that those of derived classes override them.
    std::vector<const Class*> up;
    for (const Class* c = &of; c; c = c->base())
        if (scripted(*c)) up.push_back(c);
    if (up.empty()) {
        wait_for(made, true);
        return made;
    }
    if (adopt(made)) wait_for(made, true);
    try {
        for (auto c = up.rbegin(); c != up.rend(); ++c)
            for (const auto& [property, value] : info(**c).defaults)
                machine_.tree.set(made, *property, value);
    } catch (...) {
        machine_.tree.destroy(made);
        throw;
    }
    return made;
}

void ScriptClasses::explain_integer(const Property& property, const Value& value) const {
    if (property.type != Type::integer || !value.is(Type::number) || !property.owner ||
        !scripted(*property.owner))
        return;
    const double number = value.number();
    if (number ==
        static_cast<double>(static_cast<std::int64_t>(std::clamp(number, -9.0e18, 9.0e18))))
        return;
    const std::string declared = property::value_text(property.default_value);
    throw Error(ErrorKind::wrong_type, property.owner->name() + "." + property.name + ": " +
                                           property::number_text(number) +
                                           " is not an integer, and the class declares " +
                                           property.name + " = " + declared + "; declare " +
                                           declared + ".0 for a property that takes any number");
}

bool ScriptClasses::deliver_ready() {
    if (waiting_.empty()) return true;
    // An unplaced instance can become ready only after a change of the tree's structure.
    const auto now = std::pair(machine_.tree.structure(), waiting_.size());
    if (std::exchange(last_check_, now) == now) return true;
    struct Due {
        std::size_t depth;
        Waiting what;
    };
    std::vector<Due> due;
    const Handle root = machine_.tree.root();
    std::erase_if(waiting_, [&](const Waiting& waiting) {
        const Handle instance = waiting.instance;
        if (!machine_.tree.alive(instance)) return true;
        if (!machine_.tree.is_below(instance, root)) return false;
        std::size_t depth = 0;
        for (Handle up = instance; up; up = machine_.tree.parent(up)) ++depth;
        due.push_back({depth, waiting});
        if (noting_) changes_.ready.push_back(instance);
        return true;
    });
    std::stable_sort(due.begin(), due.end(),
                     [](const Due& a, const Due& b) { return a.depth > b.depth; });
    const property::Event* event = machine_.tree.object_class().event("ready");
    bool ok = true;
    for (const Due& one : due) {
        const Waiting& each = one.what;
        if (!machine_.tree.alive(each.instance)) continue;
        if (each.announce && event && machine_.tree.listens(each.instance, *event))
            machine_.tree.emit(each.instance, *event, {});
        const Class& of = machine_.tree.class_of(each.instance);
        if (!has_function(of, "ready")) continue;
        ok &= protected_run(machine_, Context("ready", each.instance), [&](lua_State* L) {
            if (!push_function(L, of, "ready")) return;
            push_instance(L, each.instance);
            lua_call(L, 1, 0);
        });
    }
    return ok;
}

template <class Push>
bool ScriptClasses::call_all(const char* name, Push push) {
    if (!any_functions_ || members_.empty()) return true;
    const Handle root = machine_.tree.root();
    bool ok = true;
    bool stopped = false;
    bool ended = false;
    // Instances that are created meanwhile are called next time. The functions of a host may step
    // again or restore a snapshot, and both change `members_`.
    const std::vector<Handle> called = members_;
    for (const Handle instance : called) {
        if (!machine_.tree.alive(instance)) {
            ended = true;
            continue;
        }
        const Class& of = machine_.tree.class_of(instance);
        if (stopped || !has_function(of, name) || !machine_.tree.is_below(instance, root)) continue;
        ok &= protected_run(machine_, Context(of.name() + ":" + name, instance), [&](lua_State* L) {
            if (!push_function(L, of, name)) return;
            push_instance(L, instance);
            push(L);
            lua_call(L, 2, 0);
        });
        stopped = machine_.limiters.watchdog.stopped();
    }
    if (ended) forget_ended();
    return ok;
}

bool ScriptClasses::step(double dt) {
    return call_all("step", [dt](lua_State* L) { lua_pushnumber(L, dt); });
}

bool ScriptClasses::draw(Handle instance, int pen) {
    const Class& of = machine_.tree.class_of(instance);
    return protected_run(machine_, Context(of.name() + ":draw", instance), [&](lua_State* L) {
        if (!push_function(L, of, "draw")) return;
        push_instance(L, instance);
        push_registry(L, pen);
        lua_call(L, 2, 0);
    });
}

std::string hint_of_unfinished_class(const ScriptClasses& classes, std::string_view name) {
    if (!classes.unfinished().contains(name)) return {};
    return ", because its class has no table" +
           hint_to_write("class(\"" + std::string(name) + "\", Body) { }");
}

}  // namespace fettle::script
