#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string_view>

#include <limits/limiters.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <other_languages/other_languages.h>
#include <sources/sources.h>
#include <text/bare_words.h>

namespace fettle::script {

const char* next_piece(lua_State* L, std::string_view& left, std::size_t* size, std::size_t most) {
    *size = std::min(left.size(), most);
    machine_of(L).limiters.budget.charge_by_the_clock(L, *size);
    const char* const piece = left.data();
    left.remove_prefix(*size);
    return piece;
}

namespace {

constexpr std::string_view overflow = "C stack overflow";  // a message of Lua
constexpr std::string_view overflow_reason = ": too many brackets, blocks or calls in each other";

/// Reads one byte of a std::string_view; for lua_load.
const char* read_byte(lua_State* L, void* from, std::size_t* size) {
    constexpr std::size_t charged_at_once = 256;  // a look at the clock takes longer than a byte
    std::string_view& left = *static_cast<std::string_view*>(from);
    *size = std::min<std::size_t>(left.size(), 1);
    if (left.size() % charged_at_once == 0)
        machine_of(L).limiters.budget.charge_by_the_clock(L, charged_at_once);
    const char* const byte = left.data();
    left.remove_prefix(*size);
    return byte;
}

/// What Lua reads of code with an error until it reports the error. `reader` reads one byte of a
/// std::string_view.
std::string_view read_until_error(lua_State* L, std::string_view code, const char* name,
                                  lua_Reader reader) {
    std::string_view left = code;
    (void)lua_load(L, reader, &left, name, "t");
    lua_pop(L, 1);
    return code.substr(0, code.size() - left.size());
}

/// Lua has read one byte beyond the token that it looks at.
std::string_view without_last(std::string_view read) {
    return read.substr(0, read.size() - std::min<std::size_t>(read.size(), 1));
}

bool is_letter(char c) {
    return static_cast<unsigned char>(c) >= 0x80 || std::isalnum(static_cast<unsigned char>(c)) ||
           c == '_';
}

/// Lua names a byte that it does not accept by its number, as in "near '<\\231>'". Puts the whole
/// word with that byte in its place.
void name_foreign_letters(lua_State* L, std::string_view code, const char* name) {
    constexpr std::string_view before_byte = " near '<\\";
    const std::string message = string_at(L, -1);
    const std::size_t near = message.rfind(before_byte);
    if (near == std::string::npos || !message.ends_with(">'")) return;
    const auto byte = static_cast<char>(std::atoi(message.c_str() + near + before_byte.size()));
    if (static_cast<unsigned char>(byte) < 0x80) return;
    const std::size_t at = read_until_error(L, code, name, read_byte).rfind(byte);
    if (at == std::string_view::npos) return;
    std::size_t begin = at, end = at;
    while (begin > 0 && is_letter(code[begin - 1])) --begin;
    while (end < code.size() && is_letter(code[end])) ++end;
    const std::string word(code.substr(begin, end - begin));
    std::string text = message.substr(0, near) + " near '" + word + "'";
    if (begin > 0 && code[begin - 1] == '.')
        text += " (write [\"" + word + "\"]: a name after a dot has the letters a to z)";
    lua_pop(L, 1);
    push_text(L, text);
}

}  // namespace

int try_load_text(lua_State* L, std::string_view code, const char* name) {
    const auto read = [](lua_State* in, void* left, std::size_t* size) {
        return next_piece(in, *static_cast<std::string_view*>(left), size);
    };
    std::string_view left = code;
    return lua_load(L, read, &left, name, "t");
}

int load_text(lua_State* L, std::string_view code, const char* name) {
    const int status = try_load_text(L, code, name);
    if (status == LUA_OK || lua_type(L, -1) != LUA_TSTRING) return status;
    place_overflow(L, code, name, read_byte);
    name_foreign_letters(L, code, name);
    return status;
}

void place_overflow(lua_State* L, std::string_view code, const char* name, lua_Reader reader) {
    if (lua_type(L, -1) != LUA_TSTRING || !view_at(L, -1).ends_with(overflow)) return;
    const std::string_view read = without_last(read_until_error(L, code, name, reader));
    // An error in that line has its place in front.
    std::string other(static_cast<std::size_t>(std::count(read.begin(), read.end(), '\n')), '\n');
    other += '=';
    if (luaL_loadbufferx(L, other.data(), other.size(), name, "t") == LUA_OK) return;
    const std::string message = string_at(L, -1);
    const std::size_t place = message.rfind(": unexpected symbol");
    lua_pop(L, 1);
    if (place == std::string::npos) return;
    lua_pop(L, 1);
    push_text(
        L, message.substr(0, place) + ": " + std::string(overflow) + std::string(overflow_reason));
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
    if (status != LUA_OK && lua_type(L, -1) == LUA_TSTRING) set_stop(L, code, ("@" + name).c_str());
    return status;
}

/// Compiles the text again, byte by byte: Lua stops reading at the byte after the wrong token.
void Sources::set_stop(lua_State* L, std::string_view code, const char* name) {
    constexpr std::string_view before_token = " near '";
    stop = {};
    const std::string message = string_at(L, -1);
    const std::size_t near = message.rfind(before_token);
    const bool is_overflow = message.ends_with(overflow_reason);
    if (!is_overflow && (near == std::string::npos || !message.ends_with('\''))) return;
    std::string token;
    if (!is_overflow) {
        const std::size_t begin = near + before_token.size();
        token = message.substr(begin, message.size() - 1 - begin);
    }
    const std::string_view read = read_until_error(L, code, name, read_byte);
    std::size_t at = is_overflow ? without_last(without_last(read)).size() : read.rfind(token);
    // Of a word with foreign letters Lua reads the first byte.
    if (at == std::string_view::npos) at = code.rfind(token, read.size());
    if ((token.empty() && !is_overflow) || at == std::string_view::npos) return;
    const std::size_t line_end = code.substr(0, at).rfind('\n');
    const std::size_t begins = line_end == std::string_view::npos ? 0 : line_end + 1;
    stop.column = at - begins;
    stop.place = at;
    const std::string_view line = code.substr(begins, code.find('\n', at) - begins);
    // A text that is a word of Lua, as in align = end.
    std::string hint;
    if (!is_overflow) hint = bare_word_hint(machine_of(L).tree, line, token);
    if (!is_overflow && hint.empty())
        hint = hint_for_syntax(message, line, stop.column, name[0] == '@');
    stop.message = message + hint;
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
