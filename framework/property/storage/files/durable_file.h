#pragma once
// Files that are replaced whole or not at all: whatever fails, and whenever the power does, the
// name leads to the complete old content or to the complete new one.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace fettle::property {

/// Throws FileError: missing, unreadable, not a regular file, larger than `limit` bytes.
std::string read_file(const std::filesystem::path& file, std::size_t limit);

/// Writes a temporary file beside `file`, reads it back, synchronizes it with the disk, renames it
/// over `file` and synchronizes the folder. A symbolic link is followed; the permissions of a file
/// that is replaced stay. Throws FileError, having removed the temporary file.
void replace_file(const std::filesystem::path& file, std::string_view content);

}  // namespace fettle::property
