#pragma once
// A shared object in the process.

#include <filesystem>
#include <string>

namespace fettle::module {

/// A copy of a file beside it, under a name that was never used, so that the file may be replaced
/// meanwhile and taken in again. It goes with this: made by the process that tries a module in a
/// copy of itself, it goes whatever happens there.
class ModuleCopy {
  public:
    /// Which file it is, whatever its path: two paths of one file are alike.
struct FileIdentity {
    std::uint64_t device = 0, inode = 0;
    friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};
FileIdentity identity(const std::filesystem::path& file);

}  // namespace fettle::module
