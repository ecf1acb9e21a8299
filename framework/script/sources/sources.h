#pragma once
// The files of a game, and the texts of compiled chunks.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>

#include <fettle/property/storage/game_files.h>

#include <lua/lua_api.h>
#include <sources/typed_commands.h>

namespace fettle::script {

/// Compiles source text as luaL_loadbufferx does, but a budget can stop it meanwhile: Lua looks
/// each name up in all functions around it, so the time of a text may grow with the square of its
/// length.
int load_text(lua_State* L, std::string_view code, const char* name);
/// The same without searching for the place of an error, which compiles the text again.
int try_load_text(lua_State* L, std::string_view code, const char* name);

/// Lua gives no place for a text that is nested too deeply. If that is the message at the top of
/// the stack, puts the place there. `reader` reads one byte of a std::string_view.
void place_overflow(lua_State* L, std::string_view code, const char* name, lua_Reader reader);

/// The next piece of a text that is compiled, for a function that lua_load calls: short enough to
/// be compiled within milliseconds. `most`: bytes.
const char* next_piece(lua_State* L, std::string_view& left, std::size_t* size,
                       std::size_t most = 256);

/// The text without a byte order mark at its beginning.
std::string_view without_byte_order_mark(std::string_view text);
/// The text without a first line `#!...`, which is for the shell. The line end stays, so that lines
/// keep their numbers.
std::string_view without_shell_line(std::string_view text);

struct Sources {
    /// `given`: null for the files on the disk.
    explicit Sources(property::GameFiles* given) : files(given != nullptr ? *given : on_disk) {}
    Sources(const Sources&) = delete;

    property::GameFiles on_disk{};
    property::GameFiles& files;
    std::filesystem::path folder;                        // of the game; empty if there is none
    std::unordered_map<std::string, std::string> texts;  // by name of the chunk

    /// Compiles a text and stores it for error messages under `name`. Returns a status of Lua; the
    /// function or the message is at the top of the stack.
    int load(lua_State* L, const std::string& text, const std::string& name);
    /// The last text that did not compile: its message, and where in its line the token begins that
    /// the message names. Lua reports only the line.
    struct Stop {
        std::string message;
        std::size_t column = 0;  // bytes before the token
        std::size_t place = 0;   // the same in the text
    };
    Stop stop{};
    TypedCommands commands{};

    /// Sets `stop` for a text that did not compile; its message is at the top of the stack, and
    /// gets a hint if it is code of another language.
    void set_stop(lua_State* L, std::string_view code, const char* name);

    /// A line of a chunk, from 1; "" if unknown.
    std::string line(const std::string& file, int line) const;
};

}  // namespace fettle::script
