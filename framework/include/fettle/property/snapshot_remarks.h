#pragma once
// What a snapshot that went through a file does not bring back, in words for people.

#include <string>
#include <vector>

#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// The formulas that no file can hold, a line each: `world.a.x: its formula uses the local variable
/// "speed" of main.lua:12`. A file holds the last values of their properties instead.
std::vector<std::string> unsaved_formulas(const Tree& tree);

/// What could not be as it was when the last snapshot was restored, a line each: formulas that were
/// not saved or no longer compile, values that no longer fit their properties, instances that their
/// modules would not make (`world.a: it cannot be made ...`).
const std::vector<std::string>& restore_remarks(const Tree& tree);

}  // namespace fettle::property

FETTLE_PROPERTY_END
