#pragma once
// Reasons why a package of a game would not run elsewhere.

#include <string>
#include <vector>

#include <files/packed_game.h>

namespace fettle::program {

/// The reasons why the package would not run elsewhere, one line each: a script does not
/// compile, or a text names a file that is missing, whose name differs, or that has an absolute
/// path. `made`: names of files that the game makes.
std::vector<std::string> problems_of(const PackedGame& game, const std::vector<std::string>& made);

}  // namespace fettle::program
