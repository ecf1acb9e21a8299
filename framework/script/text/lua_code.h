#pragma once
// What of a text in Lua is code.

#include <string>
#include <string_view>

namespace fettle::script {

/// The text with blanks in the place of comments and of what quotes and long brackets contain;
/// their signs stay. It has as many bytes and lines.
std::string code_of(std::string_view text);

}  // namespace fettle::script
