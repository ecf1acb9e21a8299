#pragma once
// The commands that were typed into the console: the chunks of their texts, and the local variables
// that ended with them.

#include <cstddef>
#include <deque>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

#include <fettle/script/runtime.h>

namespace fettle::script {

class TypedCommands {
  public:
    using Texts = std::unordered_map<std::string, std::string>;  // by name of the chunk

    /// Stores the text of the command that runs next. A command that makes functions has a chunk of
    /// its own, such as "console 2": the functions may fail after other commands.
    void store(std::string_view command, Texts& texts);
    /// The chunk of the last command.
    const std::string& chunk() const { return chunk_; }
    /// Names the chunk of the last command "console" in an error of this command itself.
    void name_plainly(ScriptError& error) const;
    /// The same in a text that has places, such as "console 2:1".
    void name_plainly(std::string& text) const;
    /// Whether a command has declared a local variable of that name, which ended with it.
    bool was_local(std::string_view name) const { return locals_.contains(name); }

    /// Contains the text of the last command, too.
    static constexpr const char* plain_chunk = "console";
    /// Whether a chunk of that name is a command.
    static bool is_chunk(std::string_view name);

  private:
    void note_locals(std::string_view code);

    std::string chunk_{plain_chunk};
    std::size_t number_ = 1;
    std::deque<std::string> kept_{};  // chunks of commands that make functions
    std::set<std::string, std::less<>> locals_{};
};

}  // namespace fettle::script
