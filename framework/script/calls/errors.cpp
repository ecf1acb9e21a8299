#include <algorithm>
#include <optional>

#include <fettle/property/spelling.h>
#include <fettle/script/runtime.h>

#include <calls/error_place.h>
#include <calls/errors.h>
#include <limits/limiters.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/library_chunks.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <other_languages/other_languages.h>
#include <sources/call_form.h>
#include <sources/sources.h>
#include <text/columns.h>
#include <text/words.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

namespace {

constexpr int max_frames = 40;
constexpr int max_locals = 40;
constexpr std::size_t longest_local = 400;  // characters; a path has up to a million

/// The name of the global variable that holds the function of the frame, such as `update`; "" if
/// there is none.
std::string global_name(lua_State* L, lua_Debug& frame) {
    std::string name;
    if (!lua_checkstack(L, 6)) return name;
    lua_getinfo(L, "f", &frame);
    push_registry(L, machine_of(L).globals.table);
    lua_pushnil(L);
    while (lua_next(L, -2) != 0) {
        const bool found = lua_type(L, -2) == LUA_TSTRING && lua_rawequal(L, -1, -4) != 0;
        if (found) name = string_at(L, -2);
        lua_pop(L, found ? 2 : 1);
        if (found) break;
    }
    lua_pop(L, 2);
    return name;
}

std::string frame_name(lua_State* L, lua_Debug& frame) {
    if (frame.name && *frame.name) {
        const std::string name = frame.name;
        if (std::string_view(frame.namewhat) == "metamethod") return "metamethod " + name;
        return "function " + name;
    }
    if (frame.what[0] == 'm') return "main chunk";
    if (const std::string name = global_name(L, frame); !name.empty()) return "function " + name;
    return "function at line " + std::to_string(frame.linedefined);
}

std::string traceback_of(lua_State* L, int level) {
    std::string text;
    lua_Debug frame;
    int shown = 0;
    for (; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Slnt", &frame);
        // The C function through which the host calls Lua, and those that read and write
        // properties.
        const bool of_host =
            !frame.name || !*frame.name || std::string_view(frame.namewhat) == "metamethod";
        if (frame.what[0] == 'C' && of_host) continue;
        if (is_library(frame)) continue;
        if (++shown > max_frames) {
            text += "  ...\n";
            break;
        }
        text += "  ";
        if (frame.currentline > 0)
            text += std::string(frame.short_src) + ":" + std::to_string(frame.currentline) + ": ";
        text += "in " + frame_name(L, frame) + "\n";
        if (frame.istailcall) text += "  (tail calls)\n";
    }
    return text;
}

std::string locals_of(lua_State* L, lua_Debug& frame) {
    std::string text;
    if (!lua_checkstack(L, 8)) return text;
    for (int n = 1; n <= max_locals; ++n) {
        const char* name = lua_getlocal(L, &frame, n);
        if (!name) break;
        if (name[0] != '(')
            text += std::string(name) + " = " + cut(short_text(L, -1), longest_local) + "\n";
        lua_pop(L, 1);
    }
    return text;
}

// Finds the innermost frame of a script at `level` or above.
bool script_frame(lua_State* L, int level, lua_Debug& frame) {
    for (; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline > 0 && !is_library(frame)) return true;
    }
    return false;
}

// Lua's message contains neither the place nor the limit that refused the memory.
std::string with_refusal(Budget& budget, std::string message) {
    if (message != "not enough memory") return message;
    std::string refusal = budget.take_refusal();
    return refusal.empty() ? message : refusal;
}

