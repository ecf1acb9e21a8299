// Implements string.find, match, gmatch and gsub with PatternMatcher.

#include <algorithm>
#include <string>

#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <sandbox/sandbox.h>
#include <text/patterns.h>
#include <values/values.h>

namespace fettle::script {

namespace {

std::string_view text_at(lua_State* L, int index) {
    std::size_t length = 0;
    const char* text = luaL_checklstring(L, index, &length);
    return {text, length};
}

void charge_steps(void* L, std::uint64_t steps) {
    auto* state = static_cast<lua_State*>(L);
    machine_of(state).limiters.budget.charge_by_the_clock(state, steps);
}

// Start position, from 0; it may be greater than the length.
std::size_t start_at(lua_State* L, int index, std::size_t length) {
    const lua_Integer start = luaL_optinteger(L, index, 1);
    if (start > 0) return static_cast<std::size_t>(start) - 1;
    if (start == 0 || start < -static_cast<lua_Integer>(length)) return 0;
    return length - static_cast<std::size_t>(-start);
}

void push_capture(lua_State* L, const PatternMatcher& matcher, std::string_view subject,
                  std::size_t i) {
    const auto& capture = matcher.capture(i);
    if (capture.kind == PatternMatcher::Capture::open)
        throw Error(ErrorKind::rejected, "unfinished capture");
    if (capture.kind == PatternMatcher::Capture::place)
        lua_pushinteger(L, static_cast<lua_Integer>(capture.start) + 1);
    else
        push_text(L, subject.substr(capture.start, capture.length));
}

int push_captures(lua_State* L, const PatternMatcher& matcher, std::string_view subject,
                  std::size_t start, std::size_t end, bool whole_if_none) {
    const std::size_t count = matcher.capture_count();
    if (count == 0 && whole_if_none) {
        push_text(L, subject.substr(start, end - start));
        return 1;
    }
    luaL_checkstack(L, static_cast<int>(count), "too many captures");
    for (std::size_t i = 0; i < count; ++i) push_capture(L, matcher, subject, i);
    return static_cast<int>(count);
}

int search(lua_State* L, bool find) {
    const std::string_view subject = text_at(L, 1), pattern = text_at(L, 2);
    std::size_t start = start_at(L, 3, subject.size());
    if (start > subject.size()) {
        lua_pushnil(L);
        return 1;
    }
    if (find &&
        (lua_toboolean(L, 4) || pattern.find_first_of("^$*+?.([%-") == std::string_view::npos)) {
        machine_of(L).limiters.budget.charge(L, (subject.size() - start + pattern.size()) / 8);
        // memmem takes linear time; string_view::find takes the product of both lengths.
        const void* const at = ::memmem(subject.data() + start, subject.size() - start,
                                        pattern.data(), pattern.size());
        if (at == nullptr) {
            lua_pushnil(L);
            return 1;
        }
        const auto before = static_cast<lua_Integer>(static_cast<const char*>(at) - subject.data());
        lua_pushinteger(L, before + 1);
        lua_pushinteger(L, before + static_cast<lua_Integer>(pattern.size()));
        return 2;
    }
    const bool anchored = !pattern.empty() && pattern.front() == '^';
    PatternMatcher matcher(subject, pattern, charge_steps, L);
    do {
        const std::size_t end = matcher.match(start, anchored ? 1 : 0);
        if (end == PatternMatcher::failed) continue;
        if (!find) return push_captures(L, matcher, subject, start, end, true);
        lua_pushinteger(L, static_cast<lua_Integer>(start) + 1);
        lua_pushinteger(L, static_cast<lua_Integer>(end));
        return 2 + push_captures(L, matcher, subject, start, end, false);
    } while (!anchored && ++start <= subject.size());
    lua_pushnil(L);
    return 1;
}

int find(lua_State* L) {
    return search(L, true);
}
int match(lua_State* L) {
    return search(L, false);
}

// Upvalues: subject, pattern, next start, end of the last match (-1 before the first).
int next_match(lua_State* L) {
    const std::string_view subject = text_at(L, lua_upvalueindex(1));
    const std::string_view pattern = text_at(L, lua_upvalueindex(2));
    const lua_Integer last = lua_tointeger(L, lua_upvalueindex(4));
    PatternMatcher matcher(subject, pattern, charge_steps, L);
    for (auto start = static_cast<std::size_t>(lua_tointeger(L, lua_upvalueindex(3)));
         start <= subject.size(); ++start) {
        const std::size_t end = matcher.match(start);
        // An empty match directly after the last match would find the same place again.
        if (end == PatternMatcher::failed || static_cast<lua_Integer>(end) == last) continue;
        lua_pushinteger(L, static_cast<lua_Integer>(end));
        lua_copy(L, -1, lua_upvalueindex(3));
        lua_copy(L, -1, lua_upvalueindex(4));
        lua_pop(L, 1);
        return push_captures(L, matcher, subject, start, end, true);
    }
    return 0;
}

int gmatch(lua_State* L) {
    const std::string_view subject = text_at(L, 1);
    text_at(L, 2);
    const std::size_t start = std::min(start_at(L, 3, subject.size()), subject.size() + 1);
    lua_settop(L, 2);
    lua_pushinteger(L, static_cast<lua_Integer>(start));
    lua_pushinteger(L, -1);
    lua_pushcclosure(L, guarded<next_match>, 4);
    return 1;
}

// The result of gsub grows outside of Lua's memory until it is complete, so the same limit is
// checked here. There are two copies of it when it moves to a larger place, and when it becomes
// Lua's.
void append(lua_State* L, std::string& out, std::string_view piece) {
    constexpr std::size_t unchecked = 4096;  // bytes
    charge_steps(L, 4);  // instructions: a replacement may have millions of pieces
    const std::size_t size = out.size() + piece.size();
    const Arena& arena = machine_of(L).limiters.arena;
    if (size > unchecked && size > (arena.limit() - std::min(arena.limit(), arena.bytes())) / 2) {
        const Arena::Refusal refusal{.size = size, .final = true};
        machine_of(L).limiters.budget.memory_refused(refusal);
        throw Error(ErrorKind::rejected, machine_of(L).limiters.budget.out_of_memory(refusal));
    }
    out.append(piece);
}

// Expands %0 to the whole match, %1 to %9 to a capture, and %% to a percent sign.
void add_template(lua_State* L, std::string& out, std::string_view text,
                  const PatternMatcher& matcher, std::string_view subject, std::size_t start,
                  std::size_t end) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t plain = std::min(text.find('%', i), text.size()) - i;
        append(L, out, text.substr(i, plain));
        i += plain;
        if (i == text.size()) break;
        const char c = ++i < text.size() ? text[i] : '\0';
        if (c == '%') {
            append(L, out, "%");
        } else if (c == '0' || (c == '1' && matcher.capture_count() == 0)) {
            append(L, out, subject.substr(start, end - start));
        } else if (c >= '1' && c <= '9') {
            const auto capture = static_cast<std::size_t>(c - '1');
            if (capture >= matcher.capture_count())
                throw Error(ErrorKind::rejected,
                            std::string("invalid capture index %") + c + " in replacement string");
            push_capture(L, matcher, subject, capture);
            append(L, out, view_at(L, -1));
            lua_pop(L, 1);
        } else {
            throw Error(ErrorKind::rejected, "invalid use of '%' in replacement string");
        }
    }
}

