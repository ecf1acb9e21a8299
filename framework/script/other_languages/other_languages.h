#pragma once
// Words and signs of other languages, and of older versions of Lua: the words that stand in their
// place here. Each hint is " (write ...)", to be added to a message, or "".

#include <string>
#include <string_view>

namespace fettle::script {

/// For a name that no variable has: `null`, `unpack`, `sqrt`.
std::string hint_for_name(std::string_view name);
/// For a method that no text has: `split`.
std::string hint_for_text_method(std::string_view name);
/// For a message of Lua about a value: "attempt to call a nil value (field 'pow')".
std::string hint_for_value(std::string_view message);
/// For a text that does not compile. `line`: where Lua stopped; `column`: bytes of the line before
/// the token that the message names. `in_file`: and not in a command of the console.
std::string hint_for_syntax(std::string_view message, std::string_view line, std::size_t column,
                            bool in_file);
/// For a color as in style sheets, #ff8000, whose letters or digits after # begin at `at`.
std::string hint_for_color(std::string_view line, std::size_t at);
/// Whether the text ends with a number and a word after it, as in "x = 5 kg".
bool ends_with_unit(std::string_view text);
std::string hint_for_unit();

}  // namespace fettle::script
