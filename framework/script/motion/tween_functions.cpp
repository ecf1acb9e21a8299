// tween(target, property, to, seconds, ease, options), tween.sequence, tween.parallel.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fettle/property/spelling.h>

#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <motion/ease.h>
#include <motion/tweens.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

namespace {

double seconds_at(lua_State* L, int index) {
    if (lua_type(L, index) != LUA_TNUMBER) refuse_type(L, index, "tween: needs a time in seconds");
    const double seconds = lua_tonumber(L, index);
    constexpr double longest_tween = 1e9;
    if (!(seconds >= 0 && seconds <= longest_tween))
        throw Error(ErrorKind::out_of_range, "tween: expected a time from 0 to 1e9 s, got " +
                                                 property::number_text(seconds));
    return seconds;
}

double ease_value(lua_State* L, int index) {
    const bool number = lua_type(L, index) == LUA_TNUMBER;
    const double part = number ? lua_tonumber(L, index) : 0;
    if (number && std::isfinite(part)) return part;
    throw Error(ErrorKind::wrong_type,
                "tween: an ease gives numbers, not " +
                    (number ? property::number_text(part) : describe_type(L, index)));
}

/// The function is called now, so that the tween holds only values and can be saved.
property::List sampled(lua_State* L, int index) {
    property::List curve;
    for (int i = 0; i < ease_samples; ++i) {
        lua_pushvalue(L, index);
        lua_pushnumber(L, static_cast<double>(i) / (ease_samples - 1));
        lua_call(L, 1, 1);
        curve.emplace_back(ease_value(L, -1));
        lua_pop(L, 1);
    }
    return curve;
}

property::List listed(lua_State* L, int index) {
    const Value given = to_value(L, index, [] { return std::string("tween: its ease"); });
    property::List curve;
    for (const Value& each : given.list()) {
        if (!each.is_numeric() || !std::isfinite(each.as_double()))
            throw Error(ErrorKind::wrong_type, "tween: an ease that is a list has numbers, not " +
                                                   property::value_text(each));
        curve.emplace_back(each.as_double());
    }
    if (curve.size() < 2)
        throw Error(ErrorKind::wrong_type,
                    "tween: an ease that is a list has two numbers at least");
    return curve;
}

/// The nearest name, or else how all of them are made.
std::string near_ease(const std::string& name) {
    std::string near = property::suggestion(name, ease_names());
    if (!near.empty()) return near;
    return "; there are \"linear\", and in_, out_ or in_out_ before quad, cubic, quart, quint, "
           "sine, expo, circ, back, elastic and bounce";
}

void read_ease(lua_State* L, int index, Tweens::Plan& plan) {
    switch (lua_type(L, index)) {
        case LUA_TNONE:
        case LUA_TNIL:
            return;
        case LUA_TSTRING:
            plan.ease = string_at(L, index);
            for (const std::string& known : ease_names())
                if (plan.ease == known) return;
            throw Error(ErrorKind::unknown_name,
                        "tween: no ease \"" + plan.ease + "\"" + near_ease(plan.ease));
        case LUA_TFUNCTION:
            plan.ease = "curve";
            plan.curve = sampled(L, index);
            return;
        case LUA_TTABLE:
            plan.ease = "curve";
            plan.curve = listed(L, index);
            return;
        default:
            refuse_type(L, index, "tween: its ease is a name, a function or a list of numbers");
    }
}

/// The tweens and pauses in the list at 1; in a group of the kind "parallel" a pause is an error.
std::vector<Handle> members(lua_State* L, const char* kind, bool pauses) {
    Machine& machine = machine_of(L);
    const std::string what = std::string("tween.") + kind;
    if (lua_gettop(L) > 1)
        throw Error(ErrorKind::wrong_type,
                    what + ": takes one list, as in " + what + " { a, b }, with a dot");
    if (!lua_istable(L, 1)) refuse_type(L, 1, what + ": needs a list of tweens");
    std::vector<Handle> found;
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, 1));
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_rawgeti(L, 1, i);
        const auto* box = instance_at(L, -1);
        if (box != nullptr && machine.tweens.groupable(box->handle)) {
            for (const Handle other : found)
                if (other == box->handle)
                    throw Error(ErrorKind::bad_structure, what + ": element " + std::to_string(i) +
                                                              " is in the list already");
            found.push_back(box->handle);
        } else if (pauses && lua_type(L, -1) == LUA_TNUMBER) {
            found.push_back(machine.tweens.add_pause(seconds_at(L, -1)));
        } else {
            throw Error(ErrorKind::wrong_type,
                        what + ": element " + std::to_string(i) + " is " + describe_type(L, -1) +
                            ", expected a tween or group that is in no other group" +
                            (pauses ? ", or a number of seconds" : ""));
        }
        lua_pop(L, 1);
    }
    return found;
}

