#pragma once
// The program that tries modules out before they are loaded: `fettle-trial`.
//
// A module is opened, attached, tested and stepped there first, in a tree with the classes, the
// instances and the values of the game, so that a module that crashes does no harm to the game.

#include <filesystem>
#include <vector>

#include <fettle/module/export.h>

FETTLE_MODULE_BEGIN

namespace fettle::module {

/// Sets the file of the program, for games that bring it along in a place of their own. An empty
/// path: it is looked for again.
void set_trial_program(const std::filesystem::path& file);

/// The places where the program is looked for, in this order. What `set_trial_program` or the
/// environment variable `FETTLE_TRIAL` names is the only place. Otherwise: beside the program that
/// runs and beside the library `fettle_module`, in the folder `libexec/fettle` of their prefix, and
/// where the library was installed.
std::vector<std::filesystem::path> trial_program_places();

/// All that the program does: `int main() { return fettle::module::trial_main(); }`. A game whose
/// modules call functions of the game itself builds such a program with these functions.
int trial_main();

}  // namespace fettle::module

FETTLE_MODULE_END
