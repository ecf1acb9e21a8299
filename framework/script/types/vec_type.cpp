// The type vec(x, y): arithmetic and methods.

#include <cmath>

#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/short_text.h>
#include <values/store_type.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/writes.h>

namespace fettle::script {

namespace {

[[noreturn]] void bad_operand(lua_State* L, const char* operation) {
    const int wrong = vec_at(L, 1) ? 2 : 1;
    throw Error(ErrorKind::wrong_type,
                std::string("vec ") + operation + ": cannot use " + describe_type(L, wrong) +
                    (lua_type(L, wrong) == LUA_TNUMBER ? " (write vec(x, y))" : ""));
}

int vec_add(lua_State* L) {
    const auto *a = vec_at(L, 1), *b = vec_at(L, 2);
    if (!a || !b) bad_operand(L, "+");
    push_vec(L, {a->x + b->x, a->y + b->y});
    return 1;
}

int vec_subtract(lua_State* L) {
    const auto *a = vec_at(L, 1), *b = vec_at(L, 2);
    if (!a || !b) bad_operand(L, "-");
    push_vec(L, {a->x - b->x, a->y - b->y});
    return 1;
}

int vec_multiply(lua_State* L) {
    if (const auto* a = vec_at(L, 1)) {
        if (vec_at(L, 2))
            throw Error(ErrorKind::wrong_type,
                        "vec * vec: say which product you mean, a:dot(b) or a:cross(b)");
        if (lua_type(L, 2) != LUA_TNUMBER) bad_operand(L, "*");
        const double s = lua_tonumber(L, 2);
        push_vec(L, {a->x * s, a->y * s});
        return 1;
    }
    if (lua_type(L, 1) != LUA_TNUMBER) bad_operand(L, "*");
    const double s = lua_tonumber(L, 1);
    const auto* b = vec_at(L, 2);
    push_vec(L, {s * b->x, s * b->y});
    return 1;
}

int vec_divide(lua_State* L) {
    const auto* a = vec_at(L, 1);
    if (!a || lua_type(L, 2) != LUA_TNUMBER) bad_operand(L, "/");
    const double s = lua_tonumber(L, 2);
    push_vec(L, {a->x / s, a->y / s});
    return 1;
}

int vec_negate(lua_State* L) {
    const auto* a = vec_at(L, 1);
    push_vec(L, {-a->x, -a->y});
    return 1;
}

int vec_equal(lua_State* L) {
    const auto *a = vec_at(L, 1), *b = vec_at(L, 2);
    lua_pushboolean(L, a && b && a->x == b->x && a->y == b->y);
    return 1;
}

int vec_tostring(lua_State* L) {
    const Vec2 v = check_vec(L, 1, "tostring");
    const std::string text = property::value_text(v, property::shortest_precision(v));
    push_text(L, text);
    return 1;
}

// --- Methods

int vec_length(lua_State* L) {
    const Vec2 v = check_vec(L, 1, "length");
    lua_pushnumber(L, std::hypot(v.x, v.y));
    return 1;
}

int vec_distance(lua_State* L) {
    const Vec2 a = check_vec(L, 1, "distance"), b = check_vec(L, 2, "distance");
    lua_pushnumber(L, std::hypot(a.x - b.x, a.y - b.y));
    return 1;
}

// A zero or infinite vector is returned unchanged.
int vec_normalized(lua_State* L) {
    const Vec2 v = check_vec(L, 1, "normalized");
    const double length = std::hypot(v.x, v.y);
    push_vec(L, length > 0 && std::isfinite(length) ? Vec2(v / length) : v);
    return 1;
}

int vec_limited(lua_State* L) {
    const Vec2 v = check_vec(L, 1, "limited");
    const double most = check_number(L, 2, "limited"), length = std::hypot(v.x, v.y);
    if (!(most >= 0))
        throw Error(ErrorKind::out_of_range, "limited: " + property::number_text(most) +
                                                 " is not a length, which is 0 or more");
    push_vec(L, length > most && std::isfinite(length) ? Vec2(v * (most / length)) : v);
    return 1;
}

int vec_floor(lua_State* L) {
    const Vec2 v = check_vec(L, 1, "floor");
    push_vec(L, {std::floor(v.x), std::floor(v.y)});
    return 1;
}

int vec_round(lua_State* L) {
    const Vec2 v = check_vec(L, 1, "round");
    push_vec(L, {std::floor(v.x + 0.5), std::floor(v.y + 0.5)});
    return 1;
}

int vec_dot(lua_State* L) {
    const Vec2 a = check_vec(L, 1, "dot"), b = check_vec(L, 2, "dot");
    lua_pushnumber(L, a.x * b.x + a.y * b.y);
    return 1;
}

int vec_cross(lua_State* L) {
    const Vec2 a = check_vec(L, 1, "cross"), b = check_vec(L, 2, "cross");
    lua_pushnumber(L, a.x * b.y - a.y * b.x);
    return 1;
}

int vec_rotated(lua_State* L) {
    const Vec2 v = check_vec(L, 1, "rotated");
    const double angle = check_number(L, 2, "rotated");
    const double c = std::cos(angle), s = std::sin(angle);
    push_vec(L, {c * v.x - s * v.y, s * v.x + c * v.y});
    return 1;
}

int vec_lerp(lua_State* L) {
    const Vec2 a = check_vec(L, 1, "lerp"), b = check_vec(L, 2, "lerp");
    const double t = check_number(L, 3, "lerp");
    push_vec(L, {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t});
    return 1;
}

int vec_angle(lua_State* L) {
    const Vec2 v = check_vec(L, 1, "angle");
    lua_pushnumber(L, std::atan2(v.y, v.x));
    return 1;
}

int vec_index(lua_State* L) {
    const auto* v = static_cast<const VecBox*>(lua_touserdata(L, 1));
    if (lua_type(L, 2) == LUA_TSTRING) {
        const char* key = lua_tolstring(L, 2, nullptr);
        if ((key[0] == 'x' || key[0] == 'y') && key[1] == '\0') {
            lua_pushnumber(L, key[0] == 'x' ? v->x : v->y);
            return 1;
        }
        return push_method(L, "a vec", {"x", "y"});
    }
    throw Error(ErrorKind::unknown_name, "a vec has x and y, not element " + key_in_message(L, 2));
}

// The common case, a property of type vec: the other component keeps its current value.
void write_component(Machine& machine, VecBox& v, char component, double number) {
    const Property& property = origin_property(machine.tree, v.origin);
    const auto read = [&] {
        const Value* seen = machine.declarations.seen(v.origin.instance, property.name);
        return seen != nullptr ? *seen : machine.tree.get(v.origin.instance, property);
    };
    const Value whole = read();
    if (!whole.is(Type::vec2))
        throw Error(ErrorKind::wrong_type,
                    origin_path(machine.tree, v.origin) + ": is not a vec any more");
    Vec2 next = whole.vec2();
    (component == 'x' ? next.x : next.y) = number;
    write_property(machine, v.origin.instance, property, Value(next));
    const Value now = read();  // as stored, possibly rounded
    if (now.is(Type::vec2)) {
        v.x = now.vec2().x;
        v.y = now.vec2().y;
    }
}

/// The name of the variable of the calling function that holds the vector at 1; "" if it is an
/// intermediate result, as in body.position.x = 3.
std::string variable_with_vec(lua_State* L) {
    lua_Debug frame;
    if (lua_getstack(L, 1, &frame) == 0 || !lua_checkstack(L, 4)) return {};
    const auto holds = [L](const char* name) {
        const bool found = name[0] != '(' && name[0] != '\0' && lua_rawequal(L, -1, 1) != 0;
        lua_pop(L, 1);
        return found;
    };
    for (int n = 1; const char* name = lua_getlocal(L, &frame, n); ++n)
        if (holds(name)) return name;
    lua_getinfo(L, "f", &frame);
    const int function = lua_gettop(L);
    std::string found;
    for (int n = 1; const char* name = lua_getupvalue(L, function, n); ++n)
        if (holds(name) && found.empty()) found = name;
    lua_settop(L, function - 1);
    return found;
}

/// Gives a note once, when a component of a variable's vector is written: the vector stays
/// connected with the place that it was read from, while other engines make copies.
template <class Path>
void note_connected(lua_State* L, Machine& machine, Path path_of, char component) {
    int& left = machine.boxes.checked_writes;
    if (left <= 0) return;
    --left;
    const std::string name = variable_with_vec(L);
    if (name.empty()) return;
    left = 0;
    const std::string path = path_of();
    if (const auto sink = machine.host.on_note)
        sink(position(L) + name + " was read from " + path + " and stays connected with it, so " +
             name + "." + component + " = ... writes " + path + "; vec(" + name + ") is a copy");
}

// Writing a component of a vector that was read from a property writes it to the property; the rest
// of the property keeps its current value.
int vec_newindex(lua_State* L) {
    auto* v = static_cast<VecBox*>(lua_touserdata(L, 1));
    const char* key = lua_type(L, 2) == LUA_TSTRING ? lua_tolstring(L, 2, nullptr) : "";
    if ((key[0] != 'x' && key[0] != 'y') || key[1] != '\0')
        throw Error(ErrorKind::unknown_name,
                    std::string("a vec has x and y, nothing else can be assigned") +
                        (key[0] ? std::string(": ") + key : std::string()));
    if (v->has_origin) {
        Machine& machine = machine_of(L);
        if (lua_type(L, 3) != LUA_TNUMBER)
            refuse_type(L, 3,
                        origin_path(machine.tree, v->origin) + "." + key + ": needs a number");
        note_connected(
            L, machine, [&] { return origin_path(machine.tree, v->origin); }, key[0]);
        const double number = lua_tonumber(L, 3);
        if (v->origin.depth == 0) {
            write_component(machine, *v, key[0], number);
            return 0;
        }
        origin_write(machine, v->origin, key, Value(number));
        const Value now = origin_read(machine, v->origin);
        if (now.is(Type::vec2)) {
            v->x = now.vec2().x;
            v->y = now.vec2().y;
        }
        return 0;
    }
    const double number = check_number(L, 3, "vec");
    const bool stored = refresh_stored(L);
    (key[0] == 'x' ? v->x : v->y) = number;
    if (stored) {
        note_connected(
            L, machine_of(L), [L] { return stored_path(L); }, key[0]);
        write_stored(L);
    }
    return 0;
}

int vec_make(lua_State* L) {
    if (lua_gettop(L) == 1 && vec_at(L, 1)) {
        push_vec(L, check_vec(L, 1, "vec"));  // a copy without an origin
        return 1;
    }
    if (lua_gettop(L) == 0) {
        push_vec(L, {0, 0});
        return 1;
    }
    if (lua_gettop(L) != 2 && lua_type(L, 1) == LUA_TNUMBER)
        throw Error(ErrorKind::wrong_type, "vec: needs x and y, not " +
                                               std::to_string(lua_gettop(L)) +
                                               (lua_gettop(L) == 1 ? " number" : " values"));
    push_vec(L, {check_number(L, 1, "vec"), check_number(L, 2, "vec")});
    return 1;
}

}  // namespace

void define_vec(lua_State* L, Machine& machine) {
    lua_newtable(L);
    add_pure<vec_index>(L, "__index");
    add_pure<vec_newindex>(L, "__newindex");
    add_pure<vec_add>(L, "__add");
    add_pure<vec_subtract>(L, "__sub");
    add_pure<vec_multiply>(L, "__mul");
    add_pure<vec_divide>(L, "__div");
    add_pure<vec_negate>(L, "__unm");
    add_pure<vec_equal>(L, "__eq");
    add_pure<vec_tostring>(L, "__tostring");
    lua_newtable(L);
    add_pure<vec_length>(L, "length");
    add_pure<vec_distance>(L, "distance");
    add_pure<vec_limited>(L, "limited");
    add_pure<vec_floor>(L, "floor");
    add_pure<vec_round>(L, "round");
    add_pure<vec_normalized>(L, "normalized");
    add_pure<vec_dot>(L, "dot");
    add_pure<vec_cross>(L, "cross");
    add_pure<vec_rotated>(L, "rotated");
    add_pure<vec_lerp>(L, "lerp");
    add_pure<vec_angle>(L, "angle");
    lua_setfield(L, -2, "methods");
    name_metatable(L, "vec");
    machine.boxes.vec = luaL_ref(L, LUA_REGISTRYINDEX);
}

void open_vec(lua_State* L) {
    add_pure<vec_make>(L, "vec");
}

}  // namespace fettle::script
