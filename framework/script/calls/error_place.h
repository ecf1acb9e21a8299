#pragma once
// Finds the place of an error from its message.

#include <fettle/script/runtime.h>

#include <sources/sources.h>

namespace fettle::script {

/// Sets the file and the line of the error if its message has the form "main.lua:12: ...".
void place_from_message(ScriptError& error);
/// Finds the column of the error, which Lua does not report: it searches the source line, without
/// its texts and comments, for the name in the message. This is a quoted name, or the last name of
/// the path at the beginning of the message, in the place that has most of the path. Returns 0 if
/// the line does not contain the name, or if several places fit. `stop`: where the last text
/// stopped that did not compile.
int guess_column(const ScriptError& error, const Sources::Stop& stop);
/// Of a very long source line, leaves the part around the column.
void shorten_source(ScriptError& error);

}  // namespace fettle::script
