#pragma once
// A folder in which something is made that has its name only when it is complete.

#include <filesystem>

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

}  // namespace fettle::program
