#pragma once
// Whether a text is Lua.

#include <string>
#include <string_view>

#include <fettle/script/export.h>

FETTLE_SCRIPT_BEGIN

namespace fettle::script {

/// Why a text does not compile, as "enemy.lua:3: unexpected symbol near '='"; "" if it does.
std::string syntax_error(std::string_view text, const std::string& name);

}  // namespace fettle::script

FETTLE_SCRIPT_END
