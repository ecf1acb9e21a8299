#include <testing/test_limit.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>

#include <ending/crash_report.h>
#include <ending/exit_status.h>

namespace fettle::program {

namespace {

[[noreturn]] void end_process(const char* format, double seconds) {
    std::array<char, 200> reason;
    std::snprintf(reason.data(), reason.size(), format, seconds);
    report_sudden_end(reason.data());
    ::_exit(script_error);
}

}  // namespace

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

TestLimit::TestLimit(std::uint64_t seconds)
    : seconds_(static_cast<double>(seconds)), thread_([this] { watch(); }) {}

TestLimit::~TestLimit() {
    {
        const std::lock_guard lock(mutex_);
        ends_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

void TestLimit::watch() {
    constexpr std::chrono::milliseconds tick{100};
    // A script is stopped at the limit itself; a step of physics may take a little longer.
    const double most = 1.2 * seconds_ + 2;
    // A program that waits for the processor of a busy machine gets more than this share of it.
    constexpr double least_share = 0.001;
    const double longest_wait = std::max(30.0, seconds_);
    const double begun = processor_seconds();
    double since = begun, waited = 0;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, tick, [this] { return ends_; })) {
        const double now = processor_seconds();
        if (now - begun > most)
            end_process("the test did not end within %g s of processor time, and native code ran",
                        seconds_);
        waited += std::chrono::duration<double>(tick).count();
        if (now - since > least_share * waited + 0.01) since = now, waited = 0;
        if (waited > longest_wait)
            end_process("the test waits for something that has not come for %g s", longest_wait);
    }
}

}  // namespace fettle::program
