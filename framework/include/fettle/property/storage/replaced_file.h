#pragma once
// Files that are replaced completely or not at all. After any error or power failure, the name
// leads to the complete old content or to the complete new one.

#include <filesystem>
#include <string_view>

#include <fettle/property/storage/export.h>

FETTLE_STORAGE_BEGIN

namespace fettle::property {

/// Writes a temporary file beside `file`, reads it back, synchronizes it with the disk, renames it
/// to `file` and synchronizes the folder. A symbolic link is followed; a replaced file keeps its
/// permissions. Throws FileError after removing the temporary file.
void replace_file(const std::filesystem::path& file, std::string_view content);

}  // namespace fettle::property

FETTLE_STORAGE_END
