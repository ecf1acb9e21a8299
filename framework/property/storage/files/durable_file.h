#pragma once
// Files that are replaced completely or not at all. After any error or power failure, the name
// leads to the complete old content or to the complete new one.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace fettle::property {

/// Throws FileError: missing, unreadable, not a regular file, larger than `limit` bytes.
std::string read_file(const std::filesystem::path& file, std::size_t limit);

/// Writes a temporary file beside `file`, reads it back, synchronizes it with the disk, renames it
/// to `file` and synchronizes the folder. A symbolic link is followed; a replaced file keeps its
/// permissions. Throws FileError after removing the temporary file.
void replace_file(const std::filesystem::path& file, std::string_view content);

}  // namespace fettle::property
