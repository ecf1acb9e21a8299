#include "one_thread.h"

#include "../c/calls/failure.h"

namespace fettle::host {

std::atomic<std::thread::id> OneThread::holder_;
int OneThread::games_ = 0;

namespace {

[[noreturn]] void refuse() {
    throw physics_c::Failure{FETTLE_LOCKED,
                             "one thread uses all games of a process: another one created the "
                             "games that there are"};
}

}  // namespace

OneThread::OneThread() {
    std::thread::id nobody;
    if (!holder_.compare_exchange_strong(nobody, std::this_thread::get_id()) &&
        nobody != std::this_thread::get_id())
        refuse();
    ++games_;
}

OneThread::~OneThread() {
    if (--games_ == 0) holder_ = std::thread::id();
}

void OneThread::require() {
    if (!is_here()) refuse();
}

}  // namespace fettle::host
