#pragma once
// The least that a property of a userdata can cost in Lua: metamethods that look at nothing. They
// ignore which property is asked for, check no type and no handle.

#include <memory>
#include <string>

struct lua_State;

namespace fettle::bench {

class BareLua {
  public:
    /// Runs `script`, in which the global `ball` is a userdata that has one number.
    explicit BareLua(const std::string& script);
    ~BareLua();
    BareLua(const BareLua&) = delete;
    BareLua& operator=(const BareLua&) = delete;

    /// Calls a global function with a number.
    void call(const char* function, long long argument);

  private:
    [[noreturn]] void fail();
    lua_State* lua_;
};

}  // namespace fettle::bench
