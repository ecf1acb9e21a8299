#include "errors.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdio>
#include <optional>

#include "format.h"
#include "machine.h"
#include "protected.h"
#include "words.h"

namespace fettle::script {

namespace {

constexpr int most_frames = 40;
constexpr int most_locals = 40;

std::string source_line(Machine& machine, const std::string& file, int line) {
    const auto found = machine.sources.find(file);
    if (found == machine.sources.end() || line <= 0) return {};
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

// "main.lua:12: ..." -> its place.
void place_from_message(ScriptError& error) {
    const std::string& text = error.message;
    for (std::size_t colon = text.find(':'); colon != std::string::npos;
         colon = text.find(':', colon + 1)) {
        std::size_t end = colon + 1;
        while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end]))) ++end;
        if (end == colon + 1 || end >= text.size() || text[end] != ':') continue;
        error.file = text.substr(0, colon);
        std::from_chars(text.data() + colon + 1, text.data() + end, error.line);
        return;
    }
}

int column_of(const std::string& line, const std::string& word) {
    if (word.empty()) return 0;
    for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1)) {
        const bool starts = at == 0 || !is_word(line[at - 1]) || !is_word(word.front());
        const std::size_t end = at + word.size();
        const bool ends = end >= line.size() || !is_word(line[end]) || !is_word(word.back());
        if (starts && ends) return static_cast<int>(shown_width(line.substr(0, at))) + 1;
    }
    return 0;
}

// Lua tells the line only. The word that a message is about (quoted, or the end of the path in
// front of it) shows the column.
int guess_column(const ScriptError& error) {
    const std::string& text = error.message;
    for (std::size_t open = text.find('\''); open != std::string::npos;) {
        const std::size_t close = text.find('\'', open + 1);
        if (close == std::string::npos) break;
        if (const int column =
                column_of(error.source_line, text.substr(open + 1, close - open - 1)))
            return column;
        open = text.find('\'', close + 1);
    }
    // "main.lua:12: world.ball.mas: no such name"
    std::size_t start = error.file.size();
    start = text.find(": ", start);
    if (start == std::string::npos) return 0;
    start += 2;
    const std::size_t end = text.find(": ", start);
    if (end == std::string::npos) return 0;
    std::string path = text.substr(start, end - start);
    std::size_t word = path.find_last_of(".:[]\" ");
    return column_of(error.source_line, word == std::string::npos ? path : path.substr(word + 1));
}

std::string frame_name(const lua_Debug& frame) {
    if (frame.name && *frame.name) {
        const std::string name = frame.name;
        if (std::string_view(frame.namewhat) == "metamethod") return "metamethod " + name;
        return "function " + name;
    }
    if (frame.what[0] == 'm') return "main chunk";
    return "function at line " + std::to_string(frame.linedefined);
}

std::string traceback_of(lua_State* L, int level) {
    std::string text;
    lua_Debug frame;
    int shown = 0;
    for (; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Slnt", &frame);
        if (frame.what[0] == 'C' && (!frame.name || !*frame.name)) continue;  // our own entry
        if (++shown > most_frames) {
            text += "  ...\n";
            break;
        }
        text += "  ";
        if (frame.currentline > 0)
            text += std::string(frame.short_src) + ":" + std::to_string(frame.currentline) + ": ";
        text += "in " + frame_name(frame) + "\n";
        if (frame.istailcall) text += "  (tail calls)\n";
    }
    return text;
}

std::string locals_of(lua_State* L, lua_Debug& frame) {
    std::string text;
    if (!lua_checkstack(L, 8)) return text;
    for (int n = 1; n <= most_locals; ++n) {
        const char* name = lua_getlocal(L, &frame, n);
        if (!name) break;
        if (name[0] != '(') text += std::string(name) + " = " + short_text(L, -1) + "\n";
        lua_pop(L, 1);
    }
    return text;
}

// The innermost frame of a script, at `level` or above.
bool script_frame(lua_State* L, int level, lua_Debug& frame) {
    for (; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline > 0) return true;
    }
    return false;
}

