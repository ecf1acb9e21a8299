#pragma once
// What would be missing in a package of a game.

#include <string>
#include <vector>

#include <files/archive.h>

namespace fettle::program {

/// Why the game would not run elsewhere, one line each: files that its texts name and that it does
/// not have, that are called differently, or that are named by an absolute path. `made`: names of
/// files that the game makes.
std::vector<std::string> problems_of(const ArchiveFiles& files,
                                     const std::vector<std::string>& made);

}  // namespace fettle::program
