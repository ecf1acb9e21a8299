#pragma once
// Pictures as the bytes of files.

#include <filesystem>
#include <string>

#include <fettle/app/screen.h>

namespace fettle::app {

/// Writes the picture as PNG, JPEG, BMP or TGA, as the ending of the name says. Throws
/// std::runtime_error that names file and reason; then an earlier file is as it was.
void write_picture(const Pixels& picture, const std::filesystem::path& file);

}  // namespace fettle::app
