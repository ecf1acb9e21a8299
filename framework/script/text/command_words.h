#pragma once
// What people type who know a shell, the console of another engine or a browser, and what they can
// type here.

#include <string>
#include <string_view>

namespace fettle::script {

/// For a command that is not valid here: " (write it = world.ball)" for `cd world.ball`; "" if its
/// first word is unknown.
std::string hint_for_command(std::string_view command);
/// For a command such as `rewind 5` or `bind f5 restart()`, whose first word is a function: the
/// call with these arguments, "rewind(5)"; "" if the arguments are unclear.
std::string call_with_arguments(std::string_view command);
/// The first word of a command: what blanks or a bracket end.
std::string_view first_word(std::string_view command);

}  // namespace fettle::script
