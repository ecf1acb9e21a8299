#pragma once
// Functions of scripts that are kept for later calls.

#include <cstddef>
#include <memory>
#include <string>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// Keeps a Lua function for a handler. The tree and its handlers may outlive Lua.
class FunctionRef {
  public:
    /// Pops the function from the stack.
    FunctionRef(lua_State* L, Machine& machine);
    ~FunctionRef();
    FunctionRef(const FunctionRef&) = delete;
    void push(lua_State* L) const;
    /// Estimated bytes that only this function keeps, if they were computed with `held_memory`;
    /// else 0.
    std::size_t holds() const { return holds_; }
    void set_holds(std::size_t bytes) { holds_ = bytes; }

    /// The place in a script where a function of Fettle was given to a timer, as in `after(1,
    /// world.b.delete)`, because errors of such a function contain no place. "" for a function of a
    /// script.
    const std::string& given_at() const { return given_at_; }
    void set_given_at(std::string place) { given_at_ = std::move(place); }

  private:
    std::string given_at_;
    std::shared_ptr<lua_State*> alive_;
    int reference_;
    std::size_t holds_ = 0;
};

}  // namespace fettle::script
