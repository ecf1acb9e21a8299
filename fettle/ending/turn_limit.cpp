#include <ending/turn_limit.h>

#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>

#include <ending/crash_report.h>
#include <ending/exit_status.h>

namespace fettle::program {

TurnLimit::TurnLimit(double seconds) : seconds_(seconds) {
    if (seconds_ > 0) thread_ = std::thread([this] { watch(); });
}

TurnLimit::~TurnLimit() {
    if (!thread_.joinable()) return;
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void TurnLimit::turn_ends(std::uint64_t steps) {
    if (seconds_ <= 0) return;
    const std::lock_guard lock(mutex_);
    lasted_ = 0;
    steps_ = steps;
}

void TurnLimit::watch() {
    constexpr std::chrono::milliseconds tick{100};
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, tick, [this] { return ends_; })) {
        lasted_ += std::chrono::duration<double>(tick).count();
        if (lasted_ <= seconds_) continue;
        std::array<char, 200> reason;
        std::snprintf(reason.data(), reason.size(),
                      "after step %llu, the game did not come back for %g seconds, and nothing "
                      "could stop it: the run ends at once",
                      static_cast<unsigned long long>(steps_), seconds_);
        report_sudden_end(reason.data());
        ::_exit(script_error);
    }
}

}  // namespace fettle::program
