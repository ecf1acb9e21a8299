#pragma once
// Functions of scripts that are kept for later.

#include <cstddef>
#include <memory>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// A function kept alive for a handler. The tree may outlive Lua and so may handlers.
class FunctionRef {
  public:
    /// Takes the function on top of the stack.
    FunctionRef(lua_State* L, Machine& machine);
    ~FunctionRef();
    FunctionRef(const FunctionRef&) = delete;
    void push(lua_State* L) const;
    /// Bytes that only this function keeps, estimated: `held_memory`, if it was computed; else 0.
    std::size_t holds() const { return holds_; }
    void set_holds(std::size_t bytes) { holds_ = bytes; }

  private:
    std::shared_ptr<lua_State*> alive_;
    int reference_;
    std::size_t holds_ = 0;
};

}  // namespace fettle::script
