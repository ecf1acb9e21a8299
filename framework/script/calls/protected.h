#pragma once
// Running something in Lua from outside: whatever it raises is caught and described.

#include <memory>
#include <string>
#include <type_traits>

#include <fettle/property/tree.h>

#include <lua/guard.h>
#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// What the host is calling into Lua for, as error messages say it; the path is found only when
/// there is an error.
struct Context {
    Context(const char* text) : what(text) {}
    Context(std::string text, property::Handle instance = {},
            const property::Property* changed = nullptr)
        : what(std::move(text)), about(instance), property(changed) {}
    std::string text(Machine& machine) const;

    std::string what;
    property::Handle about;
    const property::Property* property = nullptr;
};

/// Runs `body(L)` on the main thread. False when it raised: the error was described where it arose
/// and went to the sink, or stays in `machine.errors.caught` when `report` is false.
bool run_protected(Machine& machine, const Context& context, int (*trampoline)(lua_State*),
                   void* body, bool report);

template <class Function>
int run_body(lua_State* L) {
    auto* function = static_cast<Function*>(lua_touserdata(L, 1));
    lua_settop(L, 0);
    (*function)(L);
    return 0;
}

template <class Body>
bool protected_run(Machine& machine, const Context& context, Body&& body, bool report = true) {
    using Function = std::remove_reference_t<Body>;
    return run_protected(machine, context, guarded<run_body<Function>>,
                         const_cast<void*>(static_cast<const void*>(std::addressof(body))), report);
}

}  // namespace fettle::script
