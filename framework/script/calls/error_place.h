#pragma once
// Finds the place of an error from its message.

#include <fettle/script/runtime.h>

namespace fettle::script {

/// Sets file and line from a message of the form "main.lua:12: ...". Does nothing for other
/// messages.
void place_from_message(ScriptError& error);
/// Lua reports only the line. The column is that of the name in the message: a quoted name, or the
/// last name of the path at its beginning. Returns 0 if the source line does not contain it.
int guess_column(const ScriptError& error);

}  // namespace fettle::script
