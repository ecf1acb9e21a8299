#include <fettle/property/path.h>
#include <fettle/property/question.h>
#include <fettle/script/runtime.h>

#include <handlers/formulas.h>
#include <handlers/function_source.h>
#include <handlers/observed.h>
#include <lua/environment.h>
#include <lua/machine.h>
#include <lua/runtime_lifetime.h>
#include <lua/stack.h>
#include <text/selected_name.h>
#include <text/words.h>
#include <values/values.h>

namespace fettle::script {

std::string with_selected(Machine& machine, std::string_view source) {
    if (!mentions_it(source)) return std::string(source);
    const Handle it = machine.globals.it;
    if (!machine.tree.alive(it)) throw Error(ErrorKind::unknown_name, "it: nothing is selected");
    if (it != machine.tree.root() && !machine.tree.is_below(it, machine.tree.root()))
        throw Error(ErrorKind::bad_structure,
                    "it: " + machine.tree.path(it) +
                        " has no place in the tree, so it cannot be found again later");
    return with_it_named(source, machine.tree.path(it));
}

void bind_selected(lua_State* L, Machine& machine, int index) {
    if (!machine.tree.alive(machine.globals.it)) return;
    index = lua_absindex(L, index);
    for (int i = 1; const char* name = lua_getupvalue(L, index, i); ++i) {
        push_registry(L, machine.globals.table);
        const bool environment = std::string_view(name) == "_ENV" && lua_rawequal(L, -1, -2) != 0;
        lua_pop(L, 2);
        if (!environment) continue;
        // An environment of its own: `it`, and everything else from the globals.
        (void)luaL_loadbufferx(L, "return", 6, "=environment", "t");
        lua_newtable(L);
        lua_pushliteral(L, "it");
        push_instance(L, machine.globals.it);
        lua_rawset(L, -3);
        lua_newtable(L);
        for (const char* field : {"__index", "__newindex"}) {
            lua_pushstring(L, field);
            push_registry(L, machine.globals.table);
            lua_rawset(L, -3);
        }
        lua_setmetatable(L, -2);
        lua_setupvalue(L, -2, 1);
        lua_upvaluejoin(L, index, i, -1, 1);
        lua_pop(L, 1);
        return;
    }
}

namespace {

/// The words with dots between them, such as `world.ball.mass`.
std::vector<std::string> paths_in(std::string_view text) {
    std::vector<std::string> found;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t begin = i;
        while (i < text.size() && (is_word(text[i]) || text[i] == '.')) ++i;
        const std::string_view path = text.substr(begin, i - begin);
        if (path.find('.') != std::string_view::npos && !path.starts_with('.'))
            found.emplace_back(path);
        if (i == begin) ++i;
    }
    return found;
}

Observed observed(Machine& machine, std::string text, property::Formula formula) {
    Observed result;
    result.text = std::move(text);
    // The runtime may end before the tree, and after it.
    result.compute_formulas = [&machine, alive = machine.life.tree, lua = machine.lua.alive,
                               paths = paths_in(result.text)] {
        if (*lua == nullptr || alive.expired() || machine.tree.formula_count() == 0) return;
        for (const std::string& path : paths) try {
                const property::Place place = property::resolve(machine.tree, path);
                if (place.property != nullptr)
                    (void)machine.tree.get(place.instance, *place.property);
            } catch (const std::exception&) {
                // A variable, a function, or a formula in error: `value` says so.
            }
    };
    result.value = [&machine, alive = machine.life.tree, lua = machine.lua.alive,
                    function = std::move(formula.function)]() -> Value {
        if (*lua == nullptr) throw Error(ErrorKind::deleted, "the runtime was destroyed");
        if (alive.expired()) throw Error(ErrorKind::deleted, "the tree was destroyed");
        const property::Inquiry inquiry(machine.tree, "what is observed", "cannot");
        try {
            return function(machine.tree);
        } catch (const Error&) {
            throw;
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(without_chunk(error.what()));
        }
    };
    return result;
}

}  // namespace

Observed observe(Machine& machine, std::string_view expression) {
    const std::string source = with_selected(machine, trimmed(expression));
    Observed result = observed(machine, source, compile_formula(machine, source, "the expression"));
    try {
        const property::Place place = property::resolve(machine.tree, source);
        if (place.property != nullptr) {
            result.path = source;
            result.unit = place.property->unit;
        }
    } catch (const Error&) {
        // An expression.
    }
    return result;
}

Observed observe(lua_State* L, int index, const char* what) {
    Machine& machine = machine_of(L);
    if (lua_type(L, index) == LUA_TSTRING) return observe(machine, string_at(L, index));
    if (lua_type(L, index) != LUA_TFUNCTION)
        refuse_type(L, index,
                    std::string(what) +
                        ": needs a path or an expression as text, or a "
                        "function that returns the value");
    std::string text = function_source(L, machine, index).text;
    if (mentions_it(text)) bind_selected(L, machine, index);
    if (text.empty()) text = "a function";
    lua_pushvalue(L, index);
    return observed(machine, one_line(text), formula_of(L, machine));
}

}  // namespace fettle::script
