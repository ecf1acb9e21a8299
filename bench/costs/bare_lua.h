#pragma once
// The least cost of a property of a userdata in Lua: metamethods that ignore the name of the
// property and check neither type nor handle.

#include <memory>
#include <string>

struct lua_State;

namespace fettle::bench {

class BareLua {
  public:
    /// Runs `script`. Its global `ball` is a userdata with one number.
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
