#pragma once
// Files on their way to their place. A process holds a lock on each of its own for as long as it
// writes it; one that nobody holds was left behind by a process that was killed.

#include <filesystem>

#include <files/file_access.h>

namespace fettle::property {

class TemporaryFile {
  public:
    /// Makes an empty file beside `target`, under a hidden name that was free:
    /// `.level.json.123.fettle.tmp`. Throws std::system_error.
    explicit TemporaryFile(const std::filesystem::path& target);
    /// Removes it, unless it has found its place.
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int descriptor() const { return descriptor_.number(); }
    /// Gives it the name of its target, replacing what has that name. False with errno set.
    bool put_into_place();

  private:
    std::filesystem::path target_, path_;
    Descriptor descriptor_;
    bool placed_ = false;
};

/// Removes the temporary files in a folder that killed processes have left there. Files that a
/// living process writes, and names of any other form, are left alone; nothing is thrown.
void remove_leftovers(const std::filesystem::path& folder) noexcept;

}  // namespace fettle::property
