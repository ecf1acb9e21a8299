#pragma once
// `fettle repl --attach`: a terminal types into the console of a game that runs already.

#include <string>

namespace fettle::program {

/// `wanted`: the game's name, path or process; "": the only one that listens. Returns the exit
/// status. Throws FileError.
int attach(const std::string& wanted);

}  // namespace fettle::program
