#pragma once
// The expression before the cursor of a console, read without running any of it: no function is
// called and no metamethod of a script.

#include <string_view>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct Scan {
    bool in_string = false;
    std::size_t string_start = 0;     // behind the quote
    std::vector<std::size_t> braces;  // unclosed `{` and `(`, outermost first
};

Scan scan(std::string_view text);
/// Start of the word that ends at `end`.
std::size_t word_start(std::string_view text, std::size_t end);
/// End of what stands before `end`, blanks left out.
std::size_t skip_blanks_back(std::string_view text, std::size_t end);
/// Start of the path expression (names, dots, brackets) that ends at `end`.
std::size_t path_start(std::string_view text, std::size_t end);
/// Pushes what the path stands for; the property it ends in goes to `read`. Nothing is pushed when
/// it stands for nothing.
bool push_path(lua_State* L, Machine& machine, std::string_view path,
               const property::Property** read);

}  // namespace fettle::script
