#include <library/host_functions.h>

#include <exception>
#include <utility>
#include <vector>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/path.h>

#include <calls/protected.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <values/values.h>

namespace fettle::script {

namespace {

/// An exception of no known type would reach Lua without a message: an error of the script would
/// be whatever value is on the stack.
Value result_of(const HostFunction& function, const std::vector<Value>& arguments) {
    try {
        return function(arguments);
    } catch (const std::exception&) {
        throw;
    } catch (...) {
        throw property::Error(property::ErrorKind::rejected, property::exception_text());
    }
}

// Upvalue: the address of the function, which the host's parts keep.
int call_host(lua_State* L) {
    // A copy, because the call may replace it.
    const HostFunction function =
        *static_cast<HostFunction*>(lua_touserdata(L, lua_upvalueindex(1)));
    std::vector<Value> arguments;
    for (int i = 1; i <= lua_gettop(L); ++i) arguments.push_back(to_value(L, i));
    push_value(L, result_of(function, arguments));
    return 1;
}

}  // namespace

void add_host_function(Machine& machine, const std::string& name, HostFunction function) {
    if (!property::is_identifier(name))
        throw property::Error(property::ErrorKind::bad_name,
                              "add_function: \"" + name + "\": expected a name as in Lua");
    if (!function)
        throw property::Error(property::ErrorKind::rejected,
                              "add_function: " + name + ": expected a function, got an empty one");
    HostFunction& kept = machine.host.functions[name];
    kept = std::move(function);
    protected_run(machine, "a function of the host", [&](lua_State* L) {
        push_registry(L, machine.globals.table);
        push_text(L, name);
        lua_pushlightuserdata(L, &kept);
        lua_pushcclosure(L, guarded<effect<call_host>>, 1);
        lua_rawset(L, -3);
    });
}

}  // namespace fettle::script
