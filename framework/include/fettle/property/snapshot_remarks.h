#pragma once
// Descriptions of what a snapshot from a file does not restore.

#include <string>
#include <vector>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// The formulas that no file can contain, one line each: `world.a.x: its formula uses the local
/// variable "speed" of main.lua:12`. A file contains the last values of their properties instead.
std::vector<std::string> unsaved_formulas(const Tree& tree);

/// Differences from the last restored snapshot, one line each: formulas that were not saved or no
/// longer compile, values that no longer fit their properties, instances that their modules refused
/// to create (`world.a: it cannot be made ...`), and the data that parts lost.
const std::vector<std::string>& restore_remarks(const Tree& tree);

}  // namespace fettle::property

FETTLE_PROPERTY_END
