#include <algorithm>
#include <string_view>

#include <lua/budget.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/sources.h>
#include <lua/stack.h>

namespace fettle::script {

const char* take_piece(lua_State* L, std::string_view& left, std::size_t* size) {
    constexpr std::size_t longest = 256;
    *size = std::min(left.size(), longest);
    machine_of(L).budget.charge_by_the_clock(L, *size);
    const char* const piece = left.data();
    left.remove_prefix(*size);
    return piece;
}

int load_text(lua_State* L, std::string_view code, const char* name) {
    const auto read = [](lua_State* in, void* left, std::size_t* size) {
        return take_piece(in, *static_cast<std::string_view*>(left), size);
    };
    return lua_load(L, read, &code, name, "t");
}

int Sources::load(lua_State* L, const std::string& text, const std::string& name) {
    std::string_view code = text;
    if (code.starts_with("\xEF\xBB\xBF")) code.remove_prefix(3);  // a byte order mark
    if (code.starts_with(LUA_SIGNATURE[0])) {
        push_text(L, name +
                         ": this is compiled Lua, which is not loaded; a script is loaded as "
                         "source text");
        return LUA_ERRSYNTAX;
    }
    texts[name] = code;
    // A first line of `#!...` is for the shell.
    if (code.starts_with('#')) code.remove_prefix(std::min(code.find('\n'), code.size()));
    return load_text(L, code, ("@" + name).c_str());
}

std::string Sources::line(const std::string& file, int line) const {
    const auto found = texts.find(file);
    if (found == texts.end() || line <= 0) return {};
    const std::string& text = found->second;
    std::size_t start = 0;
    for (int i = 1; i < line; ++i) {
        start = text.find('\n', start);
        if (start == std::string::npos) return {};
        ++start;
    }
    std::string result = text.substr(start, text.find('\n', start) - start);
    if (!result.empty() && result.back() == '\r') result.pop_back();
    return result;
}

}  // namespace fettle::script
