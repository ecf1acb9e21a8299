#pragma once
// A shared object in the process.

#include <cstdint>
#include <filesystem>
#include <string>

namespace fettle::module {

/// A copy of a file beside it, under a name that was never used, so that the file may be replaced
/// and loaded again. To test a module in a copy of the process, make this before: its destructor
/// removes the file in any case.
class ModuleCopy {
  public:
    /// Throws LoadError unless `file` can be a shared object for this machine.
    explicit ModuleCopy(const std::filesystem::path& file);
    ~ModuleCopy();
    ModuleCopy(const ModuleCopy&) = delete;
    ModuleCopy& operator=(const ModuleCopy&) = delete;

    /// The file that is copied.
    const std::filesystem::path& of() const { return file_; }
    /// The copy; the file itself where none could be made.
    const std::filesystem::path& path() const { return copy_.empty() ? file_ : copy_; }

  private:
    bool copy_into(const std::filesystem::path& folder);
    std::filesystem::path file_, copy_;
    int lock_ = -1;  // held while it lives: a copy without a lock was left by a killed process
};

class SharedObject {
  public:
    SharedObject() = default;
    /// Takes the copy in. Throws LoadError.
    explicit SharedObject(const ModuleCopy& copy);
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

/// Which file it is, whatever its path: two paths of one file are alike.
struct FileIdentity {
    std::uint64_t device = 0, inode = 0;
    friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};
FileIdentity identity(const std::filesystem::path& file);

}  // namespace fettle::module
