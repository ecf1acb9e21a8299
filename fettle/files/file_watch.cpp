#include <files/file_watch.h>

#include <sys/stat.h>

namespace fettle::program {

FileWatch::State FileWatch::state_of(const std::filesystem::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return {};
    return {.time = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec,
            .size = static_cast<std::uint64_t>(status.st_size),
            .number = status.st_ino};
}

std::vector<std::filesystem::path> FileWatch::changed(
    const std::vector<std::filesystem::path>& files) {
    next_ = Clock::now() + interval;
    std::vector<std::filesystem::path> result;
    bool unsettled = false;
    for (const std::filesystem::path& file : files) {
        const State state = state_of(file);
        const auto [entry, added] = known_.try_emplace(file, Known{state});
        Known& known = entry->second;
        if (known.now == state) {
            if (known.pending) result.push_back(file);
            continue;
        }
        known.now = state;
        known.pending = true;
        unsettled = true;
    }
    // Files that are saved together are reported together. A file that a tool writes all the time
    // must not keep back the others.
    constexpr int longest_wait = 10;
    held_back_ = unsettled ? held_back_ + 1 : 0;
    if (unsettled && held_back_ < longest_wait) return {};
    for (const std::filesystem::path& file : result) known_.at(file).pending = false;
    return result;
}

void FileWatch::mark_seen(const std::filesystem::path& file) {
    if (const auto found = known_.find(file); found != known_.end())
        found->second = Known{state_of(file)};
}

}  // namespace fettle::program
