#include "shared_object.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include <fettle/module/plugin.h>

namespace fettle::module {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t size_limit = std::uintmax_t{1} << 30;  // bytes

/// Opens a file for reading; O_NONBLOCK: a pipe must not wait for a writer.
int opened(const fs::path& file, int flags = 0) {
    return ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | flags);
}

void require_regular(const fs::path& file, const struct stat& status) {
    const mode_t mode = status.st_mode;
    const char* const found = S_ISREG(mode)    ? nullptr
                              : S_ISDIR(mode)  ? "a folder"
                              : S_ISFIFO(mode) ? "a pipe"
                              : S_ISSOCK(mode) ? "a socket"
                                               : "a device";
    if (found != nullptr)
        throw LoadError(file, std::string("expected a shared object, found ") + found);
    if (static_cast<std::uintmax_t>(status.st_size) > size_limit)
        throw LoadError(file, "expected a shared object, found a file larger than " +
                                  std::to_string(size_limit >> 20) + " MB");
}

void require_shared_object(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0)
        throw LoadError(file, errno == ENOENT || errno == ENOTDIR
                                  ? std::string("there is no such file")
                                  : std::string("it cannot be read: ") + std::strerror(errno));
    require_regular(file, status);
    const int in = opened(file);
    char magic[4] = {};
    const ssize_t count = in < 0 ? -1 : ::read(in, magic, sizeof magic);
    const int error = errno;
    if (in >= 0) ::close(in);
    if (count < 0) throw LoadError(file, std::string("it cannot be read: ") + std::strerror(error));
    if (std::string_view(magic, 4) !=
        "\x7f"
        "ELF")
        throw LoadError(file, "expected a shared object, found a file of another kind");
}

constexpr std::string_view mark = ".fettle-";

/// A new name such as `.weather.fettle-123-4.so` in `folder`. In the folder of the file itself, the
/// loader finds the same neighboring libraries.
fs::path fresh_name(const fs::path& file, const fs::path& folder) {
    static std::atomic<unsigned> count{0};
    return folder /
           ("." + file.stem().string().substr(0, 200) + std::string(mark) +
            std::to_string(getpid()) + "-" + std::to_string(++count) + file.extension().string());
}

/// Whether the name of an open file is gone.
bool removed(int file) {
    struct stat status {};
    return ::fstat(file, &status) == 0 && status.st_nlink == 0;
}

/// Removes copies that killed processes have left in a folder.
void remove_leftovers(const fs::path& folder) {
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        const std::string name = it->path().stem().string();
        const std::size_t at = name.rfind(mark);
        if (!name.starts_with('.') || at == std::string::npos) continue;
        const std::string_view numbers = std::string_view(name).substr(at + mark.size());
        if (numbers.find_first_not_of("0123456789-") != std::string_view::npos) continue;
        const int copy = opened(it->path(), O_NOFOLLOW);
        if (copy < 0) continue;
        struct stat status {};
        if (::fstat(copy, &status) == 0 && S_ISREG(status.st_mode) &&
            ::flock(copy, LOCK_EX | LOCK_NB) == 0)
            ::unlink(it->path().c_str());
        ::close(copy);
    }
}

}  // namespace

ModuleCopy::ModuleCopy(const fs::path& file) : file_(file) {
    require_shared_object(file);
    const fs::path whole = fs::absolute(file);
    remove_leftovers(whole.parent_path());
    std::error_code error;
    if (copy_into(whole.parent_path()) || copy_into(fs::temp_directory_path(error))) return;
    file_ = whole;
}

ModuleCopy::~ModuleCopy() {
    if (!copy_.empty()) ::unlink(copy_.c_str());
    if (lock_ >= 0) ::close(lock_);
}

bool ModuleCopy::copy_into(const fs::path& folder) {
    // Create and lock an empty file first: another process may remove any unlocked copy. It may
    // also do that between the creation and the lock; then another file is created.
    do {
        if (lock_ >= 0) ::close(lock_);
        copy_ = fresh_name(file_, folder);
        lock_ = ::open(copy_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
        if (lock_ >= 0) (void)::flock(lock_, LOCK_EX);
    } while (lock_ >= 0 && removed(lock_));
    std::error_code error;
    if (lock_ >= 0 && fs::copy_file(file_, copy_, fs::copy_options::overwrite_existing, error))
        return true;
    if (lock_ >= 0) {
        ::unlink(copy_.c_str());
        ::close(std::exchange(lock_, -1));
    }
    copy_.clear();
    return false;
}

SharedObject::SharedObject(const fs::path& copy, const fs::path& file) {
    const fs::path whole = fs::absolute(copy);
    handle_ = dlopen(whole.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) return;
    std::string reason = dlerror();
    // The loader's message begins with the path of the copy. The message names the original file.
    if (const std::string prefix = whole.string() + ": "; reason.starts_with(prefix))
        reason.erase(0, prefix.size());
    constexpr std::string_view undefined = "undefined symbol: ";
    if (const std::size_t at = reason.find(undefined); at != std::string::npos)
        throw LoadError(file, "it needs the symbol " + reason.substr(at + undefined.size()) +
                                  ", which no loaded library defines");
    throw LoadError(file, "expected a shared object for this machine: " + reason);
}

SharedObject& SharedObject::operator=(SharedObject&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
}

void SharedObject::close() {
    if (handle_ != nullptr) dlclose(handle_);
    handle_ = nullptr;
}

void* SharedObject::symbol(const char* name) const {
    return dlsym(handle_, name);
}

FileIdentity identity(const fs::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) return {};
    return {static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_ino)};
}

}  // namespace fettle::module
