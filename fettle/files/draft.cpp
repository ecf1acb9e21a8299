#include <files/draft.h>

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>

#include <files/game_path.h>

namespace fettle::program {

namespace fs = std::filesystem;

namespace {

fs::path folder_beside(const fs::path& result) {
    fs::path whole = fs::absolute(result).lexically_normal();
    if (!whole.has_filename()) whole = whole.parent_path();
    std::error_code error;
    fs::create_directories(whole.parent_path(), error);
    std::string name = whole.string() + ".XXXXXX";
    if (::mkdtemp(name.data()) == nullptr)
        throw FileError(result.string() + ": cannot be written: " + std::strerror(errno));
    return name;
}

}  // namespace

Draft::Draft(const fs::path& result) : path(folder_beside(result)) {}

Draft::~Draft() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
}

std::string reason_of_write(const fs::path& folder, const std::error_code& code) {
    // Copying to a full disk may fail with another code of the system.
    constexpr std::uintmax_t nearly_nothing = 64 << 10;
    std::error_code error;
    const fs::space_info space = fs::space(folder, error);
    if (!error && space.available < nearly_nothing) return "the disk is full";
    return code ? code.message() : "the system gives no reason";
}

}  // namespace fettle::program
