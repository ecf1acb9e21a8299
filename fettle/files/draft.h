#pragma once
// A folder in which something is made that has its name only when it is complete.

#include <filesystem>
#include <string>
#include <system_error>

namespace fettle::program {

/// An empty folder with a new name beside `result`, so that what is made in it can be renamed to
/// `result`. It is deleted at the end. Throws FileError.
class Draft {
  public:
    explicit Draft(const std::filesystem::path& result);
    ~Draft();
    Draft(const Draft&) = delete;
    const std::filesystem::path path;
};

/// Why a file could not be written into the folder: the disk is full, or the reason of the system.
std::string reason_of_write(const std::filesystem::path& folder, const std::error_code& code);

}  // namespace fettle::program
