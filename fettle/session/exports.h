#pragma once
// Files that a person exports from the console: plots as tables and pictures.

#include <filesystem>
#include <functional>
#include <string>

#include <fettle/app/layer.h>

namespace fettle::program {

/// A name that no file has, in the folder `plots` below `folder`, which is made. Throws FileError.
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& kind);
/// Write a new file and return its path. Throw FileError.
std::string write_export(const std::filesystem::path& file, const std::string& content);
std::string draw_export(const std::filesystem::path& file, float width, float height,
                        const std::function<void(app::Surface&)>& draw);

}  // namespace fettle::program
