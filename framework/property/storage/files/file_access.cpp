#include <files/file_access.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include <fettle/property/storage/scene.h>

namespace fettle::property {

std::string system_reason(int error) {
    std::string words = std::generic_category().message(error);
    if (error == ENOSPC) return "the disk is full (" + words + ")";
    if (error == EDQUOT) return "the disk quota is used up (" + words + ")";
    if (error == EFBIG) return "a file may not become that large here (" + words + ")";
    return words;
}

std::string why_no_file(mode_t mode) {
    if (S_ISREG(mode)) return {};
    if (S_ISDIR(mode)) return "it is a folder";
    const char* const what = S_ISFIFO(mode)                   ? "pipe"
                             : S_ISSOCK(mode)                 ? "socket"
                             : S_ISLNK(mode)                  ? "link"
                             : S_ISCHR(mode) || S_ISBLK(mode) ? "device"
                                                              : "thing of another kind";
    return std::string("it is a ") + what + ", not a regular file";
}

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
}

bool Descriptor::close() {
    return number_ < 0 || ::close(std::exchange(number_, -1)) == 0;
}

Descriptor open_file(const std::filesystem::path& path, int flags, mode_t mode) {
    int number = -1;
    do number = ::open(path.c_str(), flags | O_CLOEXEC | O_NOCTTY, mode);
    while (number < 0 && errno == EINTR);
    return Descriptor(number);
}

bool try_lock(const Descriptor& descriptor) {
    int result = -1;
    do result = ::flock(descriptor.number(), LOCK_EX | LOCK_NB);
    while (result != 0 && errno == EINTR);
    return result == 0;
}

Descriptor lock_folder(const std::filesystem::path& folder) {
    constexpr std::chrono::seconds timeout{5};
    Descriptor locked = open_file(folder, O_RDONLY | O_DIRECTORY);
    const auto deadline = std::chrono::steady_clock::now() + timeout;
    while (locked && !try_lock(locked)) {
        if (errno != EWOULDBLOCK) break;  // the file system has no locks
        if (std::chrono::steady_clock::now() > deadline)
            throw FileError(
                folder, "another program holds the lock on this folder, so nothing was written");
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return locked;
}

}  // namespace fettle::property
