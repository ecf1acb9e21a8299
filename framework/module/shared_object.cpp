#include "shared_object.h"

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <utility>

#include <fettle/module/plugin.h>

namespace fettle::module {

namespace fs = std::filesystem;

namespace {

/// A name beside the file, where its own neighbors are found as for the file itself.
fs::path fresh_name(const fs::path& file, const fs::path& folder) {
    static std::atomic<unsigned> count{0};
    return folder / ("." + file.stem().string() + "-" + std::to_string(getpid()) + "-" +
                     std::to_string(++count) + file.extension().string());
}

/// Removes the copy in the end: once taken in, its name is of no use.
struct Copy {
    fs::path file;
    ~Copy() {
        std::error_code ignored;
        if (!file.empty()) fs::remove(file, ignored);
    }
};

bool copied(const fs::path& file, Copy& copy) {
    std::error_code error;
    for (const fs::path& folder : {file.parent_path(), fs::temp_directory_path(error)}) {
        copy.file = fresh_name(file, folder);
        if (fs::copy_file(file, copy.file, error)) return true;
        copy.file.clear();
    }
    return false;
}

}  // namespace

void require_shared_object(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error)) throw LoadError(file, "there is no such file");
    if (fs::is_directory(file, error))
        throw LoadError(file, "expected a shared object, found a folder");
    std::ifstream in(file, std::ios::binary);
    char magic[4] = {};
    if (!in.read(magic, sizeof magic) || std::string_view(magic, 4) !=
                                             "\x7f"
                                             "ELF")
        throw LoadError(file,
                        in.bad() || (!in && in.gcount() == 0 && fs::file_size(file, error) > 0)
                            ? "it cannot be read"
                            : "expected a shared object, found a file of another kind");
}

SharedObject::SharedObject(const fs::path& file) {
    require_shared_object(file);
    const fs::path whole = fs::absolute(file);
    Copy copy;
    const fs::path& taken = copied(whole, copy) ? copy.file : whole;
    handle_ = dlopen(taken.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ != nullptr) return;
    std::string reason = dlerror();
    // The loader begins with the name of what it was given; ours is known already.
    if (const std::string prefix = taken.string() + ": "; reason.starts_with(prefix))
        reason.erase(0, prefix.size());
    constexpr std::string_view undefined = "undefined symbol: ";
    if (const std::size_t at = reason.find(undefined); at != std::string::npos)
        throw LoadError(file, "it needs the symbol " + reason.substr(at + undefined.size()) +
                                  ", which nothing here has");
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