constexpr const char* out_of_memory = "not enough memory";  // as Lua says it, and no more

void tell_refusal(Machine& machine, ScriptError& error) {
    if (std::string told = machine.budget.take_refusal(); !told.empty())
        error.message = std::move(told);
}

// What the error says of itself, if it is an object that can. Its `__tostring` may raise as well,
// and it may take only so long.
std::optional<std::string> own_text(lua_State* L, int index) {
    if (machine_of(L).budget.stopping() || luaL_getmetafield(L, index, "__tostring") == LUA_TNIL)
        return std::nullopt;
    lua_pushvalue(L, index < 0 ? index - 1 : index);
    std::optional<std::string> text;
    const Budget::Scope budget(machine_of(L).budget, {.instructions = 100'000, .memory = 1 << 20});
    machine_of(L).budget.enter(L);
    if (lua_pcall(L, 1, 1, 0) == LUA_OK && lua_type(L, -1) == LUA_TSTRING) text = string_at(L, -1);
    lua_pop(L, 1);
    return text;
}

// A screen, a terminal or a log would end the text at a zero byte, and obey other ones.
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
    if (const auto text = own_text(L, index))
        return without_control_characters(std::string_view(*text).substr(0, longest));
    return without_control_characters("the error is not a text but " + describe_type(L, index) +
                                      ": " + short_text(L, index));
}

void add_missing_position(lua_State* L, lua_State* from, int level) {
    if (lua_type(from, -1) != LUA_TSTRING) return;
    lua_Debug frame;
    if (!lua_getstack(L, level, &frame) || !lua_checkstack(L, 4)) return;
    lua_getinfo(L, "f", &frame);
    const lua_CFunction raiser = lua_tocfunction(L, -1);
    lua_pop(L, 1);
    if (raiser == nullptr) return;
    const auto& told = machine_of(L).raise_as_told;
    if (std::find(told.begin(), told.end(), raiser) != told.end()) return;
    ScriptError error;
    error.message = string_at(from, -1);
    place_from_message(error);
    if (error.line > 0) return;
    std::string placed = position(L) + error.message;
    if (error.message == out_of_memory)
        if (std::string refusal = machine_of(L).budget.take_refusal(); !refusal.empty())
            placed = std::move(refusal);
    lua_pop(from, 1);
    lua_pushlstring(from, placed.data(), placed.size());
}

int placing_handler(lua_State* L) {
    if (!machine_of(L).budget.stopping()) add_missing_position(L, L, 1);
    return 1;
}

ScriptError describe_error(Machine& machine, lua_State* L, int level, lua_State* from, int index) {
    ScriptError error;
    lua_checkstack(from, 8);
    error.message = error_text(from, index);
    if (error.message == out_of_memory) tell_refusal(machine, error);
    if (machine.thread_error && machine.thread_error->message == error.message) {
        // It rose out of a coroutine, where it was described already.
        error = std::move(*machine.thread_error);
        machine.thread_error.reset();
        // A timer's coroutine was started by nobody in a script.
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
    error.source_line = source_line(machine, error.file, error.line);
    error.column = guess_column(error);
    error.traceback = traceback_of(L, level);
    if (found) error.locals = locals_of(L, frame);
    return error;
}

ScriptError describe_place(Machine& machine, lua_State* L) {
    ScriptError place;
    lua_Debug frame;
    if (script_frame(L, 0, frame)) {
        place.file = frame.short_src;
        place.line = frame.currentline;
        place.source_line = source_line(machine, place.file, place.line);
        place.locals = locals_of(L, frame);
    }
    place.traceback = traceback_of(L, 0);
    return place;
}

int describing_handler(lua_State* L) {
    Machine& machine = machine_of(L);
    try {
        lua_settop(L, 1);
        add_missing_position(L, L, 1);
        machine.caught = describe_error(machine, L, 1, L, 1);
    } catch (const std::exception&) {
        machine.caught.reset();
    }
    lua_settop(L, 1);
    return 1;
}

/// A sink may run scripts, which may be in error: that ends before the stack does.
void report(Machine& machine, ScriptError error) {
    constexpr int deepest = 16;
    if (machine.reports == deepest) {
        std::fprintf(stderr, "an error while errors were told, %d deep: %s\n", deepest,
                     error.message.c_str());
        return;
    }
    struct Depth {
        int& of;
        explicit Depth(int& reports) : of(reports) { ++of; }
        ~Depth() { --of; }
    } depth(machine.reports);
    if (const auto sink = machine.error_sink) sink(error);  // it may be replaced meanwhile
}

std::string Context::text(Machine& machine) const {
    if (!about) return what;
    const bool alive = machine.tree.alive(about);
    if (property)
        return what + " of " +
               (alive ? machine.tree.path(about, *property) : "(deleted)." + property->name);
    return what + " of " + (alive ? machine.tree.path(about) : "(deleted)");
}

namespace {

void tell_where_stopped(Machine& machine, ScriptError& error) {
    error.message = machine.budget.reason();
    error.file = machine.budget.file();
    error.line = machine.budget.line();
    error.source_line = source_line(machine, error.file, error.line);
    error.column = 0;
}

}  // namespace

bool run_protected(Machine& machine, const Context& context, int (*trampoline)(lua_State*),
                   void* body, bool report_error) {
    if (!machine.in_tree) return false;  // its runtime was destroyed: only what runs ends yet
    const Machine::Use use(machine);
    const Watchdog::Call call(machine.watchdog);
    lua_State* L = machine.main;
    lua_State* outer = machine.running;
    machine.running = L;
    machine.caught.reset();
    const int top = lua_gettop(L);
    int status = LUA_ERRMEM;
    if (lua_checkstack(L, 4)) {
        lua_pushcfunction(L, describing_handler);
        lua_pushcfunction(L, trampoline);
        lua_pushlightuserdata(L, body);
        const ScriptCause cause(machine, machine.writer);
        status = lua_pcall(L, 1, 0, top + 1);
    }
    machine.running = outer;
    // A pcall that ends what runs may have caught the end of the budget.
    const bool stopped = machine.budget.stopping();
    if (status == LUA_OK && !stopped) {
        lua_settop(L, top);
        return true;
    }
    if (!machine.caught) {
        // Out of memory, or an error while describing one: there is a message and no more.
        ScriptError error;
        error.message = status == LUA_OK                 ? machine.budget.reason()
                        : lua_type(L, -1) == LUA_TSTRING ? error_text(L, -1)
                        : status == LUA_ERRMEM           ? out_of_memory
                                                         : "an error that cannot be described";
        if (error.message == out_of_memory) tell_refusal(machine, error);
        place_from_message(error);
        error.source_line = source_line(machine, error.file, error.line);
        machine.caught = std::move(error);
    }
    lua_settop(L, top);
    // Where it was stopped, whatever the script made of that error.
    if (stopped) tell_where_stopped(machine, *machine.caught);
    machine.thread_error.reset();
    machine.caught->context = context.text(machine);
    if (report_error) {
        ScriptError error = std::move(*machine.caught);
        machine.caught.reset();
        report(machine, std::move(error));
    }
    return false;
}

ScriptCause::ScriptCause(Machine& machine, property::Writer writer)
    : locate_([&machine] {
          std::string text = position(machine.running ? machine.running : machine.main);
          if (text.size() > 2) text.resize(text.size() - 2);
          return text;
      }),
      scope_(machine.tree, writer, &locate_) {}

}  // namespace fettle::script

std::vector<std::string> fettle::script::error_lines(const ScriptError& error) {
    std::vector<std::string> lines = {error.message};
    if (!error.source_line.empty()) {
        std::string line = error.source_line;
        for (char& c : line)
            if (c == '\t') c = ' ';
        lines.push_back("  " + line);
        if (error.column > 0)
            lines.push_back("  " + std::string(static_cast<std::size_t>(error.column) - 1, ' ') +
                            "^");
    }
    return lines;
}
