#include <algorithm>
#include <string_view>

#include <lua/budget.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/sources.h>
#include <lua/stack.h>
#include <text/other_languages.h>

namespace fettle::script {

const char* take_piece(lua_State* L, std::string_view& left, std::size_t* size,
                       std::size_t longest) {
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

std::string_view without_byte_order_mark(std::string_view text) {
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

std::string_view without_shell_line(std::string_view text) {
    return text.starts_with('#') ? text.substr(std::min(text.find('\n'), text.size())) : text;
}

int Sources::load(lua_State* L, const std::string& text, const std::string& name) {
    std::string_view code = without_byte_order_mark(text);
    if (code.starts_with(LUA_SIGNATURE[0])) {
        push_text(L, name +
                         ": this is compiled Lua, which is not loaded; a script is loaded as "
                         "source text");
        return LUA_ERRSYNTAX;
    }
    texts[name] = code;
    code = without_shell_line(code);
    const int status = load_text(L, code, ("@" + name).c_str());
    if (status == LUA_ERRSYNTAX) note_stop(L, code, ("@" + name).c_str());
    return status;
}

/// Compiles the text again, byte by byte: Lua stops reading at the byte after the wrong token.
void Sources::note_stop(lua_State* L, std::string_view code, const char* name) {
    constexpr std::string_view before_token = " near '";
    stop = {};
    const std::string message = string_at(L, -1);
    const std::size_t near = message.rfind(before_token);
    if (near == std::string::npos || !message.ends_with('\'')) return;
    const std::size_t begin = near + before_token.size();
    const std::string token = message.substr(begin, message.size() - 1 - begin);
    std::string_view left = code;
    const auto read_byte = [](lua_State* in, void* rest, std::size_t* size) {
        return take_piece(in, *static_cast<std::string_view*>(rest), size, 1);
    };
    (void)lua_load(L, read_byte, &left, name, "t");
    lua_pop(L, 1);
    const std::size_t at = code.substr(0, code.size() - left.size()).rfind(token);
    if (token.empty() || at == std::string_view::npos) return;
    const std::size_t line_end = code.substr(0, at).rfind('\n');
    const std::size_t begins = line_end == std::string_view::npos ? 0 : line_end + 1;
    stop.column = at - begins;
    const std::string_view line = code.substr(begins, code.find('\n', at) - begins);
    stop.message = message + hint_for_syntax(message, line, stop.column);
    lua_pop(L, 1);
    push_text(L, stop.message);
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
