#include "durable_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <random>
#include <system_error>
#include <utility>

#include <fettle/property/storage/scene.h>

namespace fettle::property {

namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
    return std::generic_category().message(error);
}

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }
    /// Network file systems report a full disk only here.
    bool close() { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_;
};

/// Removes the file with its own life, unless told that it has found its place.
class Temporary {
  public:
    explicit Temporary(fs::path path) : path_(std::move(path)) {}
    ~Temporary() {
        if (!kept_) ::unlink(path_.c_str());
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    const fs::path& path() const { return path_; }
    void keep() { kept_ = true; }

  private:
    fs::path path_;
    bool kept_ = false;
};

int open_retrying(const fs::path& path, int flags, mode_t mode = 0) {
    int number = -1;
    do number = ::open(path.c_str(), flags | O_CLOEXEC, mode);
    while (number < 0 && errno == EINTR);
    return number;
}

/// Reads to the end, or one byte beyond `limit`. Returns false with errno set.
bool read_all(int descriptor, std::string& out, std::size_t limit) {
    constexpr std::size_t piece = std::size_t{1} << 16;
    std::size_t size = 0;
    while (size <= limit) {
        out.resize(size + piece);
        const ssize_t count = ::read(descriptor, out.data() + size, piece);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        if (count == 0) break;
        size += static_cast<std::size_t>(count);
    }
    out.resize(size);
    return true;
}

bool write_all(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t count = ::write(descriptor, content.data(), content.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        content.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

class Replacement {
  public:
    Replacement(const fs::path& asked, std::string_view content)
        : asked_(asked), content_(content) {}

    void run() {
        find_target();
        fs::path folder = target_.parent_path();
        if (folder.empty()) folder = ".";
        Temporary temporary(write_temporary(folder));
        Descriptor& written = *descriptor_;
        if (!write_all(written.number(), content_)) fail(errno);
        compare(written.number());
        if (::fsync(written.number()) != 0) fail(errno);
        if (!written.close()) fail(errno);
        if (::rename(temporary.path().c_str(), target_.c_str()) != 0) fail(errno);
        temporary.keep();
        synchronize(folder);
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw FileError(asked_, "could not be written: " + why);
    }
    [[noreturn]] void fail(int error) const { fail(reason(error)); }

    /// What the name leads to. Renaming would quietly replace a device, and a file that somebody
    /// protected against writing.
    void find_target() {
        std::error_code error;
        target_ = asked_;
        if (fs::is_symlink(asked_, error)) {
            target_ = fs::canonical(asked_, error);
            if (error) fail("it is a link, and what it leads to cannot be found");
        }
        struct stat status {};
        if (::stat(target_.c_str(), &status) != 0) {
            if (errno != ENOENT) fail(errno);
            return;
        }
        if (S_ISDIR(status.st_mode)) fail("it is a folder");
        if (!S_ISREG(status.st_mode)) fail("it is not a regular file");
        if (::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);
        replaces_ = true;
        mode_ = status.st_mode & 07777;
    }

    fs::path write_temporary(const fs::path& folder) {
        std::random_device random;
        for (int attempt = 0;; ++attempt) {
            fs::path path = folder / ("." + target_.filename().string() + "." +
                                      std::to_string(random()) + ".tmp");
            const int number = open_retrying(path, O_RDWR | O_CREAT | O_EXCL, 0666);
            if (number < 0 && errno == EEXIST && attempt < 100) continue;
            if (number < 0) fail(errno);
            descriptor_.emplace(number);
            if (replaces_) ::fchmod(number, mode_);  // some file systems have no permissions
            return path;
        }
    }

    void compare(int descriptor) const {
        std::string read;
        if (::lseek(descriptor, 0, SEEK_SET) != 0 || !read_all(descriptor, read, content_.size())) {
            fail(errno);
        }
        if (read != content_) fail("what was read back differs from what was written");
    }

    /// The new name itself is durable only when the folder is.
    void synchronize(const fs::path& folder) const {
        const Descriptor descriptor(open_retrying(folder, O_RDONLY | O_DIRECTORY));
        const bool done = descriptor && ::fsync(descriptor.number()) == 0;
        if (done || errno == EINVAL || errno == ENOSYS || errno == EACCES) return;
        throw FileError(asked_,
                        "was written, but may not survive a loss of power: " + reason(errno));
    }

    const fs::path& asked_;
    std::string_view content_;
    fs::path target_;
    bool replaces_ = false;
    mode_t mode_ = 0;
    std::optional<Descriptor> descriptor_;
};

}  // namespace

std::string read_file(const fs::path& file, std::size_t limit) {
    // Not blocking: opening a pipe would wait for somebody to write to it.
    const Descriptor descriptor(open_retrying(file, O_RDONLY | O_NONBLOCK));
    const auto fail = [&file](const std::string& why) {
        throw FileError(file, "could not be read: " + why);
    };
    if (!descriptor) fail(reason(errno));
    struct stat status {};
    if (::fstat(descriptor.number(), &status) != 0) fail(reason(errno));
    if (S_ISDIR(status.st_mode)) fail("it is a folder");
    if (!S_ISREG(status.st_mode)) fail("it is not a regular file");
    std::string content;
    if (!read_all(descriptor.number(), content, limit)) fail(reason(errno));
    if (content.size() > limit) {
        fail("it is larger than " + std::to_string(limit >> 20) + " MB");
    }
    return content;
}

void replace_file(const fs::path& file, std::string_view content) {
    Replacement(file, content).run();
}

}  // namespace fettle::property
