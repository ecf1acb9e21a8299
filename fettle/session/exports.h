#pragma once
// Files that a person writes from the console: plots as tables and pictures, recordings.

#include <filesystem>
#include <functional>
#include <string>

#include <fettle/app/layer.h>

namespace fettle::program {

/// `STEM-N.KIND`, which no file is called yet, in the folder `name` of the player's folder
/// `player`; makes that folder. Throws FileError.
std::filesystem::path free_name(const std::filesystem::path& player, const std::string& name,
                                const std::string& stem, const std::string& kind);
/// Write a new file and return its path. Throw FileError.
std::string write_export(const std::filesystem::path& file, const std::string& content);
std::string draw_export(const std::filesystem::path& file, float width, float height,
                        const std::function<void(app::Surface&)>& draw);

}  // namespace fettle::program