const std::vector<std::string>& tween_option_names() {
    static const std::vector<std::string> names{"alternate", "loops", "pauses"};
    return names;
}

/// Writes the value at the top of the stack to the option whose name is below it.
void take_option(lua_State* L, Handle made) {
    const std::string name = lua_type(L, -2) == LUA_TSTRING ? string_at(L, -2) : "";
    if (std::ranges::find(tween_option_names(), name) == tween_option_names().end())
        throw Error(ErrorKind::unknown_name, "tween: there is no option " + short_text(L, -2) +
                                                 property::suggestion(name, tween_option_names()));
    machine_of(L).tree.set(made, name, to_value(L, -1));
}

/// A group of what is in the list at 1, which may hold options: { a, b, loops = 0 }.
int group_of(lua_State* L, const char* kind, bool pauses) {
    Machine& machine = machine_of(L);
    const Handle made = machine.tweens.add_group(kind, members(L, kind, pauses));
    try {
        for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1))
            if (lua_isinteger(L, -2) == 0) take_option(L, made);
    } catch (const Error&) {
        machine.tree.destroy(made);
        throw;
    }
    push_instance(L, made);
    return 1;
}

int tween_sequence(lua_State* L) {
    return group_of(L, in_sequence, true);
}

int tween_parallel(lua_State* L) {
    return group_of(L, in_parallel, false);
}

/// The global `tween` is a table that can be called; the call passes the table first.
int call_tween(lua_State* L) {
    lua_remove(L, 1);
    return tween_function(L);
}

}  // namespace

namespace {

/// Whether the value is a table with options such as { pauses = false }, and no list.
bool is_options(lua_State* L, int index) {
    return lua_istable(L, index) && lua_rawlen(L, index) == 0;
}

/// Writes { pauses = false, loops = 0 } to the properties of the tween.
void take_options(lua_State* L, int index, Handle tween) {
    if (lua_isnoneornil(L, index)) return;
    if (!is_options(L, index)) refuse_type(L, index, "tween: needs options such as { loops = 0 }");
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) take_option(L, tween);
}

/// Throws Error if `name` is a component of a property, such as "position.x" or "position:x".
void require_whole_value(const property::Tree& tree, property::Handle target,
                         const std::string& name) {
    const std::size_t point = name.find_first_of(".:");
    if (point == std::string::npos || tree.find(target, name) != nullptr) return;
    const std::string whole = name.substr(0, point);
    if (tree.find(target, whole) == nullptr) return;
    throw Error(ErrorKind::unknown_name, "tween: " + tree.path(target) + " has no property \"" +
                                             name + "\"; tween the whole value, such as tween(" +
                                             tree.path(target) + ", \"" + whole + "\", vec(3, " +
                                             tree.path(target) + "." + whole + ".y), 1)");
}

}  // namespace

int tween_function(lua_State* L) {
    lua_settop(L, 6);
    if (lua_isnil(L, 6) && is_options(L, 5)) {
        lua_pushnil(L);
        lua_insert(L, 5);
        lua_settop(L, 6);
    }
    Tweens::Plan plan;
    if (vec_at(L, 1) != nullptr)
        throw Error(ErrorKind::wrong_type,
                    "tween: needs an instance, not a vec: tween(ball, \"position\", vec(3, "
                    "ball.position.y), 1) moves it along x");
    plan.target = check_instance(L, 1, "tween");
    plan.property = check_text(L, 2, "tween: needs the name of a property");
    require_whole_value(machine_of(L).tree, plan.target, plan.property);
    plan.to = to_value(L, 3, [] { return std::string("tween"); });
    plan.seconds = seconds_at(L, 4);
    read_ease(L, 5, plan);
    const Handle made = machine_of(L).tweens.add(plan);
    try {
        take_options(L, 6, made);
    } catch (const Error&) {
        machine_of(L).tree.destroy(made);
        throw;
    }
    push_instance(L, made);
    return 1;
}

void open_tweens(lua_State* L) {
    lua_newtable(L);
    add_function<tween_sequence>(L, "sequence");
    add_function<tween_parallel>(L, "parallel");
    lua_newtable(L);
    note_name(L, guarded<effect<call_tween>>, "tween");
    add_function<call_tween>(L, "__call");
    lua_setmetatable(L, -2);
    lua_setfield(L, -2, "tween");
}

}  // namespace fettle::script
