#pragma once
// Scene files of a game.

#include <string>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::script {

struct Machine;

/// Loads a scene file. `what` begins messages about its name.
property::Handle load_scene_file(Machine& machine, const char* what, const std::string& file,
                                 property::Handle parent, const std::string& name);
/// The file of the scene that is called so: "level_2" is scenes/level_2.json or level_2.json. Empty
/// if there is none.
std::string scene_file_named(Machine& machine, const std::string& name);
/// Names of all scenes that are files.
std::vector<std::string> scene_file_names(Machine& machine);

}  // namespace fettle::script
