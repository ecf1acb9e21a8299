#pragma once
// The place of an error, found in its message.

#include <fettle/script/runtime.h>

namespace fettle::script {

/// "main.lua:12: ...": file and line. Nothing when the message does not begin so.
void place_from_message(ScriptError& error);
/// Lua tells the line only. The word that a message is about (quoted, or the end of the path in
/// front of it) shows the column; 0 when the source line does not have it.
int guess_column(const ScriptError& error);

}  // namespace fettle::script
