#include <console/last_expression.h>

#include <string>

#include <sources/sources.h>

namespace fettle::script {

bool load_with_last_expression(lua_State* L, std::string_view command, const char* chunk) {
    // The last semicolon may be inside a table, a text or a block: what is before it must be
    // complete.
    constexpr int most_tried = 3;
    std::size_t at = command.size();
    for (int i = 0; i < most_tried && at > 0; ++i) {
        at = command.rfind(';', at - 1);
        if (at == std::string_view::npos || at == 0) return false;
        std::string code(command.substr(0, at + 1));
        const bool complete = try_load_text(L, code, chunk) == LUA_OK;
        lua_pop(L, 1);
        if (!complete) continue;
        code += " return ";
        code += command.substr(at + 1);
        if (try_load_text(L, code, chunk) == LUA_OK) return true;
        lua_pop(L, 1);
    }
    return false;
}

}  // namespace fettle::script
