#pragma once
// What the operating system has to say about files, for those that are read, written and locked
// here.

#include <sys/stat.h>

#include <filesystem>
#include <string>

namespace fettle::property {

/// What an error number means, in words that say what to do about a full disk.
std::string system_reason(int error);

/// Why something of that mode cannot be read or replaced as a file: "it is a folder", "it is a
/// pipe, not a regular file"; "" for a regular file.
std::string why_no_file(mode_t mode);

/// A descriptor that is closed with its owner.
class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept;
    Descriptor& operator=(Descriptor&& other) noexcept;
    int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }
    /// Network file systems report a full disk only here.
    bool close();

  private:
    int number_ = -1;
};

/// `flags` as for open(2). Nothing when it fails, with errno set.
Descriptor open_file(const std::filesystem::path& path, int flags, mode_t mode = 0);

/// Locks the file for its descriptor alone if nobody else has locked it. False with errno set;
/// EWOULDBLOCK: another one has.
bool try_lock(const Descriptor& descriptor);

}  // namespace fettle::property
