#pragma once
// Descriptors, locks and error messages of files.

#include <sys/stat.h>

#include <filesystem>
#include <string>

namespace fettle::property {

/// The meaning of an error number in words. For a full disk it says how to make room.
std::string system_reason(int error);

/// Why something of that mode cannot be read or replaced as a file: "it is a folder", "it is a
/// pipe, not a regular file"; "" for a regular file.
std::string why_no_file(mode_t mode);

/// A file descriptor with an owner that closes it.
class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }
    /// False if closing fails: network file systems report a full disk only here.
    bool close();

  private:
    int number_ = -1;
};

/// `flags` as for open(2). The result is empty, with errno set, if the call fails.
Descriptor open_file(const std::filesystem::path& path, int flags, mode_t mode = 0);

/// Locks the file unless another descriptor has locked it. False with errno set; EWOULDBLOCK: it is
/// locked.
bool try_lock(const Descriptor& descriptor);

/// Locks a folder itself, so no lock file is necessary. The lock ends with the result, or with the
/// process. Waits some seconds for another process that has locked it; then throws FileError. The
/// result locks nothing if the folder cannot be opened, or its file system has no locks.
Descriptor lock_folder(const std::filesystem::path& folder);

}  // namespace fettle::property