// Appends the replacement of one match; nil and false keep the match.
void add_replacement(lua_State* L, std::string& out, const PatternMatcher& matcher,
                     std::string_view subject, std::size_t start, std::size_t end) {
    switch (lua_type(L, 3)) {
        case LUA_TFUNCTION: {
            lua_pushvalue(L, 3);
            const int n = push_captures(L, matcher, subject, start, end, true);
            lua_call(L, n, 1);
            break;
        }
        case LUA_TTABLE:
            if (matcher.capture_count() == 0)
                push_text(L, subject.substr(start, end - start));
            else
                push_capture(L, matcher, subject, 0);
            lua_gettable(L, 3);
            break;
        default:
            add_template(L, out, text_at(L, 3), matcher, subject, start, end);
            return;
    }
    if (!lua_toboolean(L, -1)) {
        append(L, out, subject.substr(start, end - start));
    } else if (lua_isstring(L, -1)) {
        append(L, out, view_at(L, -1));
    } else {
        throw Error(ErrorKind::wrong_type,
                    "invalid replacement value (" + describe_type(L, -1) + ")");
    }
    lua_pop(L, 1);
}

int gsub(lua_State* L) {
    const std::string_view subject = text_at(L, 1);
    std::string_view pattern = text_at(L, 2);
    const int kind = lua_type(L, 3);
    if (kind != LUA_TNUMBER && kind != LUA_TSTRING && kind != LUA_TTABLE && kind != LUA_TFUNCTION)
        refuse_type(L, 3, "gsub: the replacement is a text, a table or a function");
    const lua_Integer max_count =
        luaL_optinteger(L, 4, static_cast<lua_Integer>(subject.size()) + 1);
    const bool anchored = !pattern.empty() && pattern.front() == '^';
    PatternMatcher matcher(subject, pattern, charge_steps, L);
    std::string out;
    lua_Integer count = 0;
    std::size_t start = 0, last = PatternMatcher::failed;
    while (count < max_count) {
        const std::size_t end = matcher.match(start, anchored ? 1 : 0);
        if (end != PatternMatcher::failed && end != last) {
            ++count;
            add_replacement(L, out, matcher, subject, start, end);
            start = last = end;
        } else if (start < subject.size()) {
            out += subject[start++];
        } else {
            break;
        }
        if (start > subject.size() || anchored) break;
    }
    if (start < subject.size()) append(L, out, subject.substr(start));
    push_text(L, out);
    lua_pushinteger(L, count);
    return 2;
}

}  // namespace

void open_patterns(lua_State* L) {
    lua_getfield(L, -1, "string");
    add_pure<find>(L, "find");
    add_pure<match>(L, "match");
    add_pure<gmatch>(L, "gmatch");
    add_pure<gsub>(L, "gsub");
    lua_pop(L, 1);
}

}  // namespace fettle::script
