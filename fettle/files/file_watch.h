#pragma once
// Notices that files have changed. The times and sizes of all files are compared a few times a
// second: that works on every file system, and for editors that replace a file by another one.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace fettle::program {

class FileWatch {
  public:
    using Clock = std::chrono::steady_clock;

    /// Whether it is time to look again.
    bool due() const { return Clock::now() >= next_; }
    /// Returns which of the files have changed since they were first passed here. A file that is
    /// still being written is returned later: it must have stayed the same between two looks. The
    /// others wait for it, but not longer than ten looks. Call it when it is `due`.
    std::vector<std::filesystem::path> changed(const std::vector<std::filesystem::path>& files);
    /// Records the file as it is now: earlier changes of it are not returned.
    void mark_seen(const std::filesystem::path& file);

  private:
    static constexpr std::chrono::milliseconds interval{100};
    /// All zeros for a file that does not exist.
    struct State {
        std::int64_t time = 0;  // of the last change, ns
        std::uint64_t size = 0, number = 0;
        friend bool operator==(const State&, const State&) = default;
    };
    struct Known {
        State now;
        bool pending = false;
    };
    static State state_of(const std::filesystem::path& file);

    std::map<std::filesystem::path, Known> known_;
    Clock::time_point next_{};
    int held_back_ = 0;  // looks in which a file changed
};

}  // namespace fettle::program