// The text from the error object's `__tostring`, if it has one. `__tostring` may raise an error
// too, and its run time is limited.
std::optional<std::string> tostring_text(lua_State* L, int index) {
    if (machine_of(L).limiters.budget.stopping() ||
        luaL_getmetafield(L, index, "__tostring") == LUA_TNIL)
        return std::nullopt;
    lua_pushvalue(L, index < 0 ? index - 1 : index);
    std::optional<std::string> text;
    const Budget::Scope budget(machine_of(L).limiters.budget,
                               {.instructions = 100'000, .memory = 1 << 20});
    machine_of(L).limiters.budget.enter(L);
    if (lua_pcall(L, 1, 1, 0) == LUA_OK && lua_type(L, -1) == LUA_TSTRING) text = string_at(L, -1);
    lua_pop(L, 1);
    return text;
}

// A zero byte would end the text on a screen, in a terminal or in a log, and a terminal obeys other
// control characters.
std::string without_control_characters(std::string_view text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        if ((c >= 0x20 && c != 0x7f) || c == '\n' || c == '\t')
            shown += text[i];
        else if (c != '\r')
            shown += "\\" + std::to_string(c);
    }
    return shown;
}

/// Suggests a function of a table, as math.sqrt for math.sqr, after a call of a
/// field that is nil.
std::string nearest_function(lua_State* L, const ScriptError& error) {
    constexpr std::string_view beginning = "attempt to call a nil value (field '";
    constexpr std::size_t most = 1000;  // names that are looked at
    const std::size_t at = error.message.find(beginning);
    if (at == std::string::npos) return {};
    std::string name = error.message.substr(at + beginning.size());
    name.resize(std::min(name.find('\''), name.size()));
    const Machine& machine = machine_of(L);
    const std::string line = machine.sources.line(error.file, error.line);
    const std::size_t field = find_word(line, name);
    if (field == std::string::npos || field < 2 || line[field - 1] != '.') return {};
    std::size_t begin = field - 1;
    while (begin > 0 && is_word(line[begin - 1])) --begin;
    const std::string table = line.substr(begin, field - 1 - begin);
    std::vector<std::string> names;
    const int top = lua_gettop(L);
    push_registry(L, machine.globals.table);
    push_text(L, table);
    if (lua_rawget(L, -2) == LUA_TTABLE)
        for (lua_pushnil(L); names.size() < most && lua_next(L, -2) != 0; lua_pop(L, 1))
            if (lua_type(L, -2) == LUA_TSTRING) names.push_back(string_at(L, -2));
    lua_settop(L, top);
    return property::suggestion(name, names);
}

/// For a method that was called without its instance.
std::string hint_for_missing_self(lua_State* L, int level, std::string_view message) {
    if (std::string hint = colon_hint(L, level); !hint.empty()) return hint;
    lua_Debug caller;
    const bool by_lua = lua_getstack(L, level + 1, &caller) != 0 &&
                        lua_getinfo(L, "S", &caller) != 0 && caller.what[0] != 'C';
    if (by_lua || message.find("a nil value (local 'self')") == std::string_view::npos) return {};
    return " (nothing is given as self here: write self:after(...), or function() self:name() end)";
}

/// The message of a formula's error is a part of the message of those who read its value, and may
/// have the hint already.
void add_hint(std::string& message, const std::string& hint) {
    if (message.find(hint) == std::string::npos) message += hint;
}

}  // namespace

std::string error_text(lua_State* L, int index) {
    constexpr std::size_t longest = 4000;
    if (lua_type(L, index) == LUA_TSTRING || lua_type(L, index) == LUA_TNUMBER) {
        lua_pushvalue(L, index);
        const std::string text = string_at(L, -1);
        lua_pop(L, 1);
        return without_control_characters(std::string_view(text).substr(0, longest));
    }
    if (lua_isnil(L, index)) return "error() was called with nil in place of a message";
    if (const auto text = tostring_text(L, index))
        return without_control_characters(std::string_view(*text).substr(0, longest));
    return without_control_characters("the error is not a text but " + describe_type(L, index) +
                                      ": " + short_text(L, index));
}

