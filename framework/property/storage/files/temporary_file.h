#pragma once
// Temporary files for replacing other files. A process locks each of its temporary files while it
// writes them. A temporary file without a lock was left by a process that was killed.

#include <filesystem>

#include <files/file_access.h>

namespace fettle::property {

class TemporaryFile {
  public:
    /// Makes an empty file beside `target` with an unused hidden name:
    /// `.level.json.123.fettle.tmp`. Throws std::system_error.
    explicit TemporaryFile(const std::filesystem::path& target);
    /// Removes the file unless `put_into_place` succeeded.
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int descriptor() const { return descriptor_.number(); }
    /// Renames it to its target, replacing an existing file. False with errno set.
    bool put_into_place();

  private:
    std::filesystem::path target_, path_;
    Descriptor descriptor_;
    bool placed_ = false;
};

/// Removes the temporary files that killed processes left in a folder. Files of running processes,
/// and files with names of any other form, stay. Throws nothing.
void remove_leftovers(const std::filesystem::path& folder) noexcept;

}  // namespace fettle::property
