#include <files/temporary_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

namespace fettle::property {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view ending = ".fettle.tmp";

/// Whether the name has the form that the constructor below gives.
bool is_name_of_ours(std::string_view name) {
    if (!name.starts_with('.') || !name.ends_with(ending)) return false;
    name.remove_suffix(ending.size());
    const std::size_t point = name.rfind('.');
    const std::string_view number = name.substr(point + 1);
    return point > 0 && !number.empty() && number.size() <= 10 &&
           std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Whether the path still leads to the open file.
bool is_called(const Descriptor& file, const fs::path& path) {
    struct stat open {
    }, named{};
    return ::fstat(file.number(), &open) == 0 && ::lstat(path.c_str(), &named) == 0 &&
           open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& target) : target_(target) {
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    // A file name may have 255 bytes, so the name of the target is shortened.
    const std::string stem = "." + target.filename().string().substr(0, 200) + ".";
    std::random_device random;
    for (int attempt = 0;; ++attempt) {
        path_ = folder / (stem + std::to_string(random()) + std::string(ending));
        descriptor_ = open_file(path_, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW, 0666);
        const int error = errno;
        if (descriptor_) {
            // Before the lock was there, another process may have removed the file as a leftover.
            // Without locks in the file system, no process removes leftovers.
            const bool ours = try_lock(descriptor_) || errno != EWOULDBLOCK;
            if (ours && is_called(descriptor_, path_)) return;
        } else if (error != EEXIST) {
            throw std::system_error(error, std::generic_category());
        }
        if (attempt == 100) throw std::system_error(EEXIST, std::generic_category());
    }
}

TemporaryFile::~TemporaryFile() {
    if (!placed_) ::unlink(path_.c_str());
}

bool TemporaryFile::put_into_place() {
    // Network file systems report a full disk on closing. A duplicate is closed, because closing
    // the only descriptor would end the lock before the rename.
    if (!Descriptor(::dup(descriptor_.number())).close()) return false;
    if (::rename(path_.c_str(), target_.c_str()) != 0) return false;
    placed_ = true;
    descriptor_.close();
    return true;
}

void remove_leftovers(const fs::path& folder) noexcept {
    try {
        std::error_code error;
        for (fs::directory_iterator it(folder, error), end; !error && it != end;
             it.increment(error)) {
            const fs::path& path = it->path();
            if (!is_name_of_ours(path.filename().string())) continue;
            const Descriptor file = open_file(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK);
            struct stat status {};
            if (!file || ::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) continue;
            if (try_lock(file) && is_called(file, path)) ::unlink(path.c_str());
        }
    } catch (const std::exception&) {  // a later call removes them
    }
}

}  // namespace fettle::property