void complete_message(lua_State* L, lua_State* from, int level) {
    if (lua_type(from, -1) != LUA_TSTRING) return;
    lua_Debug frame;
    if (!lua_getstack(L, level, &frame) || !lua_checkstack(L, 6)) return;
    lua_getinfo(L, "f", &frame);
    const lua_CFunction raiser = lua_tocfunction(L, -1);
    lua_pop(L, 1);
    const auto& unchanged = machine_of(L).errors.raise_unchanged;
    const bool by_lua = raiser == nullptr;  // which puts its position before the message
    // Lua raises it in any function, without a position.
    const bool overflow = view_at(from, -1) == "C stack overflow";
    if (!by_lua && !overflow &&
        std::find(unchanged.begin(), unchanged.end(), raiser) != unchanged.end())
        return;
    ScriptError error;
    error.message = string_at(from, -1);
    place_from_message(error);
    std::string completed = error.message;
    if ((!by_lua || overflow) && error.line == 0) {
        completed = with_refusal(machine_of(L).limiters.budget, completed);
        if (completed == error.message) completed.insert(0, position(L));
    }
    std::string hint = hint_for_value(error.message);
    if (hint.empty()) hint = nearest_function(L, error);
    add_hint(completed, hint);
    if (!by_lua)
        add_hint(completed, dot_hint(L, level));
    else if (error.message.find("(local 'self')") != std::string::npos)
        add_hint(completed, hint_for_missing_self(L, level, error.message));
    if (completed == error.message) return;
    lua_pop(from, 1);
    push_text(from, completed);
}

int placing_handler(lua_State* L) {
    if (!machine_of(L).limiters.budget.stopping()) complete_message(L, L, 1);
    return 1;
}

ScriptError describe_error(Machine& machine, lua_State* L, int level, lua_State* from, int index) {
    ScriptError error;
    lua_checkstack(from, 8);
    error.message = error_text(from, index);
    error.message = with_refusal(machine.limiters.budget, std::move(error.message));
    if (machine.errors.thread_error && machine.errors.thread_error->message == error.message) {
        // The error comes from a coroutine and was described there.
        error = std::move(*machine.errors.thread_error);
        machine.errors.thread_error.reset();
        // The coroutine of a timer was not started by a script, so `outside` may be empty.
        if (const std::string outside = traceback_of(L, level); !outside.empty())
            error.traceback += "  (coroutine started from)\n" + outside;
        return error;
    }
    lua_Debug frame;
    const bool found = script_frame(L, level, frame);
    if (lua_type(from, index) == LUA_TSTRING) place_from_message(error);
    if (error.line == 0 && found) {
        error.file = frame.short_src;
        error.line = frame.currentline;
        if (lua_type(from, index) != LUA_TSTRING)
            error.message = error.file + ":" + std::to_string(error.line) + ": " + error.message;
    }
    error.source_line = machine.sources.line(error.file, error.line);
    error.column = guess_column(error, machine.sources.stop);
    shorten_source(error);
    error.traceback = traceback_of(L, level);
    if (found) error.locals = locals_of(L, frame);
    return error;
}

ScriptError bare_error(Machine& machine, std::string message) {
    ScriptError error;
    error.message = with_refusal(machine.limiters.budget, std::move(message));
    place_from_message(error);
    error.source_line = machine.sources.line(error.file, error.line);
    shorten_source(error);
    return error;
}

ScriptError describe_place(Machine& machine, lua_State* L) {
    ScriptError place;
    lua_Debug frame;
    if (script_frame(L, 0, frame)) {
        place.file = frame.short_src;
        place.line = frame.currentline;
        place.source_line = machine.sources.line(place.file, place.line);
        shorten_source(place);
        place.locals = locals_of(L, frame);
    }
    place.traceback = traceback_of(L, 0);
    return place;
}

int describing_handler(lua_State* L) {
    Machine& machine = machine_of(L);
    try {
        lua_settop(L, 1);
        complete_message(L, L, 1);
        machine.errors.caught = describe_error(machine, L, 1, L, 1);
    } catch (const std::exception&) {
        machine.errors.caught.reset();
    }
    lua_settop(L, 1);
    return 1;
}

}  // namespace fettle::script
