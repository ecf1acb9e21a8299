#pragma once

#include <string>
#include <string_view>

#include <fettle/property/tree.h>

namespace fettle::script {

/// ` (a text needs quotes: did you mean type = "static"?)`, if the line has `word` without quotes
/// where a property takes one of several texts, of which one is this or a similar word; else "".
std::string bare_word_hint(const property::Tree& tree, std::string_view line,
                           std::string_view word);

}  // namespace fettle::script
