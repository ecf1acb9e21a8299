#pragma once
// Numbers in messages, with a point in every locale of the program.

#include <string>

namespace fettle::physics::detail {

/// With so many digits, as "%g" of printf in the locale "C".
std::string number_text(double number, int digits = 6);

/// With six digits, or nine if six name another number: a number just beyond a limit does not look
/// like the limit.
std::string exact_text(float number);

}  // namespace fettle::physics::detail
