#pragma once
// How many cells of a font of fixed width a text takes: that of a terminal and of the console.

#include <cstddef>
#include <string_view>

#include <fettle/script/export.h>

FETTLE_SCRIPT_BEGIN

namespace fettle::script {

/// How many cells a character takes: two for Chinese characters and emoji, zero for a character
/// that only joins or changes its neighbors.
int cells_of(char32_t character);
/// How many cells a text takes.
std::size_t cell_count(std::string_view text);

}  // namespace fettle::script

FETTLE_SCRIPT_END
