#include "measure/round_trip.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <thread>

#include "measure/timing.h"

namespace fettle::bench {
namespace {

constexpr int tries = 5, trips = 5000;

double trip_ns() {
    std::atomic<int> word = 0;
    const auto wait_for = [&word](int value) {
        for (int looks = 0; word.load(std::memory_order_acquire) != value; ++looks)
            if (looks % 1000 == 999) std::this_thread::yield();
    };
    std::thread other([&] {
        for (int i = 0; i < trips; ++i) {
            wait_for(2 * i + 1);
            word.store(2 * i + 2, std::memory_order_release);
        }
    });
    const WallClock clock;
    for (int i = 0; i < trips; ++i) {
        word.store(2 * i + 1, std::memory_order_release);
        wait_for(2 * i + 2);
    }
    const double ns = 1e6 * clock.elapsed_ms() / trips;
    other.join();
    return ns;
}

}  // namespace

double round_trip_ns() {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < tries; ++i) best = std::min(best, trip_ns());
    return best;
}

}  // namespace fettle::bench
