#pragma once
// Protected calls into Lua: errors are caught and described.

#include <memory>
#include <string>
#include <type_traits>

#include <fettle/property/tree.h>

#include <lua/exception_guard.h>
#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// The reason why the host calls Lua, for error messages. The path is computed only for an error.
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

/// Runs `body(L)` on the main thread. Returns false if it raised an error. The error is described
/// where it was raised; it goes to the host's function, or stays in `machine.errors.caught` if
/// `report` is false.
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
