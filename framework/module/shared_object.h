#pragma once
// A shared object in the process.

#include <filesystem>
#include <string>

namespace fettle::module {

class SharedObject {
  public:
    SharedObject() = default;
    /// Takes in `file` through a copy under a name that was never used, so that it may be replaced
    /// meanwhile and taken in again. Throws LoadError.
    explicit SharedObject(const std::filesystem::path& file);
    ~SharedObject() { close(); }
    SharedObject(SharedObject&& other) noexcept : handle_(other.handle_) {
        other.handle_ = nullptr;
    }
    SharedObject& operator=(SharedObject&& other) noexcept;

    /// Null when there is none of that name.
    void* symbol(const char* name) const;

  private:
    void close();
    void* handle_ = nullptr;
};

/// Throws LoadError unless `file` can be a shared object for this machine.
void require_shared_object(const std::filesystem::path& file);

/// Which file it is, whatever its path: two paths of one file are alike.
struct FileIdentity {
    std::uint64_t device = 0, inode = 0;
    friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};
FileIdentity identity(const std::filesystem::path& file);

}  // namespace fettle::module
