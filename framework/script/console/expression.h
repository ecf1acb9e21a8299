#pragma once
// Analyzes the expression before the cursor of a console without running it: calls no function and
// no metamethod of a script.

#include <string_view>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

struct Scan {
    bool in_string = false;
    std::size_t string_start = 0;     // index after the quote
    std::vector<std::size_t> braces;  // unclosed `{` and `(`, outermost first
};

Scan scan(std::string_view text);
/// Start of the word that ends at `end`.
std::size_t word_start(std::string_view text, std::size_t end);
/// End of the text before `end` without trailing blanks.
std::size_t skip_blanks_back(std::string_view text, std::size_t end);
/// Start of the path expression (names, dots, brackets) that ends at `end`.
std::size_t path_start(std::string_view text, std::size_t end);
/// Pushes the value of a path and sets `read` to its last property. Returns false and pushes
/// nothing if there is no such value.
bool push_path(lua_State* L, Machine& machine, std::string_view path,
               const property::Property** read);

}  // namespace fettle::script
