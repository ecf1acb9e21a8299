#pragma once
// The output of a console command, as the terminal shows it.

#include <string>
#include <vector>

#include <fettle/script/runtime.h>

namespace fettle::program {

/// The printed lines and results, each behind two spaces; then the error, behind a cross.
std::vector<std::string> lines_of(const script::Evaluation& answer);

}  // namespace fettle::program
