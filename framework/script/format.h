#pragma once
// Values as text for people: in the console, among local variables, in messages. Nothing here calls
// into a script, so hostile metamethods have no say, and no address is ever shown.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include "lua_api.h"

namespace fettle::script {

struct Machine;

/// A number as people write it: floats of native memory short, integral floats with ".0".
std::string number_for_people(double number);
/// One line of at most about 80 characters: `2`, `"text"`, `vec(1, 2)`, `world.ball`, `{1, 2, x =
/// 3}`.
std::string short_text(lua_State* L, int index);
/// A key in a message: a name as it is, anything else as `short_text`.
std::string key_in_message(lua_State* L, int index);
/// "2 kg", "vec(0, -10) m/s²"
std::string with_unit(const Machine& machine, const property::Value& value,
                      const property::Property& property);
/// A whole value as lines: instances and tables of instances as tables with units.
std::vector<std::string> long_text(lua_State* L, int index);
/// Columns of text, padded to their widest cell; the last is not.
std::vector<std::string> columns(const std::vector<std::vector<std::string>>& rows);
/// How many characters a terminal shows of UTF-8 text.
std::size_t shown_width(std::string_view text);
/// `text` cut to about `width` characters, whole UTF-8 sequences only, with "…" where cut.
std::string cut(std::string_view text, std::size_t width);

}  // namespace fettle::script
