#include <calls/function_ref.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>

namespace fettle::script {

FunctionRef::FunctionRef(lua_State* L, Machine& machine)
    : alive_(machine.lua.alive), reference_(luaL_ref(L, LUA_REGISTRYINDEX)) {}

FunctionRef::~FunctionRef() {
    if (*alive_) luaL_unref(*alive_, LUA_REGISTRYINDEX, reference_);
}

void FunctionRef::push(lua_State* L) const {
    push_registry(L, reference_);
}

}  // namespace fettle::script
