#pragma once
// The console's layout of a game, in a file of the player.

#include <filesystem>
#include <string>

#include <fettle/console/console.h>

namespace fettle::program {

/// Reads `console.json` in that folder. An empty layout if the file is missing or damaged.
console::Layout read_layout(const std::filesystem::path& folder);
/// Writes it if it has changed. Throws if it cannot.
void write_layout(const std::filesystem::path& folder, const console::Layout& layout);
/// The player's `autoexec.lua`; "" if there is none. `problem`: why it cannot be read.
std::string autoexec(std::string& problem);

}  // namespace fettle::program
