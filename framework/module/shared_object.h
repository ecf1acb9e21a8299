#pragma once
// Loading of shared objects.

#include <cstdint>
#include <filesystem>
#include <string>

namespace fettle::module {

/// A copy of a file in the same folder under a new name, so that the file may be replaced and
/// loaded again. The process of a trial loads the copy of the game, which removes it even if the
/// trial crashes.
class ModuleCopy {
  public:
    /// Throws LoadError unless `file` can be a shared object for this machine.
    explicit ModuleCopy(const std::filesystem::path& file);
    ~ModuleCopy();
    ModuleCopy(const ModuleCopy&) = delete;
    ModuleCopy& operator=(const ModuleCopy&) = delete;

    /// The original file.
    const std::filesystem::path& of() const { return file_; }
    /// The copy, or the original file if no copy could be made.
    const std::filesystem::path& path() const { return copy_.empty() ? file_ : copy_; }

  private:
    bool copy_into(const std::filesystem::path& folder);
    std::filesystem::path file_, copy_;
    // Held while this object lives; a copy without a lock belongs to a killed process.
    int lock_ = -1;
};

class SharedObject {
  public:
    SharedObject() = default;
    /// Loads the copy of a file. Throws LoadError, which names the file.
    SharedObject(const std::filesystem::path& copy, const std::filesystem::path& file);
    ~SharedObject() { close(); }
    SharedObject(SharedObject&& other) noexcept : handle_(other.handle_) {
        other.handle_ = nullptr;
    }
    SharedObject& operator=(SharedObject&& other) noexcept;

    /// Null if there is no symbol of that name.
    void* symbol(const char* name) const;

  private:
    void close();
    void* handle_ = nullptr;
};

/// Identifies a file independently of its path.
struct FileIdentity {
    std::uint64_t device = 0, inode = 0;
    friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};
FileIdentity identity(const std::filesystem::path& file);

}  // namespace fettle::module
