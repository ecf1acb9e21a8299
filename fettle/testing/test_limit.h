#pragma once
// A time limit for a test that hangs in native code. Scripts are stopped by limits of their own.

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace fettle::program {

/// Processor time that this process has used until now, s.
double processor_seconds();

/// While it exists, the process is ended with a message and an error status if a test uses more
/// processor time than `seconds` by far, or uses none for half a minute and as many seconds.
class TestLimit {
  public:
    explicit TestLimit(std::uint64_t seconds);
    ~TestLimit();
    TestLimit(const TestLimit&) = delete;
    TestLimit& operator=(const TestLimit&) = delete;

  private:
    void watch();

    const double seconds_;
    std::mutex mutex_;
    std::condition_variable wake_;
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace fettle::program
