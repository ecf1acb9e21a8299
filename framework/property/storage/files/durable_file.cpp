#include <files/durable_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>

#include <fettle/property/storage/scene.h>

#include <files/file_access.h>
#include <files/temporary_file.h>

namespace fettle::property {

namespace {

namespace fs = std::filesystem;

/// Reads to the end, or one byte more than `limit`. Returns false with errno set.
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
    Replacement(const fs::path& given, std::string_view content)
        : given_(given), content_(content) {}

    void run() {
        find_target();
        fs::path folder = target_.parent_path();
        if (folder.empty()) folder = ".";
        remove_leftovers(folder);
        try {
            write(folder);
        } catch (const std::system_error& error) {
            fail(error.code().value());
        }
        synchronize(folder);
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw FileError(given_, "could not be written: " + why);
    }
    [[noreturn]] void fail(int error) const { fail(system_reason(error)); }

    /// Follows links and checks the target: renaming would replace a device or a write-protected
    /// file without an error.
    void find_target() {
        std::error_code error;
        target_ = given_;
        if (fs::is_symlink(given_, error)) {
            target_ = fs::canonical(given_, error);
            if (error) fail("it is a link, and what it leads to cannot be found");
        }
        struct stat status {};
        if (::stat(target_.c_str(), &status) != 0) {
            if (errno != ENOENT) fail(errno);
            return;
        }
        if (const std::string why = why_no_file(status.st_mode); !why.empty()) fail(why);
        if (::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);
        replaces_ = true;
        mode_ = status.st_mode & 07777;
    }

    void write(const fs::path& folder) {
        TemporaryFile temporary(folder / target_.filename());
        if (replaces_)
            ::fchmod(temporary.descriptor(), mode_);  // not all file systems support this
        if (!write_all(temporary.descriptor(), content_)) fail(errno);
        compare(temporary.descriptor());
        if (::fsync(temporary.descriptor()) != 0) fail(errno);
        if (!temporary.put_into_place()) fail(errno);
    }

    void compare(int descriptor) const {
        std::string read;
        if (::lseek(descriptor, 0, SEEK_SET) != 0 || !read_all(descriptor, read, content_.size())) {
            fail(errno);
        }
        if (read != content_) fail("what was read back differs from what was written");
    }

    /// Synchronizes the folder, because otherwise the new name may be lost.
    void synchronize(const fs::path& folder) const {
        const Descriptor descriptor(open_file(folder, O_RDONLY | O_DIRECTORY));
        const bool done = descriptor && ::fsync(descriptor.number()) == 0;
        if (done || errno == EINVAL || errno == ENOSYS || errno == EACCES) return;
        throw FileError(
            given_, "was written, but may not survive a loss of power: " + system_reason(errno));
    }

    const fs::path& given_;
    std::string_view content_;
    fs::path target_;
    bool replaces_ = false;
    mode_t mode_ = 0;
};

}  // namespace

std::string read_file(const fs::path& file, std::size_t limit) {
    // Non-blocking, because opening a pipe would wait for a writer.
    const Descriptor descriptor = open_file(file, O_RDONLY | O_NONBLOCK);
    const auto fail = [&file](const std::string& why) {
        throw FileError(file, "could not be read: " + why);
    };
    const int error = errno;
    struct stat status {};
    // A socket cannot be opened, but its status can be read.
    if ((descriptor ? ::fstat(descriptor.number(), &status) : ::stat(file.c_str(), &status)) != 0)
        fail(system_reason(errno));
    if (const std::string why = why_no_file(status.st_mode); !why.empty()) fail(why);
    if (!descriptor) fail(system_reason(error));
    const auto too_large = [&] {
        fail("it is larger than " + std::to_string(limit >> 20) + " MB");
    };
    if (status.st_size > 0 && static_cast<std::uintmax_t>(status.st_size) > limit) too_large();
    std::string content;
    if (!read_all(descriptor.number(), content, limit)) fail(system_reason(errno));
    if (content.size() > limit) too_large();
    return content;
}

void replace_file(const fs::path& file, std::string_view content) {
    Replacement(file, content).run();
}

}  // namespace fettle::property
