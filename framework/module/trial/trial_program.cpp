#include <fettle/module/trial_program.h>

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>

/// The folder of the program. Defined in programs that are linked with an installed static library,
/// which does not contain the place of its installation (`cmake/trial_place.cpp`).
extern "C" __attribute__((weak)) const char* fettle_trial_place();

namespace fettle::module {

namespace fs = std::filesystem;

namespace {

constexpr const char* program_name = "fettle-trial";

/// What `set_trial_program` has set. Modules may be loaded on several threads, one for each tree.
struct Chosen {
    std::mutex mutex;
    fs::path file;
};

Chosen& chosen() {
    static Chosen one;
    return one;
}

fs::path folder_of_library() {
    Dl_info info{};
    if (dladdr(reinterpret_cast<const void*>(&set_trial_program), &info) == 0 ||
        info.dli_fname == nullptr)
        return {};
    std::error_code error;
    return fs::weakly_canonical(info.dli_fname, error).parent_path();
}

fs::path folder_of_program() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

}  // namespace

void set_trial_program(const fs::path& file) {
    const std::lock_guard lock(chosen().mutex);
    chosen().file = file;
}

std::vector<fs::path> trial_program_places() {
    {
        const std::lock_guard lock(chosen().mutex);
        if (!chosen().file.empty()) return {chosen().file};
    }
    if (const char* const named = std::getenv("FETTLE_TRIAL"); named != nullptr && *named != 0)
        return {named};
    std::vector<fs::path> all;
    const auto add = [&](const fs::path& folder) {
        const fs::path file = (folder / program_name).lexically_normal();
        if (std::find(all.begin(), all.end(), file) == all.end()) all.push_back(file);
    };
    for (const fs::path& folder : {folder_of_program(), folder_of_library()}) {
        if (folder.empty()) continue;
        add(folder);
        add(folder / FETTLE_LIBEXEC_FROM_BIN);
        add(folder / FETTLE_LIBEXEC_FROM_LIB);
    }
#ifdef FETTLE_TRIAL_BUILT
    add(FETTLE_TRIAL_BUILT);
#endif
    if (fettle_trial_place != nullptr) add(fettle_trial_place());
    add(FETTLE_LIBEXEC);
    return all;
}

}  // namespace fettle::module
