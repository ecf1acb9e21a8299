#pragma once
// Reading whole files; <fettle/property/storage/replaced_file.h> has the writing.

#include <cstddef>
#include <filesystem>
#include <string>

#include <fettle/property/storage/replaced_file.h>

namespace fettle::property {

/// Throws FileError: missing, unreadable, not a regular file, larger than `limit` bytes.
std::string read_file(const std::filesystem::path& file, std::size_t limit);

}  // namespace fettle::property
